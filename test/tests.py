#!/usr/bin/python3
"""Which tests there are, and what came of them.

Usage: tests.py list BUILD [PATTERN]
       tests.py names BUILD quick|all|only:PATTERN
       tests.py needs BUILD quick|all|only:PATTERN
       tests.py count RESULTS
       tests.py report BUILD TIMES

list: a line for each test: name, tier, usual duration [s]. names: the CTest names of a tier, or of the tests whose name
matches the regular expression, one a line; exit 2 when there is none. needs: the targets that these need built. count: adds up
the JUnit files below a directory, prints what failed and last "N passed, M failed". report: reads what ctest left (BUILD/ctest.xml)
and what the tests wrote (BUILD/test_results), and prints each test's counts, what failed, the time of each stage, the
ten slowest tests, and last "N passed, M failed". TIMES holds lines "stage,seconds" of what was no test. All durations
go to BUILD/test_durations.csv. Exit of count and report: 0 when all passed, 1 when something failed, crashed, or nothing ran.
"""
import collections
import csv
import json
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

HERE = os.path.dirname(os.path.realpath(__file__))
USUAL = os.path.join(HERE, "durations.csv")
DURATIONS = "test_durations.csv"
TIERS = ("quick", "long")
SLOWEST = 10
SHOWN_LINES = 25  # of one failure

Test = collections.namedtuple("Test", "name ctest tier stage")


def short(ctest_name):
    """The name that users give: catkin's without its beginning."""
    return re.sub(r"^_ctest_poinsot_(gtest_|rostest_test_)", "", ctest_name.replace("roslaunch-check_launch", "gtest_launch_files"))


def registered(build):
    found = json.loads(subprocess.check_output(["ctest", "--test-dir", build, "--show-only=json-v1"]).decode())
    tests = []
    for entry in found["tests"]:
        labels = next((p["value"] for p in entry.get("properties", []) if p["name"] == "LABELS"), [])
        tier = [label for label in labels if label in TIERS]
        if len(tier) != 1:
            sys.exit("tests.py: %s is registered without a tier" % entry["name"])
        stage = [label for label in labels if label not in TIERS]
        tests.append(Test(short(entry["name"]), entry["name"], tier[0], stage[0] if stage else "other"))
    return sorted(tests)


def usual_durations(build):
    """Of the last run here, else of the table that comes with the package."""
    out = {}
    for path in (USUAL, os.path.join(build, DURATIONS)):
        if os.path.exists(path):
            with open(path) as table:
                out.update({row[0]: float(row[2]) for row in csv.reader(table) if len(row) == 3 and row[0] != "name"})
    return out


def listed(build, pattern):
    usual = usual_durations(build)
    for test in registered(build):
        if re.search(pattern, test.name):
            print("%-58s %-6s %s" % (test.name, test.tier, "%6.0f s" % usual[test.name] if test.name in usual else ""))
    return 0


def chosen(build, wanted):
    tests = registered(build)
    if wanted == "all":
        return tests
    if wanted == "quick":
        return [t for t in tests if t.tier == "quick"]
    return [t for t in tests if re.search(wanted[len("only:"):], t.name)]


def print_each(words):
    for word in words:
        print(word)
    return 0 if words else 2


def words_of(trouble):
    """Google Test says the same in the message and in the text, rostest does not."""
    message, text = (trouble.get("message") or "").strip(), (trouble.text or "").strip()
    return text if message in text else message + "\n" + text


def cases(path):
    """Yields (name, outcome, text) of each test case in a JUnit file."""
    try:
        root = ElementTree.parse(path).getroot()
    except (ElementTree.ParseError, OSError) as error:
        yield os.path.basename(path), "failed", "cannot be read: %s" % error
        return
    for case in root.iter("testcase"):
        name = "%s.%s" % (case.get("classname", ""), case.get("name", ""))
        trouble = [e for e in case if e.tag in ("failure", "error")]
        if trouble:
            yield name, "failed", "\n".join(words_of(e) for e in trouble).strip()
        elif case.get("status") == "notrun" or case.find("skipped") is not None:
            yield name, "skipped", (case.findtext("skipped") or "")
        else:
            yield name, "passed", ""


