#!/usr/bin/python3
"""A thousand ticks a second, and what the node says about them."""
import math
import os
import sys
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rospy  # noqa: E402
import rostest  # noqa: E402
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus  # noqa: E402

import graph  # noqa: E402
from poinsot.msg import BodyState  # noqa: E402

RATE = 1000.0
STRETCH = 3.0  # s of stamps
ATTEMPTS = 10  # a busy machine may disturb some of them


class RateTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("rate_test")
        cls.diagnostics = graph.Listener("/diagnostics", DiagnosticArray)
        cls.states = graph.Listener("/wingnut/state", BodyState)
        graph.wait_for(cls.states.last, what="a state")

    def stretch(self):
        """The stamps of some seconds [s], from the first."""
        self.states.clear()
        first = self.states.next().header.stamp
        self.states.next_where(lambda s: (s.header.stamp - first).to_sec() > STRETCH, 60)
        return [(s.header.stamp - first).to_sec() for s in self.states.all() if s.header.stamp >= first]

    def test_keeps_its_rate(self):
        for _ in range(ATTEMPTS):
            stamps = self.stretch()
            for a, b in zip(stamps, stamps[1:]):
                self.assertLess(a, b)
            gaps = [b - a for a, b in zip(stamps, stamps[1:])]
            mean = (stamps[-1] - stamps[0]) / len(gaps)
            jitter = math.sqrt(sum((gap - mean) ** 2 for gap in gaps) / len(gaps))
            print("%.2f Hz; gaps: standard deviation %.0f us, largest %.0f us" %
                  (1 / mean, 1e6 * jitter, 1e6 * max(gaps)))
            if abs(1 / mean / RATE - 1) < 0.02:
                return
            time.sleep(1.0)
        self.fail("never within 2 % of 1000 Hz")

    def status(self, suffix):
        def found():
            return [s for m in self.diagnostics.all() for s in m.status if s.name.endswith(suffix)]
        # The first report may come before anything was measured.
        return graph.wait_for(lambda: found()[-1] if len(found()) > 1 else None, what="two reports of " + suffix)

    def number(self, status, key):
        values = {v.key: v.value for v in status.values}
        self.assertIn(key, values)
        value = float(values[key])
        self.assertTrue(math.isfinite(value), key)
        return value

    def test_diagnostics_of_ticks(self):
        status = self.status("ticks")
        self.assertIn(status.level, (DiagnosticStatus.OK, DiagnosticStatus.WARN))
        self.assertEqual(self.number(status, "rate asked [Hz]"), RATE)
        self.assertGreater(self.number(status, "rate [Hz]"), 0.1 * RATE)
        self.assertLess(self.number(status, "rate [Hz]"), 1.5 * RATE)
        mean, worst = self.number(status, "lateness, mean [s]"), self.number(status, "lateness, worst [s]")
        self.assertGreaterEqual(self.number(status, "jitter, standard deviation [s]"), 0)
        self.assertGreater(mean, 0)
        self.assertGreaterEqual(worst, mean)
        print("; ".join("%s %s" % (v.key, v.value) for v in status.values))

    def test_diagnostics_of_bodies(self):
        status = self.status("body wingnut")
        self.assertEqual(status.level, DiagnosticStatus.OK)
        self.assertEqual(status.message, "closed_form")
        self.assertGreater(self.number(status, "simulation time [s]"), 0)
        self.assertLess(abs(self.number(status, "energy drift")), 1e-3)
        self.assertLess(self.number(status, "momentum drift"), 1e-9)
        self.assertGreater(self.number(status, "cost [CPU s per simulated s]"), 0)

    def test_the_message_says_what_the_motion_costs(self):
        self.assertGreater(self.states.next().cost, 0)


if __name__ == "__main__":
    rostest.rosrun("poinsot", "rate", RateTest)
