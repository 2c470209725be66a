#!/usr/bin/python3
"""Each launch file plays after each other one on the same ROS master, whatever that has left on the parameter server.

Usage: test_launch_pairs.py    (in the environment of the devel space)

It starts a master of its own. Every ordered pair of demo, demo with publish_clock:=true, compare, regimes and replay is tried, in
the global namespace and in one of their own: frames arrive on /tf, and the node moves the scene that it was given. Then the
options of replay.launch are tried, and that a clock which runs is followed. The last line reads "N passed, M failed".
"""
import os
import shutil
import socket
import subprocess
import sys
import tempfile

ROOT = os.path.realpath(os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", ".."))
sys.path[:0] = [os.path.join(ROOT, "test"), os.path.join(ROOT, "test", "ros")]
import rosgraph  # noqa: E402
import rospy  # noqa: E402
from rosgraph_msgs.msg import Clock  # noqa: E402
from tf2_msgs.msg import TFMessage  # noqa: E402
from visualization_msgs.msg import MarkerArray  # noqa: E402

import checks  # noqa: E402
import graph  # noqa: E402
import processes  # noqa: E402
from poinsot.msg import NodeStatus  # noqa: E402

# What a launch is called here: its file and arguments, the scene that ~status names, and whether ROS time is simulated.
LAUNCHES = {
    "demo": (["demo.launch"], "dzhanibekov", False),
    "demo with publish_clock": (["demo.launch", "scene:=phone", "publish_clock:=true"], "phone", True),
    "compare": (["compare.launch"], "", False),
    "regimes": (["regimes.launch"], "regimes", False),
    "replay": (["replay.launch", "delay:=0"], None, True),
}
OWN = "robot1"
SECONDS = 30  # of the bag


def walk():
    """The names of launches in an order in which every ordered pair of two of them occurs once: an Eulerian path."""
    left = {a: [b for b in LAUNCHES if b != a] for a in LAUNCHES}
    stack, out = [next(iter(LAUNCHES))], []
    while stack:
        if left[stack[-1]]:
            stack.append(left[stack[-1]].pop())
        else:
            out.append(stack.pop())
    return out[::-1]


class Launch(object):
    """A launch file under way, without RViz."""

    def __init__(self, arguments, namespace=""):
        environment = dict(os.environ)
        environment.pop("ROS_NAMESPACE", None)
        if namespace:
            environment["ROS_NAMESPACE"] = namespace
        self.process = processes.Process(["roslaunch", "--skip-log-check", "poinsot"] + arguments + ["rviz:=false"], environment)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.close()

    def wait_for(self, condition, what):
        """The value of condition() once it is true. A launch that ends is not waited for."""
        def met():
            value = condition()
            if not value and not self.process.running():
                raise AssertionError("the launch ended, waiting for " + what)
            return value
        return graph.wait_for(met, what=what)


def moves(listener):
    """Whether the statuses of a node show it playing: its t has gone on."""
    statuses = listener.all()
    return len(statuses) > 1 and statuses[-1].time > statuses[0].time and not statuses[-1].waiting_for_clock


def complaints_of(name, namespace, bag):
    """What is wrong with a launch that was started now."""
    arguments, scene, simulated = LAUNCHES[name]
    status = graph.Listener("/%s/poinsot/status" % namespace if namespace else "/poinsot/status", NodeStatus)
    tf, clock = graph.Listener("/tf", TFMessage), graph.Listener("/clock", Clock)
    out = []
    with Launch(arguments + (["bag:=" + bag] if scene is None else []), namespace) as launch:
        try:
            if scene is None:
                launch.wait_for(lambda: clock.count() > 1, "/clock")
            else:
                launch.wait_for(lambda: moves(status), "a node that plays")
                if status.last().scene != scene:
                    out.append("expected the scene \"%s\", got \"%s\"" % (scene, status.last().scene))
            launch.wait_for(lambda: tf.count() > 1, "/tf")
            if bool(rospy.get_param("/use_sim_time", False)) != simulated:
                out.append("expected /use_sim_time %s" % simulated)
        except AssertionError as error:
            out += [str(error)] + launch.process.console.splitlines()[-6:]
    for listener in (status, tf, clock):
        listener.close()
    return out


def try_pairs(namespace, bag, before):
    for name in walk():
        checks.check("%s%s after %s" % (name, " in namespace " + namespace if namespace else "", before),
                     complaints_of(name, namespace, bag))
        before = name
    return before


def try_replay(bag):
    """The options of replay.launch, which are those of rosbag play."""
    clock, static = graph.Listener("/clock", Clock), graph.Listener("/markers_static", MarkerArray)
    with Launch(["replay.launch", "bag:=" + bag, "delay:=0", "start:=25", "rate:=4", "loop:=true"]) as launch:
        out = []

        def seconds():
            return [message.clock.to_sec() for message in clock.all()]
        try:
            launch.wait_for(lambda: any(b < a - 3 for a, b in zip(seconds(), seconds()[1:])), "a clock that jumps back")
            launch.wait_for(static.last, "what does not move, although it was sent before the start")
            if not 25 <= min(seconds()) < 27:
                out.append("start:=25: expected a clock from 26 s on, got %g s" % min(seconds()))
        except AssertionError as error:
            out += [str(error)] + launch.process.console.splitlines()[-6:]
    clock.close()
    static.close()
    checks.check("replay with start, rate and loop", out)


def try_simulator():
    """The clock of another node is followed while that node runs; of one that was killed, nothing is awaited."""
    tf = graph.Listener("/tf", TFMessage)
    with Launch(LAUNCHES["demo with publish_clock"][0], "simulator") as simulator:
        simulator.wait_for(tf.last, "the node with a clock")
        with Launch(["demo.launch"], OWN) as demo:
            status, out = graph.Listener("/%s/poinsot/status" % OWN, NodeStatus), []
            try:
                demo.wait_for(lambda: moves(status), "a node that plays")
                stamp = status.last().header.stamp.to_sec()
                if stamp > 1e6 or not rospy.get_param("/use_sim_time"):
                    out.append("expected the time of the other node, from 1 s on, got %g s" % stamp)
            except AssertionError as error:
                out += [str(error)] + demo.process.console.splitlines()[-6:]
            status.close()
    checks.check("the clock of a node that runs is followed", out)
    tf.close()
    rospy.set_param("/use_sim_time", True)
    master = rosgraph.Master("/killed")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        address = "http://127.0.0.1:%d/" % free.getsockname()[1]
    rosgraph.Master("/killed").registerPublisher("/clock", "rosgraph_msgs/Clock", address)
    checks.check("the clock of a node that was killed is not waited for", complaints_of("demo", "", ""))
    master.unregisterPublisher("/clock", address)


def main():
    directory = tempfile.mkdtemp()
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    os.environ.update(ROS_MASTER_URI="http://127.0.0.1:%d" % port, ROS_IP="127.0.0.1", ROS_HOME=directory,
                      ROS_LOG_DIR=os.path.join(directory, "log"))
    os.environ.pop("ROS_HOSTNAME", None)  # it would win over ROS_IP
    core = processes.Process(["roscore", "-p", str(port)], dict(os.environ))
    try:
        graph.wait_for(rosgraph.is_master_online, what="the master")
        rospy.init_node("stranger", disable_signals=True)
        bag = os.path.join(directory, "motion.bag")
        subprocess.run([processes.program("simulate"), processes.package_path("scenes", "dzhanibekov.yaml"),
                        "--duration", str(SECONDS), "--bag", bag], check=True)
        try_pairs(OWN, bag, try_pairs("", bag, "nothing"))
        try_replay(bag)
        try_simulator()
        return checks.finish()
    finally:
        core.close()
        shutil.rmtree(directory)


if __name__ == "__main__":
    sys.exit(main())
