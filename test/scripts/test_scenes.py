#!/usr/bin/python3
"""Every scene of scenes/ is valid, runs, has its comment, its view, its place in doc/gallery.md, and does what that says.

What a scene promises is measured on the CSV that simulate writes, with moments computed here. Every check is then shown
scenes that break it.

Usage: test_scenes.py [DIRECTORY OF PROGRAMS]    The last line reads "N passed, M failed".
"""
import csv
import glob
import os
import re
import subprocess
import sys
import tempfile

import numpy as np
import yaml

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "test"))
from checks import check, finish  # noqa: E402
PROGRAMS = sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "build", "devel", "lib", "poinsot")
SCENES = os.path.join(ROOT, "scenes")
EXPECTED = """dzhanibekov regimes separatrix t_handle wingnut tennis_racket symmetric_prolate symmetric_oblate sphere toutatis
nasa_brick tossed_book heavy_top_sleeping heavy_top_loops heavy_top_cusps heavy_top_waves explorer1 gravity_gradient
damped_tumble thruster_despin hundred phone""".split()



def run(*words):
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.returncode, done.stdout


# --- what every scene has -------------------------------------------------------------------------------------------


def comment_complaints(text):
    """At the head, at least three lines, and where the numbers are from."""
    head = []
    for line in text.splitlines():
        if not line.startswith("#"):
            break
        head.append(line)
    out = []
    if len(head) < 3:
        out.append("%d lines of comment at the head" % len(head))
    if not any(line.startswith("# Numbers:") for line in head):
        out.append("no paragraph that begins with # Numbers:")
    return out


def document_complaints(name, document, folder):
    """In doc/gallery.md: a heading, the picture (there, a PNG), the command."""
    out = []
    section = re.search(r"^## %s\n(.*?)(?=^## |\Z)" % re.escape(name), document, re.M | re.S)
    if not section:
        return ["no heading ## " + name]
    text = section.group(1)
    if "](scenes/%s.png)" % name not in text:
        out.append("does not show scenes/%s.png" % name)
    if "scene:=%s\n" % name not in text:
        out.append("does not give its command")
    if "Source" not in text:
        out.append("gives no source")
    picture = os.path.join(folder, "scenes", name + ".png")
    if not os.path.isfile(picture) or open(picture, "rb").read(8) != b"\x89PNG\r\n\x1a\n":
        out.append("doc/scenes/%s.png is no picture" % name)
    return out


def run_complaints(path):
    """--check, and a minute of simulate, without a warning."""
    out = []
    code, said = run(os.path.join(PROGRAMS, "poinsot_node"), "--check", path)
    if code != 0 or "warn" in said.lower():
        out.append("--check: exit %d, %s" % (code, said.strip()[:300]))
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "states.csv")
        code, said = run(os.path.join(PROGRAMS, "simulate"), path, "--csv", file, "--duration", "60")
        if code != 0 or "warn" in said.lower() or "the best that doubles allow" in said:
            return out + ["simulate: exit %d, %s" % (code, said.strip()[:300])]
        states = read(file)
    with open(path) as text:
        names = [body["name"] for body in yaml.safe_load(text)["bodies"]]
    if list(states) != names:
        out.append("simulate: bodies " + ", ".join(states))
    for name, rows in states.items():
        if rows[-1, 0] != 60 or not np.isfinite(rows).all():
            out.append("simulate: %s ends at %g s" % (name, rows[-1, 0]))
    return out


def view_complaints(name, launch=os.path.join(ROOT, "launch", "demo.launch")):
    """The view that demo.launch opens is there."""
    code, said = run("roslaunch", "--args", "/rviz", launch, "scene:=" + name)
    views = re.findall(r"\S+\.rviz", said)
    if code != 0 or len(views) != 1:
        return ["roslaunch --args: exit %d, %s" % (code, said.strip()[-300:])]
    return [] if os.path.isfile(views[0]) else ["%s is not there" % views[0]]


# --- what doc/poinsot_construction.md says ------------------------------------------------------------------------------


