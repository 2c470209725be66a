#!/usr/bin/python3
"""Runs work_precision as a stranger does, and judges its CSV and its pictures.

Usage: test_work_precision.py [PROGRAM]    The last line reads "N passed, M failed".
"""
import csv
import math
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "test"))
from checks import check, finish  # noqa: E402
PROGRAM = sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "build", "devel", "lib", "poinsot", "work_precision")
HEADER = "body,method,step,horizon,max_error_rad,energy_drift,momentum_drift,norm_drift,ns_per_step,cpu_s,evaluations"
ORDERS = {"lie_euler": 1, "buss2": 2, "buss3": 3, "buss4": 4, "rk4": 4, "rkmk4": 4, "cf4": 4, "midpoint": 2, "splitting2": 2,
          "splitting4": 4, "splitting6": 6, "dmv2": 2, "dmv4": 4, "dmv6": 6, "dmv8": 8, "dmv10": 10}
KEEP_MOMENTUM = set(ORDERS) - {"rk4"}
KEEP_ENERGY = {"dmv2", "dmv4", "dmv6", "dmv8", "dmv10"}
BODIES = ["dzhanibekov_slow", "dzhanibekov_fast", "t_handle", "near_symmetric", "near_separatrix", "extreme_ratio"]



def run(*words, **options):
    return subprocess.run([PROGRAM] + list(words), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options)


def malformed(text):
    """What is wrong with a CSV."""
    lines = text.splitlines()
    if not lines or lines[0] != HEADER:
        return ["the header is %r" % (lines[0] if lines else "")]
    out = [] if len(lines) > 1 else ["no rows"]
    for number, line in enumerate(lines[1:], 2):
        cells = line.split(",")
        if len(cells) != 11:
            out.append("line %d: %d cells" % (number, len(cells)))
            continue
        try:
            step, horizon, error, energy, momentum, norm, ns, cpu, evaluations = map(float, cells[2:])
        except ValueError as objection:
            out.append("line %d: %s" % (number, objection))
            continue
        if math.isnan(step) != (cells[1] == "closed_form"):
            out.append("line %d: a step of %s for %s" % (number, cells[2], cells[1]))
        elif not math.isnan(step):
            if not 0 < step <= horizon:
                out.append("line %d: a step of %s" % (number, cells[2]))
            elif not abs(ns * 1e-9 * horizon / step / cpu - 1) < 1e-3:
                out.append("line %d: ns_per_step and cpu_s do not agree" % number)
            elif cells[1] == "rk4" and evaluations != 4 * round(horizon / step):
                out.append("line %d: %s evaluations" % (number, cells[10]))
        if not (error >= 0 and energy >= 0 and momentum >= 0 and norm >= 0 and cpu > 0):
            out.append("line %d: a negative or undefined figure" % number)
        if horizon != 100:
            out.append("line %d: horizon %s" % (number, cells[3]))
    return out


def rows_of(text):
    return [{key: value if key in ("body", "method") else float(value) for key, value in row.items()}
            for row in csv.DictReader(text.splitlines())]


def wrong_errors(rows, tolerance):
    """Errors must fall with the order of the method, where neither saturated nor rounding."""
    out = []
    for body in BODIES:
        for method, order in ORDERS.items():
            ladder = sorted((r["step"], r["max_error_rad"]) for r in rows if (r["body"], r["method"]) == (body, method))
            pairs = [(h, e, math.log(e / f) / math.log(h / g)) for (g, f), (h, e) in zip(ladder, ladder[1:])
                     if 1e-10 < f and e < 1e-2 and h < 1.99 * 4 * g]
            for h, e, slope in pairs:
                if slope < order - tolerance:
                    out.append("%s, %s at %.3g: order %.2f" % (body, method, h, slope))
    return out


def wrong_invariants(rows):
    out = []
    for row in rows:
        where = "%s, %s, step %.3g: " % (row["body"], row["method"], row["step"])
        own = row["method"] in ORDERS or row["method"] == "closed_form"
        if own and row["norm_drift"] > 1e-15:
            out.append(where + "norm %.2g" % row["norm_drift"])
        if (row["method"] in KEEP_MOMENTUM or row["method"] == "closed_form") and row["momentum_drift"] > 4e-15:
            out.append(where + "L %.2g" % row["momentum_drift"])
        if (row["method"] in KEEP_ENERGY or row["method"] == "closed_form") and row["energy_drift"] > 1e-13:
            out.append(where + "E %.2g" % row["energy_drift"])
        if row["method"] == "closed_form" and row["max_error_rad"] > 2e-15:
            out.append(where + "error %.2g" % row["max_error_rad"])
    return out


