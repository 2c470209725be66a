#!/usr/bin/python3
"""Another scene, another method, another spin while it plays: what a subscriber sees of them."""
import io
import math
import os
import subprocess
import sys
import threading
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rospkg  # noqa: E402
import rospy  # noqa: E402
import rostest  # noqa: E402
from geometry_msgs.msg import Vector3  # noqa: E402
from tf2_msgs.msg import TFMessage  # noqa: E402
from visualization_msgs.msg import Marker, MarkerArray  # noqa: E402

import graph  # noqa: E402
import processes  # noqa: E402
from poinsot.msg import Activity, BodyDescription, BodyState, NodeStatus  # noqa: E402
from poinsot.srv import LoadScene, SetMethod, SetSpin  # noqa: E402

BODY = "wingnut"
NAN, INF = float("nan"), float("inf")
LONG = 300  # s: far more than 1e8 steps take, which under a sanitizer is a minute


def vector(v):
    return (v.x, v.y, v.z)


def distance(a, b):
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b)))


class ChangesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("changes_test")
        cls.control = graph.Control()
        for name in ("load_scene", "set_method", "set_spin"):
            rospy.wait_for_service("/poinsot/" + name, graph.PATIENCE)
        cls.load_scene = staticmethod(rospy.ServiceProxy("/poinsot/load_scene", LoadScene))
        cls.set_method = staticmethod(rospy.ServiceProxy("/poinsot/set_method", SetMethod))
        cls.set_spin = staticmethod(rospy.ServiceProxy("/poinsot/set_spin", SetSpin))
        cls.states = graph.Listener("/%s/state" % BODY, BodyState)
        cls.descriptions = graph.Listener("/%s/description" % BODY, BodyDescription)
        cls.status = graph.Listener("/poinsot/status", NodeStatus)
        cls.still = graph.Listener("/markers_static", MarkerArray)
        cls.moving = graph.Listener("/markers", MarkerArray)
        cls.tf_static = graph.Listener("/tf_static", TFMessage)
        graph.wait_for(cls.states.last, what="a state")
        graph.wait_for(cls.status.last, what="a status")
        cls.start = cls.states.next_where(lambda s: True)
        cls.methods = cls.status.last().bodies[0].methods
        cls.description = graph.wait_for(cls.descriptions.last, what="a description")

    def setUp(self):
        self.control.speed(1.0)
        self.control.pause(False)
        if self.status.last().scene != "dzhanibekov":
            self.load("dzhanibekov")
        _, changed = self.change(lambda: self.set_method(BODY, "closed_form", 0))
        since = self.states.count()
        self.control.reset()
        # A test that ended near t = 0 has sent such states too, of the segment before.
        self.first = self.states.next_where(lambda s: s.segment > changed.segment and s.time_rate == 1 and
                                            0 <= s.time < 0.1 and s.attitude_error == 0, since=since)

    def tearDown(self):
        self.assertTrue(graph.stamps_never_decrease(self.states.all()), "stamps decreased")
        segments = [m.segment for m in self.states.all()]
        self.assertEqual(segments, sorted(segments), "a segment came back")

    def change(self, act):
        """Does it, expects it to be done, and gives the last state before it and the first of the new segment."""
        before = self.states.last()
        since = self.states.count()
        response = act()
        self.assertTrue(response.success, response.message)
        after = self.states.next_where(lambda s: s.segment > before.segment, since=since)
        before = [s for s in self.states.all() if s.segment < after.segment][-1]
        return before, after

    def load(self, scene):
        response = self.load_scene(scene)
        self.assertTrue(response.success, response.message)
        self.status.next_where(lambda s: s.scene == os.path.basename(scene).replace(".yaml", "") and not s.busy)

    def refuse(self, act, *pieces):
        before = self.states.last()
        response = act()
        self.assertFalse(response.success)
        for piece in pieces:
            self.assertIn(piece, response.message)
        self.status.next_where(lambda s: s.refused == response.message)
        # That nothing comes of it shows in what is published afterwards.
        after = self.states.more(20)
        self.assertEqual({s.segment for s in after}, {before.segment}, "what was refused changed something")
        self.assertGreater(after[-1].time, before.time, "it does not play on")

    def propagated(self, state, method, step=None):
        """The attitude at the state's t, by the program, from the scene's start."""
        d = self.description
        # Body axes to principal ones and back are the caller's affair there.
        axes = d.principal_axes
        q0, o0 = multiplied((0.70710678118654752, 0, 0, 0.70710678118654752), quaternion(axes)), \
            rotated(inverse(quaternion(axes)), (0.0, 0.2, 3.0))
        row = "a," + ",".join(repr(float(x)) for x in list(d.principal_moments) + list(q0) + list(o0) + [state.time])
        command = [processes.program("propagate"), "--method", method] + (["--step", repr(step)] if step else [])
        out = subprocess.run(command, input="id,mu1,mu2,mu3,q0w,q0x,q0y,q0z,O01,O02,O03,t\n" + row + "\n",
                             stdout=subprocess.PIPE, check=True, universal_newlines=True).stdout
        q = [float(x) for x in out.strip().splitlines()[-1].split(",")[2:6]]
        return multiplied(q, inverse(quaternion(axes)))

    def test_status_says_what_plays(self):
        status = self.status.last()
        self.assertEqual(status.scene, "dzhanibekov")
        scenes = os.path.join(rospkg.RosPack().get_path("poinsot"), "scenes")
        self.assertEqual(status.scenes, sorted(f[:-5] for f in os.listdir(scenes) if f.endswith(".yaml")))
        self.assertEqual(os.path.realpath(status.scene_file), os.path.realpath(scenes + "/dzhanibekov.yaml"))
        self.assertEqual([b.name for b in status.bodies], [BODY])
        self.assertIn("lie_euler", status.bodies[0].methods)
        self.assertEqual((status.paused, status.speed, status.rate), (False, 1, 60))
        self.control.pause(True)
        self.status.next_where(lambda s: s.paused)
        self.control.pause(False)
        self.control.speed(-2.5)
        self.status.next_where(lambda s: s.speed == -2.5 and not s.paused)

    def test_markers_keep_to_their_budget(self):
        # doc/benchmarks.md: 250 kB/s a free body at 60 messages a second, and 75 kB of what stands still.
        self.moving.clear()
        graph.wait_for(lambda: self.moving.count() > 400, what="as many messages as one trail is long")
        sizes = [size(m) for m in self.moving.all()]
        self.assertLess(60 * sum(sizes) / len(sizes), 250e3)
        self.assertLess(size(self.still.last()), 75e3)
        self.assertGreater(size(self.still.last()), 10e3, "nothing to measure")

    def test_status_counts_and_foretells_flips(self):
        # A flip: the component of Omega along the hub, the axis of intermediate moment, changes its sign.
        status = self.status.next()
        self.assertTrue(status.bodies[0].flips)
        flip_at = status.time + status.bodies[0].time_to_next_flip
        self.assertEqual(status.bodies[0].flips_since_start, 0)
        self.control.seek(flip_at - 0.2)
        self.states.next_where(lambda s: abs(s.time - flip_at + 0.2) < 0.1)
        after = self.states.next_where(lambda s: s.time > flip_at + 0.1)
        run = [s for s in self.states.all() if s.segment == after.segment]
        crossing = [(a, b) for a, b in zip(run, run[1:]) if a.omega_body.z * b.omega_body.z <= 0]
        self.assertEqual(len(crossing), 1)
        self.assertTrue(crossing[0][0].time - 1e-9 <= flip_at <= crossing[0][1].time + 1e-9)
        status = self.status.next_where(lambda s: s.time > flip_at)
        self.assertEqual(status.bodies[0].flips_since_start, 1)

    def test_another_method_goes_on_from_the_same_start(self):
        since = self.descriptions.count()
        before, after = self.change(lambda: self.set_method(BODY, "lie_euler", 0.01))
        self.assertAlmostEqual(after.time, before.time, delta=0.2)
        self.assertGreaterEqual(after.time, before.time, "time went back")
        self.assertEqual(after.segment, before.segment + 1)
        description = self.descriptions.next_where(lambda d: d.method == "lie_euler", since=since)
        self.assertEqual(description.step, 0.01)
        later = self.states.next_where(lambda s: s.time > after.time + 2)
        self.assertGreater(later.attitude_error, 1e-4, "lie_euler at this step goes wrong")
        self.assertGreater(abs(later.energy_drift), 1e-6)
        truth = self.propagated(later, "closed_form")
        self.assertAlmostEqual(later.attitude_error, angle(truth, quaternion(later.attitude)), delta=1e-9)
        # On the grid of steps, where the program takes the same ones.
        self.control.seek(1.0)
        self.control.pause(True)
        self.states.next_where(lambda s: s.time_rate == 0)
        self.control.seek(1.0)
        state = self.states.next_where(lambda s: s.time == 1.0 and s.time_rate == 0)
        self.assertLess(angle(self.propagated(state, "lie_euler", 0.01), quaternion(state.attitude)), 1e-12)

    def test_a_step_is_chosen_where_none_is_given(self):
        for method in ("rk4", "dmv4"):
            self.change(lambda: self.set_method(BODY, method, 0))
            status = self.status.next_where(lambda s: s.bodies[0].method == method)
            self.assertGreater(status.bodies[0].step, 0)
            self.assertLess(status.bodies[0].step, 0.1)

    def test_bad_methods_are_refused(self):
        self.refuse(lambda: self.set_method(BODY, "rk5", 0), "rk5", "expected one of the methods that move this body, closed_form")
        self.refuse(lambda: self.set_method("book", "rk4", 0), 'expected one of wingnut, got "book"')
        self.refuse(lambda: self.set_method(BODY, "rk4", -1), "step", "expected a positive finite number")
        self.refuse(lambda: self.set_method(BODY, "rk4", NAN), "step", "expected a positive finite number")
        self.refuse(lambda: self.set_method(BODY, "rk4", 50), "rk4 with a step of 50 s", "a step of at most")

    def test_another_spin_starts_where_the_body_is(self):
        self.states.next_where(lambda s: s.time > 0.5)
        omega = Vector3(2.5, 0.3, -0.4)
        before, after = self.change(lambda: self.set_spin(BODY, omega))
        self.assertEqual(after.time, 0)
        self.assertEqual(after.segment, before.segment + 1)
        self.assertLess(distance(vector(after.omega_body), vector(omega)), 1e-14)
        # It was made ready while the body moved on: the attitude is that of a state lately seen.
        seen = [graph.quaternion_distance(s.attitude, after.attitude)
                for s in self.states.all()[-120:] if s.segment == before.segment]
        self.assertLess(min(seen), 0.06)
        # The picture is that of the new spin.
        bead = marker_at(self.moving, after.header.stamp, BODY + "/model/omega")

        def levels():
            found = [m for m in self.still.last().markers if m.ns.startswith(BODY + "/model/") and
                     m.ns.endswith("_ellipsoid")]
            return [level(m, vector(bead.pose.position)) for m in found]
        graph.wait_for(lambda: len(levels()) == 2 and all(abs(x - 1) < 1e-3 for x in levels()),
                       what="ellipsoids through the new Omega")

    def test_forbidden_spins_are_refused(self):
        for bad in (NAN, INF, -INF, 1e200):
            self.refuse(lambda: self.set_spin(BODY, Vector3(1, bad, 0)), BODY, "expected 3 finite numbers")
        self.refuse(lambda: self.set_spin("book", Vector3(1, 0, 0)), 'expected one of wingnut, got "book"')

    def test_rest_is_allowed_and_reset_brings_the_spin_back(self):
        self.change(lambda: self.set_spin(BODY, Vector3(0, 0, 0)))
        self.assertEqual(vector(self.states.next().omega_body), (0, 0, 0))
        self.change(self.control.reset)
        self.assertLess(distance(vector(self.states.next().omega_body), (0, 0.2, 3)), 0.1)

    def test_reset_brings_the_start_back_and_leaves_the_method(self):
        self.change(lambda: self.set_method(BODY, "buss2", 0.01))
        self.change(lambda: self.set_spin(BODY, Vector3(2.5, 0.3, -0.4)))
        _, after = self.change(self.control.reset)
        self.assertEqual(after.time, 0)
        self.assertLess(distance(vector(after.omega_body), (0, 0.2, 3)), 1e-14)
        self.assertLess(angle(quaternion(after.attitude), (0.70710678118654752, 0, 0, 0.70710678118654752)), 1e-15)
        self.assertEqual(self.status.next().bodies[0].method, "buss2")

    def test_another_scene_while_it_plays(self):
        for scene in ("regimes", os.path.join(rospkg.RosPack().get_path("poinsot"), "scenes", "heavy_top_cusps.yaml")):
            self.load(scene)
            status = self.status.last()
            names = [b.name for b in status.bodies]
            self.assertNotIn(BODY, names)
            self.assertLess(status.time, 20)
            for name in names:
                listener = graph.Listener("/%s/state" % name, BodyState)
                state = listener.next()
                self.assertEqual(state.segment, status.segment)
                listener.close()
            for listener in (self.still, self.moving):
                graph.wait_for(lambda: {ns.split("/")[0] for ns, _ in graph.drawn(listener.all())} == set(names),
                               what="the bodies of this scene alone")
            late = {m.ns.split("/")[0] for m in self.still.last().markers if m.action == Marker.ADD}
            self.assertEqual(late, set(names), "what a late RViz sees")
            frames = {t.child_frame_id.split("_space")[0].split("_model")[0] for t in self.tf_static.last().transforms}
            self.assertEqual(frames, set(names))
            graph.wait_for(lambda: not {"/%s/%s" % (BODY, what) for what in ("state", "odometry", "description")} &
                           {name for name, _ in rospy.get_published_topics()}, what="the end of the topics of " + BODY)
        since = self.states.count()
        self.load("dzhanibekov")
        self.assertEqual(self.states.next_where(lambda s: s.time_rate == 1, since=since).body, BODY)

    def test_who_listens_is_served_after_quick_changes_of_scenes(self):
        # "wingnut" has a body of the same name. "t_handle" has not: were the topics withdrawn and advertised again, a rospy
        # subscriber that hears of the new publisher before it notices the end of the old connection would stay alone.
        before = self.states.last()
        for other in ("wingnut", "t_handle"):
            for scene in 10 * ("dzhanibekov", other):
                response = self.load_scene(scene)
                self.assertTrue(response.success, response.message)
            for scene in (other, "dzhanibekov"):
                response = self.load_scene(scene)
                self.assertTrue(response.success, response.message)
                graph.wait_for(lambda: self.status.last().scene == scene and not self.status.last().busy, what=scene)
            for listener in (self.states, self.moving):
                listener.more(5)
            self.assertTrue(self.states.last()._connection_header is before._connection_header, "connected anew")
        self.assertEqual({ns.split("/")[0] for ns, _ in graph.drawn(self.moving.all())}, {BODY})

    def test_bad_scenes_are_refused(self):
        self.refuse(lambda: self.load_scene("nosuch"), 'expected the path of a scene file or one of ', "dzhanibekov",
                    'got "nosuch"')
        self.refuse(lambda: self.load_scene("/nowhere/at_all.yaml"), "/nowhere/at_all.yaml")
        bad = os.path.join(os.environ.get("ROS_HOME", "/tmp"), "poinsot_bad_scene.yaml")
        with open(bad, "w") as file:
            file.write("bodies:\n  - {name: a, inertia: [1, -2, 3], angular_velocity: [0, 1, 0]}\n")
        self.refuse(lambda: self.load_scene(bad), bad + ":2", "got -2", "expected a positive finite number")
        os.remove(bad)

    def test_a_path_to_a_pipe_or_a_device_is_refused_and_services_go_on(self):
        def within_seconds(act):  # a service that never answers fails the test, and does not stop it
            answers = []
            thread = threading.Thread(target=lambda: answers.append(act()), daemon=True)
            thread.start()
            thread.join(20)
            self.assertTrue(answers, "no answer in 20 s")
            return answers[0]

        pipe = os.path.join(os.environ.get("ROS_HOME", "/tmp"), "poinsot_pipe.yaml")
        os.mkfifo(pipe)
        self.addCleanup(os.remove, pipe)
        self.refuse(lambda: within_seconds(lambda: self.load_scene(pipe)), pipe, "got a FIFO (named pipe)",
                    "expected a regular file")
        self.refuse(lambda: within_seconds(lambda: self.load_scene("/dev/zero")), "/dev/zero",
                    "got a character device", "expected a regular file")
        self.assertTrue(within_seconds(lambda: self.set_method(BODY, "rk4", 0.01)).success)

    def test_asked_for_in_a_hurry_the_last_word_counts(self):
        segment = self.states.last().segment
        for method in ("rk4", "buss2", "lie_euler", "dmv2", "cf4"):
            self.assertTrue(self.set_method(BODY, method, 0).success)
        self.assertTrue(self.set_spin(BODY, Vector3(0.1, 2, 0.1)).success)
        status = self.status.next_where(lambda s: not s.busy and s.segment > segment)
        self.assertEqual(status.bodies[0].method, "cf4")
        state = self.states.next_where(lambda s: s.segment == status.segment, since=0)
        self.assertLess(distance(vector(state.omega_body), (0.1, 2, 0.1)), 0.2)

    def seek(self, t):
        since = self.states.count()
        self.control.seek(t)
        return self.states.next_where(lambda s: t <= s.time < t + 60, since=since)

    def test_a_method_is_not_played_at_a_time_too_far_for_it(self):
        self.seek(2e5)
        self.assertTrue(self.set_method(BODY, "lie_euler", 0.004).success)  # 5e7 steps: it takes its time
        self.seek(1e9)
        status = self.status.next_where(lambda s: s.refused, LONG)
        for piece in ("method lie_euler of wingnut refused", "to t = 1e+09 s", "steps of 0.004 s",
                      "expected at most 1e+09 steps, got"):
            self.assertIn(piece, status.refused)
        state = self.states.next_where(lambda s: s.time > 1e9 + 1)
        self.assertEqual(state.attitude_error, 0, "what was refused plays")
        self.assertEqual(self.status.last().bodies[0].method, "closed_form")

    def test_a_method_is_made_ready_for_the_time_that_has_come(self):
        self.seek(2e5)
        self.assertTrue(self.set_method(BODY, "lie_euler", 0.004).success)
        segment = self.seek(4e5).segment  # 5e7 steps more
        since = self.states.count()
        self.status.next_where(lambda s: s.bodies[0].method == "lie_euler", LONG)
        there = [s for s in self.states.all() if s.segment == segment and s.time >= 4e5]
        self.assertGreater(len(there), 10, "nothing was published while it was made ready")
        self.assertTrue(all(s.attitude_error == 0 for s in there))
        state = self.states.next_where(lambda s: s.segment == segment + 1, since=since - 1)
        # Steps taken between two ticks would be a gap, three times as long as the steps before.
        following = self.states.next_where(lambda s: s.segment > segment and s.time > state.time, since=since - 1)
        self.assertLess(following.time - there[-1].time, there[-1].time - there[0].time)
        self.assertGreaterEqual(state.time, there[-1].time)
        self.assertGreater(state.attitude_error, 1e-6)

    def test_reset_does_not_wait_for_a_method(self):
        self.seek(2e6)
        self.assertTrue(self.set_method(BODY, "lie_euler", 0.004).success)  # 5e8 steps: far longer than a test waits
        asked = Activity(kind=Activity.SET_METHOD, body=BODY, method="lie_euler")
        self.status.next_where(lambda s: s.activities == [asked])
        since = self.states.count()
        self.control.reset()
        state = self.states.next_where(lambda s: s.time < 1e6, seconds=5, since=since)
        self.assertEqual(state.time, 0)
        self.assertEqual(self.status.next().bodies[0].method, "lie_euler", "t = 0 is played by the method before")
        later = self.states.next_where(lambda s: 1 < s.time < 1e6)
        self.assertEqual(later.segment, state.segment, "one motion from t = 0 on")
        self.assertGreater(later.attitude_error, 1e-5)
        self.assertGreater(abs(later.energy_drift), 1e-6)

    def test_a_seek_outlives_another_method(self):
        self.change(lambda: self.set_method(BODY, "lie_euler", 0.004))
        self.control.seek(2e5)
        seeking = self.status.next_where(lambda s: s.busy == "seek")
        self.assertEqual(seeking.activities, [Activity(kind=Activity.SEEK)])
        self.change(lambda: self.set_method(BODY, "buss2", 0.01))
        state = self.states.next_where(lambda s: s.time >= 2e5, LONG)
        self.assertLess(state.time, 2e5 + 60)
        self.assertEqual(self.status.last().bodies[0].method, "buss2")

    def test_a_method_that_costs_too_much_is_refused(self):
        self.assertTrue(self.set_method(BODY, "lie_euler", 1e-8).success)  # what it costs is seen when it is there
        status = self.status.next_where(lambda s: s.refused)
        for piece in ("method lie_euler of wingnut refused", "expected steps that cost at most 0.8 CPU s", ", got ",
                      "; take larger steps"):
            self.assertIn(piece, status.refused)
        self.assertEqual(status.bodies[0].method, "closed_form")

    def test_what_is_refused_together_is_named_together(self):
        self.seek(2e5)
        self.assertTrue(self.set_method(BODY, "buss2", 0.004).success)  # 5e7 steps: not done when the next comes
        self.assertTrue(self.set_method(BODY, "lie_euler", 0.004).success)
        self.seek(1e9)
        status = self.status.next_where(lambda s: s.refused, LONG)
        self.assertIn("method buss2 of wingnut and method lie_euler of wingnut refused", status.refused)
        self.assertEqual(status.bodies[0].method, "closed_form")


def size(message):
    buffer = io.BytesIO()
    message.serialize(buffer)
    return len(buffer.getvalue())


def marker_at(listener, stamp, ns):
    def found():
        return [m for a in listener.all() for m in a.markers if m.ns == ns and m.header.stamp == stamp]
    return graph.wait_for(found, what="a marker " + ns)[0]


def quaternion(q):
    return (q.w, q.x, q.y, q.z)


def multiplied(a, b):
    return (a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
            a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0])


def inverse(q):
    return (q[0], -q[1], -q[2], -q[3])


def rotated(q, v):
    return multiplied(multiplied(q, (0,) + tuple(v)), inverse(q))[1:]


def angle(a, b):
    d = multiplied(inverse(a), b)
    return 2 * math.atan2(math.sqrt(d[1] ** 2 + d[2] ** 2 + d[3] ** 2), abs(d[0]))


def level(ellipsoid, point):
    """1 on the surface, as drawn."""
    p = rotated(inverse(quaternion(ellipsoid.pose.orientation)), point)
    return math.sqrt(sum((2 * x / s) ** 2 for x, s in zip(p, vector(ellipsoid.scale))))


if __name__ == "__main__":
    rostest.rosrun("poinsot", "changes", ChangesTest)
