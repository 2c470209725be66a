#!/usr/bin/python3
"""Plots the errors of the closed form: against time, and against the distance from the separatrix.

Usage: closed_form_error.py [--propagate FILE] [--out DIRECTORY]

Runs the program `propagate` on random bodies, the same in every run, and compares its states with those of
test/data/reference.py at 45 digits. For contrast it also shows rk4, the closed form as textbooks print it in doubles, and
how far the truth moves with half a last bit of an input. Writes closed_form_error_time.png and
closed_form_error_separatrix.png, and prints the worst of each. Takes about a minute of one core; needs python3-mpmath,
python3-gmpy2 and python3-matplotlib.

Exit status: 0; 1 when an error of the closed form is above the goal; 2 when a program is missing or fails.
"""
import argparse
import csv
import io
import math
import os
import random
import subprocess
import sys
from collections import namedtuple

import matplotlib
import mpmath
from mpmath import mp, mpf

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), ".."))
sys.path.insert(0, os.path.join(ROOT, "test", "data"))
import reference  # noqa: E402
from textbook_closed_form import textbook  # noqa: E402

GOAL = 2e-15  # rad, and of |Omega|
DIGITS = 45
ATTITUDE = [0.5, -0.5, 0.5, 0.5]
STEP, MOST_STEPS = 0.001, 1e6  # of rk4
LOWEST = 1e-18  # what is below is drawn there
NO_ANSWER = 30.0

Body = namedtuple("Body", "name moments omega")
Case = namedtuple("Case", "body t x")    # x: where in the plot
Error = namedtuple("Error", "attitude omega")  # rad; of |Omega|

BODIES = [
    Body("round the axis of largest moment", [1.0, 2.0, 3.0], [0.6, 0.5, 0.7]),
    Body("round the axis of smallest moment", [1.0, 2.0, 3.0], [1.2, 0.5, 0.2]),
    Body("wingnut, μ = (1, 2, 3), Ω = (0.01, 1, 0.01)", [1.0, 2.0, 3.0], [0.01, 1.0, 0.01]),
    Body("1e-9 from the separatrix", [4.0, 5.0, 9.0], [3.0 + 3e-9, 0.5, 1.0]),
    Body("two equal moments", [1.0, 1.0, 2.0], [0.3, 0.4, 0.5]),
    Body("flat T-handle at 10 rad/s", [0.83, 0.23, 1.06], [10.0, 0.05, 0.02]),
]
# Okabe and Ito's colours, which the colour-blind can tell apart.
STYLES = [("#0072B2", "o"), ("#E69F00", "s"), ("#009E73", "^"), ("#D55E00", "D"), ("#CC79A7", "v"), ("#56B4E9", "p")]
GREY, DARK = "#8c8c8c", "#404040"


# ----------------------------------------------------------------------------- states and errors
def truth(body, t):
    return reference.closed_form(body.moments, ATTITUDE, body.omega, t, DIGITS)


def propagate(program, cases, *arguments):
    """The states that the program computes for the cases, in their order."""
    lines = ["id,mu1,mu2,mu3,q0w,q0x,q0y,q0z,O01,O02,O03,t"]
    for k, case in enumerate(cases):
        lines.append("%d,%s" % (k, ",".join(map(float.hex, case.body.moments + ATTITUDE + case.body.omega + [case.t]))))
    run = subprocess.run([program, *arguments], input="\n".join(lines) + "\n", text=True, stdout=subprocess.PIPE)
    if run.returncode:
        sys.stderr.write("%s exits %d\n" % (program, run.returncode))
        sys.exit(2)
    rows = list(csv.DictReader(io.StringIO(run.stdout)))
    assert [row["id"] for row in rows] == [str(k) for k in range(len(cases))]
    return [([float(row[c]) for c in ("qw", "qx", "qy", "qz")], [float(row[c]) for c in ("O1", "O2", "O3")])
            for row in rows]


def error(true, state):
    with mp.workdps(DIGITS + 15):
        attitude = reference.angle_between(true[0], [mpf(x) for x in state[0]])
        off = mpmath.sqrt(sum((a - b) ** 2 for a, b in zip(true[1], state[1])))
        return Error(float(attitude), float(off / mpmath.sqrt(sum(a * a for a in true[1]))))


def worst(errors):
    return Error(max(e.attitude for e in errors), max(e.omega for e in errors))


# ----------------------------------------------------------------------------- cases
def times(draw, least, most, per_decade):
    """Numbers of either sign, evenly distributed over the logarithm."""
    n = round(math.log10(most / least) * per_decade)
    return [draw.choice((-1, 1)) * least * (most / least) ** ((k + draw.random()) / n) for k in range(n)]