def propagated(moments, omega, times):
    head = "id,mu1,mu2,mu3,q0w,q0x,q0y,q0z,O01,O02,O03,t\n"
    rows = "".join("a,%r,%r,%r,1,0,0,0,%r,%r,%r,%r\n" % tuple(float(x) for x in (*moments, *omega, t)) for t in times)
    done = subprocess.run([os.path.join(PROGRAMS, "propagate")], input=head + rows, stdout=subprocess.PIPE, text=True)
    table = np.array([[float(x) for x in row.split(",")[1:]] for row in done.stdout.splitlines()[1:]])
    return table[:, 1:5], table[:, 5:8]


def construction(moments, omega, small=0, large=2):
    """T_flip and the angle about L in 2 T_flip, by the formulas of the document."""
    mu, energy = np.array(moments, float), .5 * np.dot(moments, np.square(omega))
    l2 = float(np.sum(np.square(mu * omega)))
    n2 = (mu[large] - mu[1]) * (l2 - 2 * energy * mu[small]) / mu.prod()
    k2 = (mu[1] - mu[small]) * (2 * energy * mu[large] - l2) / ((mu[large] - mu[1]) * (l2 - 2 * energy * mu[small]))
    a, b = 1.0, (1 - k2) ** .5
    while abs(a - b) > 1e-15:
        a, b = .5 * (a + b), (a * b) ** .5
    flip = np.pi / a / n2 ** .5
    _, rates = propagated(moments, omega, np.linspace(0, 2 * flip, 4001))
    ways = mu * rates / np.linalg.norm(mu * rates, axis=1)[:, None]
    pole = np.eye(3)[large] * np.sign(omega[large])
    solid = sum(2 * np.arctan2(np.dot(pole, np.cross(p, q)), 1 + p @ q + p @ pole + q @ pole)
                for p, q in zip(ways, ways[1:]))
    return flip, 4 * energy * flip / l2 ** .5 - solid


def construction_complaints(moments, omega, sides, late=0):
    """Those formulas against the closed form. `late` shifts the time, for a check of this check [s]."""
    flip, angle = construction(moments, omega, *sides)
    flip += late
    times = np.linspace(0, 4 * flip, 8001)
    zeros = np.diff(crossings(times, propagated(moments, omega, times)[1][:, 1]))
    out = ["flips after %s s, not %g" % (zeros, flip)] if not len(zeros) or max(abs(zeros - flip)) > 1e-5 else []
    q = propagated(moments, omega, [2 * flip])[0][0]
    way = np.array(moments) * omega / np.linalg.norm(np.array(moments) * omega)
    turned = 2 * np.arctan2(np.dot(q[1:], way), q[0])
    if abs((turned - angle + np.pi) % (2 * np.pi) - np.pi) > 1e-5:
        out.append("turns by %g, not by %g" % (turned % (2 * np.pi), angle % (2 * np.pi)))
    return out


# --- what is made by scripts --------------------------------------------------------------------------------------------


def regenerated_complaints(script, folder, ending):
    """Run again, the script writes the files that are in the folder, byte for byte, and no others."""
    out = []
    with tempfile.TemporaryDirectory() as fresh:
        code, said = run(os.path.join(ROOT, "scripts", script), fresh)
        if code != 0:
            return ["%s: exit %d, %s" % (script, code, said.strip()[-300:])]
        names = sorted(os.path.basename(p) for p in glob.glob(os.path.join(folder, "*" + ending)))
        if not names or names != sorted(os.listdir(fresh)):
            out.append("%s writes %s; there are %s" % (script, sorted(os.listdir(fresh)), names))
        for name in names:
            with open(os.path.join(folder, name), "rb") as one:
                committed = one.read()
            path = os.path.join(fresh, name)
            if os.path.isfile(path) and open(path, "rb").read() != committed:
                out.append("%s writes another %s than the one in %s" % (script, name, folder))
    return out


def mesh_complaints(folder):
    """Small enough, and as large as they say: nothing reaches further than 1.2 m."""
    out = []
    for path in sorted(glob.glob(os.path.join(folder, "*.dae"))):
        with open(path) as text:
            numbers = re.search(r'id="p-a" count="\d+">([^<]*)<', text.read()).group(1).split()
        reach = np.linalg.norm(np.array(numbers, float).reshape(-1, 3), axis=1).max()
        if not .4 < reach < 1.2:
            out.append("%s reaches %g m" % (path, reach))
        if os.path.getsize(path) > 150000:
            out.append("%s has %d bytes" % (path, os.path.getsize(path)))
    return out


