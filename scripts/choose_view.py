#!/usr/bin/python3
"""Copies a .rviz file and makes a saved view the current one: choose_view.py IN OUT NAME [WxH].

With a size, the window gets that size. The panel fits the view to the scene.
Exit: 0; 2 when there is no such view; stderr lists the views.
"""
import sys

import yaml


def main():
    if len(sys.argv) not in (4, 5):
        print(__doc__, file=sys.stderr)
        return 2
    source, target, name = sys.argv[1:4]
    with open(source) as file:
        config = yaml.safe_load(file)
    views = config["Visualization Manager"]["Views"]
    saved = {view["Name"]: view for view in views["Saved"] or []}
    if name not in saved:
        print("--view: expected one of %s, got %s" % (", ".join(saved), name), file=sys.stderr)
        return 2
    views["Current"] = dict(saved[name], Name="Current View")
    for panel in config["Panels"]:
        if panel["Class"] == "poinsot/Panel":
            panel["View"] = name  # by which the panel knows what to hide
    if len(sys.argv) == 5:
        width, height = (int(x) for x in sys.argv[4].split("x"))
        config["Window Geometry"].update(Width=width, Height=height)
    with open(target, "w") as out:
        yaml.safe_dump(config, out, default_flow_style=None, width=4096)
    return 0


if __name__ == "__main__":
    sys.exit(main())
