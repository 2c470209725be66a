#!/usr/bin/python3
"""Shows that the audit can fail: changes one line of the node at a time, runs the audit against it, and demands that it
reports just what is wrong.

Usage: run.py [--only NAME]   (works on a copy of the sources in a temporary directory)
  --only NAME   this change alone

The last line is "N passed, M failed"; exit 0 when all changes were caught, and the unchanged node passed.
"""
import concurrent.futures
import os
import queue
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))

AT_ONCE = 2  # copies of the package

# name, file, what stands there (once), what is put there, what the audit must say
MUTATIONS = [
    ("energy without its half", "src/core/invariants.cpp",
     "return {0.5 * state.momentum_principal.dot(", "return {state.momentum_principal.dot(",
     r"kinetic_energy is 2\.?0* times"),
    ("momentum ellipsoid with semi-axes sqrt(F/mu)", "src/view/ellipsoids.cpp",
     "std::sqrt(momentum_squared) * moments.cwiseInverse()", "(momentum_squared * moments.cwiseInverse()).cwiseSqrt()",
     r"momentum ellipsoid.*semi-axes"),
    ("R transposed in tf", "src/ros/body_messages.cpp",
     "names::kWorld, frames.body, state.position, state.attitude)",
     "names::kWorld, frames.body, state.position, state.attitude.conjugate())",
     r"tf.*inverse"),
    ("Omega in world axes in odometry", "src/ros/body_messages.cpp",
     "out.twist.twist.angular = toVector3(state.omega_body);",
     "out.twist.twist.angular = toVector3(state.omega_world);",
     r"odometry.*omega_world"),
    ("tf 10 ms later than the state", "src/ros/scene_topics.cpp",
     "appendTransforms(*body, topicsOf(*body).frames(), stamp, transforms_.transforms);",
     "appendTransforms(*body, topicsOf(*body).frames(), stamp + ros::Duration(0.01), transforms_.transforms);",
     r"no tf at the stamp of a state"),
    ("L turning slowly", "src/core/motion.cpp",
     "MotionState Motion::describe(double t, const FreeRotationState& principal, const Eigen::Vector3d& omega) const {",
     "MotionState Motion::describe(double t, const FreeRotationState& given, const Eigen::Vector3d& omega) const {\n"
     "  const FreeRotationState principal{\n"
     "      Eigen::Quaterniond(Eigen::AngleAxisd(1e-4 * t, Eigen::Vector3d::UnitX())) * given.attitude,\n"
     "      given.momentum_principal};",
     r"L .*(turn|direction|drift)"),
    ("the body turns about L the wrong way", "src/core/closed_form/set_up.h",
     "rates.turn = (drift + scaled(p * phase_slope, 2))", "rates.turn = -(drift + scaled(p * phase_slope, 2))",
     r"^FAIL.*dR/dstamp"),
    ("a flip without its change of sign", "src/core/closed_form/series.h",
     "mulAdd(-2.0, mulAdd(-2.0, nearest(0.5 * n - 0.25), n), 1.0)};", "1.0};",
     r"^FAIL.*Euler's equations"),
    ("the error of a stepper claimed for the closed form", "src/core/motion.cpp",
     "if (!grid_) return 0;", "if (!grid_) return 1e-12;",
     r"attitude_error says 1e-12 rad"),
    ("time_rate off by 1 %", "src/ros/body_messages.cpp",
     "out.time_rate = tick.time_rate;", "out.time_rate = 1.01 * tick.time_rate;",
     r"^FAIL.*time advances by time_rate"),
    ("gravity gradient with the wrong sign", "src/core/torques.cpp",
     "torque += (3 * gradient_->rate * gradient_->rate) *", "torque -= (3 * gradient_->rate * gradient_->rate) *",
     r"^FAIL +/satellite +(Euler's equations with torque|dL/dt = torque)"),
    ("a torque of the world taken for one of the body", "src/core/torque_steppers/taylor.h",
     "set(out.fields[i++], back * constant.world);", "set(out.fields[i++], constant.world);",
     r"^FAIL +/pushed +(L = L0 \+ torque t|dL/dt = torque)"),
    ("ellipsoids scaled by radius instead of diameter", "src/ros/markers/construction.cpp",
     "diameters = 2 * radii * semi_axes;", "diameters = radii * semi_axes;",
     r"(radius|half)"),
]


def run(command, **options):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)


