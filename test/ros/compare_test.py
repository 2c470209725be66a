#!/usr/bin/python3
"""What compare.launch shows: one body under four methods, each with its true figures, and what is wrong seen to be so."""
import math
import os
import re
import shutil
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rospy  # noqa: E402
import rostest  # noqa: E402
import yaml  # noqa: E402
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus  # noqa: E402
from visualization_msgs.msg import MarkerArray  # noqa: E402

import graph  # noqa: E402
import processes  # noqa: E402
from poinsot.msg import BodyDescription, BodyState  # noqa: E402

LATE = 60.0  # s, when lie_euler is far off
FIGURES = re.compile(r"^(?P<method>\w+)(, step (?P<step>\S+) ms)?\n"
                     r"error (?P<error>\S+) rad\nE/E0 = (?P<energy>1 (?P<drift>\S+)|\S+)\ncost (?P<cost>\S+) us per s(\n.*flip.*)?$")


def scene_of(mode):
    code, out, err = processes.run([processes.program("compare_scene"), "--mode", mode,
                                    processes.package_path("scenes", "dzhanibekov.yaml")])
    assert code == 0, err
    return yaml.safe_load(out), out


def vector(v):
    return (v.x, v.y, v.z)


def axes_of(q):
    """The columns of the rotation matrix."""
    return [(1 - 2 * (q.y ** 2 + q.z ** 2), 2 * (q.x * q.y + q.w * q.z), 2 * (q.x * q.z - q.w * q.y)),
            (2 * (q.x * q.y - q.w * q.z), 1 - 2 * (q.x ** 2 + q.z ** 2), 2 * (q.y * q.z + q.w * q.x)),
            (2 * (q.x * q.z + q.w * q.y), 2 * (q.y * q.z - q.w * q.x), 1 - 2 * (q.x ** 2 + q.y ** 2))]


class CompareTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("compare_test")
        cls.directory = tempfile.mkdtemp()
        cls.scene, text = scene_of("equal_cost")
        cls.names = [body["name"] for body in cls.scene["bodies"]]
        path = os.path.join(cls.directory, "compare.yaml")
        with open(path, "w") as out:
            out.write(text)
        cls.states = {n: graph.Listener("/compare/%s/state" % n, BodyState) for n in cls.names}
        cls.descriptions = {n: graph.Listener("/compare/%s/description" % n, BodyDescription) for n in cls.names}
        cls.markers = graph.Listener("/compare/markers", MarkerArray)
        cls.still = graph.Listener("/compare/markers_static", MarkerArray)
        cls.diagnostics = graph.Listener("/diagnostics", DiagnosticArray)
        cls.node = processes.start_node("/compare", {"scene_file": path})
        cls.control = graph.Control("/compare/poinsot")
        cls.control.speed(20.0)
        for listener in cls.states.values():
            graph.wait_for(lambda: listener.last() and listener.last().time > LATE, 60, "t = %g s" % LATE)
        cls.control.speed(1.0)

    @classmethod
    def tearDownClass(cls):
        cls.node.close()
        shutil.rmtree(cls.directory)

    def setUp(self):
        self.assertTrue(self.node.running(), self.node.console)

    def test_one_body_four_methods(self):
        good = self.names[2]
        self.assertEqual(self.names, ["lie_euler", "buss2", good, "closed_form"])
        self.assertNotIn(good, ("lie_euler", "buss2", "closed_form"))
        start = [(b["shape"], b["attitude"], b["angular_velocity"]) for b in self.scene["bodies"]]
        self.assertTrue(all(one == start[0] for one in start))
        for name in self.names:
            description = graph.wait_for(self.descriptions[name].last)
            self.assertEqual(description.method, name)
        places = [self.states[n].last().position for n in self.names]
        for i in range(4):
            for j in range(i):
                apart = max(abs(places[i].y - places[j].y) / 7, abs(places[i].z - places[j].z) / 4)
                self.assertGreater(apart, 1, "the pictures of two bodies overlap")

    def test_the_modes(self):
        equal, _ = scene_of("equal_step")
        self.assertEqual([b.get("step") for b in equal["bodies"]], [0.02, 0.02, 0.02, None])
        given, text = scene_of("equal_cost")
        costs = [float(c) for c in re.findall(r"costs (\S+) us per simulated second,", text)]
        self.assertEqual(len(costs), 4)
        self.assertLess(max(costs[:3]) / min(costs[:3]), 1.02)
        steps = [b["step"] for b in given["bodies"][:3]]
        self.assertLess(steps[0], steps[1], "lie_euler is the cheaper a step, so it takes the shorter one")
        self.assertLess(steps[1], steps[2])

    def test_lie_euler_spirals_to_the_smallest_axis_and_the_others_do_not(self):
        def share_of_smallest(state, description):
            """Of Omega along the principal axis of the smallest moment (the body's axes here)."""
            moments = list(description.principal_moments)
            k = moments.index(min(moments))
            axis = axes_of(description.principal_axes)[k]
            omega = vector(state.omega_body)
            return abs(sum(a * b for a, b in zip(axis, omega))) / math.sqrt(sum(x * x for x in omega))

        def least_share(name):
            description = self.descriptions[name].last()
            late = [s for s in self.states[name].all() if s.time > 0.75 * LATE]
            return min(share_of_smallest(s, description) for s in late)
        self.assertGreater(least_share("lie_euler"), 0.6)
        for name in self.names[1:]:
            self.assertLess(least_share(name), 0.3, name)

        late = {name: self.states[name].last() for name in self.names}
        self.assertGreater(late["lie_euler"].energy_drift, 0.3)
        energies = [s.kinetic_energy for s in self.states["lie_euler"].all()]
        self.assertGreater(energies[-1] / energies[0], 1.3)
        self.assertLess(abs(late["buss2"].energy_drift), 1e-3)
        self.assertLess(abs(late[self.names[2]].energy_drift), 1e-5)
        self.assertLess(abs(late["closed_form"].energy_drift), 1e-14)
        self.assertEqual(late["closed_form"].attitude_error, 0)
        worst = [max(s.attitude_error for s in self.states[name].all() if s.time <= LATE) for name in self.names[:3]]
        self.assertGreater(worst[0], 1)
        self.assertGreater(worst[0], worst[1])
        self.assertGreater(worst[1], 10 * worst[2])
        self.assertLess(worst[2], 1e-3)

    def test_omega_leaves_the_energy_ellipsoid_where_energy_is_wrong(self):
        def outside(name):
            """(Omega in units of the semi-axes)^2, from what is drawn: 1 on the ellipsoid."""
            ellipsoid = next(m for message in self.still.all() for m in message.markers
                             if m.ns == name + "/model/energy_ellipsoid")
            beads = [m for message in self.markers.all() for m in message.markers if m.ns == name + "/model/omega"]
            columns = axes_of(ellipsoid.pose.orientation)
            bead = vector(beads[-1].pose.position)
            along = [sum(a * b for a, b in zip(column, bead)) for column in columns]
            return sum((2 * x / d) ** 2 for x, d in zip(along, vector(ellipsoid.scale)))
        graph.wait_for(self.still.last)
        self.assertGreater(outside("lie_euler"), 1.3)
        for name in self.names[1:]:
            self.assertLess(abs(outside(name) - 1), 5e-3, name)

    def test_labels_carry_the_figures_of_the_state(self):
        seen = set()
        for message in self.markers.all():
            for marker in message.markers:
                match = FIGURES.match(marker.text)
                if not match:
                    continue
                name = marker.ns.split("/")[0]
                states = [s for s in self.states[name].all() if s.header.stamp == marker.header.stamp]
                if not states:
                    continue
                seen.add(name)
                state = states[0]
                self.assertEqual(match.group("method"), name)
                self.assertAlmostEqual(float(match.group("error")), state.attitude_error,
                                       delta=0.06 * state.attitude_error)
                if match.group("drift"):
                    self.assertAlmostEqual(float(match.group("drift")), state.energy_drift,
                                           delta=0.06 * abs(state.energy_drift))
                else:
                    self.assertAlmostEqual(float(match.group("energy")), 1 + state.energy_drift, delta=0.01)
                self.assertAlmostEqual(float(match.group("cost")), 1e6 * state.cost, delta=0.01 * 1e6 * state.cost)
                step = self.descriptions[name].last().step
                if match.group("step"):
                    self.assertAlmostEqual(float(match.group("step")), 1e3 * step, delta=0.01 * 1e3 * step)
                else:
                    self.assertTrue(math.isnan(step))
        self.assertEqual(seen, set(self.names))

    def test_diagnostics_carry_them_too_and_warn(self):
        def status_of(name):
            def found():
                # While the node starts, a status has no values yet.
                return [s for message in self.diagnostics.all() for s in message.status
                        if s.name.endswith("body " + name) and
                        float({v.key: v.value for v in s.values}.get("simulation time [s]", "0")) > LATE]
            return graph.wait_for(found, what="a diagnosis of " + name)[-1]
        for name in self.names:
            status = status_of(name)
            values = {v.key: float(v.value) for v in status.values}
            self.assertIn("energy drift", values)
            self.assertGreater(values["cost [CPU s per simulated s]"], 0)
            then = values["simulation time [s]"]
            graph.wait_for(lambda: self.states[name].last().time > then + 0.2, what="states around a diagnosis")
            near = [s.attitude_error for s in self.states[name].all() if abs(s.time - then) < 0.2]
            self.assertLessEqual(values["attitude error [rad]"], 1.01 * max(near))
            self.assertGreaterEqual(values["attitude error [rad]"], 0.99 * min(near))
            astray = values["attitude error [rad]"] > 0.1
            self.assertEqual(status.level, DiagnosticStatus.WARN if astray else DiagnosticStatus.OK, name)
        self.assertEqual(status_of("lie_euler").level, DiagnosticStatus.WARN)
        self.assertEqual(status_of("closed_form").level, DiagnosticStatus.OK)


if __name__ == "__main__":
    rostest.rosrun("poinsot", "compare", CompareTest)
