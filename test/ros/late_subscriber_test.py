#!/usr/bin/python3
"""Who comes late sees everything; and the node offers what it promises, no more."""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rosgraph  # noqa: E402
import rospy  # noqa: E402
import rostest  # noqa: E402
from tf2_msgs.msg import TFMessage  # noqa: E402
from visualization_msgs.msg import Marker, MarkerArray  # noqa: E402

import graph  # noqa: E402
from poinsot.msg import BodyDescription, BodyState  # noqa: E402

BODIES = ("conserving", "drifting")  # the first one's method keeps L, the other's does not
NODE = "/poinsot"

PICTURE_STATIC = {"energy_ellipsoid", "momentum_ellipsoid", "polhode", "separatrix", "axes"}
# Of free bodies, whatever method moves them.
UNDERSTAND = {"space/invariable_plane", "space/herpolhode", "space/montgomery", "model/polhode_family"}


def static_namespaces(body):
    names = {body + "/shape", body + "/label", body + "/axes"}
    names |= {"%s/%s/%s" % (body, picture, what) for picture in ("space", "model") for what in PICTURE_STATIC}
    names |= {"%s/%s" % (body, what) for what in UNDERSTAND}
    return names


def moving_namespaces(body):
    return {body + "/" + what for what in ("trail", "label", "space/label", "space/omega", "model/omega")}


STATIC = static_namespaces(BODIES[0]) | static_namespaces(BODIES[1]) | {"conserving/space/angular_momentum", "conserving/space/label"}
MOVING = moving_namespaces(BODIES[0]) | moving_namespaces(BODIES[1]) | {"drifting/space/angular_momentum"}


def norm(q):
    return (q.w ** 2 + q.x ** 2 + q.y ** 2 + q.z ** 2) ** 0.5


class LateSubscriberTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("late_subscriber_test")
        cls.states = {body: graph.Listener("/%s/state" % body, BodyState) for body in BODIES}
        for states in cls.states.values():
            graph.wait_for(lambda: states.last() and states.last().time > 2, what="the node to be two seconds old")

    def latched(self, topic, message_class):
        """What a subscriber that comes now is given at once."""
        listener = graph.Listener(topic, message_class)
        message = graph.wait_for(listener.last, what=topic)
        # Moving messages of later ticks arrive; nothing more comes on a latched topic.
        stamp = self.states["drifting"].next().header.stamp
        self.states["drifting"].next_where(lambda s: (s.header.stamp - stamp).to_sec() > 0.5)
        self.assertEqual(len(listener.all()), 1, topic + " is sent once")
        listener.close()
        self.assertEqual(message._connection_header["latching"], "1", topic + " is latched")
        return message

    def check_forms(self, markers):
        for m in markers:
            where = "%s %d" % (m.ns, m.id)
            self.assertAlmostEqual(norm(m.pose.orientation), 1, delta=1e-12, msg=where)
            if m.action == Marker.ADD:
                self.assertGreater(m.color.a, 0, where + " can be seen")
            if m.type == Marker.LINE_STRIP:
                self.assertGreaterEqual(len(m.points), 2, where)
                self.assertLessEqual(len(m.points), 16384, where)
                self.assertIn(len(m.colors), (0, len(m.points)), where)
        keys = [(m.ns, m.id) for m in markers]
        self.assertEqual(len(keys), len(set(keys)), "one marker, one id")

    def test_publications_are_the_contract(self):
        master = rosgraph.Master("/late_subscriber_test")
        publishers, subscribers, services = master.getSystemState()

        def of_node(topics):
            return {name for name, nodes in topics if NODE in nodes}
        expected = {"/%s/%s" % (body, what) for body in BODIES for what in ("state", "odometry", "description")}
        expected |= {"/markers", "/markers_static", "/tf", "/tf_static", "/diagnostics", "/rosout"}
        expected |= {NODE + "/" + what for what in ("status", "layout", "grip/update", "grip/update_full")}
        self.assertEqual(of_node(publishers), expected)
        self.assertEqual(of_node(subscribers), {NODE + "/" + what for what in ("speed", "seek", "viewpoint", "light_background", "grip/feedback")})
        self.assertEqual(of_node(services),
                         {NODE + "/" + what for what in ("pause", "step", "reset", "load_scene", "set_method", "set_spin",
                                                         "get_loggers", "set_logger_level")})
        types = dict(master.getTopicTypes())
        for topic, kind in (("/conserving/state", "poinsot/BodyState"),
                            ("/conserving/description", "poinsot/BodyDescription"),
                            ("/conserving/odometry", "nav_msgs/Odometry"),
                            ("/markers", "visualization_msgs/MarkerArray"),
                            ("/markers_static", "visualization_msgs/MarkerArray"),
                            ("/tf", "tf2_msgs/TFMessage"), ("/tf_static", "tf2_msgs/TFMessage"),
                            ("/diagnostics", "diagnostic_msgs/DiagnosticArray"),
                            (NODE + "/speed", "std_msgs/Float64"), (NODE + "/seek", "std_msgs/Float64")):
            self.assertEqual(types.get(topic), kind, topic)

    def test_static_markers(self):
        array = self.latched("/markers_static", MarkerArray)
        markers = list(graph.drawn([array]).values())
        self.assertEqual({m.ns for m in markers}, STATIC)
        self.check_forms(array.markers)
        for m in array.markers:
            self.assertTrue(m.header.stamp.is_zero(), m.ns)
            self.assertEqual(m.lifetime, rospy.Duration(0), m.ns)
        for m in markers:
            body, what = m.ns.split("/", 1)
            frame = {"shape": body, "axes": body, "space/angular_momentum": body + "_space"}.get(what)
            if "/" in what and what.rsplit("/", 1)[-1] in PICTURE_STATIC:
                frame = body + ("_space_body" if what.startswith("space") else "_model")
                self.assertTrue(m.frame_locked, m.ns)
            if frame:
                self.assertEqual(m.header.frame_id, frame, m.ns)
            if m.header.frame_id in (body, body + "_space_body"):
                self.assertTrue(m.frame_locked, m.ns + " follows its frame without being sent again")
        again = self.latched("/markers_static", MarkerArray)
        self.assertEqual(graph.drawn([again]), graph.drawn([array]), "everybody is given the same")

    def test_a_late_subscriber_is_sent_the_static_markers_once_more(self):
        # RViz loses latched markers that reach it before their frames do; a second copy mends that.
        listener = graph.Listener("/markers_static", MarkerArray)
        graph.wait_for(lambda: len(listener.all()) >= 2, what="the second copy")
        first, second = listener.all()[:2]
        self.assertEqual(graph.drawn([first]), graph.drawn([second]))
        at = self.states["drifting"].next().header.stamp
        self.states["drifting"].next_where(lambda s: (s.header.stamp - at).to_sec() > 3)
        self.assertEqual(len(listener.all()), 2, "and no more")
        listener.close()

    def test_a_jump_takes_the_trail_away_while_paused(self):
        control = graph.Control(NODE)
        listener = graph.Listener("/markers", MarkerArray)

        def trails(array, action):
            return [m for m in array.markers if m.ns == BODIES[0] + "/trail" and m.action == action]
        listener.next_where(lambda a: trails(a, Marker.ADD))
        control.pause(True)
        control.seek(5.0)
        listener.next_where(lambda a: trails(a, Marker.DELETE))
        self.assertFalse(trails(listener.more(15)[-1], Marker.ADD), "the trail of another place")
        control.pause(False)
        listener.next_where(lambda a: trails(a, Marker.ADD))
        listener.close()

    def test_moving_markers(self):
        listener = graph.Listener("/markers", MarkerArray)
        first = graph.wait_for(lambda: (listener.all() or [None])[0], what="/markers")
        for m in first.markers:
            if m.type == Marker.LINE_STRIP:
                self.assertLess(len(m.points), 10, "a trail begins when somebody looks")
        graph.wait_for(lambda: len(listener.all()) > 60, what="a second of markers")
        listener.close()
        arrays = listener.all()
        last = arrays[-1].markers[0].header.stamp
        for states in self.states.values():
            graph.wait_for(lambda: states.last().header.stamp >= last, what="the last state")
        stamps = {body: {s.header.stamp for s in states.all()} for body, states in self.states.items()}
        seen = set()
        for array in arrays:
            markers = [m for m in array.markers if m.action == Marker.ADD]
            seen |= {m.ns for m in markers}
            self.check_forms(markers)
            self.assertEqual(len({m.header.stamp for m in markers}), 1, "one tick, one stamp")
            for m in markers:
                self.assertIn(m.header.stamp, stamps[m.ns.split("/")[0]], m.ns + " carries a state's stamp")
        for array in arrays[1:]:
            self.assertEqual({m.action for m in array.markers}, {Marker.ADD})
        self.assertEqual(seen, MOVING)

    def test_static_and_moving_do_not_share_a_marker(self):
        static = self.latched("/markers_static", MarkerArray)
        moving = graph.Listener("/markers", MarkerArray)
        arrays = graph.wait_for(lambda: moving.all()[-1:] if len(moving.all()) > 10 else None, what="/markers")
        moving.close()
        keys = set(graph.drawn([static]))
        self.assertFalse(keys & {(m.ns, m.id) for m in arrays[0].markers if m.action == Marker.ADD})

    def test_static_transforms(self):
        message = self.latched("/tf_static", TFMessage)
        pairs = {(t.header.frame_id, t.child_frame_id) for t in message.transforms}
        self.assertEqual(pairs, {("world", body + what) for body in BODIES for what in ("_space", "_model")})
        self.assertEqual(len(message.transforms), len(pairs))
        for t in message.transforms:
            self.assertAlmostEqual(norm(t.transform.rotation), 1, delta=1e-12)
            if t.child_frame_id.endswith("_space"):
                self.assertEqual(abs(t.transform.rotation.w), 1, "the picture in world axes is not turned")

    def test_moving_transforms_are_the_state(self):
        listener = graph.Listener("/tf", TFMessage)
        graph.wait_for(lambda: len(listener.all()) > 30, what="/tf")
        listener.close()
        messages = listener.all()
        last = messages[-1].transforms[0].header.stamp
        expected = {(parent, child) for body in BODIES
                    for parent, child in (("world", body), (body + "_space", body + "_space_body"))}
        states = {}
        for body in BODIES:
            graph.wait_for(lambda: self.states[body].last().header.stamp >= last, what="the last state")
            states[body] = {s.header.stamp: s for s in self.states[body].all()}
        for message in messages:
            self.assertEqual({(t.header.frame_id, t.child_frame_id) for t in message.transforms}, expected)
            for t in message.transforms:
                body = t.child_frame_id.replace("_space_body", "")
                state = states[body][t.header.stamp]
                self.assertTrue(graph.same_attitude(t.transform.rotation, state.attitude), t.child_frame_id)
                if t.child_frame_id == body:
                    p, q = t.transform.translation, state.position
                    self.assertEqual((p.x, p.y, p.z), (q.x, q.y, q.z))

    def test_descriptions(self):
        for body, method, step in (("conserving", "buss2", 1e-4), ("drifting", "rk4", 1e-3)):
            d = self.latched("/%s/description" % body, BodyDescription)
            self.assertEqual((d.body, d.header.frame_id, d.method, d.step), (body, body, method, step))
            self.assertEqual(list(d.inertia_tensor), [1, 0, 0, 0, 2, 0, 0, 0, 3])
            self.assertEqual(sorted(d.principal_moments), [1, 2, 3])
            self.assertAlmostEqual(norm(d.principal_axes), 1, delta=1e-12)
            self.assertGreater(d.metres_per_radian_per_second, 0)
            self.assertGreater(d.metres_per_angular_momentum, 0)
            self.assertEqual(len(d.effects), 1 if body == "drifting" else 0)
            if d.effects:
                self.assertTrue(d.effects[0].startswith("translation"), d.effects)


if __name__ == "__main__":
    rostest.rosrun("poinsot", "late_subscriber", LateSubscriberTest)