def must(command, **options):
    result = run(command, **options)
    if result.returncode != 0:
        raise RuntimeError("%s failed:\n%s" % (" ".join(command), result.stdout[-4000:]))


class Copy(object):
    """A copy of the package that is built, changed, built again and audited. Copies do not meet."""

    def __init__(self, folder):
        # Laid out, and compiled, as scripts/test.sh does: where ccache is installed, only what is changed is compiled again
        # (all of it once where CI is set: a fault may bring warnings, so here they are no errors).
        self.source = os.path.join(folder, "source")
        self.build_dir = os.path.join(self.source, "build")
        self.environment = dict(os.environ, CCACHE_BASEDIR=self.source)
        shutil.copytree(ROOT, self.source, ignore=shutil.ignore_patterns(".git", "build", "bin", "__pycache__"))
        options = ["-DPYTHON_EXECUTABLE=/usr/bin/python3", "-DPOINSOT_BUILD_PANEL=OFF", "-DPOINSOT_BUILD_BENCHMARKS=OFF"]
        if shutil.which("ccache"):
            options.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
        if shutil.which("ninja"):
            options += ["-G", "Ninja"]
        must(["cmake", "-S", self.source, "-B", self.build_dir] + options)

    def build(self):
        must(["cmake", "--build", self.build_dir, "--parallel", "2", "--target", "poinsot_node", "audit_live"],
             env=self.environment)

    def audit(self):
        """Runs the audit; returns whether it passed and what it said."""
        setup = os.path.join(self.build_dir, "devel", "setup.bash")
        with tempfile.TemporaryDirectory() as home:
            said = run(["bash", "-c", 'source "$0" && exec rostest --text "--results-base-dir=$1" poinsot audit.test',
                        setup, home], env=dict(self.environment, ROS_IP="127.0.0.1", ROS_HOME=home)).stdout
        # With --text rostest's exit code says nothing: the test program's own words do.
        passed, failed = "[  PASSED  ] 1 test" in said, "[  FAILED  ]" in said
        if passed == failed:
            raise RuntimeError("the audit did not run:\n" + said[-4000:])
        return passed, said

    def unchanged(self):
        """(whether the audit lets the node as it is pass, what it says of it otherwise)"""
        self.build()
        passed, said = self.audit()
        return passed, "" if passed else "\n" + said[-6000:]

    def changed(self, name, file, old, new, expected):
        """(whether the audit reports this change, and how, or what went wrong)"""
        path = os.path.join(self.source, file)
        with open(path) as handle:
            text = handle.read()
        if text.count(old) != 1:
            return False, ": %s has %d places to change, one is needed" % (file, text.count(old))
        with open(path, "w") as handle:
            handle.write(text.replace(old, new))
        try:
            self.build()
            passed, said = self.audit()
        finally:
            with open(path, "w") as handle:
                handle.write(text)
        lines = [line.strip() for line in said.splitlines() if re.search(expected, line)]
        if passed:
            return False, ": the audit did not notice, or the change was not compiled"
        if not lines:
            return False, ": the audit failed, but did not say /%s/:\n%s" % (expected, said[-6000:])
        return True, "\n        " + lines[0][:300]


def main():
    words, changes = sys.argv[1:], MUTATIONS
    if words[:1] == ["--only"] and len(words) == 2:
        changes = [mutation for mutation in MUTATIONS if mutation[0] == words[1]]
        if not changes:
            print("run.py: expected the name of a change, got %s" % words[1], file=sys.stderr)
            return 2
    elif words:
        print(__doc__)
        return 0 if words in (["-h"], ["--help"]) else 2
    # Not below the package: ROS would find every launch file twice.
    with tempfile.TemporaryDirectory(prefix="poinsot_mutations_") as work:
        return mutate(work, changes)


def mutate(work, changes):
    first = Copy(os.path.join(work, "0"))
    results = [("the node as it is passes",) + first.unchanged()]
    copies = queue.Queue()
    copies.put(first)

    def tried(change):
        copy = copies.get()
        try:
            return (change[0],) + copy.changed(*change)
        finally:
            copies.put(copy)

    # One is compiled while another is listened to.
    for number in range(1, min(AT_ONCE, len(changes))):
        copies.put(Copy(os.path.join(work, str(number))))
    with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
        results += pool.map(tried, changes)
    for name, good, words in results:
        print("%s  %s%s" % ("PASS" if good else "FAIL", name, words))
    failed = sum(1 for result in results if not result[1])
    print("%d passed, %d failed" % (len(results) - failed, failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