def missing(rows):
    present = {(r["body"], r["method"]) for r in rows}
    wanted = {(b, m) for b in BODIES for m in list(ORDERS) + ["closed_form", "odeint_dopri5_adaptive"]}
    return ["%s, %s" % pair for pair in sorted(wanted - present)]


def main():
    with tempfile.TemporaryDirectory() as folder:
        table, png, svg = (os.path.join(folder, name) for name in ("a.csv", "a.png", "a.svg"))
        said = run("--quick", "--csv", table, "--plot", png, "--plot", svg)
        check("work_precision --quick", [] if said.returncode == 0 else [said.stderr[-300:]])
        text = open(table).read() if os.path.exists(table) else ""
        check("its CSV is well formed", malformed(text))
        rows = rows_of(text)
        check("every body and method is in it", missing(rows))
        check("errors fall with the order", wrong_errors(rows, 0.6))
        check("invariants are kept by those that keep them", wrong_invariants(rows))
        check("the table names the cheapest for each level", [] if said.stdout.count("cheapest for an error") == 6 and
              "all: closed_form" in said.stdout else [said.stdout[:200]])
        check("the PNG is a PNG", [] if os.path.exists(png) and open(png, "rb").read(8) == b"\x89PNG\r\n\x1a\n" else ["no"])
        drawn = "".join(xml.etree.ElementTree.parse(svg).getroot().itertext()) if os.path.exists(svg) else ""
        check("the SVG shows every body, the frontier and the peers",
              [word for word in BODIES + ["frontier", "closed_form", "Boost.odeint"] if word not in drawn])
        check("nothing else is left", [name for name in os.listdir(folder) if name not in ("a.csv", "a.png", "a.svg")])

        # The checks above can fail.
        broken = text.splitlines()
        check("a CSV without a column is caught", [] if malformed("\n".join(l.rsplit(",", 1)[0] for l in broken)) else ["no"])
        check("a row that is cut is caught", [] if malformed(text[:-20]) else ["no"])
        doubled = [dict(r, max_error_rad=r["max_error_rad"] ** 0.5) for r in rows]
        check("half the order is caught", [] if wrong_errors(doubled, 0.6) else ["no"])
        drifting = [dict(r, momentum_drift=1e-13) for r in rows]
        check("a drift of L is caught", [] if wrong_invariants(drifting) else ["no"])

        ticks = os.path.join(folder, "ticks.csv")
        said = run("--quick", "--mode", "ticks", "--body", "t_handle", "--method", "closed_form,dmv8,rk4", "--csv", ticks)
        rows = rows_of(open(ticks).read()) if said.returncode == 0 else []
        check("a state at every tick", [] if {r["method"] for r in rows} == {"closed_form", "dmv8", "rk4"} and
              all(math.isnan(r["step"]) or r["step"] < 1 / 59.9 for r in rows) and not wrong_invariants(rows)
              else [said.stderr, str(rows)[:300]])

        for words, needed in ((["--mode", "all"], "invalid choice"), (["--plot", "a.gif"], ".png or .svg"),
                              (["--body", "brick"], "there is no body \"brick\"; there is dzhanibekov_slow"),
                              (["--method", "euler"], "there is no method \"euler\"; there is closed_form"),
                              (["--horizon", "7"], "invalid choice"), (["extra"], "unrecognized")):
            said = run("--quick", *words)
            check("refused: " + " ".join(words),
                  [] if said.returncode == 2 and needed in said.stderr and not said.stdout else
                  ["exit %d" % said.returncode, said.stderr[-200:]])
        said = run("--quick", "--method", "closed_form", "--csv", os.path.join(folder, "no", "a.csv"))
        check("a folder that is not there", [] if said.returncode == 1 and "no/a.csv cannot be written" in said.stderr else
              ["exit %d" % said.returncode, said.stderr[-200:]])
        said = run("--help")
        check("--help", [] if said.returncode == 0 and "--quick" in said.stdout else [said.stderr])
    sys.exit(finish())


if __name__ == "__main__":
    main()
