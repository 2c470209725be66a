#!/usr/bin/python3
"""Judges the overview of every scene from what `simulate --bag` records, as a viewer's camera would show it: how much of
the frame the subjects fill, how large the smallest letters are, and whether letters overlap.

Usage: test_overviews.py PROGRAMS [SCENE ...]    (PROGRAMS: the directory of simulate and compare_scene)

Default: all of scenes/ and overviews/, which are as users write them who do not know the layout; and the scenes of compare.launch and
lesson.launch.

The frame is 800 x 450 pixels. Times: 0, 3, 10 and 30 s. Exit: 0; 1 when a scene falls short; 2 for bad use.
"""
import glob
import math
import os
import subprocess
import sys
import tempfile

import numpy as np
import rosbag
import yaml

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path.insert(0, os.path.join(HERE, ".."))
from checks import check, finish  # noqa: E402

ROOT = os.path.realpath(os.path.join(HERE, "..", ".."))
WIDTH, HEIGHT = 800, 450
TIMES = (0, 3, 10, 30)
LEAST_LETTERS = 11       # pixels
LEAST_FILLED = 0.6       # of the frame's width or height
FEWEST_FILLED = 18       # scenes
LETTER_WIDTH = 0.52      # of their height, in the mean
TANGENT = math.tan(math.radians(22.5))
ADD, SPHERE, TEXT, MESH = 0, 2, 9, 10


def rotation(q):
    w, x, y, z = q.w, q.x, q.y, q.z
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def vector(p):
    return np.array([p.x, p.y, p.z])


class Frames:
    """The frames of tf, as they were told last."""

    def __init__(self):
        self.transforms = {}

    def add(self, message):
        for t in message.transforms:
            self.transforms[t.child_frame_id] = (t.header.frame_id, vector(t.transform.translation),
                                                 rotation(t.transform.rotation))

    def to_world(self, frame, points):
        while frame != "world":
            frame, shift, turn = self.transforms[frame]
            points = points @ turn.T + shift
        return points


class Camera:
    """The nearest one at +x that shows all balls of a layout."""

    def __init__(self, layout):
        self.pitch = layout.pitch
        c, s = math.cos(self.pitch), math.sin(self.pitch)
        self.axes = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])  # towards the eye, to its right, upwards
        seen = np.array([vector(p) for p in layout.centres]) @ self.axes.T
        radii = np.array(layout.radii)
        tangents = np.array([TANGENT * WIDTH / HEIGHT, TANGENT]) * .97

        def room(distance):
            half = np.outer(distance - seen[:, 0], tangents) - np.outer(radii, np.sqrt(1 + tangents ** 2))
            return (seen[:, 1:] - half).max(axis=0), (seen[:, 1:] + half).min(axis=0)

        size = float(np.abs(seen).max() + radii.max())
        low, high = float((seen[:, 0] + radii).max()), 40 * size
        while high - low > 1e-9 * size:
            middle = .5 * (low + high)
            left, right = room(middle)
            low, high = (low, middle) if (left <= right).all() else (middle, high)
        left, right = room(high)
        self.eye, self.middle = high, .5 * (left + right)

    def pixels(self, points):
        """Pixels of points in the world, and pixels a metre there; nothing for points behind the eye."""
        seen = points @ self.axes.T
        depth = self.eye - seen[:, 0]
        a_metre = HEIGHT / (2 * TANGENT * depth)
        x = WIDTH / 2 + (seen[:, 1] - self.middle[0]) * a_metre
        y = HEIGHT / 2 - (seen[:, 2] - self.middle[1]) * a_metre
        return np.stack([x, y], axis=1), a_metre


class Picture:
    """What is drawn at one time."""

    def __init__(self):
        self.markers, self.frames, self.layout = {}, Frames(), None

    def put(self, topic, message):
        for m in message.markers:  # RViz has a display for each topic, which do not share markers
            if m.action == ADD:
                self.markers[topic, m.ns, m.id] = m
            else:
                self.markers.pop((topic, m.ns, m.id), None)

    def texts(self, camera, larger=1.0):
        """Of each text: what it says, its box in pixels, and the height of its letters."""
        out = []
        for m in self.markers.values():
            if m.type != TEXT:
                continue
            place = self.frames.to_world(m.header.frame_id, vector(m.pose.position)[None])
            (x, y), a_metre = (v[0] for v in camera.pixels(place))
            height = larger * m.scale.z * a_metre
            lines = m.text.split("\n")
            half = np.array([.5 * LETTER_WIDTH * height * max(map(len, lines)), .6 * height * len(lines)])
            if abs(x - WIDTH / 2) < WIDTH / 2 + half[0] and abs(y - HEIGHT / 2) < HEIGHT / 2 + half[1]:
                out.append((m.text, np.array([x, y]) - half, np.array([x, y]) + half, height))
        return out

    def filled(self, camera):
        """The share of the frame's width and height that bodies and ellipsoids span."""
        points = []
        for m in self.markers.values():
            solid = m.ns.endswith(("/shape", "_ellipsoid", "/ghosts", "/orbit", "/gravity", "/torque"))
            if not solid:
                continue
            if m.points:
                ends = np.array([vector(p) for p in m.points])
                points.append(self.frames.to_world(m.header.frame_id, ends))
                continue
            if m.type == MESH:  # whose size the marker does not tell; the layout does
                half = np.eye(3) * (0 if m.ns.endswith("/orbit") else .75 * self.layout.radii[0])
            else:
                half = np.diag(vector(m.scale)) / 2
            ends = np.concatenate([half, -half]) @ rotation(m.pose.orientation).T + vector(m.pose.position)
            points.append(self.frames.to_world(m.header.frame_id, ends))
        seen, _ = camera.pixels(np.concatenate(points))
        # What stands apart is outside of the frame, and no subject.
        seen = seen[(seen[:, 0] > 0) & (seen[:, 0] < WIDTH) & (seen[:, 1] > 0) & (seen[:, 1] < HEIGHT)]
        return (seen.max(axis=0) - seen.min(axis=0)) / (WIDTH, HEIGHT) if len(seen) else np.zeros(2)


