#!/usr/bin/python3
"""For compare.sh: makes a scene of two of the bodies of compare_scene, and plots the energy of all of them.

Usage: compare_energy.py scene FOUR.yaml TWO.yaml METHOD METHOD    (side by side, each with its picture in body axes)
       compare_energy.py plot FOUR.csv OUT.png WIDTH HEIGHT TIME...  (of simulate --columns states,energy; marks the times)
"""
import csv
import sys

import yaml

DPI = 100
# Okabe and Ito's colours, which the colour-blind can tell apart.
LOOKS = {"lie_euler": ("#E69F00", "-"), "buss2": ("#56B4E9", "-"), "closed_form": ("#FFFFFF", "--")}
OTHER = ("#009E73", "-.")
BACKGROUND = "#191d26"


def write_scene(source, target, left, right):
    with open(source) as file:
        scene = yaml.safe_load(file)
    bodies = {body["name"]: body for body in scene["bodies"]}
    apart = max(abs(body["effects"][0]["position"][2]) for body in bodies.values())
    scene["bodies"] = [bodies[left], bodies[right]]
    for body, y in zip(scene["bodies"], (-apart, apart)):
        body["pictures"] = "body"
        body["effects"][0]["position"] = [0, y, 0]
    with open(target, "w") as out:
        yaml.safe_dump(scene, out, sort_keys=False)


def plot(source, target, width, height, times):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    runs = {}
    with open(source, newline="") as file:
        for row in csv.DictReader(file):
            t, energy = runs.setdefault(row["body"], ([], []))
            t.append(float(row["t"]))
            energy.append(float(row["E"]))
    plt.rcParams.update({"font.size": 16, "text.color": "white", "axes.labelcolor": "white", "axes.edgecolor": "#8c94a6",
                         "xtick.color": "white", "ytick.color": "white", "axes.facecolor": BACKGROUND})
    figure, axes = plt.subplots(figsize=((width + 0.5) / DPI, (height + 0.5) / DPI), dpi=DPI, facecolor=BACKGROUND)
    last = max(t[-1] for t, _ in runs.values())
    for body, (t, energy) in runs.items():
        colour, style = LOOKS.get(body, OTHER)
        axes.plot(t, [e / energy[0] for e in energy], style, color=colour, linewidth=3)
        if body == "lie_euler":
            axes.annotate(body, (t[-1], energy[-1] / energy[0]), (8, 0), textcoords="offset points", va="center", color=colour)
    others = [body for body in runs if body != "lie_euler"]
    axes.annotate(",\n".join(others), (last, 1), (8, 0), textcoords="offset points", va="center", color="white")
    for time in times:
        axes.axvline(time, color="#8c94a6", linewidth=1)
        axes.annotate("t = %g s" % time, (time, axes.get_ylim()[1]), (6, -6), textcoords="offset points", va="top")
    axes.set_xlim(0, last)
    axes.set_xlabel("t [s]")
    axes.set_ylabel("E / E₀")
    axes.grid(True, color="#3a4152", linewidth=0.8)
    figure.tight_layout(rect=(0, 0, 0.99, 1))
    figure.savefig(target)


def main():
    if len(sys.argv) == 6 and sys.argv[1] == "scene":
        write_scene(*sys.argv[2:])
    elif len(sys.argv) > 6 and sys.argv[1] == "plot":
        plot(sys.argv[2], sys.argv[3], int(sys.argv[4]), int(sys.argv[5]), [float(t) for t in sys.argv[6:]])
    else:
        print(__doc__, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
