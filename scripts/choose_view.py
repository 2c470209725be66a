#!/usr/bin/python3
"""Copies a .rviz file with another of its saved views as the current one: choose_view.py IN OUT NAME [ZOOM].

ZOOM > 1 brings an orbiting camera nearer. Exit: 0; 2 when there is no such view, with the list on stderr.
"""
import sys

import yaml


def main():
    if len(sys.argv) not in (4, 5):
        print(__doc__, file=sys.stderr)
        return 2
    source, target, name = sys.argv[1:4]
    with open(source) as text:
        config = yaml.safe_load(text)
    views = config["Visualization Manager"]["Views"]
    saved = {view["Name"]: view for view in views["Saved"] or []}
    if name not in saved:
        print("there is no view %s; there are: %s" % (name, ", ".join(saved)), file=sys.stderr)
        return 2
    views["Current"] = dict(saved[name], Name="Current View")
    if len(sys.argv) == 5 and "Distance" in saved[name]:
        views["Current"]["Distance"] = float(saved[name]["Distance"]) / float(sys.argv[4])
    with open(target, "w") as out:
        yaml.safe_dump(config, out, default_flow_style=None, width=4096)
    return 0


if __name__ == "__main__":
    sys.exit(main())