def counted(results):
    """Prints what each file below a directory says; the totals."""
    total = collections.Counter()
    files = sorted(os.path.join(folder, name) for folder, _, found in os.walk(results)
                   for name in found if name.endswith(".xml"))
    for path in files:
        count, said = collections.Counter(), []
        for name, outcome, text in cases(path):
            count[outcome] += 1
            if outcome != "passed":
                lines = text.splitlines()[:SHOWN_LINES]
                said.append("    %s %s\n%s" % (outcome.upper(), name, "\n".join("        " + t for t in lines)))
        if not sum(count.values()):
            count["failed"] = 1
            said.append("    FAILED: the file holds no test case")
        if said:
            print("%s: %d passed, %d failed" % (os.path.relpath(path, results), count["passed"], count["failed"]))
            print("\n".join(said))
        total += count
    if not files:
        print("no test wrote a result")
        total["failed"] += 1
    return total


def verdict(total):
    print("%d passed, %d failed" % (total["passed"], total["failed"]))
    return 1 if total["failed"] or not total["passed"] else 0


def ran(build):
    """[(name, seconds, passed, reason)] of ctest's own report."""
    out = []
    path = os.path.join(build, "ctest.xml")
    if os.path.exists(path):
        for case in ElementTree.parse(path).getroot().iter("testcase"):
            failure = case.find("failure")
            reason = (failure.get("message") or "") if failure is not None else case.get("status", "")
            out.append((case.get("name"), float(case.get("time", 0)), case.get("status") == "run", reason))
    return out


def tells_of_failure(build, name):
    """Whether the test has written a failure itself. One that crashed or ran out of time may not have."""
    stem = re.sub(r"\.test$", "", name)
    files = ["gtest-%s.xml" % name, "script-%s.xml" % name, "rostest-test_%s.xml" % stem]
    paths = [os.path.join(build, "test_results", "poinsot", file) for file in files]
    return any(outcome == "failed" for path in paths if os.path.exists(path) for _, outcome, _ in cases(path))


def report(build, times):
    known = {t.ctest: t for t in registered(build)}
    total = counted(os.path.join(build, "test_results"))

    stages, rows = collections.OrderedDict(), []
    with open(times) as table:
        for stage, seconds in csv.reader(table):
            stages[stage] = stages.get(stage, 0) + float(seconds)
    elapsed = sum(stages.values())
    for ctest_name, seconds, passed, reason in ran(build):
        test = known.get(ctest_name)
        if test is None:
            continue
        rows.append((test.name, test.tier, seconds))
        stages[test.stage] = stages.get(test.stage, 0) + seconds
        if not passed:
            print("%s: %s" % (test.name, reason))
            total["failed"] += not tells_of_failure(build, test.name)
    if not rows:
        print("no test ran")
        total["failed"] += not total["failed"]

    print("\n== time, tests side by side counted one by one")
    for stage, seconds in sorted(stages.items(), key=lambda entry: -entry[1]):
        print("%8.1f s  %s" % (seconds, stage))
    print("%8.1f s  in all, by the clock" % elapsed)
    print("\n== the slowest tests")
    for name, _, seconds in sorted(rows, key=lambda row: -row[2])[:SLOWEST]:
        print("%8.1f s  %s" % (seconds, name))
    # What did not run this time keeps its last duration.
    last = {}
    path = os.path.join(build, DURATIONS)
    if os.path.exists(path):
        with open(path) as table:
            last = {row[0]: row for row in csv.reader(table) if len(row) == 3 and row[0] != "name"}
    last.update({row[0]: (row[0], row[1], "%.1f" % row[2]) for row in rows})
    with open(path + ".partial", "w") as out:
        table = csv.writer(out, lineterminator="\n")
        table.writerow(("name", "tier", "seconds"))
        table.writerows(last[name] for name in sorted(last))
    os.replace(path + ".partial", path)
    print("\nall durations are in %s" % path)

    print("\n== result")
    print("%d skipped, see above" % total["skipped"] if total["skipped"] else "nothing was skipped")
    return verdict(total)


def main():
    words = sys.argv[1:]
    for word in words[2:3]:
        try:
            re.compile(word)
        except re.error as error:
            print("expected a regular expression, got '%s': %s" % (word.replace("only:", "", 1), error), file=sys.stderr)
            return 2
    if words[:1] == ["list"] and len(words) in (2, 3):
        return listed(words[1], words[2] if len(words) == 3 else "")
    if words[:1] == ["names"] and len(words) == 3:
        return print_each([test.ctest for test in chosen(words[1], words[2])])
    if words[:1] == ["needs"] and len(words) == 3:
        return print_each(["needs_" + re.sub("[^A-Za-z0-9_.-]", "_", test.name) for test in chosen(words[1], words[2])])
    if words[:1] == ["count"] and len(words) == 2:
        return verdict(counted(words[1]))
    if words[:1] == ["report"] and len(words) == 3:
        return report(words[1], words[2])
    print(__doc__)
    return 2


if __name__ == "__main__":
    sys.exit(main())
