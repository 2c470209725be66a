#!/usr/bin/python3
"""The closed form as a subscriber sees it: right at any time, at once, and what steppers are measured by."""
import csv
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
from geometry_msgs.msg import Quaternion  # noqa: E402
from rosgraph_msgs.msg import Log  # noqa: E402

import graph  # noqa: E402
import processes  # noqa: E402
from poinsot.msg import BodyDescription, BodyState  # noqa: E402

# Of every kind: general, symmetric, near the separatrix and on the unstable axis, extreme ratios, tiny and huge Omega.
ROWS = ["P006", "P009", "P017", "P019", "P025", "P033", "P044", "P056", "P058", "P063", "P067", "P069"]
TOLERANCE = 2e-15  # rad, and of |Omega|


def published_rows():
    with open(processes.package_path("test", "data", "public.csv")) as table:
        rows = {row["id"]: row for row in csv.DictReader(line for line in table if not line.startswith("#"))}
    return [rows[name] for name in ROWS]


def numbers(row, *columns):
    return [float(row[column]) for column in columns]


def body(name, row, sign, place):
    """The body of a row, or the one that spins the other way: it is at -t where the first is at t."""
    return {"name": name, "inertia": numbers(row, "mu1", "mu2", "mu3"),
            "attitude": numbers(row, "q0w", "q0x", "q0y", "q0z"),
            "angular_velocity": [sign * x for x in numbers(row, "O01", "O02", "O03")],
            "effects": [{"type": "translation", "position": [4.0 * place, 4.0 * sign, 0.0]}]}


class ClosedFormTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("closed_form_test")
        cls.directory = tempfile.mkdtemp()
        cls.log = graph.Listener("/rosout", Log)
        cls.rows = published_rows()
        bodies = []
        for place, row in enumerate(cls.rows):
            bodies += [body("forwards_" + row["id"], row, 1, place), body("backwards_" + row["id"], row, -1, place)]
        cls.node = cls.start("/rows", {"bodies": bodies})
        cls.control = graph.Control("/rows/poinsot")
        cls.first = cls.states_of("/rows", "forwards_P006")

    @classmethod
    def tearDownClass(cls):
        cls.node.close()
        shutil.rmtree(cls.directory)

    @classmethod
    def start(cls, namespace, scene):
        path = os.path.join(cls.directory, namespace.strip("/") + ".yaml")
        with open(path, "w") as out:
            yaml.safe_dump(scene, out)
        return processes.start_node(namespace, {"scene_file": path})

    @classmethod
    def states_of(cls, namespace, name):
        listener = graph.Listener("%s/%s/state" % (namespace, name), BodyState)
        graph.wait_for(listener.last, what="a state of " + name)
        return listener

    def setUp(self):
        self.assertTrue(self.node.running(), self.node.console)
        self.control.speed(1.0)
        self.control.reset()
        self.control.pause(True)
        self.first.next_where(lambda s: s.time_rate == 0)

    def test_published_states_from_messages_alone(self):
        worst = 0
        for row in self.rows:
            truth = Quaternion(w=float(row["qw"]), x=float(row["qx"]), y=float(row["qy"]), z=float(row["qz"]))
            rate = numbers(row, "O1", "O2", "O3")
            for name, sign in (("forwards_", 1), ("backwards_", -1)):
                states = self.states_of("/rows", name + row["id"])
                time = sign * float(row["t"])
                self.control.seek(time)
                state = states.next_where(lambda s: s.time == time)
                states.close()
                off = graph.quaternion_distance(state.attitude, truth)
                given = [sign * x for x in (state.omega_body.x, state.omega_body.y, state.omega_body.z)]
                # By the largest component: the squares of the smallest rates underflow.
                size = max(abs(x) for x in rate)
                off_rate = math.sqrt(sum(((a - b) / size) ** 2 for a, b in zip(given, rate)))
                self.assertLessEqual(off, TOLERANCE, "%s%s at t = %g" % (name, row["id"], time))
                self.assertLessEqual(off_rate, TOLERANCE, "%s%s at t = %g" % (name, row["id"], time))
                self.assertEqual(state.attitude_error, 0)
                self.assertLess(abs(state.energy_drift), 1e-14)
                worst = max(worst, off, off_rate)
        print("%d states, the worst off by %.2g of %.2g" % (2 * len(self.rows), worst, TOLERANCE))

    def test_a_far_seek_is_answered_at_once(self):
        self.control.pause(False)
        self.first.next_where(lambda s: s.time_rate == 1)
        for time in (1e9, -1e9, 1e12, -3.25):
            before = self.first.last()
            since = self.first.count()
            self.control.seek(time)
            after = self.first.next_where(lambda s: s.segment == before.segment + 1, since=since)
            self.assertEqual(after.time, time)
            waited = (after.header.stamp - before.header.stamp).to_sec()
            print("seek to %g s: answered %.0f ms after the last state before it" % (time, 1e3 * waited))
            self.assertLess(waited, 1.0)

    def test_even_times_at_which_doubles_lie_far_apart(self):
        self.control.pause(False)
        for time in (1e15, -1e300):
            since = self.log.count()
            before = self.first.last()
            self.control.seek(time)
            after = self.first.next_where(lambda s: s.segment == before.segment + 1)
            self.assertEqual(after.time, time)
            self.log.next_where(lambda m: "doubles lie" in m.msg and "%g" % time in m.msg, since=since)
            later = self.first.next_where(lambda s: (s.header.stamp - after.header.stamp).to_sec() > 0.5)
            self.assertEqual(later.segment, after.segment, "stamps run on as ever")
            self.assertTrue(0 <= later.time - after.time <= 1, later.time)
            q = later.attitude
            self.assertAlmostEqual(q.w ** 2 + q.x ** 2 + q.y ** 2 + q.z ** 2, 1, delta=1e-15)

    def test_any_finite_speed(self):
        self.control.pause(False)
        for speed in (1e6, -1e12, 1e200):
            self.control.speed(speed)
            first = self.first.next_where(lambda s: s.time_rate == speed)
            later = self.first.next_where(lambda s: (s.header.stamp - first.header.stamp).to_sec() > 0.3)
            self.assertEqual(later.segment, first.segment)
            expected = speed * (later.header.stamp - first.header.stamp).to_sec()
            self.assertAlmostEqual((later.time - first.time) / expected, 1, delta=1e-6)
            self.assertEqual(later.attitude_error, 0)
            self.assertLess(abs(later.energy_drift), 1e-14)

    def test_t_stays_finite_at_any_speed(self):
        self.control.pause(False)
        since = self.log.count()
        self.control.seek(1.7e308)
        self.control.speed(1e308)
        still = self.first.next_where(lambda s: s.time_rate == 0 and s.time >= 1.7e308)
        self.log.next_where(lambda m: "leaves the range of doubles" in m.msg, since=since)
        self.assertLess(still.time, math.inf)
        seen = self.first.all()
        self.assertTrue(all(math.isfinite(s.time) for s in seen))
        running = [s for s in seen if s.time_rate == 1e308]
        if running:
            self.assertGreater(still.segment, running[-1].segment, "what does not follow time_rate is another segment")

    def test_description(self):
        listener = graph.Listener("/rows/forwards_P006/description", BodyDescription)
        description = graph.wait_for(listener.last, what="a description")
        listener.close()
        self.assertEqual(description.method, "closed_form")
        self.assertTrue(math.isnan(description.step))

    def test_cost_is_a_small_figure(self):
        self.control.pause(False)
        later = self.first.next_where(lambda s: s.time_rate == 1 and s.time > 1.2)
        print("cost %.2g CPU s per simulated s" % later.cost)
        self.assertTrue(0 < later.cost < 0.01, later.cost)

    def test_attitude_error_of_steppers_falls_as_their_order_says(self):
        turn = {"inertia": [1.0, 2.0, 3.0], "attitude": [0.8, 0.1, -0.5, 0.3], "angular_velocity": [0.4, 2.0, 0.3]}
        bodies = [dict(turn, name="exact")]
        orders = {"lie_euler": 1, "buss2": 2, "rk4": 4}
        for row, method in enumerate(orders):
            for column, step in enumerate((1.0 / 256, 1.0 / 512)):
                bodies.append(dict(turn, name=method + "_%d" % column, method=method, step=step, effects=[
                    {"type": "translation", "position": [0.0, 4.0 * (row + 1), 4.0 * column]}]))
        node = self.start("/orders", {"bodies": bodies})
        self.addCleanup(node.close)
        control = graph.Control("/orders/poinsot")
        states = {b["name"]: self.states_of("/orders", b["name"]) for b in bodies}
        control.pause(True)

        def at(time):
            control.seek(time)
            return {name: listener.next_where(lambda s: s.time == time) for name, listener in states.items()}
        early, late = at(1.0), at(4.0)
        for now in (early, late):
            self.assertEqual(now["exact"].attitude_error, 0)
            for name, state in now.items():
                angle = graph.quaternion_distance(state.attitude, now["exact"].attitude)
                self.assertAlmostEqual(state.attitude_error, angle, delta=2e-15, msg=name)
        for method, order in orders.items():
            coarse, fine = late[method + "_0"].attitude_error, late[method + "_1"].attitude_error
            print("%s: %.3g rad, at half the step %.3g rad" % (method, coarse, fine))
            self.assertAlmostEqual(math.log2(coarse / fine), order, delta=0.25, msg=method)
            self.assertGreater(coarse, early[method + "_0"].attitude_error, "errors grow with t")
        for listener in states.values():
            listener.close()

    def test_a_position_beyond_doubles_is_not_published(self):
        thrown = {"name": "thrown", "inertia": [1.0, 2.0, 3.0], "angular_velocity": [0.0, 1.0, 0.1],
                  "effects": [{"type": "translation", "acceleration": [0.0, 0.0, -9.81]}]}
        node = self.start("/thrown", {"bodies": [thrown]})
        self.addCleanup(node.close)
        control = graph.Control("/thrown/poinsot")
        states = self.states_of("/thrown", "thrown")
        since, segment = self.log.count(), states.last().segment
        control.seek(1e200)
        self.log.next_where(lambda m: "seek to 1e+200 s refused" in m.msg and "position" in m.msg, since=since)
        states.next()
        self.assertEqual(states.last().segment, segment, "a refused seek changes nothing")
        control.speed(1e200)
        self.assertEqual(node.wait(20), 1, node.console)
        for word in ("FATAL", "body thrown under closed_form at t = ", "position", "range of doubles"):
            self.assertIn(word, node.console)
        self.assertTrue(all(math.isfinite(s.position.z) for s in states.all()))
        states.close()


if __name__ == "__main__":
    rostest.rosrun("poinsot", "closed_form", ClosedFormTest)
