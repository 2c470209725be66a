#!/usr/bin/python3
"""Writes RViz's views of the scenes, rviz/<scene>.rviz, and demo.rviz, compare.rviz and lesson.rviz.

Usage: make_views.py [DIRECTORY]

Each is scripts/view_template.rviz.in with three cameras: Overview, which shows everything that the scene's markers reach in
its first seconds, in a window of 4 : 3 beside the panel and on a full screen; Riding, which turns with the body; Along L,
which looks down the angular momentum on the picture in world axes. The latter two hide everything but that picture; a
scene of bodies alone does not have them. `simulate` says where things are, so the package must be built and its
devel/setup.bash sourced. The output is the same in every run.
"""
import glob
import math
import os
import subprocess
import sys
import tempfile

import rosbag

ROOT = os.path.realpath(os.path.join(os.path.dirname(os.path.realpath(__file__)), ".."))
ASPECT = 1.46  # of the narrowest picture that everything must fit into, that of RViz beside the panel
HALF_VIEW = math.tan(math.radians(22.5))  # RViz's field of view is 45 degrees high
MARGIN = .97
SAMPLES = 40

# Settings of scenes that differ from the usual ones: `until`, how long everything must be in view [s]; `pitch` of the
# camera; `bodies`: only the bodies are shown.
USUAL = {"until": 20, "pitch": .38, "bodies": False}
TABLE = {
    "damped_tumble": {"pitch": .2},
    "gravity_gradient": {"pitch": .2},
    "heavy_top_cusps": {"pitch": .45},
    "heavy_top_loops": {"pitch": .45},
    "heavy_top_sleeping": {"pitch": .45, "until": 25},
    "heavy_top_waves": {"pitch": .45},
    "hundred": {"pitch": .1, "until": .1, "bodies": True},
    "explorer1": {"until": 45},
    "regimes": {"pitch": .2},
    "separatrix": {"pitch": .2},
    "sphere": {"pitch": .2},
    "thruster_despin": {"pitch": .2, "until": 24},
    "tossed_book": {"pitch": .12, "until": 15.1},
    "wingnut": {"pitch": .12, "until": 26},
    "compare": {"pitch": .1},
    "lesson": {"pitch": .1},
}

# The arrangement of compare.launch, for the body of the first scene; the names of the steppers do not matter.
COMPARED = [("lie_euler", -7.6, 2.1), ("buss2", 0, 2.1), ("good", -7.6, -2.1), ("closed_form", 0, -2.1)]


# --- positions ------------------------------------------------------------------------------------------------------


def rotated(q, p):
    u = (q.x, q.y, q.z)
    t = [2 * (u[1] * p[2] - u[2] * p[1]), 2 * (u[2] * p[0] - u[0] * p[2]), 2 * (u[0] * p[1] - u[1] * p[0])]
    return (p[0] + q.w * t[0] + u[1] * t[2] - u[2] * t[1], p[1] + q.w * t[1] + u[2] * t[0] - u[0] * t[2],
            p[2] + q.w * t[2] + u[0] * t[1] - u[1] * t[0])


