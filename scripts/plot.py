#!/usr/bin/python3
"""Draws a motion from a CSV that `simulate` wrote, as a PNG or SVG file.

The picture has Omega(t) in body axes and the polhode, on which Omega moves. A CSV written with `--columns
states,energy,errors` also gives E(t), |L|(t), the attitude error and the energy drift. The same CSV gives the same picture.
The file comes whole or not at all. Exit: 0; 1 when it cannot be written; 2 for bad use or a bad CSV.
"""
import argparse
import array
import csv
import math
import os
import sys

STATES = ["body", "t", "qw", "qx", "qy", "qz", "O1", "O2", "O3", "bx", "by", "bz"]
ENERGY = ["E", "Lx", "Ly", "Lz"]
ERRORS = ["attitude_error", "energy_drift"]
MAY_BE_NAN = {"attitude_error"}  # under torques
DRAWN = ["t", "O1", "O2", "O3", "E", "Lx", "Ly", "Lz"] + ERRORS
ENDINGS = (".png", ".svg")
MOST_STATES = 2000000  # that are drawn: of one body
MOST_IN_POLHODE = 20000  # points: a picture shows no more

# The colours of the pictures in RViz; the three parts of Omega are told apart without colours, too.
PARTS = [("O1", r"$\Omega_1$", "#1a6bcc", "-"), ("O2", r"$\Omega_2$", "#cc5c38", "--"), ("O3", r"$\Omega_3$", "#2e333d", "-.")]
ENERGY_COLOUR, MOMENTUM_COLOUR, OMEGA_COLOUR, ERROR_COLOUR = "#c97f00", "#0f8f61", "#ed2178", "#9e7d05"


class Refusal(Exception):
    """Bad use or bad input."""


class Failure(Exception):
    """A picture that cannot be drawn or written."""


def read_header(row, name):
    """The columns besides those of the state, in their order."""
    known = [STATES, STATES + ENERGY, STATES + ERRORS, STATES + ENERGY + ERRORS]
    if row not in known:
        raise Refusal("%s:1: expected the columns of simulate, %s[,%s][,%s], got %s" % (
            name, ",".join(STATES), ",".join(ENERGY), ",".join(ERRORS), shown(",".join(row))))
    return row[len(STATES):]


def shown(text):
    """A text of the input as messages show it: on one line, and not too long."""
    text = "".join(c if c.isprintable() else " " for c in text)
    return '"%s"' % (text if len(text) <= 60 else text[:60] + "…")


def number(text, column, place):
    try:
        value = float(text)
    except ValueError:
        value = math.inf
    if math.isfinite(value) or (math.isnan(value) and column in MAY_BE_NAN):
        return value
    raise Refusal("%s: %s: expected a finite number, got %s" % (place, column, shown(text)))


def read(name, body):
    """
    The name of the body that is drawn, how many others the file has, and those of its columns that are drawn, {name:
    values}. Without a name, it is the first one.
    """
    columns, others = None, []
    with open(name, newline="", encoding="utf-8") as file:
        rows = csv.reader(file, strict=True)
        header = next(rows, [])
        names = STATES + read_header(header, name)
        for row in rows:
            place = "%s:%d" % (name, rows.line_num)
            if len(row) != len(names):
                raise Refusal("%s: expected %d cells, got %d" % (place, len(names), len(row)))
            body = body or row[0]
            if row[0] != body:
                if not others or others[-1] != row[0]:
                    others.append(row[0])
                continue
            values = [number(text, column, place) for text, column in zip(row[1:], names[1:])]
            if columns is None:
                columns = {column: array.array("d") for column in names if column in DRAWN}
            elif values[0] <= columns["t"][-1]:
                raise Refusal("%s: t: expected a time after %.17g s, got %s" % (place, columns["t"][-1], row[1]))
            elif len(columns["t"]) == MOST_STATES:
                raise Refusal("%s: expected at most %d states of body %s, got more" % (place, MOST_STATES, body))
            for column, value in zip(names[1:], values):
                if column in columns:
                    columns[column].append(value)
    if columns is None and others:
        raise Refusal("--body: expected one of %s, got %s" % (", ".join(others[:20]), shown(body)))
    if columns is None:
        raise Refusal("%s: expected at least one state, got none" % name)
    return body, len(others), columns