# --- what scenes promise ----------------------------------------------------------------------------------------------


def read(file):
    rows = {}
    with open(file) as text:
        for row in csv.DictReader(text):
            rows.setdefault(row.pop("body"), []).append([float(x) for x in row.values()])
    return {name: np.array(of) for name, of in rows.items()}


def simulated(path, duration, rate=60):
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "states.csv")
        code, said = run(os.path.join(PROGRAMS, "simulate"), path, "--csv", file, "--duration", str(duration), "--rate",
                         str(rate))
        if code != 0:
            raise RuntimeError(said)
        return {name: Motion(rows) for name, rows in read(file).items()}


def rotation(q):
    w, x, y, z = np.asarray(q, float) / np.linalg.norm(q)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


class Motion(object):
    """The rows of one body, told apart."""

    def __init__(self, rows):
        self.t, self.omega, self.place = rows[:, 0], rows[:, 5:8], rows[:, 8:11]
        self.attitude = np.array([rotation(q) for q in rows[:, 1:5]])

    def axis(self, i):
        return self.attitude[:, :, i]

    def at(self, time, values):
        values = np.asarray(values)
        return values[np.argmin(abs(self.t - time))]

    def momentum(self, tensor):
        return np.einsum("nij,jk,nk->ni", self.attitude, tensor, self.omega)


def tensor(path, body=0):
    """Of a body of boxes, ellipsoids and cylinders, about its centre of mass, or the pivot that gravity_torque names."""
    with open(path) as text:
        entry = yaml.safe_load(text)["bodies"][body]
    if "inertia" in entry:
        return np.diag(np.array(entry["inertia"], float))
    shape = entry["shape"]
    parts = shape["parts"] if shape["type"] == "assembly" else [shape]
    masses = np.array([float(p["mass"]) for p in parts])
    places = np.array([p.get("position", [0, 0, 0]) for p in parts], float)
    places = places - masses @ places / masses.sum()
    for effect in entry.get("effects", []):
        if effect["type"] == "gravity_torque":
            places = places + np.array(effect["centre_of_mass"], float)
    whole = np.zeros((3, 3))
    for part, mass, place in zip(parts, masses, places):
        if part["type"] == "cylinder":
            second = np.array([part["radius"] ** 2 / 4.0] * 2 + [part["height"] ** 2 / 12.0])
        else:
            second = np.array(part["size"], float) ** 2 / {"box": 12, "ellipsoid": 20}[part["type"]]
        turn = rotation(part.get("orientation", [1, 0, 0, 0]))
        about = turn @ np.diag(second) @ turn.T + np.outer(place, place)
        whole += mass * (np.trace(about) * np.eye(3) - about)
    return whole


def crossings(t, x):
    """When x changes its sign."""
    k = np.flatnonzero(np.sign(x[:-1]) * np.sign(x[1:]) < 0)
    return t[k] - x[k] * (t[k + 1] - t[k]) / (x[k + 1] - x[k])


def minima(t, x):
    k = 1 + np.flatnonzero((x[1:-1] < x[:-2]) & (x[1:-1] <= x[2:]))
    return t[k]


def degrees_between(a, b):
    cosine = np.einsum("ni,ni->n", a, np.broadcast_to(b, a.shape))
    return np.degrees(np.arccos(np.clip(cosine / np.linalg.norm(a, axis=1) / np.linalg.norm(b, axis=-1), -1, 1)))


def azimuth(v, about):
    """How far v has gone round that axis since the start [rad]."""
    up = about / np.linalg.norm(about)
    x = v[0] - (v[0] @ up) * up
    y = np.cross(up, x)
    angle = np.unwrap(np.arctan2(v @ y, v @ x))
    return angle - angle[0]


def when(t, values, target):
    """When values that grow in size have first reached the target."""
    return np.interp(target, np.maximum.accumulate(abs(values)), t)


def flips(scene, body, axis, duration=60):
    def measure(path):
        m = simulated(path, duration)[body]
        return list(np.diff(crossings(m.t, m.omega[:, axis]))[:2])
    return measure


