#!/usr/bin/python3
"""Nodes that share a topic of markers, and a node that takes the place of one that was killed: what a viewer sees."""
import os
import signal
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rospy  # noqa: E402
import rostest  # noqa: E402
from poinsot.msg import BodyState, NodeStatus  # noqa: E402
from poinsot.srv import LoadScene  # noqa: E402
from visualization_msgs.msg import InteractiveMarkerFeedback, InteractiveMarkerUpdate, MarkerArray  # noqa: E402

import graph  # noqa: E402
import processes  # noqa: E402

TOPICS = ("markers", "markers_static")


def body(**more):
    return dict({"inertia": [1, 2, 3], "angular_velocity": [0.1, 2, 0.1]}, **more)


def tree(name, **more):
    return {"bodies": [dict(body(**more), name=name)]}


class Viewer(object):
    """One RViz that looks at a namespace, however its nodes come and go."""

    def __init__(self, namespace):
        self.listeners = [graph.Listener("%s/%s" % (namespace, topic), MarkerArray) for topic in TOPICS]

    def drawn(self, name):
        """Namespaces and ids of a body, on both topics."""
        out = set()
        for listener in self.listeners:
            out |= {key for key in graph.drawn(listener.all()) if key[0].split("/")[0] == name}
        return out

    def close(self):
        for listener in self.listeners:
            listener.close()


class MarkersTest(unittest.TestCase):
    def setUp(self):
        self.nodes = []

    def tearDown(self):
        for node in self.nodes:
            node.close()

    def start(self, namespace, name, scene):
        private = "%s/%s" % (namespace, name)
        rospy.set_param(private, {"scene": scene, "rate": 50})
        node = processes.Process([processes.program("poinsot_node"), "__ns:=" + namespace, "__name:=" + name])
        self.nodes.append(node)
        return node

    def test_a_node_leaves_alone_what_another_draws_in_its_namespace(self):
        viewer = Viewer("/shared")
        self.start("/shared", "one", tree("first"))
        graph.wait_for(lambda: viewer.drawn("first"), what="the first body")
        # All of a free body: the static ones, and what moves, the trail last.
        graph.wait_for(lambda: {("first/shape", 0), ("first/model/omega", 0), ("first/trail", 0)} <= viewer.drawn("first"),
                       what="the whole of the first body")
        before = viewer.drawn("first")
        self.start("/shared", "two", tree("second"))
        graph.wait_for(lambda: viewer.drawn("second"), what="the second body")
        status = graph.Listener("/shared/two/status", NodeStatus)
        service = "/shared/two/load_scene"
        rospy.wait_for_service(service, graph.PATIENCE)
        answer = rospy.ServiceProxy(service, LoadScene)("dzhanibekov")
        self.assertTrue(answer.success, answer.message)
        status.next_where(lambda s: s.scene == "dzhanibekov" and not s.busy)
        graph.wait_for(lambda: viewer.drawn("wingnut") and not viewer.drawn("second"), what="the other scene alone")
        self.assertEqual(viewer.drawn("first"), before)
        status.close()
        viewer.close()

    def test_labels_keep_apart_while_a_spin_is_led(self):
        scene = {"bodies": [dict(body(), name="led"), dict(body(method="rk4", step=0.001), name="stepping")]}
        self.start("/held", "poinsot", scene)
        viewer = Viewer("/held")
        hand = rospy.Publisher("/held/poinsot/grip/feedback", InteractiveMarkerFeedback, queue_size=10)
        states = graph.Listener("/held/led/state", BodyState)
        handles = graph.Listener("/held/poinsot/grip/update", InteractiveMarkerUpdate)  # there are none until somebody looks
        handles.next_where(lambda u: any(m.name == "led" for m in list(u.markers) + list(u.poses)))
        graph.wait_for(lambda: hand.get_num_connections() and self.figures(viewer), what="the figures of a body")

        def lead(event):
            feedback = InteractiveMarkerFeedback(client_id="markers_test", marker_name="led", event_type=event)
            feedback.header.frame_id = "led_model"
            feedback.pose.orientation.w = 1
            feedback.pose.position.x, feedback.pose.position.y = 0.1, 0.9
            hand.publish(feedback)
        lead(InteractiveMarkerFeedback.MOUSE_DOWN)
        states.next_where(lambda s: s.time_rate == 0)
        lead(InteractiveMarkerFeedback.POSE_UPDATE)
        moving = viewer.listeners[0]
        graph.wait_for(lambda: not self.figures(viewer), what="a body that is drawn as it would be")
        begin = moving.count()
        moving.more(50)
        for end in range(begin, moving.count()):
            labels = [m for (ns, _), m in graph.drawn(moving.all()[:end]).items()
                      if ns == "led/label" and m.header.frame_id == "world"]
            # The words on the flips of what is drawn take the place of the figures of what is not.
            self.assertTrue(labels)
            self.assertFalse([m.text for m in labels if "\nerror " in m.text], "two labels lie on each other")
        lead(InteractiveMarkerFeedback.MOUSE_UP)
        graph.wait_for(lambda: self.figures(viewer), what="the figures again")
        for it in (states, handles, viewer):
            it.close()

    @staticmethod
    def figures(viewer):
        """The label that says how well a body is moved, where it is drawn."""
        drawn = graph.drawn(viewer.listeners[0].all())
        return [m for (ns, _), m in drawn.items() if ns == "led/label" and "\nerror " in m.text]

    def test_what_a_killed_node_has_drawn_goes_when_its_place_is_taken(self):
        pushed = tree("body", effects=[{"type": "constant_torque", "frame": "world", "torque": [0.05, 0, 0.3]}])
        viewer = Viewer("/again")
        killed = self.start("/again", "poinsot", pushed)
        # A path under torques is drawn in more and more pieces.
        graph.wait_for(lambda: ("body/torque", 0) in viewer.drawn("body") and ("body/trail", 1) in viewer.drawn("body"),
                       what="what shows a torque")
        killed.send(signal.SIGKILL, 10)
        self.start("/again", "poinsot", tree("body"))
        late = Viewer("/again")
        states = graph.Listener("/again/body/state", BodyState)
        states.next_where(lambda s: 1 < s.time < 100)
        graph.wait_for(lambda: late.drawn("body") and viewer.drawn("body") == late.drawn("body"),
                       what="an old viewer that sees what a new one does")
        self.assertNotIn(("body/torque", 0), viewer.drawn("body"))
        for it in (states, late, viewer):
            it.close()


if __name__ == "__main__":
    rospy.init_node("markers_test")
    rostest.rosrun("poinsot", "markers", MarkersTest)