def pictures(simulate, path, folder):
    """The scene at each time; where it plays in rounds, at that time of its round."""
    bag = os.path.join(folder, "scene.bag")
    subprocess.run([simulate, path, "--bag", bag, "--duration", str(max(TIMES)), "--rate", "10"], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    picture = Picture()
    with rosbag.Bag(bag) as recording:
        start = recording.get_start_time()
        with open(path) as text:
            loop = yaml.safe_load(text).get("loop", math.inf)
        due = sorted(t if t < loop else math.fmod(t, loop) for t in TIMES)
        last = None
        for topic, message, stamp in recording.read_messages():
            now = stamp.to_sec() - start
            if last is not None and now > last + 1e-6 and due and last >= due[0] - 1e-6:
                yield due.pop(0), picture
            last = now
            if topic in ("/tf", "/tf_static"):
                picture.frames.add(message)
            elif topic in ("/markers", "/markers_static"):
                picture.put(topic, message)
            elif topic == "/poinsot/layout":
                picture.layout = message
        if due:
            yield due.pop(0), picture


def overlapping(texts):
    out = []
    for i, (one, low, high, _) in enumerate(texts):
        for other, other_low, other_high, _ in texts[i + 1:]:
            shared = np.minimum(high, other_high) - np.maximum(low, other_low)
            if (shared > 1).all():
                out.append("%r and %r" % (one, other))
    return out


def complaints(picture, larger=1.0):
    """What is wrong with the letters."""
    camera = Camera(picture.layout)
    texts = picture.texts(camera, larger)
    out = ["%r is %.1f pixels high" % (text, height) for text, _, _, height in texts if height < LEAST_LETTERS]
    return out + ["%s overlap" % pair for pair in overlapping(texts)]


def compared(programs, mode, source, folder):
    """A scene that compare_scene makes."""
    path = os.path.join(folder, "compare_%s.yaml" % mode)
    with open(path, "w") as out:
        subprocess.run([os.path.join(programs, "compare_scene"), "--mode", mode, source], stdout=out, check=True)
    return path


def main():
    if len(sys.argv) < 2:
        print(__doc__, file=sys.stderr)
        return 2
    simulate, names = os.path.join(sys.argv[1], "simulate"), sys.argv[2:]
    own = os.path.join(ROOT, "scenes")
    paths = sorted(path for place in (own, os.path.join(HERE, "overviews")) for path in glob.glob(os.path.join(place, "*.yaml")))
    if names:
        known = {os.path.splitext(os.path.basename(path))[0]: path for path in paths}
        unknown = [name for name in names if name not in known]
        if unknown:
            print("expected scenes of %s, got %s" % (", ".join(sorted(known)), ", ".join(unknown)), file=sys.stderr)
            return 2
        paths = [known[name] for name in names]
    full = 0
    noticed = {"larger": False, "smaller": False}
    with tempfile.TemporaryDirectory() as folder:
        if not names:
            paths.append(compared(sys.argv[1], "equal_cost", os.path.join(own, "dzhanibekov.yaml"), folder))
            paths.append(compared(sys.argv[1], "lesson", os.path.join(ROOT, "launch", "lesson.yaml"), folder))
        for path in paths:
            name = os.path.splitext(os.path.basename(path))[0]
            wrong, filled = [], []
            for t, picture in pictures(simulate, path, folder):
                wrong += ["t = %g s: %s" % (t, text) for text in complaints(picture)]
                filled.append(picture.filled(Camera(picture.layout)).max())
                noticed["larger"] = noticed["larger"] or any("overlap" in c for c in complaints(picture, 4))
                noticed["smaller"] = noticed["smaller"] or any("high" in c for c in complaints(picture, .4))
            full += min(filled) > LEAST_FILLED and os.path.dirname(path) == own
            print("%-20s subjects fill %s" % (name, "  ".join("%3.0f %%" % (100 * share) for share in filled)))
            check("%s: letters can be read" % name, wrong)
    if not names:
        check("at least %d scenes fill the frame" % FEWEST_FILLED, [] if full >= FEWEST_FILLED else ["%d do" % full])
    check("letters that overlap are noticed", [] if noticed["larger"] else ["they are not"])
    check("letters that are too small are noticed", [] if noticed["smaller"] else ["they are not"])
    return finish()


if __name__ == "__main__":
    sys.exit(main())
