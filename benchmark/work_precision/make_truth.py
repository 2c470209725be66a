#!/usr/bin/python3
"""Makes truth.cpp: the states of the bodies of work_precision at some times, to 25 digits.

Usage: make_truth.py --program work_precision_measure

The program lists the bodies. The truth is the closed form of test/data/reference.py with 60 digits; at 10 and 100 s it is
compared with a plain Taylor series, which uses no elliptic function. A difference above 1e-24 stops the script.
"""
import argparse
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "test", "data"))
import reference  # noqa: E402
from mpmath import mp, mpf  # noqa: E402

TIMES = [1.0, 3.0, 10.0, 25.0, 50.0, 75.0, 100.0, 300.0, 500.0, 1000.0]
CHECKED = [10.0, 100.0]


def digits(x):
    return mp.nstr(mpf(x), 25, strip_zeros=False)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", required=True)
    program = parser.parse_args().program
    listed = subprocess.run([program, "--bodies"], stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()
    lines = []
    for line in listed[1:]:
        name, *numbers = line.split(",")
        values = [float.fromhex(number) for number in numbers]
        mu, q0, omega = values[:3], values[3:7], values[7:]
        for t in TIMES:
            q, o = reference.closed_form(mu, q0, omega, t, digits=60)[:2]
            if t in CHECKED:
                mp.dps = 60
                q2, o2 = reference.taylor(mu, q0, omega, t, digits=40, maxsteps=200000)[:2]
                apart = reference.angle_between([mpf(str(x)) for x in q], [mpf(str(x)) for x in q2])
                if apart > mpf("1e-24"):
                    sys.exit("%s at t = %g: two ways differ by %s rad" % (name, t, mp.nstr(apart, 3)))
            lines.append('      {"%s",\n       {%r,\n        {%s, %s,\n         %s, %s},\n        {%s, %s,\n         %s}}},\n' % (
                (name, t) + tuple(digits(x) for x in q) + tuple(digits(x) for x in o)))
    target = os.path.join(HERE, "truth.cpp")
    with open(target + ".new", "w") as out:
        out.write('// Made by make_truth.py; do not edit.\n// clang-format off\n#include "bodies.h"\n\n'
                  "namespace poinsot::work_precision {\n\nconst std::vector<Truth>& truths() {\n"
                  "  static const std::vector<Truth> all = {\n%s  };\n  return all;\n}\n\n"
                  "}  // namespace poinsot::work_precision\n" % "".join(lines))
    os.replace(target + ".new", target)


if __name__ == "__main__":
    main()
