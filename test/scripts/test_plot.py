#!/usr/bin/python3
"""scripts/plot.py draws what `simulate` wrote, and refuses everything else.

Usage: test_plot.py PROGRAMS    (the directory of the built programs)

The last line reads "N passed, M failed".
"""
import os
import subprocess
import sys
import tempfile

import matplotlib.image

ROOT = os.path.realpath(os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "test"))
import checks  # noqa: E402

PLOT = os.path.join(ROOT, "scripts", "plot.py")
HEADER = "body,t,qw,qx,qy,qz,O1,O2,O3,bx,by,bz"
ROW = "a,%s,1,0,0,0,0.1,%s,3,0,0,0"
WITH_ENERGY, WITH_ERRORS = ("E [J]", "|L| [kg"), ("attitude error [rad]", "|energy drift|")


def plot(*words):
    done = subprocess.run([PLOT] + list(words), stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
    return done.returncode, done.stdout + done.stderr


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def drawn(words, csv, present, absent, *options):
    """The picture has these words, and not those."""
    out = csv + ".svg"
    code, said = plot(csv, "--out", out, *options)
    if code != 0:
        checks.check(words, ["exit %d: %s" % (code, said)])
        return
    svg = text_of(out)
    checks.check(words, ["expected %s" % word for word in present if word not in svg] +
                 ["expected no %s" % word for word in absent if word in svg])


def refused(words, folder, content, pattern, *options):
    """A file with that content is refused with that message, and the picture that was there stays."""
    path = os.path.join(folder, "bad.csv")
    with open(path, "wb") as file:
        file.write(content if isinstance(content, bytes) else content.encode())
    picture = os.path.join(folder, "bad.png")
    with open(picture, "w") as file:
        file.write("old")
    code, said = plot(path, *options)
    out = [] if code == 2 and pattern.replace("FILE", path) in said else ["expected 2 and %s, got %d: %s" % (pattern, code, said)]
    with open(picture, "rb") as file:
        if file.read() != b"old":
            out.append("the old picture is gone")
    checks.check(words, out)


def check_refusals(folder):
    first = HEADER + "\n" + ROW % (0, 1) + "\n"
    refused("an empty file", folder, "", "FILE:1: expected the columns of simulate, body,t,qw,")
    refused("another table", folder, "a,b\n1,2\n", 'FILE:1: expected the columns of simulate, body,t,qw,qx,qy,qz,O1,O2,O3,bx,by,bz'
            '[,E,Lx,Ly,Lz][,attitude_error,energy_drift], got "a,b"')
    refused("no state", folder, HEADER + "\n", "FILE: expected at least one state, got none")
    refused("a cell that is no number", folder, first + ROW % (1, "fast") + "\n", 'FILE:3: O2: expected a finite number, got "fast"')
    refused("a cell that is not finite", folder, first + ROW % (1, "inf") + "\n", 'FILE:3: O2: expected a finite number, got "inf"')
    refused("a row that was cut off", folder, first + "a,1,1,0", "FILE:3: expected 12 cells, got 4")
    refused("a time that does not grow", folder, first + ROW % (0, 2) + "\n", "FILE:3: t: expected a time after 0 s, got 0")
    refused("bytes that are no text", folder, first.encode() + b"\xff\xfe\n", "FILE: expected text in UTF-8, got other bytes")
    refused("a body that is not there", folder, first, '--body: expected one of a, got "b"', "--body", "b")
    refused("a picture of another kind", folder, first, '--out: expected a file that ends with .png or .svg, got "a.pdf"', "--out", "a.pdf")
    refused("an unknown option", folder, first, "unrecognized arguments: --speed", "--speed")
    code, said = plot(os.path.join(folder, "missing.csv"))
    checks.check("a file that does not exist", [] if code == 2 and "missing.csv: expected a CSV that simulate wrote, got none" in said
                 else ["exit %d: %s" % (code, said)])


def check_pictures(simulate, folder):
    scene = os.path.join(folder, "scene.yaml")
    with open(scene, "w") as file:
        file.write("bodies:\n"
                   "  - {name: exact, inertia: [1, 2, 3], angular_velocity: [0.1, 2, 0.1]}\n"
                   "  - {name: stepped, inertia: [1, 2, 3], angular_velocity: [0.1, 2, 0.1], method: rk4, step: 0.01,\n"
                   "     effects: [{type: translation, position: [9, 0, 0]}]}\n"
                   "  - {name: still, inertia: [1, 2, 3], angular_velocity: [0, 0, 0], effects: [{type: translation, position: [0, 9, 0]}]}\n"
                   "  - {name: damped, inertia: [1, 2, 3], angular_velocity: [0.1, 2, 0.1],\n"
                   "     effects: [{type: viscous_damping, coefficient: 0.1}]}\n")

    def motion(columns):
        path = os.path.join(folder, columns.replace(",", "_") + ".csv")
        subprocess.run([simulate, scene, "--duration", "20", "--csv", path, "--columns", columns], check=True,
                       stderr=subprocess.DEVNULL)
        return path
    every, states = motion("states,energy,errors"), motion("states")
    drawn("all columns", every, ("polhode", "exact of") + WITH_ENERGY + WITH_ERRORS[1:], ())
    drawn("a body by its name", every, ("stepped of",) + WITH_ENERGY + WITH_ERRORS, ("exact of",), "--body", "stepped")
    drawn("a body at rest", every, ("still of",), (), "--body", "still")
    drawn("a body under torques", every, ("damped of", "no closed form"), WITH_ERRORS[:1], "--body", "damped")
    drawn("states alone", states, ("polhode",), WITH_ENERGY + WITH_ERRORS)
    drawn("energy alone", motion("energy"), WITH_ENERGY, WITH_ERRORS)
    drawn("errors alone", motion("errors"), WITH_ERRORS, WITH_ENERGY, "--body", "stepped")

    code, said = plot(every)
    png = every[:-4] + ".png"
    checks.check("the picture stands beside the CSV, and the body is named", [] if code == 0 and os.path.exists(png) and "exact is drawn, the first of 4 bodies" in said else [said])
    pixels = matplotlib.image.imread(png)[:, :, :3]
    magenta = int(((abs(pixels - [0.93, 0.13, 0.47])).max(axis=2) < 0.08).sum())
    checks.check("the polhode is on it", [] if magenta > 200 else ["expected its colour on 200 pixels, got %d" % magenta])
    with open(png, "rb") as file:
        before = file.read()
    plot(every)
    with open(png, "rb") as file:
        checks.check("the same CSV gives the same picture", [] if file.read() == before else ["they differ"])
    code, said = plot(every, "--out", os.path.join(folder, "nowhere", "a.png"))
    checks.check("a picture that cannot be written", [] if code == 1 and "cannot write" in said else ["exit %d: %s" % (code, said)])
    left = [name for name in os.listdir(folder) if name.startswith(".")]
    checks.check("nothing else is left", left)


def main():
    if len(sys.argv) != 2:
        print(__doc__)
        return 2
    with tempfile.TemporaryDirectory() as folder:
        check_pictures(os.path.join(sys.argv[1], "simulate"), folder)
        check_refusals(folder)
    return checks.finish()


if __name__ == "__main__":
    sys.exit(main())
