#!/usr/bin/python3
"""What demo.launch records is complete and right, replay.launch shows it, and the audit knows a damaged one."""
import math
import multiprocessing
import os
import shutil
import signal
import socket
import sys
import tempfile
import traceback
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rosbag  # noqa: E402
import rosgraph  # noqa: E402
import rospy  # noqa: E402
import rostest  # noqa: E402
from rosgraph_msgs.msg import Clock  # noqa: E402
from tf2_msgs.msg import TFMessage  # noqa: E402
from visualization_msgs.msg import Marker, MarkerArray  # noqa: E402

import graph  # noqa: E402
import processes  # noqa: E402
from poinsot.msg import BodyDescription, BodyState  # noqa: E402

BODY = "wingnut"
TOPICS = {"/wingnut/state": "poinsot/BodyState", "/wingnut/odometry": "nav_msgs/Odometry",
          "/wingnut/description": "poinsot/BodyDescription", "/markers": "visualization_msgs/MarkerArray",
          "/markers_static": "visualization_msgs/MarkerArray", "/tf": "tf2_msgs/TFMessage",
          "/tf_static": "tf2_msgs/TFMessage", "/poinsot/layout": "poinsot/SceneLayout",
          "/diagnostics": "diagnostic_msgs/DiagnosticArray"}
LATCHED = {"/wingnut/description", "/markers_static", "/tf_static", "/poinsot/layout"}


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


class Launch(object):
    """roslaunch, with a master of its own."""

    def __init__(self, directory, *arguments):
        port = free_port()
        self.environment = dict(os.environ, ROS_MASTER_URI="http://127.0.0.1:%d" % port, ROS_HOME=directory,
                                ROS_LOG_DIR=os.path.join(directory, "log"), ROS_IP="127.0.0.1")
        self.environment.pop("ROS_HOSTNAME", None)  # it would win over ROS_IP
        self.process = processes.Process(["roslaunch", "-p", str(port), "poinsot"] + list(arguments), self.environment)

    def ask(self, what, seconds=120):
        """Calls what() in a process that belongs to this master, and gives what it returns."""
        context = multiprocessing.get_context("fork")
        mine, its = context.Pipe(False)
        child = context.Process(target=self._answer, args=(what, its))
        child.start()
        its.close()
        try:
            if not mine.poll(seconds):
                raise AssertionError("no answer from %s; the launch file wrote:\n%s" %
                                     (what.__name__, self.process.console))
            good, answer = mine.recv()
        finally:
            child.join(10)
            if child.is_alive():
                os.kill(child.pid, signal.SIGKILL)
                child.join()
        if not good:
            raise AssertionError(answer + "\nthe launch file wrote:\n" + self.process.console)
        return answer

    def _answer(self, what, pipe):
        try:
            os.environ.clear()
            os.environ.update(self.environment)
            graph.wait_for(lambda: rosgraph.is_master_online(), 60, "the master")
            rospy.init_node("stranger", disable_signals=True)
            pipe.send((True, what()))
        except BaseException:
            pipe.send((False, traceback.format_exc()))
        pipe.close()
        os._exit(0)


def play_about():
    """Eight seconds and more with everything that one can ask of the node."""
    states = graph.Listener("/wingnut/state", BodyState)
    graph.wait_for(states.last, what="a state")

    def recorded():
        subscribers = dict(rosgraph.Master("/stranger").getSystemState()[1])
        return all("/record" in subscribers.get(topic, []) for topic in TOPICS)
    graph.wait_for(recorded, 60, "the recorder to listen to every topic")
    control = graph.Control()

    def play(seconds):
        begin = states.next().header.stamp
        states.next_where(lambda s: (s.header.stamp - begin).to_sec() > seconds, 60)
    play(4)
    control.pause(True)
    still = states.next_where(lambda s: s.time_rate == 0)
    play(0.5)
    control.step()
    states.next_where(lambda s: s.time_rate == 0 and s.time > still.time)
    play(0.3)
    control.pause(False)
    play(1.5)
    segment = states.last().segment
    control.seek(30.0)
    states.next_where(lambda s: s.segment == segment + 1)
    play(2)
    control.speed(-2.0)
    states.next_where(lambda s: s.time_rate == -2)
    play(1)
    control.speed(1.0)
    control.reset()
    states.next_where(lambda s: s.segment == segment + 2)
    play(3)
    return [(s.segment, s.time_rate) for s in states.all()]


