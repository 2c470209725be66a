#!/usr/bin/python3
"""Runs the commands of doc/course_notes.md and doc/exercises.md and compares what they print with what the documents show.

A command is a block ```sh. If the next block is ```text, that is what it prints, and the line before it says how exactly:
"within 0.1 %:" is meant of each number. All commands of one document run in one folder, one after another, as a reader would run them. Code that is quoted as `code` with a link to its file must be there. The checks are also shown
documents in which a figure or a line of code is wrong.

Usage: test_lesson.py DIRECTORY OF PROGRAMS    The last line reads "N passed, M failed".
"""
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "test"))
from checks import check, finish  # noqa: E402

NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.M | re.S)
EXACTNESS = re.compile(r"within ([0-9.]+) %:\s*\Z")
QUOTE = re.compile(r"`([^`\n]+)`[^`\n|]*?\]\(\.\./((?:src|include)/[\w./]+)\)")
NOT_RUN = re.compile(r"(roslaunch|rosrun rviz|scripts/demo\.sh|source) ")  # what opens a window, or is run already
PATIENCE = 120  # s, of one command
ROSRUN = "#!/bin/sh\nshift\nprogram=$1\nshift\nexec '%s'/\"$program\" \"$@\"\n"  # finds the programs wherever they were built
LEAST = {"course_notes.md": 8, "exercises.md": 10}  # commands with output


def document(name):
    with open(os.path.join(ROOT, "doc", name), encoding="utf-8") as file:
        return file.read()


def commands(text):
    """[(command, shown, tolerance)] of a document; shown is None where no output is given."""
    blocks, out = list(BLOCK.finditer(text)), []
    for block, following in zip(blocks, blocks[1:] + [None]):
        if block.group(1) != "sh":
            continue
        shown = tolerance = None
        if following and following.group(1) == "text":
            shown = following.group(2)
            said = EXACTNESS.search(text[block.end():following.start()])
            tolerance = float(said.group(1)) / 100 if said else None
        out.append((block.group(2), shown, tolerance))
    return out


def same(shown, printed, tolerance):
    """Whether two lines have the same words, and numbers that differ by no more than the tolerance."""
    if [part.split() for part in NUMBER.split(shown)] != [part.split() for part in NUMBER.split(printed)]:
        return False
    pairs = zip(map(float, NUMBER.findall(shown)), map(float, NUMBER.findall(printed)))
    return all(abs(a - b) <= tolerance * max(abs(a), abs(b)) for a, b in pairs)


def differences(shown, printed, tolerance):
    if tolerance is None:
        return ["does not say how exactly the figures hold: " + shown.splitlines()[0]]
    shown, printed = shown.rstrip().splitlines(), printed.rstrip().splitlines()
    out = [] if len(shown) == len(printed) else ["shows %d lines, the command prints %d:" % (len(shown), len(printed))] + printed
    return out + ["expected %r, got %r" % pair for pair in zip(shown, printed) if not same(*pair, tolerance)]


def run(command, folder):
    """The exit code of a command in a folder, and what it prints on both streams."""
    path = os.pathsep.join([os.path.join(folder, "bin"), "/usr/bin", os.environ["PATH"]])
    environment = dict(os.environ, PATH=path, LC_ALL="C.UTF-8")
    done = subprocess.run(["bash", "-e", "-o", "pipefail", "-c", command], cwd=folder, env=environment, timeout=PATIENCE,
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
    return done.returncode, done.stdout


def prepare(folder, programs):
    """What the commands need of the package's own folder."""
    for name in ("scenes", "launch"):
        os.symlink(os.path.join(ROOT, name), os.path.join(folder, name))
    os.mkdir(os.path.join(folder, "bin"))
    rosrun = os.path.join(folder, "bin", "rosrun")
    with open(rosrun, "w") as out:
        out.write(ROSRUN % os.path.realpath(programs))
    os.chmod(rosrun, 0o755)


def outputs(text, programs):
    """[(shown, printed, tolerance)] of the commands with output, and complaints about commands that fail."""
    out, complaints = [], []
    with tempfile.TemporaryDirectory() as folder:
        prepare(folder, programs)
        for command, shown, tolerance in commands(text):
            if shown is None and NOT_RUN.match(command):
                continue
            code, printed = run(command, folder)
            if code:
                complaints.append("exit %d of %s: %s" % (code, command.splitlines()[0], printed.strip()[-300:]))
            elif shown is not None:
                out.append((shown, printed, tolerance))
    return out, complaints


def missing_code(text):
    """Quoted code that is not in its file, and the number of quotations. A quotation may leave something out: …"""
    out, count = [], 0
    for code, name in QUOTE.findall(text):
        count += 1
        path = os.path.join(ROOT, name)
        if not os.path.exists(path):
            out.append("no file " + name)
            continue
        with open(path, encoding="utf-8") as file:
            there = re.sub(r"\s+", "", file.read())
        out += ["%s does not have %s" % (name, part) for part in code.split("…") if re.sub(r"\s+", "", part) not in there]
    return out, count


def changed(shown):
    """The text with its last number off by 5 % or, if it is zero, by one."""
    last = list(NUMBER.finditer(shown))[-1]
    value = float(last.group())
    return shown[:last.start()] + "%.12g" % (1.05 * value if value else 1) + shown[last.end():]


def main():
    if len(sys.argv) != 2:
        print(__doc__)
        return 2
    for name, least in LEAST.items():
        text = document(name)
        found, complaints = outputs(text, sys.argv[1])
        check("the commands of doc/%s run" % name,
              complaints or (["only %d commands with output" % len(found)] if len(found) < least else []))
        check("they print what the document shows", [c for one in found for c in differences(*one)])
        unseen = [shown.strip() for shown, printed, tolerance in found
                  if NUMBER.search(shown) and not differences(changed(shown), printed, tolerance)]
        check("and a figure that is changed by 5 % would be noticed, in each of them", unseen)

    notes = document("course_notes.md")
    complaints, count = missing_code(notes)
    check("the code that doc/course_notes.md quotes is there", complaints or ([] if count >= 10 else ["only %d quotations" % count]))
    wrong = "`rotate(state, theta);` in [x](../src/core/steppers/rotate.h)"
    check("and code that is not there would be noticed", [] if len(missing_code(wrong)[0]) == 1 else ["it is not"])
    return finish()


if __name__ == "__main__":
    sys.exit(main())
