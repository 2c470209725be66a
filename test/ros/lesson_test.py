#!/usr/bin/python3
"""What lesson.launch shows: one motion under Algorithm 1, Algorithm 2 and the closed form, of which the first gains energy."""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rospy  # noqa: E402
import rostest  # noqa: E402
from visualization_msgs.msg import MarkerArray  # noqa: E402

import graph  # noqa: E402
from poinsot.msg import BodyDescription, BodyState  # noqa: E402

NAMES = ["lie_euler", "buss2", "closed_form"]
STEP = 1.0 / 60  # s
LATE = 60.0  # s, when lie_euler has about all the energy that its |L| allows
START = 0.5 * (1 * .05 ** 2 + 2 * 5 ** 2 + 3 * .05 ** 2)  # J
ROUNDING = 1e-14  # of E


class LessonTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("lesson_test")
        cls.states = {n: graph.Listener("/%s/state" % n, BodyState) for n in NAMES}
        cls.descriptions = {n: graph.Listener("/%s/description" % n, BodyDescription) for n in NAMES}
        cls.markers = graph.Listener("/markers", MarkerArray)
        cls.control = graph.Control("/poinsot")
        cls.control.reset()
        cls.control.speed(20.0)
        for name in NAMES:
            graph.wait_for(lambda: cls.states[name].last() and cls.states[name].last().time > LATE, what="t = %g s" % LATE)
        cls.control.pause()

    def energies(self, name):
        """E/E0 of the segment that begins with the reset, in the order of t."""
        states = self.states[name].all()
        return [s.kinetic_energy / START for s in states if s.segment == states[-1].segment]

    def test_the_same_step_and_the_same_start_in_one_row(self):
        descriptions = [graph.wait_for(self.descriptions[n].last) for n in NAMES]
        self.assertEqual([d.method for d in descriptions], NAMES)
        self.assertEqual([d.step for d in descriptions[:2]], [STEP, STEP])
        self.assertTrue(all(d.principal_moments == descriptions[0].principal_moments for d in descriptions))
        places = [self.states[n].last().position for n in NAMES]
        self.assertTrue(all(p.z == places[0].z and p.x == places[0].x for p in places))
        self.assertTrue(places[0].y + 2 < places[1].y and places[1].y + 2 < places[2].y, "from left to right")

    def test_algorithm_1_gains_energy_up_to_twice_what_it_had(self):
        found = self.energies("lie_euler")
        self.assertTrue(all(b >= a - ROUNDING for a, b in zip(found, found[1:])), "its energy never falls")
        self.assertGreater(found[-1], 1.99)
        self.assertLess(found[-1], 2.0002)  # that of a spin about the axis of smallest moment, for this |L|

    def test_algorithm_2_stays_near_and_the_closed_form_keeps_it(self):
        self.assertLess(max(abs(e - 1) for e in self.energies("buss2")), 0.01)
        self.assertLess(max(abs(e - 1) for e in self.energies("closed_form")), ROUNDING)

    def test_beneath_each_body_stands_what_becomes_of_its_energy(self):
        texts = {}
        for message in self.markers.all():
            for marker in message.markers:
                if marker.text and marker.ns.endswith("/label"):
                    texts.setdefault(marker.ns.split("/")[0], set()).add(marker.text)
        for name in NAMES:
            self.assertTrue(any("energy" in text or "E/E" in text for text in texts.get(name, [])), (name, texts.get(name)))


if __name__ == "__main__":
    rostest.rosrun("poinsot", "lesson", LessonTest)