def separatrix(path):
    all_bodies = simulated(path, 60)
    m = all_bodies["separatrix"]
    once = crossings(m.t, m.omega[:, 1])
    later = simulated(path, 1e6, 1e-3)["separatrix"]
    others = [np.diff(crossings(all_bodies[b].t, all_bodies[b].omega[:, 1]))[0] for b in ("smallest", "largest")]
    return [len(once), once[0], later.omega[-1, 1]] + others + [
        len(crossings(all_bodies["largest"].t, all_bodies["largest"].omega[:, 2])),
        len(crossings(all_bodies["smallest"].t, all_bodies["smallest"].omega[:, 0]))]


def phone(path):
    """The time of a turn at the start, those between flips, and the moments."""
    m = simulated(path, 60, 200)["phone"]
    between = np.diff(crossings(m.t, m.omega[:, 1]))[:2]
    return [2 * np.pi / abs(m.omega[0, 1])] + list(between) + sorted(np.linalg.eigvalsh(tensor(path)))


def racket(path):
    m = simulated(path, 10, 600)["racket"]
    about = m.momentum(tensor(path))[0]
    end = when(m.t, azimuth(m.axis(0), about), 2 * np.pi)
    face = m.axis(2)
    return [end, degrees_between(face, face[0])[np.argmin(abs(m.t - end))]] + list(np.diag(tensor(path)))


def toutatis(path):
    m = simulated(path, 60, 600)["toutatis"]
    moments = tensor(path)
    inside = m.omega @ moments
    turn = when(m.t, azimuth(inside, np.array([0, 0, 1.0])), 2 * np.pi)
    gone = np.interp(turn, m.t, azimuth(m.axis(2), m.momentum(moments)[0]))
    return [turn / 2, abs(2 * np.pi / gone * turn / 2)]


def brick(path):
    m = simulated(path, 30)["brick"]
    return list(np.degrees(m.omega[-1])) + list(np.diag(tensor(path)) / 1.3558179483314004)


def book(path):
    m = simulated(path, 20, 600)["book"]
    back = m.t[1:][np.flatnonzero(m.place[1:, 2] < 0)[0]]
    return [back, m.place[:, 2].max(), m.at(0, m.axis(2))[0], m.at(back, m.axis(2))[0], m.at(back, m.axis(0))[2]]


def sphere(path):
    return [np.ptp(m.omega, axis=0).max() for m in simulated(path, 30).values()]


def symmetric(body):
    def measure(path):
        m = simulated(path, 60, 240)[body]
        inertia = tensor(path)
        up = m.momentum(inertia)[0]
        tilt = degrees_between(m.axis(2), up)
        rate = azimuth(m.axis(2), up)[-1] / m.t[-1]
        own = azimuth(m.omega, np.array([0, 0, 1.0]))[-1] / m.t[-1]
        return [2 * np.pi / rate, tilt.min(), tilt.max(), 2 * np.pi / own, rate / m.omega[0, 2]]
    return measure


def top(path):
    m = simulated(path, 60, 600)["top"]
    axis = m.axis(2)
    tilt = degrees_between(axis, np.array([0, 0, 1.0]))
    rate = np.gradient(azimuth(axis, np.array([0, 0, 1.0])), m.t)
    return [tilt.min(), tilt.max(), np.diff(minima(m.t, tilt)).mean(), rate[5:].min()]


def sleeping(path):
    m = simulated(path, 60, 240)["top"]
    tilt = degrees_between(m.axis(2), np.array([0, 0, 1.0]))
    speed = np.interp(15, m.t, m.omega[:, 2])
    return [tilt[m.t < 15].max(), tilt[m.t < 18].max(), tilt[m.t < 21].max(), tilt[m.t < 24].max(), speed]


def explorer(path):
    m = simulated(path, 120)["explorer"]
    inertia = tensor(path)
    slug = 0.03
    total = m.attitude[0] @ ((inertia + slug * np.eye(3)) @ m.omega[0])
    angle = degrees_between(m.axis(2), total)
    energy = 0.5 * np.einsum("ni,ij,nj->n", m.omega, inertia, m.omega)
    return [angle[0], when(m.t, angle, 45), when(m.t, angle, 89), energy[-1] / energy[0],
            np.linalg.norm(m.omega[-1]) * (inertia[0, 0] + slug) / np.linalg.norm(total)]


