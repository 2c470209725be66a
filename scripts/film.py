#!/usr/bin/python3
"""Advances a running, paused node frame by frame, and writes the screen of each frame to stdout, as raw video.

Usage: film.py WIDTH HEIGHT FRAMES SKIPPED FROM STEPS    (of the screen DISPLAY; film.sh calls it)

From frame to frame there are STEPS calls of ~step, so films are even if RViz draws slowly. A frame is taken when the screen has
changed and then stayed the same, for longer than RViz takes to draw. The node starts SKIPPED frames before the film, so that
the trail exists when the film begins; FROM is the simulation time of that start [s].
"""
import os
import subprocess
import sys
import time

import numpy as np
import rospy
from std_msgs.msg import Float64
from std_srvs.srv import SetBool, Trigger

GRABS = 16  # a second
STILL = 0.25  # s without a change, at least: RViz may show new tf and new markers in different frames
LONGEST_STILL = 1.5  # s: of a body at rest, RViz draws nothing new
LISTEN = 3.0  # s, to find out how long RViz takes to draw
LEAST = 0.4  # of the usual change from frame to frame: less is a late change of the step before
PATIENCE = 1.5  # s, beyond the time of a frame: then it is taken that nothing changes
LONGEST = 5.0  # s: the screen may never stay the same


def difference(a, b):
    """Mean difference of some of the bytes; more than 0 if the pictures differ at all."""
    if a == b:
        return 0
    if len(a) != len(b):
        return 255
    x, y = (np.frombuffer(picture, np.uint8)[::5].astype(np.int16) for picture in (a, b))
    return max(1e-9, float(np.abs(x - y).mean()))


class Screen:
    def __init__(self, width, height, frame_takes, still):
        self.patience = PATIENCE + 3 * frame_takes + still
        self.size = width * height * 4
        self.changes = []
        self.still = still
        self.grabber = subprocess.Popen(
            ["ffmpeg", "-loglevel", "error", "-nostdin", "-f", "x11grab", "-draw_mouse", "0", "-framerate", str(GRABS),
             "-video_size", "%dx%d" % (width, height), "-i", os.environ["DISPLAY"], "-f", "rawvideo", "-pix_fmt", "bgr0",
             "pipe:1"], stdout=subprocess.PIPE)

    def grab(self):
        picture = self.grabber.stdout.read(self.size)
        if len(picture) != self.size:
            raise RuntimeError("the screen can no longer be read")
        return picture

    def time_to_draw(self):
        """How long RViz takes to draw while the node plays [s]."""
        self.grab()  # ffmpeg has started
        begin, last, drawn = time.monotonic(), self.grab(), 0
        while time.monotonic() - begin < LISTEN:
            picture = self.grab()
            drawn += picture != last
            last = picture
        return LISTEN / max(drawn, 1)

    def lags(self, picture):
        """Whether the screen goes on changing when it should show this picture."""
        begin = time.monotonic()
        while time.monotonic() - begin < 4 * self.still:
            last = self.grab()
        return bool(self.changes) and difference(last, picture) > LEAST * sorted(self.changes)[len(self.changes) // 2]

    def settled(self, before):
        """The next picture that differs from `before` as much as usual and does not change any more."""
        begin, last = time.monotonic(), None
        changed = begin
        usual = sorted(self.changes[-15:])[len(self.changes[-15:]) // 2] if self.changes else 0
        while True:
            picture, now = self.grab(), time.monotonic()
            if picture != last:
                changed, last = now, picture
            waited = now - begin
            if now - changed < self.still and waited < LONGEST + self.patience:
                continue
            change = difference(picture, before)
            if change > LEAST * usual or waited > self.patience:
                if before:
                    self.changes.append(change)
                return picture

    def close(self):
        self.grabber.kill()
        self.grabber.wait()


def service(name, kind):
    rospy.wait_for_service("/poinsot/" + name, 60)
    return rospy.ServiceProxy("/poinsot/" + name, kind, persistent=True)


def main():
    width, height, frames, skipped = (int(x) for x in sys.argv[1:5])
    rospy.init_node("film", anonymous=True, disable_signals=True)
    set_paused = service("pause", SetBool)
    set_paused(True)
    step, steps = service("step", Trigger), int(sys.argv[6])
    frame_takes = steps / float(rospy.get_param("/poinsot/rate"))  # s

    def go_on():
        for _ in range(steps):
            if not step().success:
                raise RuntimeError("the node refused a step")

    seek = rospy.Publisher("/poinsot/seek", Float64, queue_size=1)
    while not seek.get_num_connections():
        time.sleep(.05)
    set_paused(False)
    screen = Screen(width, height, frame_takes, STILL)
    try:
        still = min(max(STILL, 2.5 * screen.time_to_draw()), LONGEST_STILL)
    finally:
        screen.close()
    set_paused(True)
    seek.publish(float(sys.argv[5]))
    time.sleep(1)
    for _ in range(skipped):
        go_on()
        time.sleep(frame_takes + .02)  # so that the trail has every point
    screen, begin = Screen(width, height, frame_takes, still), time.monotonic()
    try:
        picture = screen.settled(b"")
        for i in range(frames):
            sys.stdout.buffer.write(picture)
            if i + 1 < frames:
                go_on()
                picture = screen.settled(picture)
            if i % 30 == 29:
                print("%d of %d frames, %.0f s" % (i + 1, frames, time.monotonic() - begin), file=sys.stderr)
        sys.stdout.buffer.flush()
        if screen.lags(picture):
            raise RuntimeError("RViz shows what belongs to an earlier frame: the machine is too busy for a film")
    finally:
        screen.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
