#!/usr/bin/env python3
"""Writes scenes/hundred.yaml: a hundred free bodies, with another box in each row and another spin in each column."""
import math
import os

ROWS, COLUMNS = 10, 10
WIDTH, HEIGHT = 2.8, 1.6  # of a cell [m]
RATE = 3.0  # |Omega| [rad/s]

HEAD = """\
# A hundred bodies. Each row has another box, from a stick (top) to a plate (bottom). From left to right they are spun
# ever further from the axis of smallest moment, towards that of largest. Those on the left keep spinning like a spear,
# those on the right like a discus; in between they tumble: Omega goes round the axis of largest moment in 57 of them,
# and round that of smallest in the others. The border between the two is at another place in each row.
# (The view hides the pictures beside the bodies; RViz has them in Displays, under Still and Motion.)
# Numbers: ours; 3 rad/s each, Omega 5, 13.9, 22.8 ... 85 degrees from x towards z. By scripts/make_hundred.py.
rate: 60
bodies:
"""


def shape(row):
    """A box 1.2 m long."""
    share = row / (ROWS - 1.0)
    return "{type: box, size: [1.2, %.3g, %.3g], mass: 1}" % (0.36 + 0.68 * share, 0.3 - 0.2 * share)


def line(row, column):
    angle = math.radians(5 + 80.0 * column / (COLUMNS - 1))
    box = "&row%d %s" % (row, shape(row)) if column == 0 else "*row%d" % row
    omega = "[%.4f, 0, %.4f]" % (RATE * math.cos(angle), RATE * math.sin(angle))
    place = "[0, %g, %g]" % (WIDTH * (column - 0.5 * (COLUMNS - 1)), HEIGHT * (0.5 * (ROWS - 1) - row))
    return "  - {name: r%dc%d, shape: %s, angular_velocity: %s, effects: [{type: translation, position: %s}]}\n" % (
        row, column, box, omega, place)


def main():
    root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
    with open(os.path.join(root, "scenes", "hundred.yaml"), "w") as out:
        out.write(HEAD)
        for row in range(ROWS):
            out.writelines(line(row, column) for column in range(COLUMNS))


if __name__ == "__main__":
    main()
