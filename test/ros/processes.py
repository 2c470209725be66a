"""What the Python rostests share: programs that a test starts, watches and stops itself."""
import os
import signal
import subprocess
import tempfile
import time

import roslib.packages
import rosparam
import rospkg
import rospy


def package_path(*parts):
    return os.path.join(rospkg.RosPack().get_path("poinsot"), *parts)


def program(name):
    """The path of one of the package's programs."""
    found = [path for path in roslib.packages.find_node("poinsot", name) if os.access(path, os.X_OK)]
    if not found:
        raise AssertionError("no program " + name)
    return found[0]


class Process(object):
    """A program under way; what it writes goes to files, so that it never waits for a reader."""

    def __init__(self, command, environment=None):
        self._out = tempfile.TemporaryFile("w+")
        self._err = tempfile.TemporaryFile("w+")
        self._process = subprocess.Popen(command, stdout=self._out, stderr=self._err, stdin=subprocess.DEVNULL,
                                         env=environment)
        self.pid = self._process.pid

    @staticmethod
    def _text(stream):
        stream.seek(0)
        return stream.read()

    @property
    def out(self):
        return self._text(self._out)

    @property
    def err(self):
        return self._text(self._err)

    @property
    def console(self):
        return self.out + self.err

    def running(self):
        return self._process.poll() is None

    def wait(self, seconds):
        """The exit code."""
        try:
            return self._process.wait(seconds)
        except subprocess.TimeoutExpired:
            raise AssertionError("still running after %g s; it wrote:\n%s" % (seconds, self.console))

    def send(self, number, seconds):
        """Sends a signal and gives the exit code."""
        self._process.send_signal(number)
        return self.wait(seconds)

    def interrupt(self, seconds):
        return self.send(signal.SIGINT, seconds)

    def cpu_seconds(self):
        """CPU time that the process has taken so far."""
        with open("/proc/%d/stat" % self.pid) as stat:
            fields = stat.read().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def close(self):
        """For the end of a test, whatever came before."""
        if self.running():
            self._process.send_signal(signal.SIGINT)
            try:
                self._process.wait(10)
            except subprocess.TimeoutExpired:
                self._process.kill()
                self._process.wait()
        self._out.close()
        self._err.close()


def run(command, seconds=60.0):
    """Runs to the end: exit code, stdout, stderr."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL,
                          timeout=seconds, universal_newlines=True)
    return done.returncode, done.stdout, done.stderr


def start_node(namespace, parameters=None, scene_tree_file=None):
    """A poinsot_node of the name <namespace>/poinsot with these private parameters, and no others."""
    private = namespace + "/poinsot"
    if rospy.has_param(private):
        rospy.delete_param(private)
    for name, value in (parameters or {}).items():
        rospy.set_param(private + "/" + name, value)
    if scene_tree_file:  # as `rosparam load FILE ~scene` does
        for tree, place in rosparam.load_file(scene_tree_file, default_namespace=private + "/scene"):
            rosparam.upload_params(place, tree)
    return Process([program("poinsot_node"), "__ns:=" + namespace, "__name:=poinsot"])


def eventually(condition, seconds=15.0):
    """Waits, in wall time, for a condition; whether it came true."""
    deadline = time.time() + seconds
    while time.time() < deadline:
        if condition():
            return True
        time.sleep(0.01)
    return bool(condition())
