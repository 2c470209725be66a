#!/usr/bin/python3
"""Shows that the audit can fail: changes one line of the node at a time, runs the audit against it, and demands that it
reports just what is wrong.

Usage: run.py [--only NAME]   (works on a copy of the sources in a temporary directory)
  --only NAME   this change alone

The last line is "N passed, M failed"; exit 0 when all changes were caught, and the unchanged node passed.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))

# name, file, what stands there (once), what is put there, what the audit must say
MUTATIONS = [
    ("energy without its half", "src/core/invariants.cpp",
     "return {0.5 * state.momentum_body.dot(", "return {state.momentum_body.dot(",
     r"kinetic_energy is 2\.?0* times"),
    ("momentum ellipsoid with semi-axes sqrt(F/mu)", "src/view/ellipsoids.cpp",
     "std::sqrt(momentum_squared) * moments.cwiseInverse()", "(momentum_squared * moments.cwiseInverse()).cwiseSqrt()",
     r"momentum ellipsoid.*semi-axes"),
    ("R transposed in tf", "src/ros/moving_body.cpp",
     "names::kWorld, frames_.body, state_.position, state_.attitude)",
     "names::kWorld, frames_.body, state_.position, state_.attitude.conjugate())",
     r"tf.*inverse"),
    ("Omega in world axes in odometry", "src/ros/moving_body.cpp",
     "out.twist.twist.angular = toVector3(state_.omega_body);",
     "out.twist.twist.angular = toVector3(state_.omega_world);",
     r"odometry.*omega_world"),
    ("tf 10 ms later than the state", "src/ros/node.cpp",
     "body->appendTransforms(tick->stamp, transforms_);",
     "body->appendTransforms(tick->stamp + ros::Duration(0.01), transforms_);",
     r"no tf at the stamp of a state"),
    ("L turning slowly", "src/core/motion.cpp",
     "MotionState Motion::describe(double t, const RotationState& principal, const Eigen::Vector3d& omega) const {",
     "MotionState Motion::describe(double t, const RotationState& given, const Eigen::Vector3d& omega) const {\n"
     "  const RotationState principal{\n"
     "      Eigen::Quaterniond(Eigen::AngleAxisd(1e-4 * t, Eigen::Vector3d::UnitX())) * given.attitude,\n"
     "      given.momentum_body};",
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
    ("time_rate off by 1 %", "src/ros/moving_body.cpp",
     "out.time_rate = tick.time_rate;", "out.time_rate = 1.01 * tick.time_rate;",
     r"^FAIL.*time advances by time_rate"),
    ("gravity gradient with the wrong sign", "src/core/torques.cpp",
     "torque += (3 * gradient_->rate * gradient_->rate) *", "torque -= (3 * gradient_->rate * gradient_->rate) *",
     r"^FAIL +/satellite +(Euler's equations with torque|dL/dt = torque)"),
    ("a torque of the world taken for one of the body", "src/core/torque_steppers/taylor.h",
     "set(out.fields[i++], back * constant.world);", "set(out.fields[i++], constant.world);",
     r"^FAIL +/pushed +(L = L0 \+ torque t|dL/dt = torque)"),
    ("ellipsoids scaled by radius instead of diameter", "src/ros/body_picture.cpp",
     "m.scale = toVector3(2 * metres * semi_axes);", "m.scale = toVector3(metres * semi_axes);",
     r"(radius|half)"),
]


def run(command, **options):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)


def must(command, **options):
    result = run(command, **options)
    if result.returncode != 0:
        sys.exit("%s failed:\n%s" % (" ".join(command), result.stdout[-4000:]))


def build(build_dir):
    must(["cmake", "--build", build_dir, "--parallel", "2", "--target", "poinsot_node", "audit_live"])


def audit(build_dir):
    """Runs the audit; returns whether it passed and what it said."""
    setup = os.path.join(build_dir, "devel", "setup.bash")
    with tempfile.TemporaryDirectory() as home:
        said = run(["bash", "-c", "source '%s' && exec rostest --text --results-base-dir='%s' poinsot audit.test"
                    % (setup, home)], env=dict(os.environ, ROS_IP="127.0.0.1", ROS_HOME=home)).stdout
    # With --text rostest's exit code says nothing: the test program's own words do.
    passed, failed = "[  PASSED  ] 1 test" in said, "[  FAILED  ]" in said
    if passed == failed:
        sys.exit("the audit did not run:\n" + said[-4000:])
    return passed, said


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
    # Laid out, and compiled, as scripts/test.sh does: where ccache is installed, only what is changed is compiled again.
    source = os.path.join(work, "source")
    build_dir = os.path.join(source, "build")
    shutil.copytree(ROOT, source, ignore=shutil.ignore_patterns(".git", "build", "bin", "__pycache__"))
    os.environ["CCACHE_BASEDIR"] = source
    options = ["-DPYTHON_EXECUTABLE=/usr/bin/python3", "-DPOINSOT_BUILD_PANEL=OFF", "-DPOINSOT_BUILD_BENCHMARKS=OFF"]
    if shutil.which("ccache"):
        options.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
    if shutil.which("ninja"):
        options += ["-G", "Ninja"]
    must(["cmake", "-S", source, "-B", build_dir] + options)
    build(build_dir)

    passed = failed = 0

    def report(good, name, detail=""):
        nonlocal passed, failed
        passed, failed = passed + good, failed + (not good)
        print("%s  %s%s" % ("PASS" if good else "FAIL", name, detail), flush=True)

    good, said = audit(build_dir)
    report(good, "the node as it is passes", "" if good else "\n" + said[-6000:])
    for name, file, old, new, expected in changes:
        path = os.path.join(source, file)
        with open(path) as handle:
            text = handle.read()
        if text.count(old) != 1:
            report(False, name, ": %s has %d places to change, one is needed" % (file, text.count(old)))
            continue
        with open(path, "w") as handle:
            handle.write(text.replace(old, new))
        try:
            build(build_dir)
            good, said = audit(build_dir)
        finally:
            with open(path, "w") as handle:
                handle.write(text)
        lines = [line.strip() for line in said.splitlines() if re.search(expected, line)]
        if good:
            report(False, name, ": the audit did not notice")
        elif not lines:
            report(False, name, ": the audit failed, but did not say /%s/:\n%s" % (expected, said[-6000:]))
        else:
            report(True, name, "\n        " + lines[0][:300])
    print("%d passed, %d failed" % (passed, failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
