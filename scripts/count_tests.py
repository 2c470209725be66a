#!/usr/bin/python3
"""Adds up the JUnit files below a directory.

Usage: count_tests.py DIRECTORY

Prints a line for each file, the failures below it, and last "PASSED FAILED SKIPPED". A file that says that its test
crashed or is missing counts as a failure. Exit 1 when something failed or nothing ran.
"""
import os
import sys
import xml.etree.ElementTree as ElementTree


def cases(path):
    """Yields (name, outcome, text) of each test case in a file."""
    try:
        root = ElementTree.parse(path).getroot()
    except ElementTree.ParseError as error:
        yield os.path.basename(path), "failed", "cannot be read: %s" % error
        return
    for case in root.iter("testcase"):
        name = "%s.%s" % (case.get("classname", ""), case.get("name", ""))
        trouble = [e for e in case if e.tag in ("failure", "error")]
        if trouble:
            yield name, "failed", "\n".join((e.get("message") or "") + "\n" + (e.text or "") for e in trouble).strip()
        elif case.get("status") == "notrun" or case.find("skipped") is not None:
            yield name, "skipped", (case.findtext("skipped") or "")
        else:
            yield name, "passed", ""


def main():
    if len(sys.argv) != 2:
        print(__doc__)
        return 2
    total = {"passed": 0, "failed": 0, "skipped": 0}
    files = sorted(os.path.join(folder, name) for folder, _, names in os.walk(sys.argv[1])
                   for name in names if name.endswith(".xml"))
    for path in files:
        count = {"passed": 0, "failed": 0, "skipped": 0}
        said = []
        for name, outcome, text in cases(path):
            count[outcome] += 1
            if outcome != "passed":
                said.append("    %s %s\n%s" % (outcome.upper(), name, "\n".join("        " + t for t in text.splitlines()[:25])))
        if not sum(count.values()):
            count["failed"] = 1
            said.append("    FAILED: the file holds no test case")
        print("%5d passed %3d failed  %s" % (count["passed"], count["failed"], os.path.relpath(path, sys.argv[1])))
        for line in said:
            print(line)
        for outcome in total:
            total[outcome] += count[outcome]
    if not files:
        print("no test wrote a result")
        total["failed"] += 1
    print("%(passed)d %(failed)d %(skipped)d" % total)
    return 1 if total["failed"] else 0


if __name__ == "__main__":
    sys.exit(main())
