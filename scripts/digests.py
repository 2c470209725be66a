#!/usr/bin/python3
"""Prints digests of what a build writes for every scene, so that two builds can be compared: the `diff` of two outputs
shows the scenes and topics that differ.

Usage: digests.py BUILD [--duration S] [SCENE ...]

BUILD holds devel/lib/poinsot/simulate. For each scene of scenes/ (or those named): the SHA-256 of `simulate --csv`, and for
each topic of `simulate --bag` the number of messages and the SHA-256 of their stamps and bytes, one line each. The digests
leave out the texts of labels, DELETEALL markers, and the DELETE markers in the first message of a topic, because these do
not change what is shown.
Exit: 0, 1 when simulate fails, 2 for bad use.
"""
import argparse
import collections
import glob
import hashlib
import io
import os
import subprocess
import sys
import tempfile

import rosbag
from visualization_msgs.msg import Marker, MarkerArray

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), ".."))
DEFAULT_DURATION = 20.0  # s


def simulate(program, scene, option, path, duration):
    subprocess.run([program, scene, option, path, "--duration", "%.17g" % duration], check=True, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL, env=dict(os.environ, ROS_PACKAGE_PATH=ROOT))


def digest_of_file(path):
    digest = hashlib.sha256()
    with open(path, "rb") as file:
        for block in iter(lambda: file.read(1 << 20), b""):
            digest.update(block)
    return digest.hexdigest()


def masked(content, first):
    """A serialized MarkerArray without DELETEALL markers, in the first message DELETE markers, and the words of labels."""
    array = MarkerArray().deserialize(content)
    actions = (Marker.DELETEALL, Marker.DELETE) if first else (Marker.DELETEALL,)
    array.markers = [marker for marker in array.markers if marker.action not in actions]
    for marker in array.markers:
        if marker.type == Marker.TEXT_VIEW_FACING:
            marker.text = ""
    out = io.BytesIO()
    array.serialize(out)
    return out.getvalue()


def digests_of_bag(path):
    """{topic: (number of messages, digest)}"""
    digests, counts = collections.defaultdict(hashlib.sha256), collections.Counter()
    with rosbag.Bag(path) as bag:
        for topic, (kind, content, _, _, _), stamp in bag.read_messages(raw=True):
            if kind == MarkerArray._type:
                content = masked(content, first=not counts[topic])
            digests[topic].update(b"%d %d\n" % (stamp.to_nsec(), len(content)))
            digests[topic].update(content)
            counts[topic] += 1
    return {topic: (counts[topic], digests[topic].hexdigest()) for topic in counts}


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("\n\n")[1][len("Usage: "):], add_help=True)
    parser.add_argument("build")
    parser.add_argument("scenes", nargs="*")
    parser.add_argument("--duration", type=float, default=DEFAULT_DURATION)
    given = parser.parse_args()
    program = os.path.join(given.build, "devel", "lib", "poinsot", "simulate")
    if not os.access(program, os.X_OK):
        parser.error("expected a build with the program simulate, found no %s" % program)
    names = given.scenes or sorted(os.path.basename(file)[:-len(".yaml")] for file in glob.glob(ROOT + "/scenes/*.yaml"))
    with tempfile.TemporaryDirectory(prefix="poinsot_digests_") as work:
        csv, bag = os.path.join(work, "scene.csv"), os.path.join(work, "scene.bag")
        for name in names:
            scene = os.path.join(ROOT, "scenes", name + ".yaml")
            try:
                simulate(program, scene, "--csv", csv, given.duration)
                simulate(program, scene, "--bag", bag, given.duration)
            except subprocess.CalledProcessError as error:
                print("digests.py: %s failed with exit code %d" % (" ".join(error.cmd), error.returncode), file=sys.stderr)
                return 1
            print("%-28s csv %s" % (name, digest_of_file(csv)))
            for topic, (count, digest) in sorted(digests_of_bag(bag).items()):
                print("%-28s %s %d %s" % (name, topic, count, digest))
            sys.stdout.flush()
    return 0


if __name__ == "__main__":
    sys.exit(main())
