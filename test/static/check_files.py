#!/usr/bin/python3
"""Looks at files without running them.

Usage: check_files.py python|links|data|places FILE ...

python: is it valid Python? links: do the relative links of the Markdown files among them lead to files, and to headings?
data: are the YAML and XML files among them well-formed? places: does a file name a directory of one machine or user, or
a web address whose host is not in HOSTS? Text that is not UTF-8 is a fault for all of them. Prints a line
"FILE:LINE: what is wrong" for each fault. Exit: 0 when there is none, 1 otherwise, 2 for bad use.
"""
import os
import re
import sys
import xml.etree.ElementTree as ElementTree

import yaml

YAML_ENDINGS = (".yaml", ".yml", ".rviz")
XML_ENDINGS = (".xml", ".launch", ".test", ".dae", ".svg")
# Hosts that the files may name. Where packages come from is the system's business, not this package's.
HOSTS = {"127.0.0.1", "creativecommons.org", "download.ros.org", "example.com", "github.com", "localhost",
         "matplotlib.org", "purl.org", "www.collada.org", "www.w3.org"}
# A user of one letter is an example.
LOCAL_PLACE = re.compile(r"(?<![\w.$}~*-])/(?:home|root|Users|work|tmp/\w+)/[\w.-]{2,}")


def text_of(name):
    """The text of a file, or nothing when it is no text, that is, when it has a zero byte."""
    with open(name, "rb") as file:
        content = file.read()
    return "" if b"\0" in content else content.decode("utf-8")


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def python(name):
    try:
        compile(text_of(name), name, "exec", dont_inherit=True)
    except SyntaxError as error:
        yield error.lineno or 1, error.msg


def data(name):
    if name.endswith(YAML_ENDINGS):
        try:
            for _ in yaml.parse(text_of(name), Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader)):
                pass
        except yaml.MarkedYAMLError as error:
            mark = error.problem_mark or error.context_mark
            yield mark.line + 1 if mark else 1, error.problem
        except yaml.YAMLError as error:
            yield 1, str(error)
    elif name.endswith(XML_ENDINGS):
        try:
            ElementTree.parse(name)
        except ElementTree.ParseError as error:
            yield error.position[0], str(error)


def without_code(text):
    """The text with its examples blanked out, as long as before."""
    blank = lambda found: re.sub(r"[^\n]", " ", found.group())
    text = re.sub(r"^```.*?^```", blank, text, flags=re.M | re.S)
    text = re.sub(r"^ {4}.*$", blank, text, flags=re.M)
    return re.sub(r"`[^`\n]+`", blank, text)


def anchors(name):
    """What links to headings of a Markdown file end with, as web sites make them."""
    text = re.sub(r"^```.*?^```", "", text_of(name), flags=re.M | re.S)
    found = {}
    for heading in re.findall(r"^#{1,6} +(.*?) *#*$", text, flags=re.M):
        words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
        anchor = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        count = found.get(anchor, 0)
        found[anchor] = count + 1
        yield "%s-%d" % (anchor, count) if count else anchor
    yield from re.findall(r"<a (?:id|name)=\"([^\"]+)\"", text)


def links(name):
    if not name.endswith(".md"):
        return
    text = without_code(text_of(name))
    for found in re.finditer(r"\]\(\s*<?([^)\s>]+)>?[^)]*\)", text):
        target, _, anchor = found.group(1).partition("#")
        if re.match(r"[a-z]+:", target):
            continue
        path = os.path.join(os.path.dirname(name), target) if target else name
        if not os.path.exists(path):
            yield line_of(text, found.start()), "the link leads to %s, which does not exist" % target
        elif anchor and path.endswith(".md") and anchor not in anchors(path):
            yield line_of(text, found.start()), "%s has no heading for the link #%s" % (target or name, anchor)


def places(name):
    text = text_of(name)
    for found in LOCAL_PLACE.finditer(text):
        yield line_of(text, found.start()), "expected no path of one machine, got %s" % found.group()
    for found in re.finditer(r"\b(?:https?|ftp)://([A-Za-z0-9.-]*[A-Za-z0-9])", text):
        if found.group(1).lower() not in HOSTS:
            yield (line_of(text, found.start()),
                   "expected a host from the list in test/static/check_files.py, got %s" % found.group(1))


def main():
    checks = {"python": python, "links": links, "data": data, "places": places}
    if len(sys.argv) < 3 or sys.argv[1] not in checks:
        print(__doc__)
        return 2
    faults = 0
    for name in sys.argv[2:]:
        try:
            for line, words in checks[sys.argv[1]](name):
                print("%s:%d: %s" % (name, line, words))
                faults += 1
        except UnicodeDecodeError as error:
            print("%s:%d: expected UTF-8, got %s" % (name, error.object.count(b"\n", 0, error.start) + 1, error))
            faults += 1
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