def read_or_explain(name, body):
    try:
        return read(name, body)
    except OSError as error:
        raise Refusal("%s: expected a CSV that simulate wrote, got none that can be read: %s" % (name, error.strerror))
    except UnicodeDecodeError:
        raise Refusal("%s: expected text in UTF-8, got other bytes" % name)
    except csv.Error as error:
        raise Refusal("%s: expected a CSV that simulate wrote, got another file: %s" % (name, error))


def set_steady_limits(panel, values):
    """Draws what does not change as a level line, not as the noise of its last digits."""
    low, high = min(values), max(values)
    if high - low <= 1e-6 * max(abs(low), abs(high)):
        margin = 0.1 * abs(high) or 1
        panel.set_ylim(low - margin, high + margin)


def add_legend(panel):
    """Names the curves above the panel, where no curve is."""
    panel.legend(loc="lower right", bbox_to_anchor=(1, 1), ncol=3, fontsize=8, frameon=False, borderaxespad=0.1)


def draw_errors(panel, columns):
    """Both errors on a logarithmic axis; zeros have no place there."""
    drawn = False
    for column, label, colour, style in (("attitude_error", "attitude error [rad]", OMEGA_COLOUR, "-"),
                                         ("energy_drift", "|energy drift|", ENERGY_COLOUR, "--")):
        values = [abs(value) or math.nan for value in columns[column]]
        if not all(math.isnan(value) for value in values):
            panel.semilogy(columns["t"], values, style, color=colour, linewidth=0.8, label=label)
            drawn = True
    if drawn:
        add_legend(panel)
    else:
        panel.set_yticks([])
        panel.text(0.5, 0.5, "no error", ha="center", va="center", transform=panel.transAxes)
    if all(math.isnan(value) for value in columns["attitude_error"]):
        panel.set_title("under torques: no closed form to compare with", fontsize=8, loc="left")
    panel.set_ylabel("errors")


