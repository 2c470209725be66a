#!/usr/bin/python3
"""Advances a running, paused node frame by frame, and writes the screen of each frame to stdout, as raw video.

Usage: film.py WIDTH HEIGHT FRAMES SKIPPED FROM STEPS    (of the screen DISPLAY; film.sh calls it)

From frame to frame there are STEPS calls of ~step, so films are even if RViz draws slowly. A frame is taken when the
screen has changed and then stayed the same. It begins SKIPPED frames before the film, at FROM seconds, so that the trail
exists when the film begins.
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
STILL = 4  # equal grabs in a row: RViz may show new tf and new markers in different frames
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
    def __init__(self, width, height, frame_takes):
        self.patience = PATIENCE + 3 * frame_takes
        self.size = width * height * 4
        self.changes = []
        self.grabber = subprocess.Popen(
            ["ffmpeg", "-loglevel", "error", "-nostdin", "-f", "x11grab", "-draw_mouse", "0", "-framerate", str(GRABS),
             "-video_size", "%dx%d" % (width, height), "-i", os.environ["DISPLAY"], "-f", "rawvideo", "-pix_fmt", "bgr0",
             "pipe:1"], stdout=subprocess.PIPE)

    def grab(self):
        picture = self.grabber.stdout.read(self.size)
        if len(picture) != self.size:
            raise RuntimeError("the screen can no longer be read")
        return picture

    def settled(self, before):
        """The next picture that differs from `before` as much as usual and does not change any more."""
        begin, still, last = time.monotonic(), 0, None
        usual = sorted(self.changes[-15:])[len(self.changes[-15:]) // 2] if self.changes else 0
        while True:
            picture = self.grab()
            still = still + 1 if picture == last else 0
            last = picture
            waited = time.monotonic() - begin
            if not still >= STILL and waited < LONGEST + self.patience:
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
    service("pause", SetBool)(True)
    step, steps = service("step", Trigger), int(sys.argv[6])
    frame_takes = steps / float(rospy.get_param("/poinsot/rate"))  # s

    def go_on():
        for _ in range(steps):
            if not step().success:
                raise RuntimeError("the node refused a step")

    seek = rospy.Publisher("/poinsot/seek", Float64, queue_size=1)
    while not seek.get_num_connections():
        time.sleep(.05)
    seek.publish(float(sys.argv[5]))
    time.sleep(1)
    for _ in range(skipped):
        go_on()
        time.sleep(frame_takes + .02)  # so that the trail has every point
    screen, begin = Screen(width, height, frame_takes), time.monotonic()
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
    finally:
        screen.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
