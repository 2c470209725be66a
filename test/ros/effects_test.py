#!/usr/bin/python3
"""Bodies with effects, judged by their messages: each has the markers that its effects call for, and they are right."""
import math
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import numpy  # noqa: E402
import rospy  # noqa: E402
import rostest  # noqa: E402
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus  # noqa: E402
from rosgraph_msgs.msg import Log  # noqa: E402
from visualization_msgs.msg import Marker, MarkerArray  # noqa: E402

import graph  # noqa: E402
import processes  # noqa: E402
from poinsot.msg import BodyDescription, BodyState  # noqa: E402

SCENE = processes.package_path("test", "ros", "scenes", "effects.yaml")
FREE, TORQUED = ("free",), ("flat_spin", "top", "stand_in", "satellite", "damped", "pushed")
BODIES = FREE + TORQUED
WITH_TORQUE = {"top", "stand_in", "satellite", "damped", "pushed"}  # a slug inside exerts none on the whole
WITH_GRAVITY = {"top", "stand_in", "satellite"}
PIVOT = {"top": (0, 0.1, 0.6), "stand_in": (0, 0, 0.6)}  # and the centre of mass from it
WEIGHT = {"top": (0, 0, -1), "stand_in": (0, 0, -1)}
UNDERSTAND = ("space/invariable_plane", "space/herpolhode", "space/montgomery", "model/polhode_family")  # of free bodies
SURFACES = ("energy_ellipsoid", "momentum_ellipsoid", "polhode", "separatrix", "axes")
IN_ORBIT = {"satellite"}
UNTIL = 7.0  # s


def array(v):
    return numpy.array([v.x, v.y, v.z])


def rotation(q):
    w, x, y, z = q.w, q.x, q.y, q.z
    return numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def unit(v):
    return v / numpy.linalg.norm(v)


def off_ellipsoid(marker, point):
    """Of a point [m] in the marker's frame: (x/a)² + … − 1."""
    semi = array(marker.scale) / 2
    return float(numpy.sum((rotation(marker.pose.orientation).T @ point / semi) ** 2) - 1)


def derivative(before, now, after):
    """dL/dt from three states, which may lie at unequal distances."""
    h, k = now.time - before.time, after.time - now.time
    first = (array(now.momentum_world) - array(before.momentum_world)) / h
    second = (array(after.momentum_world) - array(now.momentum_world)) / k
    return (first * k + second * h) / (h + k)


def namespaces(arrays):
    return {m.ns for a in arrays for m in a.markers if m.action == Marker.ADD}


class EffectsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("effects_test")
        cls.log = graph.Listener("/rosout", Log)
        states = {b: graph.Listener("/effects/%s/state" % b, BodyState) for b in BODIES}
        descriptions = {b: graph.Listener("/effects/%s/description" % b, BodyDescription) for b in BODIES}
        moving = graph.Listener("/effects/markers", MarkerArray)
        still = graph.Listener("/effects/markers_static", MarkerArray)
        diagnostics = graph.Listener("/diagnostics", DiagnosticArray)
        cls.node = processes.start_node("/effects", {"scene_file": SCENE})
        for listener in states.values():
            graph.wait_for(lambda: listener.last() and listener.last().time > UNTIL, 90, "t = %g s" % UNTIL)
        cls.topics = {name for name, _ in rospy.get_published_topics("/effects")}
        cls.states = {b: {s.header.stamp.to_nsec(): s for s in l.all()} for b, l in states.items()}
        cls.descriptions = {b: l.last() for b, l in descriptions.items()}
        cls.arrays, cls.still = moving.all(), still.all()[-1:]
        cls.diagnostics = diagnostics.all()
        cls.drawn = {}  # by namespace and id: the markers in order
        for m in graph.told(cls.arrays):
            cls.drawn.setdefault((m.ns, m.id), []).append(m)
        for listener in list(states.values()) + list(descriptions.values()) + [moving, still, diagnostics]:
            listener.close()
        cls.control = graph.Control("/effects/poinsot")

    @classmethod
    def tearDownClass(cls):
        cls.node.close()

    def added(self, name, marker_id=0):
        """The markers of that name which have a state of their stamp, each with it."""
        body = name.split("/")[0]
        out = [(m, self.states[body][m.header.stamp.to_nsec()]) for m in self.drawn.get((name, marker_id), [])
               if m.action == Marker.ADD and m.header.stamp.to_nsec() in self.states[body]]
        self.assertGreater(len(out), 10, name)
        return out

    def test_no_body_has_more_topics_than_another(self):
        wanted = {"/effects/%s/%s" % (b, t) for b in BODIES for t in ("state", "odometry", "description")}
        of_node = {"/effects/poinsot/" + t for t in ("status", "layout", "grip/update", "grip/update_full")}
        self.assertEqual(self.topics, wanted | of_node | {"/effects/markers", "/effects/markers_static"})

    def test_namespaces_are_those_that_effects_call_for(self):
        still, moving = namespaces(self.still), namespaces(self.arrays)
        for body in BODIES:
            surfaces = {"%s/%s/%s" % (body, p, s) for p in ("space", "model") for s in SURFACES}
            of_body = {ns for ns in still if ns.startswith(body + "/")}
            wanted = {body + "/shape", body + "/label", body + "/axes"}
            if body in FREE:
                wanted |= surfaces | {body + "/space/angular_momentum", body + "/space/label"} | {"%s/%s" % (body, s) for s in UNDERSTAND}
            if body in PIVOT:
                wanted |= {body + "/gravity"}
            if body in IN_ORBIT:
                wanted |= {body + "/orbit"}
            self.assertEqual(of_body, wanted)

            of_body = {ns for ns in moving if ns.startswith(body + "/")}
            wanted = {body + "/" + what for what in ("trail", "label", "space/label", "space/omega", "model/omega")}
            if body in TORQUED:
                wanted |= surfaces | {body + "/space/angular_momentum"}
            if body in WITH_TORQUE:
                wanted |= {body + "/torque"}
            if body in WITH_GRAVITY:
                wanted |= {body + "/gravity"}
            if body in IN_ORBIT:
                wanted |= {body + "/orbit"}
            self.assertEqual(of_body, wanted)

    def test_omega_lies_on_both_ellipsoids_as_drawn(self):
        for body in TORQUED:
            metres = self.descriptions[body].metres_per_radian_per_second
            principal = rotation(self.descriptions[body].principal_axes)
            moments = numpy.array(self.descriptions[body].principal_moments)
            for picture in ("space", "model"):
                for what in ("energy_ellipsoid", "momentum_ellipsoid"):
                    for m, s in self.added("%s/%s/%s" % (body, picture, what)):
                        omega = array(s.omega_body)
                        self.assertLess(abs(off_ellipsoid(m, metres * omega)), 1e-9, m.ns)
                        components = principal.T @ omega
                        energy = 0.5 * float(numpy.sum(moments * components ** 2))
                        length = math.sqrt(float(numpy.sum((moments * components) ** 2)))
                        semi = numpy.sqrt(2 * energy / moments) if what[0] == "e" else length / moments
                        numpy.testing.assert_allclose(array(m.scale) / 2, metres * semi, rtol=1e-9)
            for m, s in self.added(body + "/model/omega"):
                numpy.testing.assert_allclose(array(m.pose.position), metres * array(s.omega_body), atol=1e-12)
            for m, s in self.added(body + "/space/omega"):
                numpy.testing.assert_allclose(array(m.points[1]), metres * array(s.omega_world), atol=1e-12)

    def test_curves_lie_on_the_ellipsoids_of_their_stamp(self):
        for body in TORQUED:
            for picture in ("space", "model"):
                ellipsoids = {}
                for what in ("energy_ellipsoid", "momentum_ellipsoid"):
                    for m in self.drawn["%s/%s/%s" % (body, picture, what), 0]:
                        ellipsoids.setdefault(m.header.stamp.to_nsec(), []).append(m)
                for m, _ in self.added("%s/%s/polhode" % (body, picture)):
                    pose = rotation(m.pose.orientation)
                    values = [off_ellipsoid(e, pose @ array(p))
                              for e in ellipsoids[m.header.stamp.to_nsec()] for p in m.points]
                    self.assertLess(max(values) - min(values), 1e-6, m.ns)
                    self.assertTrue(0 < min(values) and max(values) < 0.05, "lifted a little off the surface")

    def test_picture_keeps_its_size(self):
        for body in TORQUED:
            longest = max(max(array(m.scale)) / 2 for m, _ in self.added(body + "/model/momentum_ellipsoid"))
            self.assertLess(longest, 1.01, body)
            self.assertGreater(longest, 0.1, body)

    def test_torque_arrows_point_where_momentum_goes(self):
        for body in WITH_TORQUE:
            stamps = sorted(self.states[body])
            neighbours = {b: (a, c) for a, b, c in zip(stamps, stamps[1:], stamps[2:])}
            lengths, torques = [], []
            for marker_id in (0, 1):
                judged = 0
                for m, s in self.added(body + "/torque", marker_id):
                    if s.header.stamp.to_nsec() not in neighbours:
                        continue
                    before, after = (self.states[body][n] for n in neighbours[s.header.stamp.to_nsec()])
                    if not 0 < after.time - before.time < 0.05 or (body == "pushed" and not 2.1 < s.time < 3.9):
                        continue
                    slope = derivative(before, s, after)
                    arrow = array(m.points[1]) - array(m.points[0])
                    if numpy.linalg.norm(slope) < 1e-3:
                        continue
                    self.assertGreater(float(unit(arrow) @ unit(slope)), 0.9995, "%s at t = %g" % (body, s.time))
                    judged += 1
                    if marker_id == 0:
                        self.assertEqual(m.header.frame_id, "world")
                        numpy.testing.assert_allclose(array(m.points[0]), array(s.position), atol=1e-12)
                        lengths.append(numpy.linalg.norm(arrow))
                        torques.append(numpy.linalg.norm(slope))
                    else:
                        self.assertEqual(m.header.frame_id, body + "_space")
                        metres = self.descriptions[body].metres_per_angular_momentum
                        numpy.testing.assert_allclose(array(m.points[0]), metres * array(s.momentum_world), atol=1e-9)
                self.assertGreater(judged, 20, body)
            ratio = numpy.array(lengths) / numpy.array(torques)
            self.assertLess(float(max(ratio) / min(ratio)), 1.05, "one scale for all times")

    def test_torque_is_gone_while_nothing_acts(self):
        arrows = self.drawn["pushed/torque", 0]
        self.assertEqual(arrows[-1].action, Marker.DELETE)
        self.assertEqual(sum(m.action == Marker.DELETE for m in arrows), 1)
        for m, s in self.added("pushed/torque"):
            self.assertTrue(2 <= s.time < 4, s.time)
        labels = [m for (ns, _), all_of_it in self.drawn.items() if ns in ("pushed/label", "pushed/space/label") for m in all_of_it[-1:]]
        self.assertNotIn("\u03c4", {m.text for m in labels if m.action == Marker.ADD})

    def test_body_at_rest_shows_no_ellipsoids(self):
        first = min(m.header.stamp.to_nsec() for m, _ in self.added("pushed/model/energy_ellipsoid"))
        self.assertGreaterEqual(self.states["pushed"][first].time, 2)

    def test_weight_and_pivot(self):
        for body, centre in PIVOT.items():
            still = [m for m in graph.told(self.still) if m.ns == body + "/gravity"]
            self.assertEqual({m.header.frame_id for m in still}, {body})
            spheres = [m for m in still if m.type == Marker.SPHERE]
            self.assertEqual([list(array(m.pose.position)) for m in spheres], [[0, 0, 0]])
            rods = [m for m in still if m.type == Marker.CYLINDER]
            self.assertEqual(len(rods), 1)
            along = rotation(rods[0].pose.orientation)[:, 2] * rods[0].scale.z / 2
            numpy.testing.assert_allclose(array(rods[0].pose.position) + along, centre, atol=1e-12)
            numpy.testing.assert_allclose(array(rods[0].pose.position) - along, 0, atol=1e-12)
            drawn = [(m, s) for i in range(8) if (body + "/gravity", i) in self.drawn
                     for m, s in self.added(body + "/gravity", i)]
            self.assertEqual({m.type for m, _ in drawn}, {Marker.ARROW, Marker.LINE_STRIP})
            for m, s in drawn:
                if m.type == Marker.LINE_STRIP:  # the way of a point on the axis, which ends where that point is
                    now = array(m.points[-1]) - array(s.position)
                    along = rotation(s.attitude) @ numpy.array(centre)
                    numpy.testing.assert_allclose(unit(now), unit(along), atol=1e-9)
                    continue
                start = array(s.position) + rotation(s.attitude) @ numpy.array(centre)
                numpy.testing.assert_allclose(array(m.points[0]), start, atol=1e-9)
                numpy.testing.assert_allclose(unit(array(m.points[1]) - array(m.points[0])), WEIGHT[body], atol=1e-12)
            # The shape's parts have their common centre there; for these shapes it is the mean of their places.
            places = [array(m.pose.position) for m in graph.told(self.still) if m.ns == body + "/shape"]
            numpy.testing.assert_allclose(sum(places) / len(places), centre, atol=1e-9)

    def test_way_to_the_centre_of_the_orbit(self):
        normal, radial = unit(numpy.array([0, 1, 2])), numpy.array([1.0, 0, 0])
        arrows = [(m, s) for i in range(8) if ("satellite/gravity", i) in self.drawn
                  for m, s in self.added("satellite/gravity", i)]
        for m, s in arrows:
            r = radial * math.cos(0.4 * s.time) + numpy.cross(normal, radial) * math.sin(0.4 * s.time)
            self.assertEqual(m.type, Marker.ARROW)
            numpy.testing.assert_allclose(unit(array(m.points[1]) - array(m.points[0])), -r, atol=1e-9)

    def test_trail_of_a_torqued_body_is_long_and_bounded(self):
        for body in TORQUED:
            pieces = {i: all_of_it for (ns, i), all_of_it in self.drawn.items() if ns == body + "/trail" and i > 0}
            self.assertTrue(pieces, body)
            self.assertLessEqual(sum(max(len(m.points) for m in p) for p in pieces.values()), 16384)
            self.assertLess(sum(len(p) for p in pieces.values()), 0.25 * len(self.arrays), "a few times a second")
        self.assertFalse([key for key in self.drawn if key[0] == "free/trail" and key[1] > 0])

    def test_path_of_a_dissipating_body_grows_with_the_momentum_ellipsoid(self):
        ellipsoids = {m.header.stamp.to_nsec(): m for m in self.drawn["flat_spin/model/momentum_ellipsoid", 0]}
        sizes, values = [], []
        for m, _ in self.added("flat_spin/trail", 1):
            ellipsoid = ellipsoids[m.header.stamp.to_nsec()]
            semi = array(ellipsoid.scale) / 2
            sizes.append(max(semi))
            above = (1 + 0.02 * max(semi) / min(semi)) ** 2 - 1  # by 2 cm at the most
            values += [off_ellipsoid(ellipsoid, array(p)) / above for p in m.points]
        self.assertGreater(max(sizes), 1.1 * min(sizes))  # else this test would say nothing
        self.assertGreater(min(values), 0)
        self.assertLess(max(values), 1)

    def test_labels_have_energies_and_no_error(self):
        for body in TORQUED:
            texts = {m.text for (ns, _), all_of_it in self.drawn.items() if ns == body + "/label" for m in all_of_it}
            figures = [t for t in texts if "step" in t]
            self.assertTrue(figures, body)
            for text in figures:
                self.assertIn("energy ", text)
                self.assertNotIn("nan", text)
                self.assertNotIn("error", text)

    def test_no_warning_for_bodies_without_a_closed_form(self):
        statuses = [s for a in self.diagnostics for s in a.status if "body " in s.name]
        self.assertEqual({s.name.split("body ")[1] for s in statuses}, set(BODIES))
        for s in statuses:
            self.assertEqual(s.level, DiagnosticStatus.OK, s.message)
            self.assertFalse([v for v in s.values if "nan" in v.value.lower()], s.name)

    def test_z_seek_to_where_there_is_no_state_is_refused(self):
        listener = graph.Listener("/effects/damped/state", BodyState)
        before = graph.wait_for(listener.last, what="a state")
        since = self.log.count()
        self.control.seek(-1e5)
        message = self.log.next_where(lambda m: "seek" in m.msg and "refused" in m.msg, 60, since)
        self.assertEqual(message.level, Log.ERROR)
        after = listener.next()
        self.assertEqual(after.segment, before.segment)
        self.assertTrue(self.node.running())
        listener.close()


if __name__ == "__main__":
    rostest.rosrun("poinsot", "effects", EffectsTest)
