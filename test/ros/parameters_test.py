#!/usr/bin/python3
"""Bad parameters and bad scenes are refused at start, in words; good ones are heeded."""
import math
import os
import shutil
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rospy  # noqa: E402
import rostest  # noqa: E402

import graph  # noqa: E402
import processes  # noqa: E402
from poinsot.msg import BodyDescription, BodyState  # noqa: E402

GOOD = """
rate: 60
bodies:
  - name: top
    inertia: [1, 2, 3]
    angular_velocity: [0.1, 1, 0.1]
"""

# What is wrong with a scene, the scene, and words that the message must hold.
BAD_SCENES = [
    ("no YAML", "bodies: [name: {", ["not YAML"]),
    ("an empty file", "", ["empty"]),
    ("no bodies", "rate: 60\n", ["expected the key bodies", "got none"]),
    ("empty bodies", "bodies: []\n", ["bodies", "at least one body"]),
    ("a list", "- name: top\n", ["expected a map", "got a list of 1"]),
    ("an unknown key", GOOD + "    weather: red\n", ["weather: expected one of the keys name, ", 'got "weather"', "top"]),
    ("an unknown key above", GOOD + "speed: 3\n", ["speed: expected one of the keys rate, loop, bodies", 'got "speed"']),
    ("a negative moment", GOOD.replace("[1, 2, 3]", "[1, -2, 3]"), ["inertia", "positive", "got -2", "top"]),
    ("a zero moment", GOOD.replace("[1, 2, 3]", "[1, 0, 3]"), ["inertia", "positive", "got 0"]),
    ("a moment that is no number", GOOD.replace("[1, 2, 3]", "[1, .nan, 3]"), ["inertia", "got .nan", "finite"]),
    ("two moments", GOOD.replace("[1, 2, 3]", "[1, 2]"), ["inertia", "got a list of 2"]),
    ("a tensor that is not symmetric", GOOD.replace("[1, 2, 3]", "[[1, 0.5, 0], [0, 2, 0], [0, 0, 3]]"),
     ["inertia", "symmetric"]),
    ("an infinite rate of turning", GOOD.replace("[0.1, 1, 0.1]", "[0.1, .inf, 0.1]"), ["angular_velocity", "finite", "got .inf"]),
    ("an unknown method", GOOD + "    method: magic\n    step: 0.01\n", ["method: expected one of closed_form, ", "buss2", "rk4", 'got "magic"']),
    ("a step without a method", GOOD + "    step: 0.01\n", ["step", "expected no step", "rk4", "got a step without a method, which means closed_form"]),
    ("a step beside the closed form", GOOD + "    method: closed_form\n    step: 0.01\n",
     ["step", "expected no step", "rk4", "got a step beside closed_form"]),
    ("a stepper without a step", GOOD + "    method: rk4\n", ["method: expected the key step beside it", "got none"]),
    ("a hopeless step", GOOD + "    method: lie_euler\n    step: 5\n",
     ["top", "lie_euler with a step of 5 s", "|Omega| = 1.0", "a step of at most", "closed_form, which has no step"]),
    ("a mesh that is not there", GOOD + "    appearance: {mesh: package://poinsot/meshes/nosuch.dae}\n",
     ["top", "appearance.mesh", "expected the address of a mesh", "got package://poinsot/meshes/nosuch.dae",
      "there is no file"]),
    ("a mesh of no package", GOOD + "    appearance: {mesh: package://nosuch_package/a.dae}\n",
     ["top", "appearance.mesh", "there is no package nosuch_package"]),
    ("an energy that underflows", GOOD.replace("[0.1, 1, 0.1]", "[0, 1e-200, 0]"), ["angular_velocity", "too small"]),
    ("a negative step", GOOD + "    method: rk4\n    step: -0.01\n", ["step", "positive", "got -0.01"]),
    ("a zero quaternion", GOOD + "    attitude: [0, 0, 0, 0]\n", ["attitude", "got a zero quaternion", "top"]),
    ("an unknown effect", GOOD + "    effects: [{type: wind}]\n", ["expected one of translation, ", 'got "wind"']),
    ("a rate of zero", GOOD.replace("rate: 60", "rate: 0"), ["rate", "positive", "got 0"]),
    ("one name twice", GOOD + "  - {name: top, inertia: [1, 2, 3], angular_velocity: [0, 1, 0]}\n", ['expected a name that no other body has, got "top" a second time']),
    ("the name of a frame", GOOD.replace("name: top", "name: world"), ["world"]),
]


