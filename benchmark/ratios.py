#!/usr/bin/python3
"""Measures the closed form and the steppers against one step of a general solver, and judges the ratios.

Usage: ratios.py [--program FILE] [--runs N] [--repetitions N] [--min-time S] [--csv FILE] [--markdown FILE]

Runs the program `benchmarks` for each instruction set that this processor has, with repetitions interleaved at random, and
takes medians of CPU time. Ratios are to peer/odeint_rk4_step of the same run. Exit: 0 when every target is met in every
run, 1 when one is missed, 2 for bad use.
"""
import argparse
import csv
import json
import os
import statistics
import subprocess
import sys

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), ".."))
PEER = "peer/odeint_rk4_step"

# What the library asks of a processor before it uses an instruction set, as Linux names it; the best comes last.
LEVELS = [
    ("baseline", set()),
    ("x86-64-v3", {"avx2", "fma"}),
    ("x86-64-v4", {"avx2", "fma", "avx512f", "avx512bw", "avx512dq", "avx512vl"}),
]

FAR = ["general", "symmetric", "steady", "far_time", "extreme_ratio"]
NEAR = ["towards_separatrix", "near_separatrix", "at_separatrix", "near_unstable_axis_1e-140", "dzhanibekov"]


def targets(level, best):
    """{name: (most, unit)}; unit "peer" for a ratio, "ns" for a time. Targets that do not depend on the instruction set
    are judged on the best one, which is the one that runs."""
    wanted = {}
    for regime in FAR + NEAR:
        for states in (6000, 100):
            most = 0.6 if level == "baseline" else {6000: 0.2, 100: 0.4}[states]
            wanted["closed_form/sample_per_state/%s/%d" % (regime, states)] = (most, "peer")
        if best:
            wanted["closed_form/at/" + regime] = (1.3 if regime in FAR else 2, "peer")
            wanted["closed_form/setup/" + regime] = (6000, "ns")
    wanted["closed_form/sample_per_state"] = wanted["closed_form/sample_per_state/general/6000"]
    if best:
        wanted["closed_form/at"] = wanted["closed_form/at/general"]
        wanted["closed_form/setup"] = wanted["closed_form/setup/general"]
        for method in ("lie_euler", "buss2"):
            for suffix in ("", "/near_separatrix"):
                wanted["step/" + method + suffix] = (1, "peer")
    return wanted


def available_levels():
    """Their names; [None], the program's own choice, where there is only one."""
    try:
        with open("/proc/cpuinfo") as handle:
            flags = next((line.split(":")[1].split() for line in handle if line.startswith("flags")), [])
    except OSError:
        flags = []
    if "sse2" not in flags:
        return [None]
    found = []
    for name, needed in LEVELS:
        if not needed <= set(flags):
            break
        found.append(name)
    return found


