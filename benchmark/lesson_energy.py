#!/usr/bin/python3
"""Plots the energy of the motion of lesson.launch under Algorithm 1, Algorithm 2 and the closed form.

Usage: lesson_energy.py [--programs DIRECTORY] [--out FILE.svg]

Runs compare_scene and simulate on launch/lesson.yaml, prints E/E0 at some times, and writes doc/lesson_energy.svg. The
output is the same in every run. Takes some seconds; needs python3-numpy and python3-matplotlib.
Exit: 0; 2 when a program is missing or fails.
"""
import argparse
import io
import os
import subprocess
import sys
import tempfile

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), ".."))
SCENE = os.path.join(ROOT, "launch", "lesson.yaml")
DURATION = 60  # s
STEPS = [60, 120, 240]  # a second
TOLD = [5, 10, 20, 30, 60]  # s
# Okabe and Ito's colours, which the colour-blind can tell apart.
LIE_EULER, BUSS2, CLOSED_FORM, GREY = "#D55E00", "#0072B2", "#009E73", "#8c8c8c"


def output_of(*command):
    run = subprocess.run(command, stdout=subprocess.PIPE, universal_newlines=True)
    if run.returncode:
        print("lesson_energy.py: %s ends with %d" % (command[0], run.returncode), file=sys.stderr)
        sys.exit(2)
    return run.stdout


def energies(programs, steps_a_second):
    """{body: (t, E/E0)} of the scene of lesson.launch."""
    with tempfile.TemporaryDirectory() as folder:
        scene = os.path.join(folder, "lesson.yaml")
        with open(scene, "w") as out:
            out.write(output_of(os.path.join(programs, "compare_scene"), "--mode", "lesson", "--step",
                                repr(1 / steps_a_second), SCENE))
        table = output_of(os.path.join(programs, "simulate"), scene, "--duration", str(DURATION), "--columns",
                          "states,energy", "--csv", "-")
    rows = np.genfromtxt(io.StringIO(table), delimiter=",", names=True, dtype=None, encoding="utf-8")
    out = {}
    for body in ("lie_euler", "buss2", "closed_form"):
        own = rows[rows["body"] == body]
        out[body] = own["t"], own["E"] / own["E"][0]
    return out


def draw(runs, path):
    plt.rcParams.update({"font.family": "DejaVu Sans", "font.size": 11, "svg.fonttype": "path", "svg.hashsalt": "lesson"})
    figure, axes = plt.subplots(figsize=(9, 4.6))
    for steps, style in zip(STEPS, ("-", "--", ":")):
        axes.plot(*runs[steps]["lie_euler"], style, color=LIE_EULER, linewidth=1.6, label="Algorithm 1, Δt = 1/%d s" % steps)
    axes.plot(*runs[60]["buss2"], color=BUSS2, linewidth=2.6, label="Algorithm 2, Δt = 1/60 s")
    axes.plot(*runs[60]["closed_form"], "--", color=CLOSED_FORM, linewidth=1.4, label="closed form")
    axes.axhline(2.0001, color=GREY, linewidth=1, zorder=0)
    axes.text(0.5, 2.02, "the most that this |L| allows: a spin about axis 1", color="#505050", fontsize=10)
    axes.set_xlim(0, DURATION)
    axes.set_ylim(0.9, 2.15)
    axes.set_xlabel("t [s]")
    axes.set_ylabel("E(t) / E(0)")
    axes.set_title("μ = (1, 2, 3) kg·m², Ω(0) = (0.05, 5, 0.05) rad/s", fontsize=12)
    axes.grid(True, color="#e4e4e4", linewidth=0.8)
    axes.legend(loc="center right", frameon=False)
    figure.tight_layout()
    figure.savefig(path + ".part", format="svg", metadata={"Date": None})
    os.replace(path + ".part", path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", metavar="DIRECTORY", default=os.path.join(ROOT, "build/devel/lib/poinsot"))
    parser.add_argument("--out", metavar="FILE.svg", default=os.path.join(ROOT, "doc", "lesson_energy.svg"))
    options = parser.parse_args()
    for program in ("compare_scene", "simulate"):
        if not os.access(os.path.join(options.programs, program), os.X_OK):
            parser.error("expected the program %s, which scripts/build.sh builds, in %s" % (program, options.programs))
    runs = {steps: energies(options.programs, steps) for steps in STEPS}
    print("E/E0 at t =  " + "".join("%9d s" % t for t in TOLD))
    for steps in STEPS:
        for body in ("lie_euler", "buss2", "closed_form"):
            t, ratio = runs[steps][body]
            print("%-11s 1/%-3d s" % (body, steps) + "".join("%11.6f" % np.interp(x, t, ratio) for x in TOLD))
    draw(runs, options.out)
    return 0


if __name__ == "__main__":
    sys.exit(main())
