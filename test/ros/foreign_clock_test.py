#!/usr/bin/python3
"""Somebody else's /clock: late, frozen, fast, and jumping back. The test is that somebody."""
import os
import sys
import threading
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rosgraph  # noqa: E402
import rospy  # noqa: E402
import rostest  # noqa: E402
import yaml  # noqa: E402
from diagnostic_msgs.msg import DiagnosticArray  # noqa: E402
from geometry_msgs.msg import Vector3  # noqa: E402
from nav_msgs.msg import Odometry  # noqa: E402
from rosgraph_msgs.msg import Clock  # noqa: E402
from tf2_msgs.msg import TFMessage  # noqa: E402
from visualization_msgs.msg import MarkerArray  # noqa: E402

import graph  # noqa: E402
import processes  # noqa: E402
from poinsot.msg import BodyDescription, BodyState, NodeStatus  # noqa: E402
from poinsot.srv import LoadScene, SetMethod, SetSpin  # noqa: E402

NODE = "/poinsot"
START = 1000.0  # s


class Time(object):
    """/clock, about a hundred times a second of wall time; a held clock goes on saying the same."""
    PERIOD = 0.01

    def __init__(self):
        self._publisher = rospy.Publisher("/clock", Clock, queue_size=1000, tcp_nodelay=True)
        self._lock = threading.Lock()
        self._now = None  # nothing is sent
        self._speed = 0.0
        self.said = set()
        thread = threading.Thread(target=self._run)
        thread.daemon = True
        thread.start()

    def _run(self):
        last = time.time()
        while not rospy.is_shutdown():
            time.sleep(self.PERIOD)
            now = time.time()
            with self._lock:
                if self._now is not None:
                    self._now += self._speed * min(now - last, 0.1)
                    self._say()
            last = now

    def _say(self):
        stamp = rospy.Time.from_sec(self._now)
        self.said.add(stamp.to_nsec())
        self._publisher.publish(Clock(stamp))

    def set(self, now):
        with self._lock:
            self._now = now
            self._say()

    def run(self, speed):
        with self._lock:
            self._speed = speed

    def now(self):
        with self._lock:
            return self._now

    def wait_for_listener(self, node):
        """Until the node, and everybody who asked before, is connected."""
        def connected():
            subscribers = dict(rosgraph.Master("/foreign_clock_test").getSystemState()[1]).get("/clock", [])
            return node in subscribers and self._publisher.get_num_connections() >= len(subscribers)
        graph.wait_for(connected, what=node + " to listen to /clock")


