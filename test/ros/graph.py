"""What the Python rostests share: listening to a body as any subscriber would, and talking to the node."""
import math
import threading
import time

import rospy
import rostopic
from std_msgs.msg import Float64
from std_srvs.srv import SetBool, Trigger
from visualization_msgs.msg import Marker


# How long a condition may take [s, wall time]: far longer than it does, also on a busy machine and under a sanitizer.
PATIENCE = 60.0


def wait_for(condition, seconds=PATIENCE, what="a condition"):
    """Waits, in wall time, until condition() is true and returns its value."""
    deadline = time.time() + seconds
    while time.time() < deadline:
        value = condition()
        if value:
            return value
        time.sleep(0.01)
    raise AssertionError("waited %g s in vain for %s" % (seconds, what))


class Listener(object):
    """All messages of one topic, in order."""

    def __init__(self, topic, message_class):
        self._lock = threading.Lock()
        self._messages = []
        self._subscriber = rospy.Subscriber(topic, message_class, self._take, queue_size=10000, tcp_nodelay=True)
        self._topic = topic

    def _take(self, message):
        with self._lock:
            self._messages.append(message)

    def all(self):
        with self._lock:
            return list(self._messages)

    def clear(self):
        with self._lock:
            self._messages = []

    def last(self):
        with self._lock:
            return self._messages[-1] if self._messages else None

    def next(self, seconds=PATIENCE):
        """The next message to arrive."""
        return self.next_where(lambda message: True, seconds)

    def count(self):
        with self._lock:
            return len(self._messages)

    def next_where(self, condition, seconds=PATIENCE, since=None):
        """
        The first message that meets the condition, from now on or from an earlier count() on: an answer may be here
        before one comes to wait for it.
        """
        seen = self.count() if since is None else since

        def found():
            return [m for m in self.all()[seen:] if condition(m)]
        return wait_for(found, seconds, "a message on " + self._topic)[0]

    def more(self, number, since=None, seconds=PATIENCE):
        """The next messages, this many, from now on or from an earlier count() on."""
        seen = self.count() if since is None else since
        wait_for(lambda: self.count() >= seen + number, seconds, "%d messages on %s" % (number, self._topic))
        return self.all()[seen:seen + number]

    def close(self):
        self._subscriber.unregister()


class Control(object):
    """The services and topics in of one node."""

    def __init__(self, node="/poinsot"):
        for name in ("pause", "step", "reset"):
            rospy.wait_for_service(node + "/" + name, PATIENCE)
        self._pause = rospy.ServiceProxy(node + "/pause", SetBool)
        self._step = rospy.ServiceProxy(node + "/step", Trigger)
        self._reset = rospy.ServiceProxy(node + "/reset", Trigger)
        self._speed = rospy.Publisher(node + "/speed", Float64, queue_size=10)
        self._seek = rospy.Publisher(node + "/seek", Float64, queue_size=10)
        wait_for(lambda: self._speed.get_num_connections() and self._seek.get_num_connections(),
                 what="the node to listen to speed and seek")

    def pause(self, paused=True):
        return self._pause(paused)

    def step(self):
        return self._step()

    def reset(self):
        return self._reset()

    def speed(self, value):
        self._speed.publish(Float64(value))

    def seek(self, value):
        self._seek.publish(Float64(value))


def message_class(topic):
    """The class of a topic's messages, once it is there."""
    return wait_for(lambda: rostopic.get_topic_class(topic)[0], what=topic)


def told(arrays):
    """The markers of these arrays of one topic in order, without deletions of what is not there."""
    there = set()
    for array in arrays:
        for marker in array.markers:
            key = marker.ns, marker.id
            if marker.action == Marker.ADD:
                there.add(key)
            elif marker.action != Marker.DELETE:
                raise AssertionError("action %d, which takes away what other nodes have drawn" % marker.action)
            elif key in there:
                there.remove(key)
            else:
                continue
            yield marker


def drawn(arrays):
    """The markers that a viewer such as RViz has after these arrays of one topic: by namespace and id."""
    out = {}
    for marker in told(arrays):
        if marker.action == Marker.ADD:
            out[marker.ns, marker.id] = marker
        else:
            del out[marker.ns, marker.id]
    return out


def quaternion_distance(a, b):
    """The angle between two attitudes [rad]."""
    d = [a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z,
         a.w * b.x - a.x * b.w - a.y * b.z + a.z * b.y,
         a.w * b.y + a.x * b.z - a.y * b.w - a.z * b.x,
         a.w * b.z - a.x * b.y + a.y * b.x - a.z * b.w]
    return 2 * math.atan2(math.sqrt(d[1] ** 2 + d[2] ** 2 + d[3] ** 2), abs(d[0]))


def same_attitude(a, b):
    """Bit for bit."""
    return (a.w, a.x, a.y, a.z) == (b.w, b.x, b.y, b.z)


def stamps_never_decrease(messages):
    stamps = [m.header.stamp.to_nsec() for m in messages]
    return all(a <= b for a, b in zip(stamps, stamps[1:]))
