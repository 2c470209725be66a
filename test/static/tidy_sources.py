#!/usr/bin/python3
"""Of a build's compile_commands.json, what clang-tidy is to read: each source below src/ once, joined or by itself.

Usage: tidy_sources.py ROOT BUILD OUT

Writes OUT/compile_commands.json, and prints a line "ROOM<tab>FILE" for each file that is compiled, joined files first:
they take longest. Files that the build itself writes, other than joined ones, are left out. Exit: 1 when a source below
ROOT/src is neither compiled nor joined.
"""
import glob
import json
import os
import re
import sys


def main():
    root, build, out = sys.argv[1:]
    with open(os.path.join(build, "compile_commands.json")) as file:
        commands = json.load(file)
    chosen, joined = {}, {}
    for command in commands:
        name = command["file"]
        in_build = name.startswith(build + "/src/")
        if in_build and "/Unity/" in name:
            with open(name) as file:
                joined[name] = re.findall(r'^#include "(.*)"$', file.read(), flags=re.M)
        elif in_build or not name.startswith(root + "/src/"):
            continue
        chosen.setdefault(name, command)  # a file of several programs is read once
    for name in {part for parts in joined.values() for part in parts}:
        chosen.pop(name, None)

    sources = set(glob.glob(glob.escape(root) + "/src/**/*.cpp", recursive=True))
    missing = sources - set(chosen) - {part for parts in joined.values() for part in parts}
    for name in sorted(missing):
        print("%s is not compiled" % name, file=sys.stderr)
    with open(os.path.join(out, "compile_commands.json"), "w") as file:
        json.dump(list(chosen.values()), file, indent=1)
    for name in sorted(chosen, key=lambda name: (name not in joined, name)):
        below = name[len(build if name in joined else root) + len("/src/"):]
        print("%s\t%s" % (below.split("/")[0], name))
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
