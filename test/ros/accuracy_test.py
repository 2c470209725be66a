#!/usr/bin/python3
"""`accuracy:` in a scene, from outside: the node says what it picked, and keeps its word in what it publishes."""
import math
import os
import shutil
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rospy  # noqa: E402
import rostest  # noqa: E402
import yaml  # noqa: E402

import graph  # noqa: E402
import processes  # noqa: E402
from poinsot.msg import BodyDescription, BodyState  # noqa: E402

HORIZON = 40.0  # s
START = {"inertia": [1.0, 2.0, 3.0], "angular_velocity": [0.3, 1.9, 0.4]}
WISHES = {"coarse": 1e-2, "middling": 1e-6, "fine": 1e-11}


class AccuracyTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("accuracy_test")
        cls.directory = tempfile.mkdtemp()
        bodies = [dict(START, name=name, method="stepper", accuracy=accuracy, horizon=HORIZON,
                       effects=[{"type": "translation", "position": [0.0, 7.0 * i, 0.0]}])
                  for i, (name, accuracy) in enumerate(sorted(WISHES.items()))]
        bodies.append(dict(START, name="free", accuracy=1e-9, horizon=HORIZON,
                           effects=[{"type": "translation", "position": [0.0, -7.0, 0.0]}]))
        cls.states = {b["name"]: graph.Listener("/%s/state" % b["name"], BodyState) for b in bodies}
        cls.descriptions = {b["name"]: graph.Listener("/%s/description" % b["name"], BodyDescription) for b in bodies}
        cls.node = processes.start_node("", {"scene_file": cls.scene(bodies)})

    @classmethod
    def scene(cls, bodies, name="scene.yaml"):
        path = os.path.join(cls.directory, name)
        with open(path, "w") as out:
            yaml.safe_dump({"bodies": bodies}, out)
        return path

    @classmethod
    def tearDownClass(cls):
        cls.node.close()
        shutil.rmtree(cls.directory)

    def test_the_word_is_kept_by_what_is_published(self):
        control = graph.Control("/poinsot")
        control.speed(15.0)
        for name, listener in self.states.items():
            graph.wait_for(lambda: listener.last() and listener.last().time >= HORIZON, 40, "the end of " + name)
            description = graph.wait_for(self.descriptions[name].last)
            errors = [s.attitude_error for s in listener.all() if s.time <= HORIZON]
            self.assertGreater(len(errors), 20)
            if name == "free":
                self.assertEqual(description.accuracy, 1e-9)
                continue
            self.assertEqual(description.accuracy, WISHES[name])
            self.assertNotEqual(description.method, "closed_form")
            self.assertGreater(description.step, 0)
            self.assertLessEqual(max(errors), WISHES[name], name)
            self.assertGreater(max(errors), 0, "nothing was judged")
            # On its console: who listens to /rosout is connected too late for what a node says first.
            said = [line for line in self.node.console.splitlines() if name + ": " + description.method in line]
            self.assertTrue(said, "the node does not say what it picked for " + name)
            for words in ("estimated error", "verified by the closed form", "CPU s per simulated s"):
                self.assertIn(words, said[0])
        steps = [self.descriptions[name].last().step for name in ("coarse", "fine")]
        self.assertFalse(any(math.isnan(step) for step in steps))

    def test_what_cannot_be_reached_is_refused_with_a_reason(self):
        path = self.scene([dict(START, name="greedy", method="lie_euler", accuracy=1e-12, horizon=HORIZON)], "greedy.yaml")
        code, out, err = processes.run([processes.program("poinsot_node"), "--check", path])
        self.assertEqual(code, 2, out + err)
        self.assertIn("greedy.yaml:", err)
        self.assertIn("expected a larger accuracy", err)
        self.assertIn("lie_euler", err)


if __name__ == "__main__":
    rostest.rosrun("poinsot", "accuracy", AccuracyTest)
