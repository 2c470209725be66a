#!/usr/bin/python3
"""Prints what a launch file sets /use_sim_time to: "true" or "false".

Usage: sim_time.py [true | false]

The word is printed as it is given. Without one, or for an empty one, it is "true" if /use_sim_time is set already and a node
that answers publishes /clock, and otherwise "false": a simulator that runs is followed, but a parameter that an earlier
launch has left behind would make the nodes wait for a clock for ever. The master asked is that of ROS_MASTER_URI; "false" if
there is none. Exit: 0; 2 for bad use.
"""
import http.client
import socket
import sys
import xmlrpc.client

import rosgraph

CALLER = "/sim_time"
PATIENCE = 3.0  # s, for an answer of a node: one that was killed may still be registered
NO_ANSWER = (OSError, http.client.HTTPException, rosgraph.MasterException, xmlrpc.client.Error)


def answers(master, node):
    """Whether a node that is registered with the master is there."""
    try:
        return xmlrpc.client.ServerProxy(master.lookupNode(node)).getPid(CALLER)[0] == 1
    except NO_ANSWER:
        return False


def has_clock():
    """Whether ROS time is simulated already, and somebody lets it go on."""
    try:
        master = rosgraph.Master(CALLER)
        if not (master.hasParam("/use_sim_time") and master.getParam("/use_sim_time") is True):
            return False
        publishers = dict(master.getSystemState()[0]).get("/clock", [])
    except NO_ANSWER:
        return False
    return any(answers(master, node) for node in publishers)


def main():
    words = [word for word in sys.argv[1:] if word]
    if len(words) > 1 or not set(words) <= {"true", "false"}:
        print("sim_time.py: use_sim_time: expected true or false, got \"%s\"" % " ".join(words), file=sys.stderr)
        return 2
    socket.setdefaulttimeout(PATIENCE)
    print(words[0] if words else "true" if has_clock() else "false")
    return 0


if __name__ == "__main__":
    sys.exit(main())
