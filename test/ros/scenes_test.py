#!/usr/bin/python3
"""A scene is the same, bit for bit, read as a file and as a tree of parameters."""
import copy
import glob
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rospy  # noqa: E402
import rostest  # noqa: E402
import yaml  # noqa: E402
from visualization_msgs.msg import MarkerArray  # noqa: E402

import graph  # noqa: E402
import processes  # noqa: E402
from poinsot.msg import BodyDescription, BodyState  # noqa: E402

SCENES = sorted(glob.glob(processes.package_path("scenes", "*.yaml")))
SCENES.append(processes.package_path("test", "ros", "scenes", "digits.yaml"))


def bare(text, prefix):
    return text[len(prefix):] if text.startswith(prefix) else text


class Side(object):
    """One of the two nodes."""

    def __init__(self, namespace, prefix, parameters, tree_file=None):
        self.namespace, self.prefix = namespace, prefix
        self.node = processes.start_node(namespace, dict(parameters, frame_prefix=prefix), tree_file)

    def latched(self, topic, message_class):
        listener = graph.Listener(self.namespace + "/" + topic, message_class)
        message = copy.deepcopy(graph.wait_for(listener.last, what=self.namespace + "/" + topic))
        listener.close()
        return message

    def description(self, body):
        d = self.latched(body + "/description", BodyDescription)
        d.header.frame_id = d.header.seq = None
        d.accuracy = repr(d.accuracy)  # NaN is not equal to itself
        d.step = repr(d.step)
        return d

    def markers(self):
        array = self.latched("markers_static", MarkerArray)
        markers = list(graph.told([array]))
        for m in markers:
            m.header.frame_id = bare(m.header.frame_id, self.prefix)
        return markers

    def states(self, bodies):
        """What every body's state is, paused, after a reset and after a seek."""
        control = graph.Control(self.namespace + "/poinsot")
        listeners = {body: graph.Listener("%s/%s/state" % (self.namespace, body), BodyState) for body in bodies}
        for listener in listeners.values():
            graph.wait_for(listener.last, what="a state")
        control.pause(True)
        control.reset()
        out = [self.fields(listeners[b].next_where(lambda s: s.time == 0 and s.time_rate == 0)) for b in bodies]
        control.seek(1.5)
        out += [self.fields(listeners[b].next_where(lambda s: s.time == 1.5 and s.time_rate == 0)) for b in bodies]
        for listener in listeners.values():
            listener.close()
        return out

    @staticmethod
    def fields(state):
        return {name: repr(getattr(state, name)) for name in state.__slots__ if name not in ("header", "cost")}


class ScenesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("scenes_test")

    def test_there_are_scenes(self):
        self.assertIn("dzhanibekov", [os.path.splitext(os.path.basename(path))[0] for path in SCENES])

    def check(self, path):
        with open(path) as text:
            bodies = [body["name"] for body in yaml.safe_load(text)["bodies"]]
        name = os.path.splitext(os.path.basename(path))[0]
        file = Side("/file_" + name, "file/", {"scene_file": path})
        self.addCleanup(file.node.close)
        tree = Side("/tree_" + name, "tree_", {}, path)
        self.addCleanup(tree.node.close)
        for body in bodies:
            a, b = file.description(body), tree.description(body)
            self.assertEqual(a.body, body)
            self.assertEqual(a, b)
        a, b = file.markers(), tree.markers()
        self.assertGreater(len(a), 1)
        self.assertEqual(len(a), len(b))
        for left, right in zip(a, b):
            self.assertEqual(left, right)
        a, b = file.states(bodies), tree.states(bodies)
        self.assertEqual(len(a), 2 * len(bodies))
        for left, right in zip(a, b):
            self.assertEqual(left, right)


def add_test(path):
    name = os.path.splitext(os.path.basename(path))[0]
    setattr(ScenesTest, "test_" + name, lambda self: self.check(path))


for scene in SCENES:
    add_test(scene)

if __name__ == "__main__":
    rostest.rosrun("poinsot", "scenes", ScenesTest)