def gradient(path):
    m = simulated(path, 80, 240)["tiangong"]
    n = 2 * np.pi / 20
    up = np.stack([0 * m.t, -np.sin(n * m.t), np.cos(n * m.t)], 1)
    swing = np.degrees(np.arcsin(np.cross(up, m.axis(0))[:, 0]))
    return [2 * np.diff(crossings(m.t, swing)).mean(), swing.max(), swing.min(), abs(m.axis(0)[:, 0]).max()]


def damped(path):
    bodies = simulated(path, 60)
    cube, slow = bodies["cube"], bodies["brick"]
    off = degrees_between(slow.omega @ tensor(path, 1), np.array([0, 0, 1.0]))
    off = np.minimum(off, 180 - off)
    law = cube.omega[0] * np.exp(-0.006 * cube.t / tensor(path)[0, 0])[:, None]
    return [abs(cube.omega - law).max(), np.linalg.norm(cube.at(30, cube.omega)) / np.linalg.norm(cube.omega[0]),
            slow.at(0, off), slow.at(20, off), slow.at(60, off)]


def despin(path):
    out = []
    for i, m in enumerate(simulated(path, 40).values()):
        size = np.linalg.norm(m.momentum(tensor(path, i)), axis=1)
        out += [m.at(8, size) / size[0], m.at(12, size) / size[0], m.at(20, size) / size[0],
                np.linalg.norm(m.omega[m.t >= 24], axis=1).max()]
    return out


def regimes(path):
    """How far Ω leaves the axis that it began near, at most [degrees]."""
    out = []
    for i, m in enumerate(simulated(path, 60).values()):
        out.append(degrees_between(m.omega, np.eye(3)[i]).max())
    return out


def hundred(path):
    """How many have Ω₁ change its sign; and how many have not, of those that the separatrix has go round z, or x."""
    turning, wrong = 0, 0
    with open(path) as text:
        entries = yaml.safe_load(text)["bodies"]
    for entry, m in zip(entries, simulated(path, 30).values()):
        x, y, z = np.array(entry["shape"]["size"], float) ** 2
        moments = y + z, x + z, x + y
        about_x = moments[0] * (moments[1] - moments[0]) * m.omega[0, 0] ** 2
        about_z = moments[2] * (moments[2] - moments[1]) * m.omega[0, 2] ** 2
        turns = m.omega[:, 0].min() < 0
        turning += turns
        wrong += turns != (about_z > about_x)
    return [len(entries), turning, wrong]


NOTHING = 1e-12

# Scene: what measures it, and for each figure what it is promised to be, and how far it may be off: half a unit of the
# last digit that the scene's comment gives, or what the sampling leaves.
PROMISES = {
    "dzhanibekov": (flips("dzhanibekov", "wingnut", 2), [(5.1, .05)] * 2),
    "regimes": (regimes, [(0, 10), (180, 20), (0, 10)]),
    "separatrix": (separatrix, [(1, 0), (6.0, .05), (-3, 1e-3), (15.7, .05), (15.7, .05), (0, 0), (0, 0)]),
    "t_handle": (flips("t_handle", "t_handle", 2), [(9.4, .05)] * 2),
    "phone": (phone, [(2.1, .05)] + [(3.76, .01)] * 2 + [(7.06e-5, 5e-8), (2.949e-4, 5e-8), (3.640e-4, 5e-8)]),
    "wingnut": (flips("wingnut", "wingnut", 2), [(8.4, .05)] * 2),
    "tennis_racket": (racket, [(4.3, .05), (170.92, .1), (.00121, 1e-9), (.01638, 1e-9), (.01748, 1e-9)]),
    "toutatis": (toutatis, [(5.3685, 5e-4), (7.4117, 5e-4)]),
    "nasa_brick": (brick, [(12.61839, 5e-6), (-17.39747, 6e-6), (31.11959, 5e-6), (.001894220, 1e-9),
                           (.006211019, 1e-9), (.007194665, 1e-9)]),
    "tossed_book": (book, [(15.1, .05), (2.8, .05), (1, .01), (-1, .01), (1, .01)]),
    "sphere": (sphere, [(0, NOTHING)] * 2),
    "symmetric_prolate": (symmetric("football"), [(3.16, .005), (25, 1e-6), (25, 1e-6), (-5.24, .005), (.662, 5e-4)]),
    "symmetric_oblate": (symmetric("plate"), [(1.54, .005), (12, 1e-6), (12, 1e-6), (3.15, .005), (2.04, .005)]),
    "heavy_top_cusps": (top, [(35, .005), (49.3, .05), (2.00, .005), (0, .005)]),
    "heavy_top_loops": (top, [(35, .005), (60.5, .05), (1.88, .005), (-.6, .005)]),
    "heavy_top_waves": (top, [(35, .005), (43.2, .05), (2.05, .005), (.3, .005)]),
    "heavy_top_sleeping": (sleeping, [(4, .1), (5.4, .5), (30, .5), (62, 1), (15.24, .01)]),
    "explorer1": (explorer, [(2.5, .05), (20, .5), (41, .5), (.41, .005), (1, 1e-3)]),
    "gravity_gradient": (gradient, [(13.9, .05), (15, .01), (-15, .01), (0, NOTHING)]),
    "damped_tumble": (damped, [(0, NOTHING), (.30, .005), (34, .5), (68, .5), (12, .5)]),
    "thruster_despin": (despin, [(2 / 3, NOTHING), (2 / 3, NOTHING), (1 / 3, NOTHING), (0, NOTHING)] * 2),
    "hundred": (hundred, [(100, 0), (57, 0), (0, 0)]),
}


