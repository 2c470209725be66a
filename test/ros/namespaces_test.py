#!/usr/bin/python3
"""Two nodes with the same body, side by side."""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rosgraph  # noqa: E402
import rospy  # noqa: E402
import rostest  # noqa: E402
from diagnostic_msgs.msg import DiagnosticArray  # noqa: E402
from nav_msgs.msg import Odometry  # noqa: E402
from tf2_msgs.msg import TFMessage  # noqa: E402
from visualization_msgs.msg import Marker, MarkerArray  # noqa: E402

import graph  # noqa: E402
from poinsot.msg import BodyDescription, BodyState  # noqa: E402

PREFIXES = {"/a": "a/", "/b": "b_"}


class NamespacesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("namespaces_test")
        cls.tf = graph.Listener("/tf", TFMessage)
        cls.tf_static = graph.Listener("/tf_static", TFMessage)
        cls.diagnostics = graph.Listener("/diagnostics", DiagnosticArray)
        cls.control = {ns: graph.Control(ns + "/poinsot") for ns in PREFIXES}
        cls.states = {ns: graph.Listener(ns + "/wingnut/state", BodyState) for ns in PREFIXES}
        for states in cls.states.values():
            graph.wait_for(states.last, what="a state")

    def setUp(self):
        for ns in PREFIXES:
            self.control[ns].speed(1.0)
            self.control[ns].pause(False)
            self.states[ns].next_where(lambda s: s.time_rate == 1)

    def advances(self, ns):
        """True when the next states of a node show it playing, and t going on."""
        first = self.states[ns].next()
        later = self.states[ns].next_where(lambda s: (s.header.stamp - first.header.stamp).to_sec() > 0.2)
        return first.time_rate == later.time_rate == 1 and later.time > first.time

    def test_topics_are_apart(self):
        publishers = rosgraph.Master("/namespaces_test").getSystemState()[0]
        nodes = dict(publishers)
        for ns in PREFIXES:
            for what in ("wingnut/state", "wingnut/odometry", "wingnut/description", "markers", "markers_static"):
                self.assertEqual(nodes[ns + "/" + what], [ns + "/poinsot"])
        for topic in ("/tf", "/tf_static", "/diagnostics"):
            self.assertEqual(set(nodes[topic]), {"/a/poinsot", "/b/poinsot"})

    def test_both_run(self):
        for ns in PREFIXES:
            self.assertTrue(self.advances(ns), ns)

    def test_pausing_one_leaves_the_other(self):
        for paused, playing in (("/a", "/b"), ("/b", "/a")):
            segment = self.states[playing].last().segment
            self.assertTrue(self.control[paused].pause(True).success)
            still = self.states[paused].next_where(lambda s: s.time_rate == 0)
            self.assertTrue(self.advances(playing))
            self.assertEqual(self.states[paused].next().time, still.time)
            self.assertEqual(self.states[playing].last().segment, segment)
            self.control[paused].pause(False)
            self.states[paused].next_where(lambda s: s.time_rate == 1)

    def test_commands_reach_one_node_only(self):
        segment = {ns: self.states[ns].last().segment for ns in PREFIXES}
        self.control["/a"].reset()
        self.states["/a"].next_where(lambda s: s.segment == segment["/a"] + 1)
        self.control["/a"].seek(40.0)
        self.states["/a"].next_where(lambda s: s.segment == segment["/a"] + 2 and s.time >= 40)
        self.control["/b"].speed(-2.0)
        self.states["/b"].next_where(lambda s: s.time_rate == -2)
        self.assertTrue(self.advances("/a"))
        self.assertEqual(self.states["/b"].next().segment, segment["/b"])

    def test_one_tf_tree_holds_both(self):
        def transforms():
            return [t for m in self.tf.all() + self.tf_static.all() for t in m.transforms]

        expected = {"world": set()}
        for prefix in PREFIXES.values():
            body = prefix + "wingnut"
            expected["world"] |= {body, body + "_space", body + "_model"}
            expected[body + "_space"] = {body + "_space_body"}

        def tree():
            children = {}
            for t in transforms():
                children.setdefault(t.header.frame_id, set()).add(t.child_frame_id)
            return children
        graph.wait_for(lambda: tree() == expected or len(self.tf.all()) > 600, what="the whole tree")
        self.assertEqual(tree(), expected)

    def test_frames_carry_the_prefix(self):
        for ns, prefix in PREFIXES.items():
            body = prefix + "wingnut"
            own = {"world", body, body + "_space", body + "_model", body + "_space_body"}
            for topic in ("/markers", "/markers_static"):
                listener = graph.Listener(ns + topic, MarkerArray)
                array = graph.wait_for(listener.last, what=ns + topic)
                listener.close()
                markers = [m for m in array.markers if m.action == Marker.ADD]
                self.assertTrue(markers)
                self.assertLessEqual({m.header.frame_id for m in markers}, own)
                self.assertTrue(all(m.ns.startswith("wingnut/") for m in markers), "names of bodies carry no prefix")
            listener = graph.Listener(ns + "/wingnut/odometry", Odometry)
            odometry = graph.wait_for(listener.last, what="odometry")
            listener.close()
            self.assertEqual((odometry.header.frame_id, odometry.child_frame_id), ("world", body))
            listener = graph.Listener(ns + "/wingnut/description", BodyDescription)
            description = graph.wait_for(listener.last, what="description")
            listener.close()
            self.assertEqual((description.body, description.header.frame_id), ("wingnut", body))
            self.assertEqual(self.states[ns].last().body, "wingnut")
            self.assertEqual(self.states[ns].last().header.frame_id, "world")

    def test_diagnostics_tell_the_nodes_apart(self):
        def names():
            return {s.name for m in self.diagnostics.all() for s in m.status}
        graph.wait_for(lambda: sum(name.endswith("ticks") for name in names()) >= 2,
                       what="status `ticks` of both nodes under names of their own")


if __name__ == "__main__":
    rostest.rosrun("poinsot", "namespaces", NamespacesTest)
