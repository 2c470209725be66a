#!/usr/bin/python3
"""Compares the cost in `simulate` of a body among many with that of one alone.

Usage: many_bodies.py SIMULATE [--bodies N] [--duration S] [--bag]

Writes a scene of N ordinary bodies, each at a place of its own, and runs SIMULATE (the path of the program) on it and on
its first body. Prints CPU time, user and system, the least of three runs. The start of the program is measured by a run
of two states and printed separately.
"""
import argparse
import os
import random
import resource
import subprocess
import sys
import tempfile


def scene(count):
    draw = random.Random(1)
    lines = ["bodies:"]
    for i in range(count):
        moments = [draw.uniform(1, 2), draw.uniform(2, 2.5), draw.uniform(2.5, 3)]
        omega = [draw.uniform(-1, 1) for _ in range(3)]
        lines.append("  - {name: b%d, inertia: %s, angular_velocity: %s, effects: [{type: translation, position: "
                     "[%d, %d, 0]}]}" % (i, moments, omega, 10 * (i % 100), 10 * (i // 100)))
    return "\n".join(lines) + "\n"


def cpu(command):
    def used():
        u = resource.getrusage(resource.RUSAGE_CHILDREN)
        return u.ru_utime + u.ru_stime
    best = float("inf")
    for _ in range(3):
        before = used()
        subprocess.run(command, check=True)
        best = min(best, used() - before)
    return best


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("simulate")
    parser.add_argument("--bodies", type=int, default=10000)
    parser.add_argument("--duration", type=float, default=100)
    parser.add_argument("--bag", action="store_true", help="a bag without markers instead of CSV to /dev/null")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as directory:
        out = ["--bag", os.path.join(directory, "out.bag"), "--no-markers"] if options.bag else ["--csv", "/dev/null"]

        def run(bodies, duration):
            path = os.path.join(directory, "%d.yaml" % bodies)
            with open(path, "w") as file:
                file.write(scene(bodies))
            return cpu([options.simulate, path, "--duration", repr(duration), "--rate", "60"] + out)
        states = 60 * options.duration
        start, one = run(1, 1e-3), run(1, options.duration)
        # The states of one body take too little time to be distinguished from the start; a hundred times as many do not.
        long = (run(1, 100 * options.duration) - start) / (100 * states)
        begin, many = run(options.bodies, 1e-3), run(options.bodies, options.duration)
    each = (many - begin) / options.bodies / states
    print("whole runs: 1 body %.4g s, of it the start %.4g s; %d bodies %.4g s, of it start and reading %.4g s"
          % (one, start, options.bodies, many, begin))
    print("CPU time a body, whole runs: %.4g ms alone, %.4g ms among many, ratio %.3g"
          % (1e3 * one, 1e3 * many / options.bodies, many / options.bodies / one))
    print("CPU time a state, starts left out: %.3g us alone, %.3g us among many, ratio %.3g"
          % (1e6 * long, 1e6 * each, each / long))
    return 0


if __name__ == "__main__":
    sys.exit(main())
