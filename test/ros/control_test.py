#!/usr/bin/python3
"""Pause, step, reset, seek, speed: what a subscriber sees of them."""
import math
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rospy  # noqa: E402
import rostest  # noqa: E402
from rosgraph_msgs.msg import Log  # noqa: E402

import graph  # noqa: E402
from poinsot.msg import BodyState  # noqa: E402

RATE = 60.0


class ControlTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("control_test")
        cls.control = graph.Control()
        cls.states = graph.Listener("/top/state", BodyState)
        cls.log = graph.Listener("/rosout", Log)  # rostest starts no rosout node, so no /rosout_agg
        graph.wait_for(cls.states.last, what="a state")

    def setUp(self):
        self.control.speed(1.0)
        self.control.pause(False)
        segment, since = self.states.last().segment, self.states.count()
        self.control.reset()
        self.states.next_where(lambda s: s.segment > segment and s.time_rate == 1 and 0 <= s.time < 0.2, since=since)

    def tearDown(self):
        messages = self.states.all()
        self.assertTrue(graph.stamps_never_decrease(messages), "stamps decreased")
        segments = [m.segment for m in messages]
        self.assertEqual(segments, sorted(segments), "a segment came back")

    def settled(self, number=20, condition=lambda s: True):
        """The next state that meets the condition, and those that follow it without a gap: this many in all."""
        since = self.states.count()
        first = self.states.next_where(condition, since=since)
        return self.states.more(number, self.states.all().index(first, since))

    def pause_and_settle(self):
        """The states that a paused node goes on publishing, while stamps run."""
        self.assertTrue(self.control.pause(True).success)
        return self.settled(condition=lambda s: s.time_rate == 0)

    def test_plays_at_rate_one(self):
        states = self.settled(int(RATE))
        a, b = states[0], states[-1]
        stamps = (b.header.stamp - a.header.stamp).to_sec()
        self.assertLess(stamps, 1 / 0.8)
        self.assertAlmostEqual(b.time - a.time, stamps, delta=2e-9)
        self.assertEqual({s.time_rate for s in states}, {1.0})
        self.assertEqual({s.segment for s in states}, {a.segment})

    def test_pause_holds_time_and_attitude(self):
        states = self.pause_and_settle()
        self.assertEqual({s.time_rate for s in states}, {0.0})
        self.assertEqual(len({s.time for s in states}), 1)
        self.assertTrue(all(graph.same_attitude(states[0].attitude, s.attitude) for s in states))
        stamps = [s.header.stamp.to_nsec() for s in states]
        self.assertEqual(len(set(stamps)), len(stamps), "no stamp is sent twice")
        segment = states[0].segment
        self.control.pause(False)
        state = self.states.next_where(lambda s: s.time_rate == 1)
        self.assertEqual(state.segment, segment, "a pause is no break in the motion")

    def test_step_advances_by_one_period(self):
        for count in (1, 3):
            before = self.pause_and_settle()[-1]
            for _ in range(count):
                self.assertTrue(self.control.step().success)
            end = before.time + count / RATE - 1e-9
            after = self.settled(condition=lambda s: s.time_rate == 0 and s.time > end)
            self.assertEqual({s.time_rate for s in after}, {0.0})
            self.assertAlmostEqual(after[-1].time - before.time, count / RATE, delta=1e-12)
            self.assertEqual(after[-1].segment, before.segment, "a step is no break in the motion")

    def test_time_follows_the_stamps_also_across_pause_and_step(self):
        since = self.states.count()
        self.settled(10)
        paused_at = self.pause_and_settle()[-1].time
        for _ in range(4):
            self.control.step()
        self.settled(10, lambda s: s.time_rate == 0 and s.time > paused_at + 4 / RATE - 1e-9)
        self.control.speed(-3.0)
        self.control.pause(False)
        self.settled(20, lambda s: s.time_rate == -3)
        states = self.states.all()[since:]
        self.assertEqual({s.time_rate for s in states}, {0.0, 1.0, -3.0})
        for a, b in zip(states, states[1:]):
            expected = a.time_rate * (b.header.stamp - a.header.stamp).to_sec()
            self.assertAlmostEqual(b.time - a.time, expected, delta=5e-9,
                                   msg="between two messages t runs at the rate that the first one states")

    def test_step_is_refused_while_playing(self):
        response = self.control.step()
        self.assertFalse(response.success)
        self.assertIn("pause", response.message)

    def test_reset(self):
        segment = self.states.next_where(lambda s: s.time > 0.5).segment
        since = self.states.count()
        self.assertTrue(self.control.reset().success)
        state = self.states.next_where(lambda s: s.segment == segment + 1, since=since)
        self.assertEqual(state.time, 0)
        self.assertEqual((state.attitude.w, state.attitude.x, state.attitude.y, state.attitude.z), (1, 0, 0, 0))
        self.assertAlmostEqual(state.omega_body.y, 1.0, delta=1e-15)

    def test_reset_while_paused(self):
        self.pause_and_settle()
        self.control.reset()
        states = self.settled(condition=lambda s: s.time == 0)
        self.assertEqual({(s.time, s.time_rate) for s in states}, {(0.0, 0.0)})

    def seek(self, target):
        segment = self.states.last().segment
        since = self.states.count()
        self.control.seek(target)
        return self.states.next_where(lambda s: s.segment == segment + 1, since=since)

    def test_seek_forwards_and_to_negative_times(self):
        for target in (12.5, 100.0, -7.25, 0.0):
            state = self.seek(target)
            self.assertEqual(state.time, target)
            self.assertEqual(state.energy_drift, 0, "drift is counted from the segment's start")
            self.assertEqual(state.momentum_drift, 0)

    def test_seek_while_paused(self):
        self.pause_and_settle()
        self.seek(42.0)
        states = self.settled()
        self.assertEqual({(s.time, s.time_rate) for s in states}, {(42.0, 0.0)})

    def test_state_does_not_depend_on_the_way(self):
        self.pause_and_settle()
        first = self.seek(33.3)
        self.seek(-5.0)
        self.seek(80.0)
        again = self.seek(33.3)
        self.assertTrue(graph.same_attitude(first.attitude, again.attitude))
        self.assertEqual(first.omega_body, again.omega_body)

    def test_seek_too_far_is_refused_with_a_message(self):
        segment = self.states.last().segment
        since = self.log.count()
        self.control.seek(1e10)
        message = self.log.next_where(lambda m: "seek to 1e+10 s refused" in m.msg, since=since).msg
        for word in ("top", "buss2", "1e+14", "0.0001", "expected at most 1e+09"):
            self.assertIn(word, message)
        self.assertEqual(self.settled()[-1].segment, segment, "a refused seek changes nothing")

    def test_what_is_not_finite_is_refused_with_a_message(self):
        for name, say in (("seek", self.control.seek), ("speed", self.control.speed)):
            for value in (math.nan, math.inf, -math.inf):
                since = self.log.count()
                say(value)
                self.log.next_where(lambda m: name + " refused: expected a finite" in m.msg, since=since)
        states = self.settled()
        self.assertEqual({s.time_rate for s in states}, {1.0})
        self.assertTrue(all(math.isfinite(s.time) for s in states))

    def test_a_speed_beyond_the_machine_is_refused_with_a_message(self):
        since = self.log.count()
        self.control.speed(1e9)
        self.log.next_where(lambda m: "speed refused: expected a number from -" in m.msg and "got 1e+09" in m.msg,
                            since=since)
        self.assertEqual({s.time_rate for s in self.settled()}, {1.0})

    def test_a_long_seek_does_not_hold_up_publishing(self):
        # 2e8 steps take several seconds; a second seek gives up the first.
        segment = self.states.last().segment
        since = self.log.count()
        self.control.seek(20000.0)
        self.log.next_where(lambda m: "seek to 20000 s takes 2e+08 steps" in m.msg, since=since)
        states = self.settled(90)
        self.assertEqual({s.segment for s in states}, {segment}, "plays on until the seek is done")
        gaps = [(b.header.stamp - a.header.stamp).to_sec() for a, b in zip(states, states[1:])]
        self.assertLess(sorted(gaps)[int(0.9 * len(gaps))], 5 / RATE)
        self.assertEqual(self.seek(3.0).time, 3.0)

    def test_backward_play_and_speeds(self):
        for speed in (-2.0, 0.25, 5.0, 0.0, -1.0):
            self.control.speed(speed)
            states = self.settled(30, lambda s: s.time_rate == speed)
            self.assertEqual({s.time_rate for s in states}, {speed})
            a, b = states[0], states[-1]
            stamps = (b.header.stamp - a.header.stamp).to_sec()
            self.assertAlmostEqual(b.time - a.time, speed * stamps, delta=1e-8)
        # Backwards across the start.
        self.control.speed(-5.0)
        self.states.next_where(lambda s: s.time < -1.0)
        there = self.pause_and_settle()[-1]
        self.assertLess(there.time, -1.0)
        jumped = self.seek(there.time)
        self.assertTrue(graph.same_attitude(there.attitude, jumped.attitude), "playing there and seeking there agree")


if __name__ == "__main__":
    rostest.rosrun("poinsot", "control", ControlTest)
