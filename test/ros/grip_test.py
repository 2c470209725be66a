#!/usr/bin/python3
"""Taking hold of Omega by the interactive marker, as RViz does it: feedback in, messages out."""
import math
import os
import sys
import threading
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import numpy as np  # noqa: E402
import rospy  # noqa: E402
import rostest  # noqa: E402
from geometry_msgs.msg import PointStamped  # noqa: E402
from tf2_msgs.msg import TFMessage  # noqa: E402
from visualization_msgs.msg import (InteractiveMarkerControl, InteractiveMarkerFeedback,  # noqa: E402
                                    InteractiveMarkerInit, InteractiveMarkerUpdate, MarkerArray)

import graph  # noqa: E402
from poinsot.msg import BodyDescription, BodyState, NodeStatus  # noqa: E402

BODY = "brick"
M = np.array([[2.1, 0.3, 0.1], [0.3, 1.4, -0.2], [0.1, -0.2, 2.9]])
OMEGA = np.array([0.4, 0.2, 1.1])
MOMENTS, AXES = np.linalg.eigh(M)  # rising; columns


def array(v):
    return np.array([v.x, v.y, v.z])


def energy(omega):
    return 0.5 * omega @ M @ omega


def momentum(omega):
    return np.linalg.norm(M @ omega)


class GripTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("grip_test")
        cls.control = graph.Control()
        cls.states = graph.Listener("/%s/state" % BODY, BodyState)
        cls.status = graph.Listener("/poinsot/status", NodeStatus)
        cls.descriptions = graph.Listener("/%s/description" % BODY, BodyDescription)
        cls.still = graph.Listener("/markers_static", MarkerArray)
        cls.moving = graph.Listener("/markers", MarkerArray)
        cls.tf_static = graph.Listener("/tf_static", TFMessage)
        cls.init = graph.Listener("/poinsot/grip/update_full", InteractiveMarkerInit)
        cls.updates = graph.Listener("/poinsot/grip/update", InteractiveMarkerUpdate)
        cls.hand = rospy.Publisher("/poinsot/grip/feedback", InteractiveMarkerFeedback, queue_size=100)
        cls.eye = rospy.Publisher("/poinsot/viewpoint", PointStamped, queue_size=1)
        graph.wait_for(lambda: cls.hand.get_num_connections() and cls.eye.get_num_connections(), what="the grip")
        graph.wait_for(cls.states.last, what="a state")
        graph.wait_for(cls.status.last, what="a status")
        cls.metres = graph.wait_for(cls.descriptions.last, what="a description").metres_per_radian_per_second

    def setUp(self):
        self.control.speed(1.0)
        self.control.pause(False)
        self.act(InteractiveMarkerFeedback.MENU_SELECT, entry="energy ellipsoid")
        segment, since = self.states.last().segment, self.states.count()
        self.control.reset()
        self.states.next_where(lambda s: s.segment > segment and s.time_rate == 1 and s.time < 0.1 and
                               np.allclose(array(s.omega_body), OMEGA, atol=0.2), since=since)

    def tearDown(self):
        self.assertTrue(graph.stamps_never_decrease(self.states.all()), "stamps decreased")
        for update in self.updates.all():
            for pose in update.poses:
                self.assertTrue(np.all(np.isfinite(array(pose.pose.position))), "RViz would be sent a place nowhere")

    def marker(self, body=BODY):
        def found():
            markers = self.init.last().markers if self.init.last() else []
            return [m for m in markers if m.name == body]
        return graph.wait_for(found, what="the grip of " + body)[0]

    def act(self, event, point=None, entry=None, body=BODY, frame=None):
        feedback = InteractiveMarkerFeedback()
        feedback.client_id = "grip_test"
        feedback.marker_name = body
        feedback.control_name = "lead"
        feedback.event_type = event
        feedback.header.frame_id = (body + "_model") if frame is None else frame
        feedback.pose.orientation.w = 1
        if point is not None:
            feedback.pose.position.x, feedback.pose.position.y, feedback.pose.position.z = [float(x) for x in point]
        if entry is not None:
            entries = [e for e in self.marker(body).menu_entries if e.title.split("] ")[-1].startswith(entry)]
            self.assertEqual(len(entries), 1, entry)
            feedback.menu_entry_id = entries[0].id
        self.hand.publish(feedback)

    def press(self, alive=True):
        """Takes hold; alive: and says so again and again, as RViz does, until the test ends."""
        self.act(InteractiveMarkerFeedback.MOUSE_DOWN)
        if alive:
            ended = threading.Event()

            def hold():
                while not ended.wait(0.3):
                    self.act(InteractiveMarkerFeedback.KEEP_ALIVE)
            thread = threading.Thread(target=hold, daemon=True)
            thread.start()
            self.addCleanup(thread.join)
            self.addCleanup(ended.set)
        return self.states.next_where(lambda s: s.time_rate == 0)

    def let_go(self):
        """Lets go, and gives the first state of what comes of it."""
        segment, since = self.states.last().segment, self.states.count()
        self.act(InteractiveMarkerFeedback.MOUSE_UP)
        return self.states.next_where(lambda s: s.segment > segment, since=since)

    def choose(self, entry, body=BODY):
        segment, since = self.states.last().segment, self.states.count()
        self.act(InteractiveMarkerFeedback.MENU_SELECT, entry=entry, body=body)
        return self.states.next_where(lambda s: s.segment > segment, since=since)

    def drawn(self, what, number=0):
        return graph.drawn([self.still.last()])["%s/model/%s" % (BODY, what), number]

    def semi_axes(self, what):
        """As drawn, in the order of AXES [m]."""
        return np.sort(array(self.drawn(what).scale) / 2)[::-1]

    def await_semi_axes(self, what, expected):
        """A picture of before, of a reset for instance, may still be on its way."""
        graph.wait_for(lambda: np.allclose(self.semi_axes(what), expected, rtol=1e-9, atol=0),
                       what="the %s with the semi-axes %s" % (what, expected))

    def lead(self, point):
        since = self.still.count()
        self.act(InteractiveMarkerFeedback.POSE_UPDATE, point)
        self.still.next_where(lambda a: True, since=since)

    # What there is.

    def test_there_is_one_for_each_body_that_turns(self):
        for body in ("brick", "disc"):
            marker = self.marker(body)
            self.assertEqual(marker.header.frame_id, body + "_model")
            self.assertEqual(marker.header.stamp.to_nsec(), 0)
            self.assertEqual([c.interaction_mode for c in marker.controls], [InteractiveMarkerControl.MOVE_3D])
            self.assertGreater(len(marker.menu_entries), 8)
        self.assertNotIn("still", [m.name for m in self.init.last().markers])

    def test_it_rides_with_omega(self):
        self.control.pause(True)
        state = self.states.next_where(lambda s: s.time_rate == 0)

        def places():
            return [array(p.pose.position) for u in self.updates.all() for p in u.poses if p.name == BODY]
        graph.wait_for(lambda: np.linalg.norm(places()[-1] - self.metres * array(state.omega_body)) < 1e-6,
                       what="the grip at Omega")
        count = len(places())
        self.states.more(30)
        self.assertEqual(len(places()), count, "what stands still is not sent again and again")

    # Dragging.

    def test_dragging_over_the_energy_ellipsoid(self):
        before = self.press()
        held = array(before.omega_body)
        e_axes = self.metres * np.sqrt(2 * energy(held) / MOMENTS)
        self.await_semi_axes("energy_ellipsoid", e_axes)
        l_axes = self.metres * momentum(held) / MOMENTS
        self.await_semi_axes("momentum_ellipsoid", l_axes)
        directions = [AXES @ np.array(d) for d in ([1, 0.2, 0.3], [1, 0.6, 0.1], [0.2, 0.3, 1.0])]
        families = set()
        for direction in directions:
            self.lead(1.7 * direction)  # off the surface: what counts is where it points
            omega = direction * math.sqrt(energy(held) / energy(direction))
            # The pictures follow: the same energy ellipsoid, another of L, the polhode through the new place.
            self.await_semi_axes("momentum_ellipsoid", self.metres * momentum(omega) / MOMENTS)
            np.testing.assert_allclose(self.semi_axes("energy_ellipsoid"), e_axes, rtol=1e-9)
            self.assertFalse(np.allclose(self.semi_axes("momentum_ellipsoid"), l_axes))
            bead = self.moving.next_where(lambda a: any(
                m.ns == BODY + "/model/omega" and
                np.linalg.norm(array(m.pose.position) - self.metres * omega) < 1e-6 for m in a.markers))
            self.assertTrue(bead)
            d = AXES.T @ direction
            side = (MOMENTS[2] * (MOMENTS[2] - MOMENTS[1]) * d[2] ** 2 - MOMENTS[0] * (MOMENTS[1] - MOMENTS[0]) * d[0] ** 2)
            words = "about the axis of %s moment" % ("largest" if side > 0 else "smallest")
            status = self.status.next_where(lambda s: s.bodies[0].regime == words).bodies[0]
            self.assertEqual(status.regime_kind, status.ABOUT_LARGEST if side > 0 else status.ABOUT_SMALLEST)
            self.assertAlmostEqual(status.held_energy / energy(omega), 1, delta=1e-9)
            self.assertAlmostEqual(status.held_momentum / momentum(omega), 1, delta=1e-9)
            families.add(words)
            polhode = self.drawn("polhode")
            points = np.array([array(p) for p in polhode.points])
            q = polhode.pose.orientation
            points = points @ rotation(q).T
            self.assertLess(np.min(np.linalg.norm(points / 1.01 - self.metres * omega, axis=1)), 0.05)
        self.assertEqual(len(families), 2, "the separatrix was not crossed")
        state = self.states.next()
        self.assertEqual((state.time, state.segment), (before.time, before.segment), "held, not moved")
        after = self.let_go()
        self.assertEqual((after.time, after.segment), (0, before.segment + 1))
        np.testing.assert_allclose(array(after.omega_body), omega, rtol=1e-9)
        self.assertTrue(math.isnan(self.status.next_where(lambda s: s.segment == after.segment).bodies[0].held_energy))
        self.assertAlmostEqual(after.kinetic_energy / before.kinetic_energy, 1, delta=1e-12)
        self.assertLess(graph.quaternion_distance(before.attitude, after.attitude), 1e-14, "the body jumped")
        self.states.next_where(lambda s: s.time > 0.2)  # it plays on as before
        np.testing.assert_allclose(self.semi_axes("energy_ellipsoid"), e_axes, rtol=1e-9)

    def test_dragging_over_the_momentum_ellipsoid(self):
        self.act(InteractiveMarkerFeedback.MENU_SELECT, entry="momentum ellipsoid")
        graph.wait_for(lambda: any("x" in e.title.split("]")[0] for e in self.marker().menu_entries
                                   if "momentum ellipsoid" in e.title), what="a mark in the menu")
        before = self.press()
        direction = AXES @ np.array([1, 0.2, 0.3])
        self.lead(0.3 * direction)
        after = self.let_go()
        omega = direction * momentum(array(before.omega_body)) / momentum(direction)
        np.testing.assert_allclose(array(after.omega_body), omega, rtol=1e-9)
        self.assertLess(after.kinetic_energy / before.kinetic_energy, 3)
        self.assertNotAlmostEqual(after.kinetic_energy / before.kinetic_energy, 1, delta=1e-3)

    def test_with_a_viewpoint_omega_lies_under_the_mouse(self):
        centre, turn = self.frame_of_model()
        eye_model = AXES @ np.array([0.5, 5.0, 0.7])
        before = self.press()
        semi = self.metres * np.sqrt(2 * energy(array(before.omega_body)) / MOMENTS)
        place = AXES @ (semi * unit([0.3, 0.9, -0.2]))  # on the near side
        in_hand = eye_model + 0.6 * (place - eye_model)  # somewhere on the same line of sight
        try:
            self.look_from(centre + turn @ eye_model)
            self.lead_until(in_hand, place)
            after = self.let_go()
            self.assertLess(np.linalg.norm(self.metres * array(after.omega_body) - place), 1e-6)
        finally:
            self.look_from(centre)
        # With the eye at the centre, directions count again.
        self.press()
        direction = in_hand / np.linalg.norm(in_hand)
        self.lead_until(in_hand, direction / np.linalg.norm(direction @ AXES / semi))
        self.let_go()

    def look_from(self, place):
        eye = PointStamped()
        eye.header.frame_id = "world"
        eye.point.x, eye.point.y, eye.point.z = place
        self.eye.publish(eye)

    def lead_until(self, in_hand, place):
        """Leads the grip again and again, until Omega is drawn at the place: when the eye arrives, nothing tells."""
        def there():
            self.lead(in_hand)
            beads = [m for m in self.moving.next().markers if m.ns == BODY + "/model/omega"]
            return any(np.linalg.norm(array(m.pose.position) - place) < 1e-6 for m in beads)
        graph.wait_for(there, what="Omega where it is led to")

    def frame_of_model(self):
        found = [t.transform for t in self.tf_static.last().transforms if t.child_frame_id == BODY + "_model"][0]
        return array(found.translation), rotation(found.rotation)

    def test_a_click_changes_nothing(self):
        before = self.press()
        self.act(InteractiveMarkerFeedback.POSE_UPDATE, self.metres * array(before.omega_body) + 1e-3)
        self.act(InteractiveMarkerFeedback.MOUSE_UP)
        after = self.states.next_where(lambda s: s.time_rate == 1)
        self.assertEqual(after.segment, before.segment)
        self.assertGreaterEqual(after.time, before.time)

    def test_a_click_changes_nothing_however_fast_it_plays(self):
        # The tick that holds the body moves it once more, at this speed by more than a hand may move in a click.
        self.control.speed(20.0)
        self.states.next_where(lambda s: s.time_rate == 20)
        held = self.press()
        played = [s for s in self.states.all() if s.time_rate == 20][-1]
        place, before = [self.metres * array(s.omega_body) for s in (held, played)]
        self.assertGreater(np.linalg.norm(place - before), 0.01)
        self.act(InteractiveMarkerFeedback.POSE_UPDATE, place + 1e-3)
        self.act(InteractiveMarkerFeedback.MOUSE_UP)
        after = self.states.next_where(lambda s: s.time_rate == 20)
        self.assertEqual(after.segment, held.segment)

    def test_paused_before_is_paused_after(self):
        self.control.pause(True)
        self.states.next_where(lambda s: s.time_rate == 0)
        self.press()
        self.lead(AXES @ np.array([1, 0.2, 0.3]))
        after = self.let_go()
        self.assertEqual(after.time_rate, 0)
        self.assertEqual({s.time for s in self.states.more(20)}, {0})
        self.control.pause(False)

    def test_a_viewer_that_dies_lets_go(self):
        before = self.press(alive=False)
        self.lead(AXES @ np.array([1, 0.2, 0.3]))
        after = self.states.next_where(lambda s: s.time_rate == 1)
        self.assertEqual(after.segment, before.segment, "what nobody let go of was taken for meant")
        np.testing.assert_allclose(np.linalg.norm(array(self.states.next().omega_body)), np.linalg.norm(OMEGA), rtol=0.3)
        longest = self.metres * momentum(OMEGA) / MOMENTS[0]
        graph.wait_for(lambda: abs(self.semi_axes("momentum_ellipsoid")[0] / longest - 1) < 1e-6,
                       what="the ellipsoid as it was before")

    # Forbidden.

    def refuse(self, *pieces):
        status = self.status.next_where(lambda s: s.refused)
        for piece in pieces:
            self.assertIn(piece, status.refused)

    def test_forbidden_places(self):
        self.assertEqual(self.status.next().refused, "")
        for bad in ([0, 0, 0], [math.inf, 0, 0], [0, -math.inf, 1], [math.nan] * 3):
            before = self.press()
            self.act(InteractiveMarkerFeedback.POSE_UPDATE, bad)
            self.refuse("brick", "expected a finite point (m) off the centre, got (")
            self.act(InteractiveMarkerFeedback.MOUSE_UP)
            after = self.states.next_where(lambda s: s.time_rate == 1)
            self.assertEqual(after.segment, before.segment, bad)
            self.control.pause(False)  # takes the refusal away
            self.status.next_where(lambda s: not s.refused)

    def test_forbidden_places_are_not_sent_on_whenever_they_come(self):
        # They arrive beside the ticks: at any moment of one. tearDown looks at what is sent.
        since = self.updates.count()
        for _ in range(100):
            for _ in range(10):
                self.act(InteractiveMarkerFeedback.POSE_UPDATE, [math.nan, 0, math.inf])
            self.states.next()
        self.refuse("brick", "expected a finite point (m) off the centre, got (")
        self.assertGreater(self.updates.count(), since)

    def test_after_a_forbidden_place_the_last_good_one_counts(self):
        self.press()
        direction = AXES @ np.array([1, 0.2, 0.3])
        self.lead(direction)
        for bad in ([0, 0, 0], [math.inf, 0, 0]):
            self.act(InteractiveMarkerFeedback.POSE_UPDATE, bad)
        self.refuse("expected a finite point")
        after = self.let_go()
        np.testing.assert_allclose(unit(array(after.omega_body)), unit(direction), rtol=1e-9)

    def test_places_far_away_and_close_by_have_a_direction(self):
        direction = AXES @ np.array([1, 0.2, 0.3])
        for size in (1e-12, 1e12, 1e300):
            self.press()
            self.lead(size * direction)
            after = self.let_go()
            np.testing.assert_allclose(unit(array(after.omega_body)), unit(direction), rtol=1e-9)

    def test_a_place_in_another_frame_and_an_unknown_body_are_refused(self):
        before = self.states.last()
        self.act(InteractiveMarkerFeedback.POSE_UPDATE, [1, 0, 0], body="nobody")  # not one of the server's
        self.act(InteractiveMarkerFeedback.POSE_UPDATE, [1, 0, 0], frame="world")
        # Feedback is answered in order: what came before has had its effect, if any.
        self.refuse('expected a point in frame brick_model, got one in frame "world"')
        self.assertEqual({s.segment for s in self.states.more(20)}, {before.segment})

    # The menu.

    def test_spins_about_the_axes(self):
        e = energy(OMEGA)
        for k, name in enumerate(("smallest moment", "intermediate moment", "largest moment")):
            after = self.choose_in("Spin exactly", name)
            omega = AXES.T @ array(after.omega_body)
            self.assertAlmostEqual(abs(omega[k]) / np.linalg.norm(omega), 1, delta=1e-14)
            self.assertAlmostEqual(energy(array(after.omega_body)) / e, 1, delta=1e-9)
            self.assertEqual(after.time, 0)

    def choose_in(self, parent, entry):
        """An entry whose title occurs in several submenus."""
        entries = self.marker().menu_entries
        parents = [e.id for e in entries if e.title.startswith(parent)]
        ids = [e.id for e in entries if e.parent_id in parents and e.title.startswith(entry)]
        self.assertEqual(len(ids), 1)
        segment, since = self.states.last().segment, self.states.count()
        feedback = InteractiveMarkerFeedback(client_id="grip_test", marker_name=BODY, control_name="lead",
                                             event_type=InteractiveMarkerFeedback.MENU_SELECT, menu_entry_id=ids[0])
        self.hand.publish(feedback)
        return self.states.next_where(lambda s: s.segment > segment, since=since)

    def test_the_three_regimes(self):
        for k, name in ((0, "smallest moment"), (2, "largest moment")):
            after = self.choose_in("Spin near", name)
            omega = AXES.T @ array(after.omega_body)
            f, e = momentum(array(after.omega_body)) ** 2, energy(array(after.omega_body))
            self.assertEqual(f > 2 * e * MOMENTS[1], k == 2, "on the wrong side of the separatrix")
            self.assertGreater(abs(omega[k]) / np.linalg.norm(omega), 0.9)
            self.assertFalse(self.status.next_where(lambda s: s.segment == after.segment).bodies[0].flips)
        after = self.choose_in("Spin near", "intermediate moment")
        status = self.status.next_where(lambda s: s.segment == after.segment)
        self.assertTrue(status.bodies[0].flips)
        self.control.seek(status.time + status.bodies[0].time_to_next_flip + 1)
        flipped = self.states.next_where(lambda s: s.segment > after.segment)
        self.assertLess((AXES.T @ array(flipped.omega_body))[1] * (AXES.T @ array(after.omega_body))[1], 0)

    def test_on_the_separatrix(self):
        after = self.choose("Spin exactly on the separatrix (to rounding)")
        omega = array(after.omega_body)
        self.assertAlmostEqual(momentum(omega) ** 2 / (2 * energy(omega) * MOMENTS[1]), 1, delta=1e-14)
        # Roundoff may leave it a hair beside.
        self.assertIn(self.status.next_where(lambda s: s.segment == after.segment).bodies[0].regime,
                      ("on the separatrix", "on the separatrix, to rounding"))

    def test_a_symmetric_body_has_no_separatrix(self):
        before = self.states.last()
        self.act(InteractiveMarkerFeedback.MENU_SELECT, entry="Spin exactly on the separatrix (to rounding)", body="disc")
        self.refuse("disc", "two moments are equal")
        self.assertEqual(self.states.next().segment, before.segment)

    def test_reset(self):
        self.choose_in("Spin near", "smallest moment")
        after = self.choose("Reset")
        self.assertEqual(after.time, 0)
        np.testing.assert_allclose(array(after.omega_body), OMEGA, rtol=1e-14)


def unit(v):
    v = np.array(v) / np.max(np.abs(v))
    return v / np.linalg.norm(v)


def rotation(q):
    w, x, y, z = q.w, q.x, q.y, q.z
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


if __name__ == "__main__":
    rostest.rosrun("poinsot", "grip", GripTest)
