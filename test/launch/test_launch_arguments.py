#!/usr/bin/python3
"""What the arguments of the launch files set; nothing is started.

Usage: test_launch_arguments.py    (in the environment of the devel space)

The last line reads "N passed, M failed".
"""
import os
import subprocess
import sys

import yaml

ROOT = os.path.realpath(os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "test"))
import checks  # noqa: E402

PRIVATE = "/poinsot/"
# What demo.launch sets by itself.
USUAL = {"scene_file": os.path.join(ROOT, "scenes", "dzhanibekov.yaml"), "publish_clock": False, "frame_prefix": ""}


def roslaunch(*words):
    """Exit code, stdout and stderr."""
    # No master answers there, so /use_sim_time does not depend on what else runs.
    environment = dict(os.environ, ROS_MASTER_URI="http://127.0.0.1:9")
    environment.pop("ROS_NAMESPACE", None)
    done = subprocess.run(["roslaunch"] + list(words), stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment,
                          universal_newlines=True)
    return done.returncode, done.stdout, done.stderr


def parameters(*arguments):
    """The parameters that a launch would set."""
    code, out, err = roslaunch("--dump-params", "poinsot", *arguments)
    return yaml.safe_load(out) if code == 0 else {"": err}


def sets(words, expected, *arguments):
    """The node gets these parameters besides the usual ones, and no others."""
    found = parameters(*arguments)
    own = {name[len(PRIVATE):]: value for name, value in found.items() if name.startswith(PRIVATE)}
    wanted = dict(USUAL, **expected)
    checks.check(words, [] if own == wanted else ["expected %s, got %s" % (wanted, own or found)])


def simulated(words, expected, *arguments):
    found = parameters(*arguments).get("/use_sim_time")
    checks.check(words, [] if found is expected else ["expected %s, got %s" % (expected, found)])


def plays(words, expected, *arguments):
    """replay.launch calls rosbag with these words after the delay."""
    _, out, err = roslaunch("--args", "/play", "poinsot", "replay.launch", "bag:=a b.bag", "rviz:=false", *arguments)
    found = out.split()
    if "--delay=3" in found:
        found = [word for word in found[found.index("--delay=3") + 1:] if ":=" not in word]
    checks.check(words, [] if found == expected + ["a", "b.bag"] else ["expected %s, got %s" % (expected, found or err)])


def refused(words, pattern, *arguments):
    """The launch file cannot be loaded, for this reason; roslaunch exits with 0 all the same."""
    _, out, err = roslaunch("--dump-params", "poinsot", *arguments)
    complaint = "expected no parameters and the message %s, got %s" % (pattern, out + err)
    checks.check(words, [] if not out.strip() and pattern in err else [complaint])


def main():
    sets("demo sets the scene", {}, "demo.launch")
    sets("an empty argument is one that is not given", {}, "demo.launch", "rate:=", "method:=", "step:=", "frame_prefix:=")
    sets("demo passes on rate, method, step and prefix", {"rate": "30", "method": "rk4", "step": "1e-3", "frame_prefix": "a/"},
         "demo.launch", "rate:=30", "method:=rk4", "step:=1e-3", "frame_prefix:=a/")
    sets("a prefix that looks like a number stays a text", {"frame_prefix": "1"}, "demo.launch", "frame_prefix:=1")
    simulated("demo does not simulate ROS time", False, "demo.launch")
    simulated("demo with a clock does", True, "demo.launch", "publish_clock:=true")
    simulated("demo can be told to wait for a clock", True, "demo.launch", "use_sim_time:=true")
    simulated("compare can be told to wait for a clock", True, "compare.launch", "use_sim_time:=true")
    simulated("regimes can be told to wait for a clock", True, "regimes.launch", "use_sim_time:=true")
    refused("demo: use_sim_time that is neither", 'expected true or false, got "perhaps"', "demo.launch", "use_sim_time:=perhaps")

    refused("compare: a scene that there is not", "expected the path of a scene file or one of ", "compare.launch", "scene:=foo")
    refused("lesson: a scene that there is not", "expected the path of a scene file or one of ", "lesson.launch", "scene:=foo")

    plays("replay plays once", [])
    plays("replay: an empty argument is one that is not given", [], "loop:=", "rate:=", "start:=")
    plays("replay passes on loop, rate and start", ["--loop", "--rate=0.5", "--start=10"], "loop:=true", "rate:=0.5", "start:=10")
    plays("replay: loop:=false", [], "loop:=false")
    refused("replay: loop that is neither", "perhaps", "replay.launch", "loop:=perhaps")
    return checks.finish()


if __name__ == "__main__":
    sys.exit(main())