def draw_polhode(panel, columns):
    """The path of Omega in body axes, in equal scales."""
    every = -(-len(columns["t"]) // MOST_IN_POLHODE)
    path = [columns[name][::every] for name in ("O1", "O2", "O3")]
    panel.plot(*path, color=OMEGA_COLOUR, linewidth=1)
    panel.plot(*([values[0]] for values in path), "o", color=OMEGA_COLOUR, markersize=5)
    middle = [(min(values) + max(values)) / 2 for values in path]
    half = max((max(values) - min(values)) / 2 for values in path)
    half = 1.05 * max(half, 1e-3 * max(abs(value) for value in middle)) or 1  # a point, or rest
    for axis, centre, label in zip("xyz", middle, (r"$\Omega_1$", r"$\Omega_2$", r"$\Omega_3$")):
        getattr(panel, "set_%slim" % axis)(centre - half, centre + half)
        getattr(panel, "set_%slabel" % axis)(label + " [rad/s]")
    panel.set_box_aspect((1, 1, 1), zoom=0.86)  # leaves room for the names of the axes
    panel.set_title("polhode (the dot: t = %g s)" % columns["t"][0], fontsize=10)


def draw(title, columns, path, ending):
    """Writes the picture to a path."""
    try:
        import matplotlib
    except ImportError:
        raise Failure("matplotlib is not installed; on Debian: scripts/setup.sh --plots")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    plt.rcParams.update({"font.size": 9, "svg.fonttype": "none", "svg.hashsalt": "poinsot", "agg.path.chunksize": 10000,
                         "axes.formatter.useoffset": False})
    has_energy, has_errors = "E" in columns, "attitude_error" in columns
    heights = [2] + [1, 1] * has_energy + [1.4] * has_errors
    figure = plt.figure(figsize=(11, 1.6 + 1.5 * sum(heights)), constrained_layout=True)
    grid = figure.add_gridspec(len(heights), 2, width_ratios=[1.25, 1], height_ratios=heights)
    panels = []
    for line in range(len(heights)):
        panels.append(figure.add_subplot(grid[line, 0], sharex=panels[0] if panels else None))
        panels[-1].grid(True, color="#dddddd", linewidth=0.6)
        panels[-1].tick_params(labelbottom=line == len(heights) - 1)
    panels[-1].set_xlabel("t [s]")
    for column, label, colour, style in PARTS:
        panels[0].plot(columns["t"], columns[column], style, color=colour, linewidth=1, label=label)
    add_legend(panels[0])
    panels[0].set_ylabel(r"$\Omega$ in body axes [rad/s]")
    if has_energy:
        size = [math.sqrt(x * x + y * y + z * z) for x, y, z in zip(*(columns[name] for name in ("Lx", "Ly", "Lz")))]
        for panel, values, label, colour in ((panels[1], columns["E"], "E [J]", ENERGY_COLOUR),
                                             (panels[2], size, "|L| [kg·m²/s]", MOMENTUM_COLOUR)):
            panel.plot(columns["t"], values, color=colour, linewidth=1)
            panel.set_ylabel(label)
            set_steady_limits(panel, values)
    if has_errors:
        draw_errors(panels[-1], columns)
    draw_polhode(figure.add_subplot(grid[:, 1], projection="3d"), columns)
    figure.suptitle(title)
    figure.savefig(path, format=ending[1:], dpi=110, metadata={"Date": None} if ending == ".svg" else {})


def write_whole(path, write):
    """Calls write() with a path beside this one, and gives what is there this name once it is complete."""
    path = os.path.realpath(path)
    temporary = os.path.join(os.path.dirname(path), ".%s.%d.tmp" % (os.path.basename(path), os.getpid()))
    try:
        write(temporary)
        os.replace(temporary, path)
    except OSError as error:
        raise Failure("cannot write %s: %s" % (path, error.strerror))
    finally:
        if os.path.lexists(temporary):
            os.remove(temporary)


class Parser(argparse.ArgumentParser):
    def error(self, message):
        self.exit(2, "plot.py: %s; see plot.py --help\n" % message)


def main():
    parser = Parser(prog="plot.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("csv", metavar="MOTION.csv", help="what simulate wrote")
    parser.add_argument("--out", metavar="FILE", help="the picture, .png or .svg (default: MOTION.png)")
    parser.add_argument("--body", metavar="NAME", help="which body is drawn (default: the first)")
    words = parser.parse_args()
    out = words.out or os.path.splitext(words.csv)[0] + ".png"
    ending = os.path.splitext(out)[1].lower()
    try:
        if ending not in ENDINGS:
            raise Refusal("--out: expected a file that ends with .png or .svg, got %s" % shown(out))
        if os.path.realpath(out) == os.path.realpath(words.csv):
            raise Refusal("--out: expected a file other than the CSV, got %s" % shown(out))
        if words.body == "":
            raise Refusal("--body: expected a name, got \"\"")
        body, others, columns = read_or_explain(words.csv, words.body)
        if others and words.body is None:
            print("plot.py: %s is drawn, the first of %d bodies; --body NAME draws another" % (body, others + 1),
                  file=sys.stderr)
        write_whole(out, lambda path: draw("%s of %s" % (body, os.path.basename(words.csv)), columns, path, ending))
    except Refusal as refusal:
        print("plot.py: %s" % refusal, file=sys.stderr)
        return 2
    except Failure as failure:
        print("plot.py: %s" % failure, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
