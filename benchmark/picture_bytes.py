#!/usr/bin/python3
"""Measures what the pictures of a running node cost on the wire: bytes and messages a second on `markers`, and the size of
`markers_static`, as serialised by ROS.

Usage: picture_bytes.py [--seconds S] [--namespace NS]

  --seconds S     how long to listen to `markers` (default 10)
  --namespace NS  the namespace that the node's topics are in (default /)

For example, with roslaunch poinsot demo.launch running:  benchmark/picture_bytes.py

It subscribes to `markers` and `markers_static` only. The first message of `markers` to a new subscriber deletes what a viewer
may still show, and does not count. Exit status: 0; 1 when no node sends markers within 20 s; 2 for bad use.
"""
import argparse
import sys
import threading
import time

import rospy


class Sizes:
    """Sizes [bytes] of a topic's messages, undecoded, and when each came [s]."""

    def __init__(self, topic):
        self.sizes, self.times, self.news = [], [], threading.Event()
        self.subscriber = rospy.Subscriber(topic, rospy.AnyMsg, self.take, queue_size=1000, tcp_nodelay=True)

    def take(self, message):
        self.sizes.append(len(message._buff))
        self.times.append(time.monotonic())
        self.news.set()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=10)
    parser.add_argument("--namespace", default="/")
    options = parser.parse_args(rospy.myargv()[1:])
    if not 0.1 <= options.seconds <= 3600:
        parser.error("--seconds: expected 0.1 to 3600")
    base = options.namespace.rstrip("/") + "/"

    rospy.init_node("picture_bytes", anonymous=True, disable_signals=True)
    still = Sizes(base + "markers_static")
    if not still.news.wait(20):
        print("picture_bytes.py: nothing on %smarkers_static within 20 s: does a node run?" % base, file=sys.stderr)
        return 1
    print("markers_static  %8.1f kB" % (still.sizes[0] / 1e3))
    moving = Sizes(base + "markers")
    if not moving.news.wait(20):
        print("picture_bytes.py: nothing on %smarkers within 20 s: is the motion at rest?" % base, file=sys.stderr)
        return 1
    time.sleep(options.seconds)
    moving.subscriber.unregister()
    sizes, times = moving.sizes[1:], moving.times
    if not sizes:
        print("picture_bytes.py: one message only on %smarkers" % base, file=sys.stderr)
        return 1
    seconds = times[-1] - times[0]
    print("markers         %8.1f kB/s, %.1f messages/s, %.1f kB the largest" %
          (sum(sizes) / seconds / 1e3, len(sizes) / seconds, max(sizes) / 1e3))
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
