#!/usr/bin/python3
"""Runs a test that is a program of its own, and writes what it says as a JUnit file.

Usage: script_result.py RESULT.xml OUTPUT.log PROGRAM [ARGUMENT ...]

The program prints a line "PASS  words" or "FAIL  words" for each check, details on indented lines below it, and last
"N passed, M failed". Everything that it prints goes into OUTPUT.log, too. A last line that is missing or that counts
something else than the lines above it, and an exit code that does not agree with it, is a failure.
Exit: 0 when all passed, 1 when not, 2 for bad use.
"""
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

LAST_LINES = 30  # shown of a program that broke off


def checks_of(lines):
    """[(words, passed, details)] of the PASS and FAIL lines."""
    checks = []
    for line in lines:
        head = re.match(r"(PASS|FAIL)  (.*)", line)
        if head:
            checks.append((head.group(2).strip(), head.group(1) == "PASS", []))
        elif checks and line.startswith("        "):
            checks[-1][2].append(line.strip())
    return checks


def disagreement(lines, checks, code):
    """What is wrong with how the program ended, or nothing."""
    last = re.match(r"(\d+) passed, (\d+) failed$", lines[-1] if lines else "")
    if not last:
        return "expected a last line \"N passed, M failed\", got exit code %d after:\n%s" % (
            code, "\n".join(lines[-LAST_LINES:]) or "no output")
    counted = tuple(sum(1 for check in checks if check[1] is passed) for passed in (True, False))
    said = int(last.group(1)), int(last.group(2))
    if said != counted:
        return "the last line says %d passed, %d failed; the lines above it are %d and %d" % (said + counted)
    if not sum(counted):
        return "expected at least one check, got none"
    if (code == 0) != (counted[1] == 0):
        return "exit code %d with %d failed" % (code, counted[1])
    return ""


def main():
    if len(sys.argv) < 4:
        print(__doc__)
        return 2
    result, log, command = sys.argv[1], sys.argv[2], sys.argv[3:]
    lines = []
    with open(log, "w") as copy:
        program = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   universal_newlines=True, errors="replace")
        for line in program.stdout:
            sys.stdout.write(line)
            sys.stdout.flush()
            copy.write(line)
            copy.flush()
            lines.append(line.rstrip("\n"))
        code = program.wait()

    name = os.path.splitext(os.path.basename(result))[0].replace("script-", "", 1)
    checks = checks_of(lines)
    trouble = disagreement(lines, checks, code)
    if trouble:
        checks.append(("the program ends as it should", False, [trouble]))
    suite = ElementTree.Element("testsuite", name=name, tests=str(len(checks)),
                                failures=str(sum(1 for check in checks if not check[1])))
    for words, passed, details in checks:
        case = ElementTree.SubElement(suite, "testcase", classname=name, name=words)
        if not passed:
            failure = ElementTree.SubElement(case, "failure", message=words)
            failure.text = "\n".join(details)
    os.makedirs(os.path.dirname(os.path.abspath(result)), exist_ok=True)
    # Control characters in what a program printed are not allowed in XML.
    text = re.sub(r"[\x00-\x08\x0b\x0c\x0e-\x1f]", "?", ElementTree.tostring(suite, encoding="unicode"))
    with open(result + ".partial", "w") as out:
        out.write(text)
    os.replace(result + ".partial", result)
    return 1 if any(not check[1] for check in checks) else 0


if __name__ == "__main__":
    sys.exit(main())