def period(body):
    """The period of Omega [s]; for moments in ascending order, no steady spins, not on the separatrix."""
    I1, I2, I3 = map(mpf, body.moments)
    w1, w2, w3 = map(mpf, body.omega)
    if I3 * (I3 - I2) * w3 * w3 < I1 * (I2 - I1) * w1 * w1:
        (I1, I3), (w1, w3) = (I3, I1), (w3, w1)
    from_first = I2 * (I2 - I1) * w2 * w2 + I3 * (I3 - I1) * w3 * w3  # L^2 - 2 E I1
    from_second = I1 * (I1 - I2) * w1 * w1 + I3 * (I3 - I2) * w3 * w3
    complement = (I3 - I1) * from_second / ((I3 - I2) * from_first)
    rate = mpmath.sqrt((I3 - I2) * from_first / (I1 * I2 * I3))
    return float(2 * mp.pi / mpmath.agm(1, mpmath.sqrt(complement)) / rate)


def distances(draw, least, per_decade):
    n = round(-math.log10(least) * per_decade)
    return [least * (0.9 / least) ** ((k + draw.random()) / n) for k in range(n)]


ON_IT = 2e-18  # where the plot shows a distance of 0
FAMILIES = ["round axis 3: Ω = (3 − 3δ, ±½, 1), μ = (4, 5, 9)", "round axis 1: Ω = (3 + 3δ, ±½, 1), μ = (4, 5, 9)",
            "wingnut: Ω = (δ, 1, δ), μ = (1, 2, 3)"]


def near_separatrix(family, draw, delta):
    """A body of the family, and how far it is from the separatrix after its numbers are rounded."""
    if family == 2:
        return Body(FAMILIES[2], [1.0, 2.0, 3.0], [delta, 1.0, delta]), delta
    outer = 3.0 * (1 + (-1, 1)[family] * delta)
    if delta > 0 and outer == 3:
        outer = 3 + (-1, 1)[family] * 2.0 ** -51  # the double next to it
    return Body(FAMILIES[family], [4.0, 5.0, 9.0], [outer, draw.choice((-0.5, 0.5)), 1.0]), abs(outer - 3) / 3


def separatrix_cases(family):
    """At times within five periods."""
    draw = random.Random(40 + family)
    cases = []
    for delta in distances(draw, 1e-16, 24):
        body, distance = near_separatrix(family, draw, delta)
        span = 5 * period(body)
        cases.append(Case(body, draw.uniform(-span, span), distance))
    for _ in range(12):
        body, _ = near_separatrix(family, draw, 0.0)
        cases.append(Case(body, draw.uniform(-100, 100), ON_IT * 2 ** draw.uniform(-1, 1)))
    return cases


# ----------------------------------------------------------------------------- plots
def shown(values):
    return [max(v, LOWEST) for v in values]


def scatter(axes, xs, errors, label, colour, marker, **more):
    style = dict(linestyle="none", marker=marker, color=colour, markersize=4.2, markeredgewidth=0, alpha=0.85)
    style.update(more)
    axes[0].plot(xs, shown([e.attitude for e in errors]), label=label, **style)
    axes[1].plot(xs, shown([e.omega for e in errors]), **style)


def new_figure(title, highest):
    plt.rcParams.update({"font.family": "DejaVu Sans", "font.size": 11, "axes.titlesize": 12, "legend.fontsize": 10})
    figure, axes = plt.subplots(2, 1, sharex=True, figsize=(9.6, 9.2))
    axes[0].set_title(title, fontsize=13.5, pad=12)
    axes[0].set_ylabel("error of the attitude [rad]")
    axes[1].set_ylabel("error of Ω, relative to |Ω|")
    for a in axes:
        a.set_xscale("log")
        a.set_yscale("log")
        a.set_ylim(LOWEST / 2, highest)
        a.set_yticks([10.0 ** k for k in range(-18, 1, 3) if 10.0 ** k <= highest])
        a.minorticks_off()
        a.grid(True, color="#e4e4e4", linewidth=0.8)
        a.set_axisbelow(True)
        a.axhline(GOAL, color="black", linewidth=1.3, linestyle="--", zorder=3)
    return figure, axes