def watch():
    """What one sees who joins in the middle of a replay."""
    clock = graph.Listener("/clock", Clock)
    begin = graph.wait_for(clock.last, what="/clock").clock
    clock.next_where(lambda m: (m.clock - begin).to_sec() > 2)  # the latched messages have gone by
    static = {}
    for topic, kind in (("/markers_static", MarkerArray), ("/tf_static", TFMessage),
                        ("/wingnut/description", BodyDescription)):
        listener = graph.Listener(topic, kind)
        static[topic] = graph.wait_for(listener.last, what=topic)
        listener.close()
    moving = graph.Listener("/markers", MarkerArray)
    tf = graph.Listener("/tf", TFMessage)
    states = graph.Listener("/wingnut/state", BodyState)
    graph.wait_for(lambda: all(len(listener.all()) > 20 for listener in (moving, tf, states)), what="what moves")
    clocks = [m.clock.to_nsec() for m in clock.all()]
    return {
        "static markers": sorted({m.ns for m in static["/markers_static"].markers if m.action == Marker.ADD}),
        "static frames": sorted(t.child_frame_id for t in static["/tf_static"].transforms),
        "described": static["/wingnut/description"].body,
        "moving markers": sorted({m.ns for a in moving.all() for m in a.markers if m.action == Marker.ADD}),
        "moving frames": sorted({t.child_frame_id for m in tf.all() for t in m.transforms}),
        "states": len(states.all()),
        "clock in order": clocks == sorted(clocks),
        "clock ran": (clocks[-1] - clocks[0]) * 1e-9,
    }


