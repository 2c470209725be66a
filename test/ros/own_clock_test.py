#!/usr/bin/python3
"""The node as the owner of /clock, and how nodes end."""
import math
import os
import shutil
import signal
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rospy  # noqa: E402
import rostest  # noqa: E402
import yaml  # noqa: E402
from rosgraph_msgs.msg import Clock, Log  # noqa: E402

import graph  # noqa: E402
import processes  # noqa: E402
from poinsot.msg import Activity, BodyState, NodeStatus  # noqa: E402
from poinsot.srv import LoadScene  # noqa: E402

RATE = 100
PERIOD = 1000000000 // RATE  # ns


class OwnClockTest(unittest.TestCase):
    """One story: the tests run in the order of their names."""

    @classmethod
    def setUpClass(cls):
        rospy.init_node("own_clock_test")
        cls.clock = graph.Listener("/clock", Clock)
        cls.states = graph.Listener("/owner/wingnut/state", BodyState)
        cls.followed = graph.Listener("/follower/wingnut/state", BodyState)
        scene = processes.package_path("scenes", "dzhanibekov.yaml")
        cls.follower = processes.start_node("/follower", {"scene_file": scene, "rate": RATE, "frame_prefix": "f/"})
        graph.Control("/follower/poinsot")
        cls.began = time.time()
        cls.owner = processes.start_node("/owner", {"scene_file": scene, "rate": RATE, "publish_clock": True})
        cls.control = graph.Control("/owner/poinsot")
        graph.wait_for(cls.states.last, what="a state")

    @classmethod
    def tearDownClass(cls):
        for process in (cls.owner, cls.follower):
            process.close()

    def clocks(self):
        return [m.clock.to_nsec() for m in self.clock.all()]

    def test_1_starts_above_zero(self):
        first = graph.wait_for(self.clocks, what="/clock")[0]
        self.assertGreater(first, 0)
        self.assertLess(first * 1e-9, 10 + time.time() - self.began, "a clock of its own, not the wall's")

    def test_2_advances_by_one_period_a_tick_at_about_wall_speed(self):
        graph.wait_for(self.clocks, what="/clock")
        self.clock.clear()
        begin = time.time()
        graph.wait_for(lambda: time.time() > begin + 3 and len(self.clocks()) > RATE, 60, "three seconds of /clock")
        wall = time.time() - begin
        clocks = self.clocks()
        for a, b in zip(clocks, clocks[1:]):
            self.assertGreater(b, a, "/clock never decreases, and no tick repeats it")
            ticks = int(round((b - a) / PERIOD))  # more than one only where a message was lost on the way
            self.assertLessEqual(abs((b - a) - ticks * PERIOD), 1)
        one = sum(1 for a, b in zip(clocks, clocks[1:]) if b - a < 1.5 * PERIOD)
        self.assertGreater(one, 0.9 * len(clocks))
        pace = (clocks[-1] - clocks[0]) * 1e-9 / wall
        print("pace against the wall clock: %.4f" % pace)
        self.assertTrue(0.5 < pace < 1.2, pace)

    def test_3_stamps_are_values_of_the_clock_with_every_listener(self):
        for states in (self.states, self.followed):
            self.assertTrue(self.control.pause(False).success)
            first = states.next()
            last = states.next_where(lambda s: (s.header.stamp - first.header.stamp).to_sec() > 1)
            graph.wait_for(lambda: self.clock.last().clock >= last.header.stamp, what="the clock")
            shown = set(self.clocks())
            earliest = min(shown)
            stamps = [s.header.stamp.to_nsec() for s in states.all()
                      if earliest <= s.header.stamp.to_nsec() <= last.header.stamp.to_nsec()]
            self.assertGreater(len(stamps), RATE / 4)
            self.assertEqual(len(stamps), len(set(stamps)))
            missing = [stamp for stamp in stamps if stamp not in shown]
            self.assertLess(len(missing), 0.02 * len(stamps), missing)  # a message of /clock may be lost on the way

    def test_4_runs_on_while_paused(self):
        self.control.pause(True)
        first = self.states.next_where(lambda s: s.time_rate == 0)
        later = self.states.next_where(lambda s: (s.header.stamp - first.header.stamp).to_sec() > 0.5)
        self.assertEqual(later.time, first.time)
        self.assertGreater(self.clock.next().clock, first.header.stamp)
        following = self.followed.next()
        self.assertEqual(following.time_rate, 1, "who follows the clock is not paused")
        self.control.reset()
        self.control.pause(False)
        self.states.next_where(lambda s: s.time_rate == 1)
        clocks = self.clocks()
        self.assertEqual(clocks, sorted(clocks), "a reset does not touch the clock")

    def test_5_ends_cleanly_with_its_clock(self):
        self.assertTrue(self.owner.running())
        self.assertEqual(self.owner.interrupt(5), 0, self.owner.console)

    def test_6_ends_cleanly_under_a_clock_that_stands_still(self):
        self.assertTrue(self.follower.running())
        self.assertEqual(self.follower.interrupt(5), 0, self.follower.console)

    def test_7_ends_cleanly_under_a_clock_that_never_began(self):
        node = processes.start_node("/waiting", {"scene_file": processes.package_path("scenes", "dzhanibekov.yaml")})
        try:
            graph.Control("/waiting/poinsot")
            self.assertEqual(node.interrupt(5), 0, node.console)
        finally:
            node.close()

    def test_8_a_slow_node_ends_as_promptly(self):
        node = processes.start_node("/slow", {"scene_file": processes.package_path("scenes", "dzhanibekov.yaml"),
                                              "rate": 0.01, "publish_clock": True})
        try:
            graph.Control("/slow/poinsot")
            self.assertEqual(node.interrupt(5), 0, node.console)
        finally:
            node.close()

    def heavy(self):
        """A scene whose accuracies take a minute or more to be met."""
        bodies = [{"name": "top%d" % i, "inertia": [1.0, 1.2, 0.5], "angular_velocity": [0.1, 0.2, 20.0 + i],
                   "accuracy": 1e-9, "horizon": 3000.0,
                   "effects": [{"type": "gravity_torque", "mass": 1.0, "gravity": [0.0, 0.0, -9.8],
                                "centre_of_mass": [0.0, 0.0, 0.4]}]} for i in range(60)]
        path = os.path.join(tempfile.mkdtemp(), "heavy.yaml")
        self.addCleanup(shutil.rmtree, os.path.dirname(path))
        with open(path, "w") as out:
            yaml.safe_dump({"bodies": bodies}, out)
        return path

    def test_9_ends_while_accuracies_are_looked_for_at_the_start(self):
        node = processes.start_node("/heavy", {"scene_file": self.heavy()})
        try:
            graph.wait_for(lambda: node.cpu_seconds() > 1, what="the node to be at work")
            self.assertTrue(node.running(), node.console)
            self.assertEqual(node.interrupt(5), 0, node.console)
        finally:
            node.close()

    def test_9_ends_while_accuracies_are_looked_for_later(self):
        scene = processes.package_path("scenes", "dzhanibekov.yaml")
        node = processes.start_node("/heavier", {"scene_file": scene, "publish_clock": True})
        try:
            graph.Control("/heavier/poinsot")
            status = graph.Listener("/heavier/poinsot/status", NodeStatus)
            load = rospy.ServiceProxy("/heavier/poinsot/load_scene", LoadScene)
            self.assertTrue(load(self.heavy()).success)
            at_work = node.cpu_seconds()
            graph.wait_for(lambda: node.cpu_seconds() > at_work + 0.5, what="the node to be at work")
            self.assertEqual(status.next().busy, "scene heavy")
            # Another wish is not kept waiting either.
            self.assertTrue(load("phone").success)
            status.next_where(lambda s: s.scene == "phone" and not s.busy)
            self.assertTrue(load(self.heavy()).success)
            again = status.next_where(lambda s: s.busy)
            self.assertEqual(again.busy, "scene heavy")
            self.assertEqual(again.activities, [Activity(kind=Activity.LOAD_SCENE, scene="heavy")])
            self.assertEqual(node.interrupt(5), 0, node.console)
            status.close()
        finally:
            node.close()

    def test_9_ends_whenever_it_is_told_to(self):
        scene = processes.package_path("scenes", "phone.yaml")
        for number in (signal.SIGINT, signal.SIGTERM):
            for after in range(0, 500, 40):  # ms
                node = processes.start_node("/early", {"scene_file": scene, "publish_clock": True})
                try:
                    time.sleep(1e-3 * after)
                    code = node.send(number, 5)
                    # Before the node takes signals they end it at once.
                    self.assertIn(code, (0, -number), "after %d ms: %s" % (after, node.console))
                finally:
                    node.close()

    def test_9_ends_without_a_master(self):
        environment = dict(os.environ, ROS_MASTER_URI="http://127.0.0.1:9")
        node = processes.Process([processes.program("poinsot_node")], environment)
        try:
            graph.wait_for(lambda: "waiting for a ROS master at http://127.0.0.1:9" in node.console, what="its message")
            self.assertEqual(node.interrupt(5), 0, node.console)
        finally:
            node.close()

    def test_9_ends_in_the_middle_of_a_long_seek(self):
        scene = processes.package_path("test", "ros", "scenes", "buss2.yaml")
        node = processes.start_node("/seeking", {"scene_file": scene, "publish_clock": True})
        log = graph.Listener("/rosout", Log)
        states = graph.Listener("/seeking/top/state", BodyState)
        try:
            control = graph.Control("/seeking/poinsot")
            # A refused seek that is heard of shows that the log is listened to.
            def heard():
                control.seek(math.nan)
                time.sleep(0.1)
                return any("seek refused: expected a finite time (s), got nan" in m.msg for m in log.all())
            graph.wait_for(heard, what="the node's log")
            control.seek(90000.0)
            graph.wait_for(lambda: any("playing on meanwhile" in m.msg for m in log.all()), what="the seek to begin")
            self.assertLess(states.next().time, 90000)
            self.assertEqual(node.interrupt(5), 0, node.console)
        finally:
            node.close()


if __name__ == "__main__":
    rostest.rosrun("poinsot", "own_clock", OwnClockTest)