def promise_complaints(path, promise):
    measure, figures = promise
    found = measure(path)
    if len(found) != len(figures):
        return ["%d figures of %d: %s" % (len(found), len(figures), found)]
    return ["figure %d is %.9g, promised %g, off by at most %g" % (i, x, want, off)
            for i, (x, (want, off)) in enumerate(zip(found, figures)) if not abs(x - want) <= off]


def seam_complaints(path):
    """A film's scene is at its start again after the time that its comment tells."""
    with open(path) as text:
        period = re.search(r"T = ([0-9.]+) s", text.read()).group(1)
    code, said = run(os.path.join(PROGRAMS, "simulate"), path, "--duration", period, "--rate", "0.001", "--csv", "-")
    rows = [row.split(",")[2:9] for row in said.splitlines()[1:]]
    if code != 0 or len(rows) != 2:
        return [said.strip()[:300]]
    first, last = (np.array(row, float) for row in rows)
    apart = 2 * np.arccos(min(1, abs(first[:4] @ last[:4]))), np.linalg.norm(first[4:] - last[4:])
    return ["%g %s from the start" % pair for pair in zip(apart, ("rad", "rad/s")) if pair[0] > 1e-6]


def changed(path, folder, old, new):
    """A copy of a scene with something else in it."""
    with open(path) as text:
        before = text.read()
    after = re.sub(old, new, before, count=1)
    if after == before:
        raise RuntimeError("%s has no %s" % (path, old))
    out = os.path.join(folder, os.path.basename(path))
    with open(out, "w") as text:
        text.write(after)
    return out


# For each promise, a change to its scene that must be noticed.
BREAKS = {
    "damped_tumble": (r"coefficient: 0\.006", "coefficient: 0.0061"),
    "explorer1": (r"damping: 0\.08", "damping: 0.03"),
    "gravity_gradient": (r"orbit_rate: 0\.31", "orbit_rate: 0.32"),
    "heavy_top_sleeping": (r"coefficient: \[0, 0, ", "coefficient: [0, 0, 1"),
    "hundred": (r"angular_velocity: \[2\.9886, 0, 0\.2615\]", "angular_velocity: [0.2615, 0, -2.9886]"),
    "nasa_brick": (r"angular_velocity: \[0\.1745", "angular_velocity: [0.1746"),
    "phone": (r"size: \[1\.1736", "size: [1.18"),
    "regimes": (r"angular_velocity: \[0\.3, 3, 0\.3\]", "angular_velocity: [0.3, 0.3, 3]"),
    "sphere": (r"size: \[1, 1, 1\]", "size: [1, 1.1, 1]"),
    "tennis_racket": (r"mass: 0\.001, position: \[0\.1", "mass: 0.001, position: [0.2"),
    "thruster_despin": (r"from: 20, to: 24", "from: 20, to: 23"),
    "tossed_book": (r"velocity: \[0, 0, 0\.741\]", "velocity: [0, 0, 0.8]"),
    "toutatis": (r"size: \[0\.88", "size: [0.89"),
}
FASTER = (r"(angular_velocity: \[[^\]]*, )(-?[0-9.]+)\]", r"\g<1>\g<2>9]")  # one more digit at least


