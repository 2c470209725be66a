#!/usr/bin/python3
"""A bag that simulate writes is what the node would have sent: complete, audited, replayed, the same numbers as its CSV."""
import csv
import math
import os
import shutil
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rosbag  # noqa: E402
import rostest  # noqa: E402

import processes  # noqa: E402
from record_and_replay_test import LATCHED, TOPICS, Launch, watch  # noqa: E402

DURATION, RATE = 14.51, 60
TICKS = 872  # 0, 1/60, ..., 870/60, and the duration


class SimulateTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.mkdtemp()
        cls.bag, cls.csv = (os.path.join(cls.directory, name) for name in ("run.bag", "run.csv"))
        code, out, err = cls.simulate("dzhanibekov", "--bag", cls.bag, "--csv", cls.csv)
        assert code == 0 and not out and not err, out + err

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.directory)

    @classmethod
    def simulate(cls, scene, *arguments):
        """Without a master, and without a way to one."""
        path = scene if os.path.isabs(scene) else processes.package_path("scenes", scene + ".yaml")
        return processes.run(["env", "-u", "ROS_MASTER_URI", processes.program("simulate"), path,
                              "--duration", str(DURATION), "--rate", str(RATE)] + list(arguments))

    def check_bag(self, path, *arguments):
        code, out, err = processes.run([processes.program("check_bag"), path] + list(arguments), 120)
        return code, out + err

    def test_topics_types_and_counts(self):
        expected = {topic: kind for topic, kind in TOPICS.items() if topic != "/diagnostics"}
        counts = {topic: TICKS for topic in expected}
        counts.update({"/wingnut/description": 1, "/tf_static": 1, "/poinsot/layout": 1, "/markers_static": 2})
        with rosbag.Bag(self.bag) as bag:
            topics = bag.get_type_and_topic_info().topics
            self.assertEqual({topic: info.msg_type for topic, info in topics.items()}, expected)
            self.assertEqual({topic: info.message_count for topic, info in topics.items()}, counts)
            latched = {c.topic for c in bag._get_connections()
                       if c.header.get(b"latching", c.header.get("latching")) in (b"1", "1")}
            self.assertEqual(latched, LATCHED)
            self.assertTrue(all(c.msg_def.strip() for c in bag._get_connections()), "it carries its definitions")

    def test_states_are_those_of_the_csv(self):
        with open(self.csv) as file:
            rows = list(csv.DictReader(file))
        with rosbag.Bag(self.bag) as bag:
            messages = [(m, stamp) for _, m, stamp in bag.read_messages("/wingnut/state")]
        self.assertEqual(len(rows), TICKS)
        self.assertEqual(len(messages), TICKS)
        self.assertEqual(messages[-1][0].time, DURATION)
        for row, (m, stamp) in zip(rows, messages):
            q, w, p = m.attitude, m.omega_body, m.position
            self.assertEqual([float(row[k]) for k in "t qw qx qy qz O1 O2 O3 bx by bz".split()],
                             [m.time, q.w, q.x, q.y, q.z, w.x, w.y, w.z, p.x, p.y, p.z])
            self.assertEqual(row["body"], m.body)
            self.assertEqual((m.time_rate, m.segment), (1, 0))
            self.assertEqual(m.header.stamp.to_nsec(), 10**9 + round(m.time * 10**9))
            self.assertEqual(stamp, m.header.stamp)
            self.assertTrue(math.isnan(m.cost))

    def test_the_audit_passes(self):
        code, text = self.check_bag(self.bag)
        self.assertEqual(code, 0, text)

    def test_scenes_of_many_kinds_pass_the_audit(self):
        scenes = {"regimes": "regimes"}
        for name in ("tensor", "thrown", "rk4", "two_methods"):
            scenes[name] = os.path.join(os.path.dirname(os.path.abspath(__file__)), "scenes", name + ".yaml")
        for name, scene in scenes.items():
            with self.subTest(name):
                path = os.path.join(self.directory, name + ".bag")
                code, out, err = self.simulate(scene, "--bag", path)
                self.assertEqual(code, 0, err)
                code, text = self.check_bag(path)
                self.assertEqual(code, 0, text)

    def test_bodies_under_torques_pass_the_audit_and_wrong_torques_do_not(self):
        path = os.path.join(self.directory, "torques.bag")
        scene = os.path.join(os.path.dirname(os.path.abspath(__file__)), "scenes", "torques.yaml")
        code, out, err = self.simulate(scene, "--bag", path)
        self.assertEqual(code, 0, err)
        code, text = self.check_bag(path)
        self.assertEqual(code, 0, text)
        for check in ("E - m g.Rc conserved", "E - n N.L + 3/2 n^2 u'Mu conserved", "slug's equation",
                      "L = L0 + torque t", "E never rises", "one motion: omega"):
            self.assertIn(check, text)

        # The same recording, described as if something else acted.
        for body, was, put in (("top", "mass 2,", "mass 2.02,"),
                               ("satellite", "orbit_rate 0.1", "orbit_rate 0.1005"),
                               ("satellite", "orbit_normal [0, ", "orbit_normal [0, -"),
                               ("explorer", "damping 0.5", "damping 0.505"),
                               ("despun", "frame body, torque [0, 0, -0.5]", "frame world, torque [0, 0, -0.5]"),
                               ("despun", "frame body, torque [0, 0, -0.5]", "frame body, torque [0, 0, 0.5]"),
                               ("pushed", "frame world", "frame body"),
                               ("damped", "coefficient [0.1", "coefficient [0.101"),
                               ("damped", "viscous_damping", "viscous_drag")):
            with self.subTest(body + ": " + put):
                spoiled = os.path.join(self.directory, "other_torques.bag")
                changed = 0
                with rosbag.Bag(path) as source, rosbag.Bag(spoiled, "w") as out:
                    topics = ["/%s/%s" % (body, name) for name in ("state", "description", "odometry")]
                    for topic, message, stamp, header in source.read_messages(topics + ["/tf", "/tf_static"],
                                                                              return_connection_header=True):
                        if topic == topics[1]:
                            changed += sum(was in text for text in message.effects)
                            message.effects = [text.replace(was, put) for text in message.effects]
                        out.write(topic, message, stamp, connection_header=header)
                self.assertEqual(changed, 1)
                code, text = self.check_bag(spoiled, "--without", "markers")
                self.assertEqual(code, 1, text)

    def test_without_markers(self):
        path = os.path.join(self.directory, "bare.bag")
        self.assertEqual(self.simulate("dzhanibekov", "--bag", path, "--no-markers")[0], 0)
        with rosbag.Bag(path) as bag:
            self.assertEqual(set(bag.get_type_and_topic_info().topics),
                             set(TOPICS) - {"/diagnostics", "/markers", "/markers_static", "/poinsot/layout"})
        code, text = self.check_bag(path, "--without", "markers")
        self.assertEqual(code, 0, text)
        self.assertEqual(self.check_bag(path)[0], 1, "missing markers are noticed")

    def test_the_audit_fails_on_a_damaged_bag(self):
        def spoiled(name, spoil):
            path = os.path.join(self.directory, name)
            with rosbag.Bag(self.bag) as source, rosbag.Bag(path, "w") as out:
                count = 0
                for topic, message, stamp, header in source.read_messages(return_connection_header=True):
                    count += topic == "/wingnut/state"
                    if topic == "/wingnut/state" and count == 400:
                        spoil(message)
                    out.write(topic, message, stamp, connection_header=header)
            return path

        def shift(message):
            message.attitude.x += 1e-6

        def slow(message):
            message.omega_body.x += 1e-3

        def cost(message):
            message.cost = math.inf
        self.assertEqual(self.check_bag(spoiled("same.bag", lambda message: None))[0], 0)
        for spoil in (shift, slow, cost):
            with self.subTest(spoil.__name__):
                code, text = self.check_bag(spoiled(spoil.__name__ + ".bag", spoil))
                self.assertEqual(code, 1, text)
        cut = os.path.join(self.directory, "cut.bag")
        with open(self.bag, "rb") as whole, open(cut, "wb") as out:
            out.write(whole.read(300000))
        self.assertEqual(self.check_bag(cut)[0], 2)

    def test_replay(self):
        replay = Launch(self.directory, "replay.launch", "bag:=" + self.bag, "rviz:=false", "delay:=1")
        try:
            seen = replay.ask(watch)
            for picture in ("space", "model"):
                for what in ("energy_ellipsoid", "momentum_ellipsoid", "polhode", "separatrix"):
                    self.assertIn("wingnut/%s/%s" % (picture, what), seen["static markers"])
                self.assertIn("wingnut/%s/omega" % picture, seen["moving markers"])
            self.assertEqual(seen["static frames"], ["wingnut_model", "wingnut_space"])
            self.assertEqual(seen["moving frames"], ["wingnut", "wingnut_space_body"])
            self.assertEqual(seen["described"], "wingnut")
            self.assertTrue(seen["clock in order"])
            self.assertEqual(replay.process.wait(90), 0, replay.process.console)
        finally:
            replay.process.close()


if __name__ == "__main__":
    rostest.rosrun("poinsot", "simulate", SimulateTest)
