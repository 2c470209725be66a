#!/usr/bin/python3
"""Compares the figures of scene_cost with those of a bare loop over the same motion, running the two programs in turn.

Usage: cost_breakdown_check.py [ROUNDS]    (default 20; needs the targets scene_cost and instruction_probe in build/)

The time of the bare loop is that of its fastest run from start to end; the figure of scene_cost is the median of its runs.
For the loop, the part of an effect is the difference of two scenes, one of them without the effect.
"""
import csv
import os
import statistics
import subprocess
import sys
import tempfile

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), ".."))
PROGRAMS = os.path.join(ROOT, "build", "devel", "lib", "poinsot")
SECONDS, RATE = "60", "60"
BODY = "name: body, inertia: [1, 2, 3], angular_velocity: [0.1, 1, 0.2]"
TOP = "name: body, inertia: [1, 1, 0.3], angular_velocity: [0.1, 0.2, 20], method: rk4, step: 0.001"
WEIGHT = "{type: gravity_torque, mass: 1, centre_of_mass: [0, 0, 0.3]}"
NOTHING = "{type: constant_torque, frame: body, torque: [0, 0, 0]}"
ORBIT = BODY + ", method: taylor12, step: 0.1"
GRADIENT = "{type: gravity_gradient, orbit_rate: 0.1, orbit_normal: [0, 0, 1], radial_at_start: [1, 0, 0]}"
# name: the body, its effects, and the effects without the one whose part is measured
SCENES = {
    "closed_form": (BODY, [], None, None),
    "dmv8, 0.01 s": (BODY + ", method: dmv8, step: 0.01", [], None, None),
    "heavy top, rk4, 0.001 s": (TOP, [WEIGHT], [NOTHING], "gravity_torque"),
    "orbit, taylor12, 0.1 s": (ORBIT, [GRADIENT], [NOTHING], "gravity_gradient"),
}


def run(name, *words):
    return subprocess.run([os.path.join(PROGRAMS, name)] + list(words), check=True, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL).stdout


def write(folder, name, body, effects):
    path = os.path.join(folder, name)
    with open(path, "w") as handle:
        handle.write("bodies: [{%s%s}]\n" % (body, ", effects: [%s]" % ", ".join(effects) if effects else ""))
    return path


def main():
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 20
    print("%-26s %28s %28s" % ("", "ns per simulated s", "part of the effect"))
    print("%-26s %9s %9s %8s %14s %13s" % ("", "ledger", "loop", "ratio", "ledger", "loop"))
    with tempfile.TemporaryDirectory() as folder:
        for name, (body, effects, without, looked_at) in SCENES.items():
            scene = write(folder, "scene.yaml", body, effects)
            other = write(folder, "without.yaml", body, without) if without else None
            loops, others, totals, parts = [], [], [], []
            for _ in range(rounds):
                loops.append(float(run("instruction_probe", "run", scene, SECONDS, RATE).split()[1]))
                if other:
                    others.append(float(run("instruction_probe", "run", other, SECONDS, RATE).split()[1]))
                rows = {row["part"]: row for row in csv.DictReader(
                    run("scene_cost", scene, "--duration", SECONDS, "--rate", RATE, "--csv", "-").splitlines())}
                totals.append(float(rows["total"]["ns_per_simulated_s"]))
                parts.append(float(rows[looked_at]["share"]) if looked_at else 0)
            ledger, loop = statistics.median(totals), min(loops)
            print("%-26s %9.0f %9.0f %8.3f" % (name, ledger, loop, ledger / loop), end="")
            print(" %12.1f %% %11.1f %%" % (100 * statistics.median(parts), 100 * (1 - min(others) / loop)) if other else "")


if __name__ == "__main__":
    main()