class ForeignClockTest(unittest.TestCase):
    """One story: the tests run in the order of their names."""

    @classmethod
    def setUpClass(cls):
        rospy.init_node("foreign_clock_test")
        cls.states = graph.Listener("/wingnut/state", BodyState)
        cls.odometry = graph.Listener("/wingnut/odometry", Odometry)
        cls.tf = graph.Listener("/tf", TFMessage)
        cls.markers = graph.Listener("/markers", MarkerArray)
        cls.static = {"markers_static": graph.Listener("/markers_static", MarkerArray),
                      "tf_static": graph.Listener("/tf_static", TFMessage),
                      "description": graph.Listener("/wingnut/description", BodyDescription)}
        cls.status = graph.Listener(NODE + "/status", NodeStatus)
        cls.control = graph.Control(NODE)
        cls.time = Time()
        cls.time.wait_for_listener(NODE)

    def moving(self):
        return [self.states, self.odometry, self.tf, self.markers]

    def static_counts(self):
        return {name: len(listener.all()) for name, listener in self.static.items()}

    def quiet(self):
        """Waits until nothing comes any more."""
        def counts():
            return [len(listener.all()) for listener in self.moving()]
        before, since, deadline = counts(), time.time(), time.time() + 15
        while time.time() - since < 0.7:
            self.assertLess(time.time(), deadline, "something keeps coming")
            time.sleep(0.02)
            if counts() != before:
                before, since = counts(), time.time()

    def hold(self):
        self.time.run(0.0)
        self.quiet()

    def check_stamps(self, states):
        for a, b in zip(states, states[1:]):
            self.assertLess(a.header.stamp, b.header.stamp, "no stamp comes twice")
        for s in states:
            self.assertIn(s.header.stamp.to_nsec(), self.time.said, "a stamp that the clock never showed")

    def check_time(self, states):
        """t follows the stamps."""
        for a, b in zip(states, states[1:]):
            expected = a.time_rate * (b.header.stamp - a.header.stamp).to_sec()
            self.assertAlmostEqual(b.time - a.time, expected, delta=5e-9)

    def test_1_nothing_moves_before_the_clock_begins(self):
        graph.wait_for(lambda: all(self.static_counts().values()), what="what is static")
        time.sleep(1.0)  # there is no condition for what must not come
        for listener in self.moving():
            self.assertEqual(len(listener.all()), 0)
        for t in self.static["tf_static"].last().transforms:
            self.assertTrue(t.header.stamp.is_zero())
        self.status.next_where(lambda s: s.waiting_for_clock)

    def test_2_begins_with_the_clock(self):
        self.time.set(START)
        self.time.run(1.0)
        first = graph.wait_for(lambda: (self.states.all() or [None])[0], what="the first state")
        self.assertLess(abs(first.time), 1e-12, "t begins at 0, whatever the clock says")
        self.assertGreaterEqual(first.header.stamp.to_sec(), START)
        self.states.next_where(lambda s: s.header.stamp.to_sec() > START + 2)
        self.assertFalse(self.status.next().waiting_for_clock)
        states = self.states.all()
        self.check_stamps(states)
        self.check_time(states)
        self.assertEqual({s.segment for s in states}, {first.segment})
        self.assertGreater(len(states), 20)
        for listener in self.moving():
            self.assertGreater(len(listener.all()), 0)

    def test_3_a_frozen_clock_repeats_no_stamp(self):
        self.hold()
        counts = [len(listener.all()) for listener in self.moving()]
        time.sleep(1.0)  # no condition here either
        self.assertEqual([len(listener.all()) for listener in self.moving()], counts)
        type(self).counts = dict(zip(self.moving(), counts))
        self.check_stamps(self.states.all())
        seen = set()
        for message in self.tf.all():
            for t in message.transforms:
                key = (t.child_frame_id, t.header.stamp.to_nsec())
                self.assertNotIn(key, seen, "tf drops a repeated stamp")
                seen.add(key)

    def test_3_b_who_comes_while_the_clock_is_frozen_sees_where_everything_is(self):
        here = self.states.last().header.stamp
        stamps = {"secs": here.secs, "nsecs": here.nsecs}

        def late_subscriber(topic):
            """What another process is given; this one is connected already."""
            code, out, err = processes.run(["rostopic", "echo", "-n1", topic])
            self.assertEqual(code, 0, err)
            return next(yaml.safe_load_all(out))
        transforms = late_subscriber("/tf")["transforms"]
        self.assertEqual({t["child_frame_id"] for t in transforms}, {"wingnut", "wingnut_space_body"})
        markers = [m for m in late_subscriber("/markers")["markers"] if m["ns"] == "wingnut/model/omega"]
        self.assertTrue(markers, "Omega in the picture")
        for it in transforms + markers:
            self.assertEqual(it["header"]["stamp"], stamps)
        for repeated in (self.states, self.tf):
            self.assertEqual(repeated.count(), self.counts[repeated], "who was there is not sent it again")

    def test_3_ba_the_status_says_that_the_clock_is_frozen(self):
        self.status.next_where(lambda s: s.waiting_for_clock)

    def test_3_bb_changes_under_a_frozen_clock_begin_where_the_body_is(self):
        status = self.status

        def call(service, kind, *arguments):
            rospy.wait_for_service(NODE + "/" + service, graph.PATIENCE)
            answer = rospy.ServiceProxy(NODE + "/" + service, kind)(*arguments)
            self.assertTrue(answer.success, answer.message)
            status.next_where(lambda s: not s.busy)
        before = self.states.last()
        self.assertGreater(before.time, 1)
        call("set_method", SetMethod, "wingnut", "buss2", 0.001)
        self.assertEqual(status.next().bodies[0].method, "buss2")
        call("set_spin", SetSpin, "wingnut", Vector3(0.1, 2.0, 0.1))
        self.time.set(self.time.now() + 0.25)
        after = self.states.next_where(lambda s: s.segment > before.segment, since=0)
        self.assertEqual(after.time, 0)
        self.assertLess(graph.quaternion_distance(after.attitude, before.attitude), 1e-3, "it goes on from where it was")
        self.quiet()

    def test_3_c_a_scene_is_loaded_while_the_clock_is_frozen(self):
        descriptions = self.static["description"].count()
        rospy.wait_for_service(NODE + "/load_scene", graph.PATIENCE)
        before = self.states.last()
        answer = rospy.ServiceProxy(NODE + "/load_scene", LoadScene)("dzhanibekov")
        self.assertTrue(answer.success, answer.message)
        self.static["description"].more(1, descriptions)
        done = self.status.next_where(lambda s: not s.busy)
        self.assertEqual((done.scene, done.refused), ("dzhanibekov", ""))
        self.assertEqual(self.states.last().header, before.header, "nothing moves before the clock does")
        self.time.set(self.time.now() + 0.25)
        after = self.states.next_where(lambda s: s.segment > before.segment, since=0)
        self.assertEqual((after.time, after.segment), (0, before.segment + 1))
        self.quiet()

    def test_4_commands_wait_while_the_clock_is_frozen(self):
        before = self.states.last()
        self.assertTrue(self.control.pause(True).success)
        self.assertTrue(self.control.reset().success)
        self.quiet()
        self.assertEqual(self.states.last().header, before.header)
        self.states.clear()
        self.time.set(self.time.now() + 0.5)
        after = graph.wait_for(lambda: (self.states.all() or [None])[0], what="a state")
        self.assertEqual((after.time, after.time_rate, after.segment), (0, 0, before.segment + 1))
        self.assertTrue(self.control.pause(False).success)
        self.quiet()
        self.assertEqual(self.states.last().time_rate, 0)

    def test_5_a_faster_clock(self):
        for speed in (2.0, 0.5, 10.0):
            self.states.clear()
            begin = self.time.now()
            self.time.run(speed)
            self.states.next_where(lambda s: s.header.stamp.to_sec() > begin + speed)
            states = self.states.all()
            self.check_stamps(states)
            self.check_time(states)
            self.assertEqual(states[-1].time_rate, 1, "t runs at rate 1 against the stamps, however fast they run")
        self.hold()

    def jump_back(self, seconds):
        """The last state before and the first after, once everything static was sent again."""
        before = self.states.last()
        counts = self.static_counts()
        static_before = {name: listener.last() for name, listener in self.static.items()}
        self.states.clear()
        self.time.set(self.time.now() - seconds)
        graph.wait_for(lambda: all(n > counts[name] for name, n in self.static_counts().items()),
                       what="what is static to be sent again")
        after = graph.wait_for(lambda: (self.states.all() or [None])[0], what="a state after the jump")
        self.assertEqual(graph.drawn([self.static["markers_static"].last()]), graph.drawn([static_before["markers_static"]]))
        sent = self.static["tf_static"].last().transforms
        self.assertEqual({(t.header.frame_id, t.child_frame_id) for t in sent},
                         {("world", "wingnut_space"), ("world", "wingnut_model")})
        self.assertEqual(len(sent), 2)
        for t in sent:
            self.assertLessEqual(t.header.stamp.to_sec(), self.time.now() + 1e-9, "no stamp of the old clock")
        new, old = self.static["description"].last(), static_before["description"]
        self.assertEqual((new.body, new.inertia_tensor, new.method), (old.body, old.inertia_tensor, old.method))
        self.assertLess(after.header.stamp, before.header.stamp, "stamps follow the new clock")
        self.assertEqual(after.segment, before.segment + 1)
        self.assertEqual(after.time, before.time, "t goes on from where it was")
        self.assertTrue(graph.same_attitude(after.attitude, before.attitude))
        self.assertEqual((after.energy_drift, after.momentum_drift), (0, 0))
        counts = {name: n + 1 for name, n in counts.items()}
        self.assertEqual(self.static_counts(), counts, "once a jump")
        return before, after

    def test_6_after_a_jump_back_everything_goes_on(self):
        _, after = self.jump_back(5.0)
        self.time.run(1.0)
        self.states.next_where(lambda s: (s.header.stamp - after.header.stamp).to_sec() > 1)
        self.hold()
        states = self.states.all()
        self.check_stamps(states)
        self.check_time(states)
        self.assertEqual({s.segment for s in states}, {after.segment})
        self.assertEqual({s.time_rate for s in states}, {1.0})

    def test_7_a_jump_back_while_paused(self):
        self.time.run(1.0)
        self.control.pause(True)
        self.states.next_where(lambda s: s.time_rate == 0)
        self.hold()
        _, after = self.jump_back(3.0)
        self.assertEqual(after.time_rate, 0)
        self.time.run(1.0)
        later = self.states.next_where(lambda s: (s.header.stamp - after.header.stamp).to_sec() > 0.5)
        self.assertEqual((later.time, later.segment), (after.time, after.segment))
        self.hold()

    def test_8_a_jump_to_before_the_first_stamp(self):
        self.jump_back(self.time.now() - 1.0)
        self.control.pause(False)
        self.time.run(1.0)
        self.states.next_where(lambda s: s.time_rate == 1)
        self.hold()

    def jump_ahead(self, states):
        """The states before and after, and one of half a second later."""
        before = states.last()
        self.time.set(self.time.now() + 1e8)
        after = states.next_where(lambda s: (s.header.stamp - before.header.stamp).to_sec() > 1e7)
        self.time.run(1.0)
        later = states.next_where(lambda s: (s.header.stamp - after.header.stamp).to_sec() > 0.5)
        self.hold()
        self.assertEqual(later.segment, after.segment)
        self.assertGreater(later.time, after.time)
        return before, after

    def test_9_the_closed_form_follows_a_jump_ahead(self):
        before, after = self.jump_ahead(self.states)
        self.assertEqual(after.segment, before.segment)
        expected = (after.header.stamp - before.header.stamp).to_sec()
        self.assertAlmostEqual(after.time - before.time, expected, delta=1e-6)

    def test_9_a_jump_ahead_is_not_stepped_through(self):
        # 1e8 s are 1e12 steps: nobody waits for them.
        scene = processes.package_path("test", "ros", "scenes", "buss2.yaml")
        node = processes.start_node("/stepper", {"scene_file": scene})
        self.addCleanup(node.close)
        self.time.wait_for_listener("/stepper/poinsot")
        states = graph.Listener("/stepper/top/state", BodyState)
        self.time.run(1.0)
        graph.wait_for(states.last, what="a state")
        self.hold()
        before, after = self.jump_ahead(states)
        self.assertEqual(after.segment, before.segment + 1)
        self.assertEqual(after.time, before.time, "t goes on from where it was")
        states.close()

    def test_a_diagnostics_outlive_a_jump_back(self):
        diagnostics = graph.Listener("/diagnostics", DiagnosticArray)
        self.time.run(1.0)
        diagnostics.next()
        self.time.set(self.time.now() - 1e7)
        diagnostics.next_where(lambda d: d.header.stamp.to_sec() < self.time.now() + 1)
        diagnostics.next()
        self.hold()


if __name__ == "__main__":
    rostest.rosrun("poinsot", "foreign_clock", ForeignClockTest)