class ParametersTest(unittest.TestCase):
    count = 0

    @classmethod
    def setUpClass(cls):
        rospy.init_node("parameters_test")
        cls.node = processes.program("poinsot_node")
        cls.directory = tempfile.mkdtemp()
        cls.good = cls.file(GOOD, "good.yaml")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.directory)

    @classmethod
    def file(cls, text, name="scene.yaml"):
        path = os.path.join(cls.directory, name)
        with open(path, "w") as out:
            out.write(text)
        return path

    def start(self, parameters, scene_tree_file=None):
        """A node in a namespace of its own."""
        ParametersTest.count += 1
        namespace = "/case%d" % ParametersTest.count
        node = processes.start_node(namespace, parameters, scene_tree_file)
        self.addCleanup(node.close)
        return namespace, node

    def refused(self, what, parameters, words, scene_tree_file=None):
        with self.subTest(what):
            _, node = self.start(parameters, scene_tree_file)
            code = node.wait(30)
            message = node.err
            self.assertEqual(code, 2, "exit code; it wrote: " + node.console)
            for word in words:
                self.assertIn(word, message)

    def test_one_scene_must_be_given(self):
        self.refused("neither", {}, ["neither", "~scene", "~scene_file"])
        self.refused("both", {"scene_file": self.good}, ["both", "~scene", "~scene_file"], self.good)

    def test_scene_file(self):
        missing = os.path.join(self.directory, "missing.yaml")
        self.refused("a missing file", {"scene_file": missing}, [missing, "No such file"])
        self.refused("a directory", {"scene_file": self.directory}, [self.directory, "got a directory"])
        pipe = os.path.join(self.directory, "pipe.yaml")
        os.mkfifo(pipe)
        self.refused("a FIFO", {"scene_file": pipe}, [pipe, "got a FIFO"])
        self.refused("a number", {"scene_file": 7}, ["~scene_file", "7", "path"])
        self.refused("an empty path", {"scene_file": ""}, ["none that can be read"])
        self.refused("a relative path", {"scene_file": "missing.yaml"},
                     ["missing.yaml: expected a regular file", "means " + os.path.join(os.getcwd(), "missing.yaml")])
        self.refused("a scene that the package does not have",
                     {"scene_file": processes.package_path("scenes", "wingnutt.yaml")},
                     ["scene: expected the path of a scene file or one of damped_tumble, dzhanibekov, ", ", wingnut, ",
                      'got "wingnutt" (did you mean "wingnut"?)'])

    def test_bad_scenes_in_a_file(self):
        for what, text, words in BAD_SCENES:
            path = self.file(text)
            self.refused(what, {"scene_file": path}, [path] + words)

    def test_bad_scenes_as_parameters(self):
        self.refused("a list", {"scene": [1, 2]}, ["/scene", "expected a map", "got a list of 2"])
        self.refused("a text", {"scene": "dzhanibekov"}, ["/scene", "expected a map", 'got "dzhanibekov"'])
        for name in ("a negative moment", "an unknown method", "a zero quaternion", "one name twice", "empty bodies",
                     "an unknown key"):
            text, words = next((t, w) for what, t, w in BAD_SCENES if what == name)
            self.refused(name, {}, words + ["/scene"], self.file(text))

    def test_rate(self):
        for value in (0, -60, 0.0, -1.5, math.nan, math.inf, "fast", "0x10", True, [60]):
            self.refused("rate %r" % (value,), {"scene_file": self.good, "rate": value}, ["~rate", "positive"])

    def test_publish_clock(self):
        for value in (1, "true", 0.0):
            self.refused("publish_clock %r" % (value,), {"scene_file": self.good, "publish_clock": value},
                         ["~publish_clock", "true or false"])

    def test_frame_prefix(self):
        for value in (3, True, "a b", " ", "a-b", "/a", "1a"):
            self.refused("frame_prefix %r" % (value,), {"scene_file": self.good, "frame_prefix": value},
                         ["~frame_prefix", "letters"])

    def test_method(self):
        for parameters, words in (
                ({"method": "magic"}, ['parameter ~method: body "top": expected one of the methods', 'got "magic"']),
                ({"method": "bus2"}, ['(did you mean "buss2"?)']),
                ({"method": 4}, ["parameter ~method: expected the name of a method, got 4"]),
                ({"method": "taylor8"}, ["parameter ~method: ", "expected one of the methods that move this body"]),
                ({"step": 0.01}, ["parameter ~step: expected no step, or one beside a ~method", "got 0.01 without a ~method"]),
                ({"method": "closed_form", "step": 0.01}, ["parameter ~step: ", "got 0.01 beside closed_form"]),
                ({"method": "rk4", "step": 0}, ["parameter ~step: expected a positive finite number (s), got 0"]),
                ({"method": "rk4", "step": "soon"}, ["parameter ~step: expected a positive finite number (s)"]),
                ({"method": "rk4", "step": 5}, ['parameter ~step: body "top": expected a step of at most', "rk4 with a step of 5 s"])):
            self.refused("%s" % parameters, dict(parameters, scene_file=self.good), words)

    def described(self, parameters):
        """The description of the body, and what the node says."""
        namespace, node, _ = self.runs(parameters)
        descriptions = graph.Listener(namespace + "/top/description", BodyDescription)
        description = graph.wait_for(descriptions.last, what="a description")
        descriptions.close()
        self.assertTrue(processes.eventually(lambda: "playing scene" in node.console), node.console)
        return description, node.console

    def test_method_and_step_hold_for_all_bodies(self):
        description, console = self.described({"scene_file": self.good, "method": "rk4", "step": "1e-3"})
        self.assertEqual((description.method, description.step), ("rk4", 1e-3))
        self.assertIn("top by rk4 with a step of 0.001 s", console)
        description, _ = self.described({"scene_file": self.good, "method": "lie_euler"})
        self.assertEqual(description.method, "lie_euler")
        self.assertGreater(description.step, 0)
        accurate = self.file(GOOD + "    accuracy: 1e-6\n    horizon: 10\n", "accurate.yaml")
        self.assertEqual(self.described({"scene_file": accurate, "method": "buss2"})[0].method, "buss2")

    def test_the_node_says_what_it_plays(self):
        namespace, node, _ = self.runs({"scene_file": self.good, "rate": 20, "frame_prefix": "a/"})
        expected = "playing scene good (%s) at 20 Hz in namespace %s, frames with the prefix a/: top by closed_form" % (
            self.good, namespace)
        self.assertTrue(processes.eventually(lambda: expected in node.console), node.console)
        namespace, node, _ = self.runs({}, self.good)
        expected = "playing the scene of parameter %s/poinsot/scene at 60 Hz" % namespace
        self.assertTrue(processes.eventually(lambda: expected in node.console), node.console)

    def runs(self, parameters, scene_tree_file=None):
        namespace, node = self.start(parameters, scene_tree_file)
        states = graph.Listener(namespace + "/top/state", BodyState)
        state = graph.wait_for(states.last, what="a state")
        states.close()
        return namespace, node, state

    def period(self, parameters, scene_tree_file=None):
        """The length of a step [s], which is 1/rate."""
        namespace, _, _ = self.runs(parameters, scene_tree_file)
        states = graph.Listener(namespace + "/top/state", BodyState)
        control = graph.Control(namespace + "/poinsot")
        control.pause()
        before = states.next_where(lambda s: s.time_rate == 0)
        answer = control.step()
        self.assertTrue(answer.success)
        after = states.next_where(lambda s: s.time_rate == 0 and s.time > before.time)
        states.close()
        return after.time - before.time

    def test_rate_wins_over_the_scene(self):
        self.assertAlmostEqual(self.period({"scene_file": self.good}), 1 / 60.0, delta=1e-9)
        self.assertAlmostEqual(self.period({"scene_file": self.good, "rate": 20}), 0.05, delta=1e-9)
        self.assertAlmostEqual(self.period({"rate": 12.5}, self.good), 0.08, delta=1e-9)
        # `rate: 1e2` of a parameter file: a text for its reader.
        self.assertAlmostEqual(self.period({"scene_file": self.good, "rate": "1e2"}), 0.01, delta=1e-9)

    def test_moments_of_no_real_body_are_simulated_with_a_warning(self):
        path = self.file(GOOD.replace("[1, 2, 3]", "[1, 2, 10]"), "unphysical.yaml")
        for parameters, tree in (({"scene_file": path}, None), ({}, path)):
            _, node, _ = self.runs(parameters, tree)
            self.assertTrue(processes.eventually(lambda: "no real body" in node.console), node.console)
            self.assertIn("WARN", node.console)
            self.assertTrue(node.running())
        _, node, _ = self.runs({"scene_file": self.good})
        self.assertNotIn("WARN", node.console)

    def test_a_doubtful_step_is_simulated_with_a_warning(self):
        path = self.file(GOOD + "    method: lie_euler\n    step: 0.05\n", "doubtful.yaml")
        _, node, _ = self.runs({"scene_file": path})
        self.assertTrue(processes.eventually(lambda: "lie_euler with a step of 0.05 s" in node.console), node.console)
        self.assertIn("WARN", node.console)
        code, _, err = processes.run([self.node, "--check", path])
        self.assertEqual(code, 0)
        self.assertIn("closed_form, which has no step", err)

    def test_check(self):
        code, out, err = processes.run([self.node, "--check", self.good])
        self.assertEqual((code, out, err), (0, "top: closed_form, about the axis of largest moment\nno fault\n", ""))
        code, out, err = processes.run([self.node, "--check", self.file(GOOD.replace("[1, 2, 3]", "[1, 2, 10]"))])
        self.assertEqual(code, 0)
        self.assertIn("no real body", err)
        self.assertTrue(out.endswith("no fault, one warning\n"), out)
        for what, text, words in BAD_SCENES:
            with self.subTest(what):
                path = self.file(text)
                code, out, err = processes.run([self.node, "--check", path])
                self.assertEqual((code, out), (2, ""))
                for word in [path] + words:
                    self.assertIn(word, err)
        self.assertEqual(processes.run([self.node, "--check", os.path.join(self.directory, "missing.yaml")])[0], 2)

    def test_options(self):
        code, out, _ = processes.run([self.node, "--help"])
        self.assertEqual(code, 0)
        for word in ("~scene", "~scene_file", "~rate", "~method", "~step", "~publish_clock", "~frame_prefix", "--check"):
            self.assertIn(word, out)
        for arguments in (["--nonsense"], ["--check"], ["some.yaml"]):
            with self.subTest(arguments):
                code, out, err = processes.run([self.node] + arguments)
                self.assertEqual((code, out), (2, ""))
                self.assertTrue(err)


if __name__ == "__main__":
    rostest.rosrun("poinsot", "parameters", ParametersTest)
