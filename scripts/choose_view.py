#!/usr/bin/python3
"""Copies a .rviz file and makes a saved view the current one: choose_view.py IN OUT NAME [WxH].

With a size, the window gets that size; in a wide window, the overview comes as near as make_views.py allows.
Exit: 0; 2 when there is no such view; stderr lists the views.
"""
import re
import sys

import yaml


def main():
    if len(sys.argv) not in (4, 5):
        print(__doc__, file=sys.stderr)
        return 2
    source, target, name = sys.argv[1:4]
    with open(source) as file:
        text = file.read()
    config = yaml.safe_load(text)
    views = config["Visualization Manager"]["Views"]
    saved = {view["Name"]: view for view in views["Saved"] or []}
    if name not in saved:
        print("--view: expected one of %s, got %s" % (", ".join(saved), name), file=sys.stderr)
        return 2
    views["Current"] = dict(saved[name], Name="Current View")
    for panel in config["Panels"]:
        if panel["Class"] == "poinsot/Panel":
            panel["View"] = name  # by which the panel knows what to hide
    nearer = re.search(r"Distance may be ([0-9]+\.[0-9]+)", text)
    if len(sys.argv) == 5:
        width, height = (int(x) for x in sys.argv[4].split("x"))
        config["Window Geometry"].update(Width=width, Height=height)
        if nearer and name == "Overview" and width * 9 >= height * 16:
            views["Current"]["Distance"] = float(nearer.group(1))
    with open(target, "w") as out:
        yaml.safe_dump(config, out, default_flow_style=None, width=4096)
    return 0


if __name__ == "__main__":
    sys.exit(main())
