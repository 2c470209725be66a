#!/usr/bin/env python3
"""Writes scenes/hundred.yaml: a hundred free bodies, with another box in each row and another spin in each column."""
import math
import os

ROWS, COLUMNS = 10, 10
WIDTH, HEIGHT = 2.2, 1.4  # of a cell [m]
RATE = 3.0  # |Omega| [rad/s]
SMALLEST, LARGEST = "[0.35, 0.72, 0.55]", "[0.78, 0.55, 0.86]"  # colours of the two families

HEAD = """\
# A hundred bodies. Each row has another box, from a stick (top) to a plate (bottom). From left to right they are spun
# ever further from the axis of smallest moment, towards that of largest. Those on the left keep spinning like a spear,
# those on the right like a discus; in between they tumble: Omega goes round the axis of largest moment in 57 of them,
# and round that of smallest in the others. The line is the border between the two, the separatrix.
# Numbers: ours; 3 rad/s each, Omega 5, 13.9, 22.8 ... 85 degrees from x towards z. By scripts/make_hundred.py.
rate: 60
bodies:
"""


def shape(row):
    """A box 1.2 m long."""
    share = row / (ROWS - 1.0)
    return "{type: box, size: [1.2, %.3g, %.3g], mass: 1}" % (0.36 + 0.68 * share, 0.3 - 0.2 * share)


def moments(row):
    share = row / (ROWS - 1.0)
    sizes = 1.2, float("%.3g" % (0.36 + 0.68 * share)), float("%.3g" % (0.3 - 0.2 * share))
    return [(sum(s * s for s in sizes) - size * size) / 12 for size in sizes]


def border(row):
    """The angle from the axis of smallest moment at which Omega is on the separatrix: mu1 (mu2 - mu1) Omega1^2 =
    mu3 (mu3 - mu2) Omega3^2."""
    small, middle, large = moments(row)
    return math.degrees(math.atan(math.sqrt(small * (middle - small) / (large * (large - middle)))))


def place(row, column):
    return WIDTH * (column - 0.5 * (COLUMNS - 1)), HEIGHT * (0.5 * (ROWS - 1) - row)


def line(row, column):
    angle = math.radians(5 + 80.0 * column / (COLUMNS - 1))
    box = "&row%d %s" % (row, shape(row)) if column == 0 else "*row%d" % row
    omega = "[%.4f, 0, %.4f]" % (RATE * math.cos(angle), RATE * math.sin(angle))
    colour = SMALLEST if math.degrees(angle) < border(row) else LARGEST
    return ("  - {name: r%dc%d, shape: %s, angular_velocity: %s, pictures: none, colour: %s, "
            "effects: [{type: translation, position: [0, %g, %g]}]}\n" % ((row, column, box, omega, colour) + place(row, column)))


def drawings():
    points = []
    for row in range(ROWS):
        y, z = place(row, (border(row) - 5) / 80 * (COLUMNS - 1))
        if row == 0:
            points.append("[0, %.4g, %.4g]" % (y, z + .5 * HEIGHT))
        points.append("[0, %.4g, %.4g]" % (y, z))
    points.append("[0, %.4g, %.4g]" % (y, z - .5 * HEIGHT))
    left, top = place(0, 0)
    right, bottom = place(ROWS - 1, COLUMNS - 1)
    texts = [("Omega goes round the axis of smallest moment", .5 * left, top + 1.5, SMALLEST),
             ("round that of largest", .55 * right, top + 1.5, LARGEST),
             ("stick", left - 2.2, top, None), ("plate", left - 2.2, bottom, None),
             ("spun about the long axis", .6 * left, bottom - 1.5, None),
             ("spun about the short axis", .6 * right, bottom - 1.5, None)]
    out = "drawings:\n  - {type: line, points: [%s]}\n" % ", ".join(points)
    for words, y, z, colour in texts:
        out += "  - {type: text, text: %s, position: [0, %.4g, %.4g]%s}\n" % (
            words, y, z, ", colour: " + colour if colour else "")
    return out


def main():
    root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
    with open(os.path.join(root, "scenes", "hundred.yaml"), "w") as out:
        out.write(HEAD)
        for row in range(ROWS):
            out.writelines(line(row, column) for column in range(COLUMNS))
        out.write(drawings())


if __name__ == "__main__":
    main()