def measure(program, level, repetitions, min_time):
    """{name: median CPU time in ns}"""
    environment = dict(os.environ)
    environment.pop("POINSOT_SIMD", None)
    if level:
        environment["POINSOT_SIMD"] = level
    said = subprocess.run([program, "--benchmark_format=json", "--benchmark_repetitions=%d" % repetitions,
                           "--benchmark_enable_random_interleaving=true", "--benchmark_min_time=%g" % min_time],
                          env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if said.returncode:
        sys.exit("%s exits %d:\n%s" % (program, said.returncode, said.stderr))
    times = {}
    for entry in json.loads(said.stdout)["benchmarks"]:
        if entry["run_type"] == "iteration":
            times.setdefault(entry["run_name"], []).append(entry["cpu_time"] * {"ns": 1, "us": 1e3}[entry["time_unit"]])
    return {name: statistics.median(values) for name, values in times.items()}


def judge(times, wanted, level, run, rows):
    """Prints a table; returns the names that miss their targets."""
    peer = times[PEER]
    missed = []
    print("\nrun %d, %s: %s is %.1f ns" % (run, level or "no instruction sets to choose from", PEER, peer))
    print("%-58s %9s %7s %7s" % ("", "ns", "ratio", "target"))
    for name in sorted(set(times) | set(wanted)):
        if name == PEER:
            continue
        most, unit = wanted.get(name, (None, None))
        if name not in times:
            print("%-58s not measured" % name)
            missed.append(name)
            continue
        figure = times[name] if unit == "ns" else times[name] / peer
        good = most is None or figure <= most
        target = "" if most is None else "%g us" % (most / 1e3) if unit == "ns" else "%g" % most
        print("%-58s %9.1f %7.3f %7s%s" % (name, times[name], times[name] / peer, target, "" if good else "  MISSED"))
        rows.append([run, level or "", name, "%.2f" % times[name], "%.4f" % (times[name] / peer), target,
                     "" if most is None else "yes" if good else "no"])
        if not good:
            missed.append(name)
    return missed


def markdown(figures, levels):
    """The tables of doc/benchmarks.md, from {level: [{name: ns} of each run]}: the worst of the runs."""
    def worst(level, name, unit):
        return max(times[name] / (times[PEER] if unit == "peer" else 1) for times in figures[level])

    def cell(level, name):
        most, unit = targets(level, level == levels[-1]).get(name, (None, "peer"))
        figure = worst(level, name, unit)
        text = "%.1f µs" % (figure / 1e3) if unit == "ns" else "%.2f" % figure
        return text if most is None or figure <= most else "**%s**" % text

    best = levels[-1]
    lines = ["| regime | setup | at | " + " | ".join("6000, %s | 100, %s" % (level, level) for level in reversed(levels)) + " |",
             "|---|" + "--:|" * (2 + 2 * len(levels))]
    for regime in FAR + NEAR:
        cells = [cell(best, "closed_form/setup/" + regime), cell(best, "closed_form/at/" + regime)]
        cells += [cell(level, "closed_form/sample_per_state/%s/%d" % (regime, states))
                  for level in reversed(levels) for states in (6000, 100)]
        lines.append("| %s | %s |" % (regime, " | ".join(cells)))
    lines += ["", "| step | far | near the separatrix |", "|---|--:|--:|"]
    for name in sorted(figures[best][0]):
        if name.startswith("step/") and name.count("/") == 1:
            lines.append("| %s | %s | %s |" % (name[5:], cell(best, name), cell(best, name + "/near_separatrix")))
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=os.path.join(ROOT, "build/devel/lib/poinsot/benchmarks"))
    parser.add_argument("--runs", type=int, default=1, help="how often to do it all (1)")
    parser.add_argument("--repetitions", type=int, default=9, help="of each benchmark in a run (9)")
    parser.add_argument("--min-time", type=float, default=0.02, help="seconds of one repetition (0.02)")
    parser.add_argument("--csv", metavar="FILE", help="writes all figures there too")
    parser.add_argument("--markdown", metavar="FILE", help="writes the tables of doc/benchmarks.md there")
    options = parser.parse_args()
    if options.runs < 1 or options.repetitions < 1 or not options.min_time > 0:
        parser.error("expected positive numbers for runs, repetitions and min-time")
    if not os.access(options.program, os.X_OK):
        parser.error("expected the program benchmarks (doc/benchmarks.md says how to build it), found no %s" % options.program)

    rows, missed = [], []
    levels = available_levels()
    figures = {level: [] for level in levels}
    for run in range(1, options.runs + 1):
        for level in levels:
            times = measure(options.program, level, options.repetitions, options.min_time)
            figures[level].append(times)
            names = judge(times, targets(level, level == levels[-1]), level, run, rows)
            missed += ["run %d, %s: %s" % (run, level, name) for name in names]
    if options.csv:
        with open(options.csv, "w", newline="") as handle:
            writer = csv.writer(handle)
            writer.writerow(["run", "level", "name", "ns", "ratio", "target", "met"])
            writer.writerows(rows)
    if options.markdown:
        with open(options.markdown, "w") as handle:
            handle.write(markdown(figures, levels))
    print("\n%d targets judged, %d missed" % (sum(1 for row in rows if row[-1]), len(missed)))
    for line in missed:
        print("    " + line)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
