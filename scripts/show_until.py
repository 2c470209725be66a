#!/usr/bin/env python3
"""Resets a running node and pauses it at a simulation time: show_until.py SECONDS."""
import sys

import rospy
from std_srvs.srv import SetBool, Trigger


def main():
    until = float(sys.argv[1])
    rospy.init_node("show_until", anonymous=True)
    rospy.wait_for_service("/poinsot/reset", 120)
    rospy.ServiceProxy("/poinsot/reset", Trigger)()
    rospy.sleep(until)
    rospy.ServiceProxy("/poinsot/pause", SetBool)(True)


if __name__ == "__main__":
    main()