class Recording:
    """A scene as `simulate` records it."""

    def __init__(self, scene, setting):
        self.frames, self.bodies, self.states, self.namespaces, self.spheres = {}, [], {}, ({}, {}), []
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "scene.bag")
            subprocess.run([os.path.join(ROOT, "build", "devel", "lib", "poinsot", "simulate"), scene, "--bag", file,
                            "--duration", str(setting["until"]), "--rate", "%.17g" % (SAMPLES / setting["until"])],
                           check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            with rosbag.Bag(file) as bag:
                self.read(bag, setting)

    def read(self, bag, setting):
        for _, message, _ in bag.read_messages("/tf_static"):
            for t in message.transforms:
                self.frames[t.child_frame_id] = t.transform
        marked = []
        for topic, message, _ in bag.read_messages():
            if topic.endswith("/state"):
                self.states.setdefault(message.body, message)
                if message.body not in self.bodies:
                    self.bodies.append(message.body)
                p = message.position
                self.spheres.append(((p.x, p.y, p.z), self.radius(message.body)))
            elif topic.endswith("markers_static") or topic.endswith("markers"):
                put = [marker for marker in message.markers if marker.action == marker.ADD]
                for marker in put:
                    self.namespaces[not topic.endswith("static")][marker.ns] = True
                marked += put
        if not setting["bodies"]:
            for marker in marked:
                self.add(marker)

    def radius(self, body):
        """The radius of the body's sphere: the layout puts the picture in world axes 1.55 m beyond it."""
        at, start = self.frames[body + "_space"].translation, self.states[body].position
        return math.dist((at.x, at.y, at.z), (start.x, start.y, start.z)) - 1.55

    def placed(self, frame, p):
        frame = frame.lstrip("/")
        if frame == "world":
            return p
        if frame.endswith("_space_body"):
            frame = frame[:-len("_body")]  # turns, about the same centre
        if frame not in self.frames:
            return None  # the frame of the body itself
        t = self.frames[frame]
        q = rotated(t.rotation, p)
        return (q[0] + t.translation.x, q[1] + t.translation.y, q[2] + t.translation.z)

    def add(self, marker):
        if marker.action != marker.ADD:
            return
        at, scale = marker.pose.position, marker.scale
        origin = (at.x, at.y, at.z)
        turning = marker.header.frame_id.endswith("_space_body")
        if marker.type == marker.TEXT_VIEW_FACING:
            lines = marker.text.split("\n")
            if "energy" in marker.text:
                lines.append("what it costs, which a recording does not measure")
            half = (.28 * scale.z * max(len(line) for line in lines[:3]), .6 * scale.z * len(lines))
            centre = self.placed(marker.header.frame_id, origin)
            if centre:
                for y, z in ((-1, 0), (1, 0), (0, 1), (0, -1)):
                    self.spheres.append(((centre[0], centre[1] + y * half[0], centre[2] + z * half[1]), .02))
            return
        points = [rotated(marker.pose.orientation, (p.x, p.y, p.z)) for p in marker.points]
        points = [tuple(a + b for a, b in zip(p, origin)) for p in points]
        if marker.type == marker.SPHERE or not points:
            points, reach = [origin], .5 * max(scale.x, scale.y, scale.z)
        else:
            reach = .02
        if turning:  # for every attitude
            points, reach = [(0, 0, 0)], reach + max(math.sqrt(sum(x * x for x in p)) for p in points)
        if len(points) > 64:
            points = points[::len(points) // 64]
        for p in points:
            centre = self.placed(marker.header.frame_id, p)
            if centre:
                self.spheres.append((centre, reach))


# --- cameras --------------------------------------------------------------------------------------------------------


def fitted(spheres, pitch):
    """The nearest camera at +x that shows all spheres: distance and focal point."""
    c, s = math.cos(pitch), math.sin(pitch)
    seen = [(p[0] * c + p[2] * s, p[1], p[2] * c - p[0] * s, r) for p, r in spheres]  # towards the eye, right, up

    def room(distance):
        low, high = [-math.inf] * 2, [math.inf] * 2
        for near, right, up, r in seen:
            for i, (x, tangent) in enumerate(((right, HALF_VIEW * ASPECT * MARGIN), (up, HALF_VIEW * MARGIN))):
                half = (distance - near) * tangent - r * math.sqrt(1 + tangent * tangent)
                low[i], high[i] = max(low[i], x - half), min(high[i], x + half)
        return low, high

    near, far = 1.0, 200.0
    while far - near > 1e-6:
        middle = .5 * (near + far)
        low, high = room(middle)
        if low[0] <= high[0] and low[1] <= high[1]:
            far = middle
        else:
            near = middle
    low, high = room(far)
    right, up = .5 * (low[0] + high[0]), .5 * (low[1] + high[1])
    return far, (-s * up, right, c * up)


def wide(spheres, pitch, focal):
    """The least distance of a camera with that focal point on a screen of 16 : 9."""
    c, s = math.cos(pitch), math.sin(pitch)
    nearest = 1.0
    for p, r in spheres:
        x, y, z = (a - b for a, b in zip(p, focal))
        for beside, tangent in ((abs(y), HALF_VIEW * 16 / 9 * MARGIN), (abs(z * c - x * s), HALF_VIEW * MARGIN)):
            nearest = max(nearest, x * c + z * s + (beside + r * math.sqrt(1 + tangent * tangent)) / tangent)
    return nearest


def orbit(name, distance, focal, pitch, yaw, near=.01):
    return """Class: rviz/Orbit
Name: %s
Distance: %.2f
Enable Stereo Rendering: {Stereo Eye Separation: 0.06, Stereo Focal Distance: 1, Swap Stereo Eyes: false, Value: false}
Focal Point: {X: %.2f, Y: %.2f, Z: %.2f}
Focal Shape Fixed Size: true
Focal Shape Size: 0.01
Invert Z Axis: false
Near Clip Distance: %.2f
Pitch: %.3f
Target Frame: world
Yaw: %.3f""" % ((name, distance) + tuple(x + 0.0 for x in focal) + (near, pitch, yaw))


def riding(body):
    """A camera on the ellipsoids of the picture in world axes: body axes rest, and the world turns."""
    distance = 4.7
    direction = (-.80, .42, .42)
    length = math.sqrt(sum(x * x for x in direction))
    place = [distance * x / length for x in direction]
    yaw, pitch = math.atan2(-place[1], -place[0]), math.asin(place[2] / distance)
    return """Class: rviz/FrameAligned
Name: Riding
Enable Stereo Rendering: {Stereo Eye Separation: 0.06, Stereo Focal Distance: 1, Swap Stereo Eyes: false, Value: false}
Invert Z Axis: false
Lock Camera: true
Near Clip Distance: %.2f
Pitch: %.3f
Point towards: arbitrary
Position: {X: %.2f, Y: %.2f, Z: %.2f}
Roll: 0
Target Frame: %s
Yaw: %.3f""" % (1.5, pitch, place[0], place[1], place[2], body + "_space_body", yaw)


def along_momentum(recording, body):
    at, momentum = recording.frames[body + "_space"].translation, recording.states[body].momentum_world
    x, y, z = momentum.x, momentum.y, momentum.z
    length = math.sqrt(x * x + y * y + z * z)
    pitch = math.asin(z / length)
    yaw = math.atan2(y, x)
    if math.hypot(x, y) < .12 * length:  # from above: nearly along L, and not rotated
        pitch, yaw = 1.57, 0
    return orbit("Along L", 4.2, (at.x, at.y, at.z), max(-1.57, min(1.57, pitch)), yaw % (2 * math.pi), near=2.3)


# --- files ----------------------------------------------------------------------------------------------------------


def indented(text, first, rest):
    lines = text.split("\n")
    return "\n".join([first + lines[0]] + [rest + line for line in lines[1:]])


def hidden(namespaces, only_bodies):
    if not only_bodies:
        return ""
    return ", ".join("%s: false" % ns for ns in sorted(namespaces) if not ns.endswith("/shape"))


def left_out(recording, body, displays):
    """Everything but the picture in world axes of that body, and these displays; for the panel's `Hidden`."""
    names = ["%s: [%s]" % (display, ", ".join(sorted(ns for ns in namespaces if not ns.startswith(body + "/space/"))))
             for display, namespaces in zip(("Still", "Motion"), recording.namespaces)]
    return ", ".join(names + [display + ": true" for display in displays])


def view(recording, setting, ride):
    distance, focal = fitted(recording.spheres, setting["pitch"])
    overview = orbit("Overview", distance, focal, setting["pitch"], 0)
    saved, left, down = [overview], [], ""
    if ride:
        body = recording.bodies[0] if ride is True else ride
        saved.append(riding(body))
        left.append("Riding: {%s}" % left_out(recording, body, ["Floor", "Grip"]))
        if any((recording.states[body].momentum_world.x, recording.states[body].momentum_world.y,
                recording.states[body].momentum_world.z)):
            saved.append(along_momentum(recording, body))
            left.append("Along L: {%s}" % left_out(recording, body, ["Grip"]))
            down = "Along L: " + body
    lowest = min(p[2] - r for p, r in recording.spheres)
    fields = {
        "wide": "%.2f" % wide(recording.spheres, setting["pitch"], focal),
        "floor_y": "%.1f" % focal[1], "floor_z": "%.2f" % (lowest - .1),
        "floor_cells": "%d" % (8 if distance < 8 else 10 if distance < 15 else 14),
        "left_out": ", ".join(left), "down": down,
        "grip": "false" if setting["bodies"] else "true",
        "hidden_still": hidden(recording.namespaces[0], setting["bodies"]),
        "hidden_motion": hidden(recording.namespaces[1], setting["bodies"]),
        "current": indented(overview.replace("Name: Overview", "Name: Current View"), " " * 6, " " * 6),
        "saved": "\n".join(indented(one, " " * 6 + "- ", " " * 8) for one in saved),
    }
    with open(os.path.join(ROOT, "scripts", "view_template.rviz.in")) as template:
        text = template.read()
    for key, value in fields.items():
        text = text.replace("@%s@" % key, value)
    return text


def compared():
    with open(os.path.join(ROOT, "scenes", "dzhanibekov.yaml")) as scene:
        head, body = scene.read().split("  - name: wingnut\n")
    return head + "".join(
        "  - name: %s\n%s    effects: [{type: translation, position: [0, %g, %g]}]\n" % (name, body, y, z)
        for name, y, z in COMPARED)


def write_lesson(folder):
    """The view of lesson.launch, for the scene that it shows unless another is named."""
    compare_scene = os.path.join(ROOT, "build", "devel", "lib", "poinsot", "compare_scene")
    scene = subprocess.run([compare_scene, "--mode", "lesson", os.path.join(ROOT, "launch", "lesson.yaml")], check=True,
                           stdout=subprocess.PIPE, universal_newlines=True).stdout
    with tempfile.TemporaryDirectory() as temporary:
        path = os.path.join(temporary, "lesson.yaml")
        with open(path, "w") as out:
            out.write(scene)
        setting = dict(USUAL, **TABLE["lesson"])
        write(folder, "lesson", view(Recording(path, setting), setting, "closed_form"))


def write(folder, name, text):
    path = os.path.join(folder, name + ".rviz")
    with open(path + ".part", "w") as out:
        out.write(text)
    os.rename(path + ".part", path)


def main():
    if len(sys.argv) > 2 or sys.argv[1:2] in (["-h"], ["--help"]):
        print(__doc__)
        return 0 if len(sys.argv) == 2 else 2
    folder = sys.argv[1] if len(sys.argv) == 2 else os.path.join(ROOT, "rviz")
    if not os.path.isdir(folder):
        print("make_views.py: expected a directory, got %s" % folder, file=sys.stderr)
        return 2
    for path in sorted(glob.glob(os.path.join(ROOT, "scenes", "*.yaml"))):
        name = os.path.splitext(os.path.basename(path))[0]
        setting = dict(USUAL, **TABLE.get(name, {}))
        recording = Recording(path, setting)
        write(folder, name, view(recording, setting, not setting["bodies"]))
        if name == "dzhanibekov":
            write(folder, "demo", view(recording, setting, None))  # for scenes of users: the names of bodies are not known
    with tempfile.TemporaryDirectory() as temporary:
        path = os.path.join(temporary, "compare.yaml")
        with open(path, "w") as out:
            out.write(compared())
        setting = dict(USUAL, **TABLE["compare"])
        write(folder, "compare", view(Recording(path, setting), setting, "closed_form"))
    write_lesson(folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