def main():
    paths = sorted(glob.glob(os.path.join(SCENES, "*.yaml")))
    names = [os.path.splitext(os.path.basename(path))[0] for path in paths]
    missing = sorted(set(EXPECTED) - set(names))
    check("the library is complete", ["no scene " + name for name in missing])
    check("what every scene does is promised", ["no promise of " + name for name in sorted(set(names) ^ set(PROMISES))])
    with open(os.path.join(ROOT, "doc", "gallery.md")) as text:
        document = text.read()
    for path, name in zip(paths, names):
        with open(path) as text:
            complaints = comment_complaints(text.read())
        complaints += document_complaints(name, document, os.path.join(ROOT, "doc")) + run_complaints(path)
        check("%s has a comment, a place in doc/gallery.md, and runs" % name, complaints + view_complaints(name))
        if name in PROMISES:
            check("%s does what it promises" % name, promise_complaints(path, PROMISES[name]))

    flip = os.path.join(ROOT, "doc", "films", "flip.yaml")
    check("the film of the flip has no seam", seam_complaints(flip))
    meshes = os.path.join(ROOT, "meshes")
    check("flips and Montgomery's angle as in doc/poinsot_construction.md",
          construction_complaints([1, 2, 3], [.4, 1, .8], (0, 2)) +
          construction_complaints([1, 2, 3], [1.4, 1, .2], (2, 0)) +
          construction_complaints([1, 1.86, 2.49], [0, 3, .2], (0, 2)))
    check("make_meshes.py writes the meshes that are there", regenerated_complaints("make_meshes.py", meshes, ".dae"))
    check("meshes are small, and of the scenes' size", mesh_complaints(meshes))

    def noticed(complaints):
        return [] if complaints else ["went by unnoticed"]

    check("a scene without a comment is noticed", noticed(comment_complaints("rate: 60\nbodies: []\n")))
    check("one that does not say where its numbers are from", noticed(comment_complaints("# a\n# b\n# c\nrate: 60\n")))
    check("one that the document does not know", noticed(document_complaints("nosuch", document, ROOT)))
    check("one whose picture is missing", noticed(document_complaints("sphere", document, ROOT)))
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "warns.yaml")
        with open(path, "w") as text:
            text.write("bodies:\n  - &a {name: a, inertia: [1, 2, 9], angular_velocity: [0, 0, 1]}\n")
        check("one that warns", noticed(run_complaints(path)))
        with open(os.path.join(ROOT, "launch", "demo.launch")) as text:
            launch = text.read()
        path = os.path.join(folder, "demo.launch")
        with open(path, "w") as text:
            text.write(launch.replace('name="view" default="demo"', 'name="view" default="nosuch"'))
        check("one whose view is missing", noticed(view_complaints("sphere", path)))
        for name in ("book.dae", "racket.dae"):
            with open(os.path.join(meshes, name)) as text, open(os.path.join(folder, name), "w") as other:
                other.write(text.read().replace("0.48", "1.48"))
        check("meshes that are missing or other ones", noticed(regenerated_complaints("make_meshes.py", folder, ".dae")))
        check("a time between flips that is not so", noticed(construction_complaints([1, 2, 3], [.4, 1, .8], (0, 2), 1e-3)))
        check("a mesh of another size", noticed(mesh_complaints(folder)))
        check("a film with a seam", noticed(seam_complaints(changed(flip, folder, r"0\.29771", "0.2978"))))
        for name in sorted(PROMISES):
            broken = changed(os.path.join(SCENES, name + ".yaml"), folder, *BREAKS.get(name, FASTER))
            try:
                complaints = promise_complaints(broken, PROMISES[name])
            except (RuntimeError, IndexError) as error:
                complaints = [str(error)]
            check("%s, changed, breaks its promise" % name, noticed(complaints))
    return finish()


if __name__ == "__main__":
    sys.exit(main())