def save(figure, axes, columns, path):
    axes[0].plot([], [], color="black", linewidth=1.3, linestyle="--", label="goal: 2e-15")
    handles, labels = axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=columns, frameon=False, markerscale=1.7, handletextpad=0.5)
    rows = -(-len(labels) // columns)
    figure.tight_layout(rect=(0, 0.012 + 0.024 * rows, 1, 1))
    temporary = path + ".part"
    figure.savefig(temporary, format="png", dpi=140)
    plt.close(figure)
    os.replace(temporary, path)


def plot_against_time(program, out):
    figure, axes = new_figure("The closed form in double precision: its error does not grow with time", 1e-3)
    found = []

    for k, (body, (colour, marker)) in enumerate(zip(BODIES, STYLES)):
        cases = [Case(body, t, abs(t)) for t in times(random.Random(k), 1e-3, 1e10, 12)]
        errors = [error(truth(c.body, c.t), s) for c, s in zip(cases, propagate(program, cases))]
        scatter(axes, [c.x for c in cases], errors, body.name, colour, marker)
        found += errors

    contrast = BODIES[0]
    draw = random.Random(7)
    stepped = [Case(contrast, t, abs(t)) for t in times(draw, 1e-3, MOST_STEPS * STEP, 6)]
    states = propagate(program, stepped, "--method", "rk4", "--step", repr(STEP))
    scatter(axes, [c.x for c in stepped], [error(truth(c.body, c.t), s) for c, s in zip(stepped, states)],
            "for contrast: rk4 at h = 1 ms", GREY, "+", markersize=6, markeredgewidth=1.3, zorder=1.5)
    printed = [Case(contrast, t, abs(t)) for t in times(draw, 1e-3, 1e10, 6)]
    scatter(axes, [c.x for c in printed],
            [error(truth(c.body, c.t), textbook(c.body.moments, ATTITUDE, c.body.omega, c.t)) for c in printed],
            "for contrast: textbook formulas", GREY, "x", markersize=5, markeredgewidth=1.3, zorder=1.5)
    last_bit = []
    for t in [10.0 ** (k / 2) for k in range(-6, 21)]:
        c = reference.condition(contrast.moments, ATTITUDE, contrast.omega, t, truth(contrast, t), DIGITS)
        last_bit.append((t, Error(16 * float(c[0]) + 1e-15, 16 * float(c[1]) + 1e-15)))
    for a, quantity in zip(axes, ("attitude", "omega")):
        a.plot([t for t, _ in last_bit], [getattr(e, quantity) for _, e in last_bit], color=DARK, linewidth=1.3,
               linestyle=":", label="16 × effect of ½ ulp of one input, + 1e-15")

    axes[1].set_xlabel("|t| [s], both signs of t")
    axes[1].set_xlim(6e-4, 1.7e10)
    axes[1].set_xticks([10.0 ** k for k in range(-3, 11)])
    save(figure, axes, 2, os.path.join(out, "closed_form_error_time.png"))
    return found


def plot_against_distance(program, out):
    figure, axes = new_figure("The closed form in double precision: the separatrix makes no difference", NO_ANSWER)
    found, by_textbook = [], []
    without = 0
    for family, name in enumerate(FAMILIES):
        cases = separatrix_cases(family)
        truths = [truth(c.body, c.t) for c in cases]
        errors = [error(x, s) for x, s in zip(truths, propagate(program, cases))]
        scatter(axes, [c.x for c in cases], errors, name, *STYLES[(0, 3, 2)[family]])
        found += errors
        for case, true in zip(cases[::3], truths[::3]):
            state = textbook(case.body.moments, ATTITUDE, case.body.omega, case.t)
            without += state is None
            by_textbook.append((case.x, error(true, state) if state else Error(NO_ANSWER, NO_ANSWER)))
    scatter(axes, [x for x, _ in by_textbook], [e for _, e in by_textbook],
            "for contrast: textbook formulas (top edge: no answer)", GREY, "x", markersize=5, markeredgewidth=1.3,
            zorder=1.5, clip_on=False)
    for a in axes:
        a.axvspan(1e-19, 2e-17, color="#f2f2f2", zorder=0)
    axes[1].set_xlabel("distance δ from the separatrix; in the shaded strip: exactly on it")
    axes[1].set_xlim(5e-19, 1.5)
    axes[1].set_xticks([ON_IT] + [10.0 ** k for k in range(-16, 1, 2)])
    axes[1].set_xticklabels(["0"] + ["$10^{%d}$" % k for k in range(-16, 1, 2)])
    save(figure, axes, 2, os.path.join(out, "closed_form_error_separatrix.png"))
    print("textbook formulas: no answer to %d of %d" % (without, len(by_textbook)))
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--propagate", metavar="FILE", default=os.path.join(ROOT, "build/devel/lib/poinsot/propagate"))
    parser.add_argument("--out", metavar="DIRECTORY", default=os.path.join(ROOT, "doc"))
    options = parser.parse_args()
    if not os.access(options.propagate, os.X_OK):
        parser.error("expected the program propagate, which scripts/build.sh builds, found no %s" % options.propagate)
    if not os.path.isdir(options.out):
        parser.error("--out: expected a directory, got %s" % options.out)

    good = True
    for name, plot in (("against time", plot_against_time), ("against the separatrix", plot_against_distance)):
        errors = plot(options.propagate, options.out)
        most = worst(errors)
        good = good and most.attitude <= GOAL and most.omega <= GOAL
        print("%s: %d states, worst attitude %.2g rad, worst Omega %.2g" % (name, len(errors), *most))
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
