#!/usr/bin/python3
"""Holds the documents that programs write to what the programs say now, as far as that is the same in every run.

Usage: test_documents.py DIRECTORY    DIRECTORY holds the programs hard_cases and accuracy_choice. The last line reads
"N passed, M failed".
"""
import os
import re
import subprocess
import sys

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "test"))
from checks import check, finish  # noqa: E402
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w.])")
ROUNDOFF = 1e-11  # below it a figure is rounding, of which another instruction set leaves another amount



def document(name):
    with open(os.path.join(ROOT, "doc", name), encoding="utf-8") as handle:
        return handle.read().splitlines()


def output(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()


def between(lines, first, last=None):
    """The lines from the heading `first` to before the heading `last`."""
    start = lines.index(first)
    return lines[start:lines.index(last, start) if last else len(lines)]


def last_digit(text):
    """One unit of the last digit that is written."""
    mantissa, _, exponent = text.partition("e")
    decimals = len(mantissa.partition(".")[2])
    return 10.0 ** (int(exponent or 0) - decimals)


def same_number(a, b):
    if a == b:
        return True
    x, y = abs(float(a)), abs(float(b))
    if x < ROUNDOFF and y < ROUNDOFF:
        return max(x, y) <= 3 * min(x, y)
    return abs(float(a) - float(b)) <= 1.01 * max(last_digit(a), last_digit(b))


def differences(shown, computed):
    """Complaints where lines differ by more than the last digit of a number."""
    if len(shown) != len(computed):
        return ["the document has %d lines, the program writes %d" % (len(shown), len(computed))]
    out = []
    for a, b in zip(shown, computed):
        same = NUMBER.split(a) == NUMBER.split(b) and all(map(same_number, NUMBER.findall(a), NUMBER.findall(b)))
        if not same:
            out.append("expected %r, got %r" % (b, a))
    return out


def rows(lines):
    """The cells of the tables' rows, without their heads."""
    table = [line.strip("| ").split(" | ") for line in lines if line.startswith("|") and not line.startswith("|---")]
    return [row for row in table if not row[0].startswith(("accuracy", "torque"))]


def without_costs(lines):
    """A row of accuracy_cost.md without its two columns of time."""
    return [" | ".join(row[:4] + row[6:]) for row in rows(lines)]


def wrong_ratios(table):
    """Complaints about rows of torque_cost.md whose ratio is not that of their times, or above 1."""
    out = []
    for row in table:
        if len(row) < 7 or not row[6]:
            continue
        ours, others, ratio = float(row[3]), float(row[5]), float(row[6])
        if abs(ours / others - ratio) > 0.006:
            out.append("expected %.2f = %s / %s, got %s" % (ours / others, row[3], row[5], row[6]))
        if ratio > 1:
            out.append("expected a ratio of at most 1, got %s: %s at %s" % (row[6], row[0], row[1]))
    return out


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    programs = sys.argv[1]
    shown = between(document("hard_cases.md"), "## In short", "## 1e8 steps")
    computed = output(os.path.join(programs, "hard_cases"))
    while computed and not computed[-1]:
        computed.pop()
    while shown and not shown[-1]:
        shown.pop()
    check("doc/hard_cases.md shows what hard_cases writes", differences(shown, computed))
    place = next(i for i, line in enumerate(shown) if line.startswith("| separatrix |") and "e-" in line)
    altered = list(shown)
    altered[place] = re.sub(r"(\d)e-(\d+)", lambda m: m.group(1) + "e-%02d" % (int(m.group(2)) - 2), altered[place], count=1)
    check("and a figure that is off would be noticed", [] if len(differences(altered, computed)) == 1 else ["it is not"])

    section = between(document("accuracy_cost.md"), "## `accuracy:` in a scene, against an exhaustive search")
    computed = [" | ".join(row) for row in rows(output(os.path.join(programs, "accuracy_choice"), "--without-costs"))]
    check("doc/accuracy_cost.md shows the methods that accuracy_choice gets", differences(without_costs(section), computed))
    altered = [line.replace("dmv6 6", "dmv6 9") for line in computed]
    check("and another choice would be noticed", [] if differences(altered, computed) else ["it is not"])

    table = rows(document("torque_cost.md"))
    check("the ratios of doc/torque_cost.md are those of its times, and at most 1",
          wrong_ratios(table) if len(table) > 20 else ["only %d rows" % len(table)])
    slower = [table[0][:6] + ["1.20"]]
    check("and a ratio that is off would be noticed", [] if len(wrong_ratios(slower)) == 2 else ["it is not"])
    return finish()


if __name__ == "__main__":
    sys.exit(main())