class RecordAndReplayTest(unittest.TestCase):
    """One story: the tests run in the order of their names."""

    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.mkdtemp()
        cls.bag = os.path.join(cls.directory, "run.bag")
        cls.launches = []

    @classmethod
    def tearDownClass(cls):
        for launch in cls.launches:
            launch.process.close()
        shutil.rmtree(cls.directory)

    def launch(self, *arguments):
        launch = Launch(self.directory, *arguments)
        self.launches.append(launch)
        return launch

    def check_bag(self, path):
        code, out, err = processes.run([processes.program("check_bag"), path], 120)
        return code, out + err

    def test_1_record(self):
        demo = self.launch("demo.launch", "rviz:=false", "record:=true", "bag:=" + self.bag)
        seen = demo.ask(play_about)
        self.assertEqual({rate for _, rate in seen}, {0, 1, -2})
        self.assertTrue(demo.process.running())
        self.assertEqual(demo.process.interrupt(60), 0, demo.process.console)
        self.assertTrue(os.path.exists(self.bag), os.listdir(self.directory))
        self.assertFalse(os.path.exists(self.bag + ".active"), "the bag was closed")

    def test_2_the_bag_is_complete(self):
        with rosbag.Bag(self.bag) as bag:
            topics = bag.get_type_and_topic_info().topics
            self.assertEqual({topic: info.msg_type for topic, info in topics.items()}, TOPICS)
            latched = set()
            for connection in bag._get_connections():
                self.assertTrue(connection.msg_def.strip(), connection.topic + " carries its definition")
                if connection.header.get(b"latching", connection.header.get("latching")) in (b"1", "1"):
                    latched.add(connection.topic)
            self.assertEqual(latched, LATCHED)
            times = [(m.header.stamp, m.segment, m.time_rate) for _, m, _ in bag.read_messages("/wingnut/state")]
            self.assertGreater((times[-1][0] - times[0][0]).to_sec(), 8)
            self.assertEqual({rate for _, _, rate in times}, {0, 1, -2})
            segments = [segment for _, segment, _ in times]
            self.assertEqual(segments[-1] - segments[0], 2, "a seek and a reset")
            self.assertTrue(all(a[0] < b[0] for a, b in zip(times, times[1:])), "stamps grow")

    def test_3_the_audit_passes(self):
        code, text = self.check_bag(self.bag)
        print(text)
        self.assertEqual(code, 0, text)

    def rewritten(self, name, change):
        """A copy of the bag; change(topic, message, count) may alter any message; count is that of its topic."""
        path = os.path.join(self.directory, name)
        counts = {}
        with rosbag.Bag(self.bag) as source, rosbag.Bag(path, "w") as out:
            for topic, message, stamp, header in source.read_messages(return_connection_header=True):
                counts[topic] = counts.get(topic, 0) + 1
                change(topic, message, counts[topic])
                out.write(topic, message, stamp, connection_header=header)
        return path

    def test_4_the_audit_fails_on_a_damaged_bag(self):
        def turn(q, angle):  # about x, by a little
            c, s = math.cos(angle / 2), math.sin(angle / 2)
            q.w, q.x, q.y, q.z = c * q.w - s * q.x, c * q.x + s * q.w, c * q.y - s * q.z, c * q.z + s * q.y

        def untouched(topic, message, count):
            pass

        def one_attitude(topic, message, count):
            if topic == "/wingnut/state" and count == 100:
                turn(message.attitude, 1e-4)

        def one_transform(topic, message, count):
            if topic == "/tf" and count == 100:
                turn(message.transforms[0].transform.rotation, 1e-6)

        def one_rate(topic, message, count):
            if topic == "/wingnut/state" and count == 100:
                message.omega_body.z *= 1.0001

        def energy(topic, message, count):
            if topic == "/wingnut/state":
                message.kinetic_energy *= 1.001

        def ellipsoid(topic, message, count):
            if topic == "/markers_static":
                next(m for m in message.markers if m.ns.endswith("model/energy_ellipsoid")).scale.x *= 1.01

        code, text = self.check_bag(self.rewritten("copied.bag", untouched))
        self.assertEqual(code, 0, "a copy is as good: " + text)
        for change in (one_attitude, one_transform, one_rate, energy, ellipsoid):
            with self.subTest(change.__name__):
                code, text = self.check_bag(self.rewritten(change.__name__ + ".bag", change))
                self.assertEqual(code, 1, text)
                self.assertTrue(text.strip())

    def test_5_the_audit_refuses_what_is_no_bag_of_ours(self):
        def file(name, content):
            path = os.path.join(self.directory, name)
            with open(path, "wb") as out:
                out.write(content)
            return path
        empty = os.path.join(self.directory, "nothing.bag")
        rosbag.Bag(empty, "w").close()
        with open(self.bag, "rb") as whole:
            cut = whole.read(200000)
        for path in (os.path.join(self.directory, "missing.bag"), file("empty.bag", b""), empty,
                     file("text.bag", b"this is no bag\n" * 100), file("cut.bag", cut), self.directory):
            with self.subTest(path):
                code, out, err = processes.run([processes.program("check_bag"), path])
                self.assertEqual(code, 2, out + err)
                self.assertIn(path, err)
        for path, cut_off in ((os.path.join(self.directory, "cut.bag"), True), (os.path.join(self.directory, "text.bag"), False)):
            self.assertEqual("rosbag reindex '%s'" % path in self.check_bag(path)[1], cut_off, path)
        code, _, err = processes.run(["sh", "-c", "exec \"$0\" \"$1\" > /dev/full", processes.program("check_bag"), self.bag])
        self.assertEqual(code, 2, "a report that nobody gets: " + err)
        self.assertIn("cannot write standard output", err)
        self.assertEqual(processes.run([processes.program("check_bag")])[0], 2)
        self.assertEqual(processes.run([processes.program("check_bag"), "--nonsense", self.bag])[0], 2)
        self.assertEqual(processes.run([processes.program("check_bag"), "--help"])[0], 0)

    def test_6_replay(self):
        replay = self.launch("replay.launch", "bag:=" + self.bag, "rviz:=false", "delay:=1")
        seen = replay.ask(watch)
        for picture in ("space", "model"):
            for what in ("energy_ellipsoid", "momentum_ellipsoid", "polhode", "separatrix"):
                self.assertIn("wingnut/%s/%s" % (picture, what), seen["static markers"])
            self.assertIn("wingnut/%s/omega" % picture, seen["moving markers"])
        self.assertEqual(seen["static frames"], ["wingnut_model", "wingnut_space"])
        self.assertEqual(seen["moving frames"], ["wingnut", "wingnut_space_body"])
        self.assertEqual(seen["described"], BODY)
        self.assertTrue(seen["clock in order"])
        self.assertGreater(seen["clock ran"], 2)
        # It ends with the bag by itself.
        self.assertEqual(replay.process.wait(90), 0, replay.process.console)


if __name__ == "__main__":
    rostest.rosrun("poinsot", "record_and_replay", RecordAndReplayTest)
