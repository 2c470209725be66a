#!/usr/bin/python3
"""Makes torque_rows.csv: bodies under effects of a scene file, and the truth at t, of the kinds that torque.csv lacks.

Usage: make_torque_rows.py [OUT]      (default: torque_rows.csv beside this script)

Needs Debian's python3-mpmath, python3-gmpy2 and python3-yaml, five minutes of processor time, and gives the same file
in every run. Every row is computed in two ways, which share the algebra of vectors, no equation of motion and no clock:
  1  Taylor series, order 50, in body axes: Omega, quaternion, slug rate and each vector of the world as seen from the
     body, by recurrences (taylor)
  2  extrapolation of Gragg's midpoint rule, order 32, in world axes: rotation matrix and angular momenta; it starts
     from the text of the row, as a reader of the file does (extrapolate)
Then the state of way 1 must satisfy what is known without either:
  E  energy: that of the body and the slug, with the potentials of gravity and of the gravity gradient, and less n N.L
     on an orbit (Jacobi's integral), changes by the work of the other effects: none in some rows; else integrated by
     way 2
  L  total angular momentum: changes by the impulse of the world's torques, exactly; under gravity, its part along it
  X  a formula, where the motion has one: pitch libration, a spin about a principal axis, a damped sphere
A row on which two ways differ by more than 1e-28 (rad, or relative to |Omega|), or that fails E, L or X by as much,
stops the script with exit code 1, and no file is written. So does a row on which one of these would have let pass a
state that is wrong by 1e-25.
"""
import copy
import csv
import io
import multiprocessing
import os
import sys
from fractions import Fraction
from operator import mul

import gmpy2
from gmpy2 import mpfr
import mpmath
from mpmath import mp, mpf
import yaml

import reference
from reference import exact, qmul, qconj, qmat, to_mp

HERE = os.path.dirname(os.path.abspath(__file__))
AGREEMENT = mpf('1e-28')   # between two ways; 25 digits are written
DIGITS = 40                # of way 1
DIGITS_OF_CONDITION = 24   # of way 1 where only the change by 1e-16 of an input is asked for
ULP = Fraction(1, 2**53)

COLUMNS = ['id', 'scene', 't', 'qw', 'qx', 'qy', 'qz', 'O1', 'O2', 'O3', 'cond_rad', 'cond_omega', 'agreement',
           'invariant', 'check', 'note']

HEADER = """\
# torque_rows.csv - rigid bodies under effects of a scene file, of the kinds that torque.csv lacks
# made by make_torque_rows.py
# scene: a body as in a scene file, without name and method (YAML flow map); t: when, in s
# q (w x y z): from the axes in which the scene gives the inertia to those of the world; Omega in the former; 25 digits
# inputs are doubles taken exactly, written with the fewest digits that name them
# attitude and directions are normalised exactly; the two directions of an orbit are exactly perpendicular
# equations (body axes; M = inertia, u = R^T r): M dOmega/dt = (M Omega) x Omega + the sum of
#   constant_torque: torque, or R^T torque;  gravity_torque: c x R^T (m g);  viscous_damping: -c_i Omega_i
#   gravity_gradient: 3 n^2 u x (M u), r(t) = r0 cos(n t) + (N x r0) sin(n t), N and r0 unit vectors
#   torque_schedule: torque, or R^T torque, from <= t < to
#   internal_dissipation: -c (Omega - sigma), J (dsigma/dt + Omega x sigma) = c (Omega - sigma), sigma(0) = Omega(0)
# cond_rad cond_omega: worst change of attitude (rad) and of Omega (relative to |Omega|) for x->x(1+2^-53) over all
#   nonzero inputs x (t and switching times included; a pair of a tensor as one); fair tolerance as in torque.csv
# agreement: worst difference (rad, or relative to |Omega|) between Taylor series and an extrapolated midpoint rule in
#   world axes
# invariant: worst relative error of the checks named in `check`: E energy (or Jacobi's integral), L angular momentum,
#   X a formula
"""


# ----------------------------------------------------------------------------- the rows
ATTITUDES = [[0.5, 0.5, -0.5, 0.5], [0.6, 0.0, 0.8, 0.0], [-0.61, -0.14, 0.73, 0.28], [0.9, 0.22, 0.34, 0.16],
             [-0.37, 0.74, -0.33, -0.46], [0.3, -0.7, 0.2, 0.68]]
TENSOR = [[2.0, 0.3, -0.2], [0.3, 1.5, 0.1], [-0.2, 0.1, 1.1]]
SLENDER = [[0.9, 0.25, 0.1], [0.25, 0.4, -0.15], [0.1, -0.15, 0.95]]
# Directions of orbits: exactly perpendicular, though of any length.
TILTED = {'orbit_normal': [1.0, 2.0, 2.0], 'radial_at_start': [2.0, 1.0, -2.0]}
SKEW = {'orbit_normal': [0.25, -0.5, 1.5], 'radial_at_start': [3.0, 0.75, -0.25]}
LEVEL = {'orbit_normal': [0.0, 0.0, 1.0], 'radial_at_start': [1.0, 0.0, 0.0]}


def gradient(rate, directions):
    return dict({'type': 'gravity_gradient', 'orbit_rate': rate}, **directions)


def damping(coefficient):
    return {'type': 'viscous_damping', 'coefficient': coefficient}


def slug(inertia, coefficient):
    return {'type': 'internal_dissipation', 'slug_inertia': inertia, 'damping': coefficient}


def gravity(mass, acceleration, centre):
    return {'type': 'gravity_torque', 'mass': mass, 'gravity': acceleration, 'centre_of_mass': centre}


def constant(frame, torque):
    return {'type': 'constant_torque', 'frame': frame, 'torque': torque}


def schedule(*segments):
    return {'type': 'torque_schedule',
            'segments': [{'from': a, 'to': b, 'frame': frame, 'torque': torque} for a, b, frame, torque in segments]}


class Rows:
    def __init__(self):
        self.rows = []

    def add(self, note, inertia, omega, t, *effects, q0=None, formula=None):
        q0 = q0 or ATTITUDES[len(self.rows) % len(ATTITUDES)]
        scene = {'inertia': inertia, 'attitude': q0, 'angular_velocity': omega, 'effects': list(effects)}
        self.rows.append((note, scene, t, formula))


def of_gradient(rows):
    rows.add('gradient; libration in pitch', [1.0, 1.6, 2.2], [0.0, 0.0, 0.5], 40.0, gradient(0.5, LEVEL),
             q0=[0.98, 0.0, 0.0, 0.15], formula=pitch_formula)
    rows.add('gradient; wide libration in pitch; small body; near its separatrix', [0.002, 0.005, 0.0055],
             [0.0, 0.0, 0.3], 30.0, gradient(0.3, LEVEL), q0=[0.72, 0.0, 0.0, 0.69], formula=pitch_formula)
    rows.add('gradient; libration about all axes; tilted orbit', [1.0, 1.7, 2.1], [0.11, 0.21, 0.19], 50.0,
             gradient(0.3, TILTED), q0=[0.58, -0.24, -0.67, 0.41])
    rows.add('gradient; strong; tumbling', [0.7, 1.3, 1.8], [0.9, -0.4, 1.1], 15.0, gradient(1.5, SKEW))
    rows.add('gradient; tensor', SLENDER, [0.2, 0.1, -0.3], 25.0, gradient(0.6, TILTED))
    rows.add('gradient; weak; fast spin', [2.0, 3.0, 4.5], [9.0, 0.3, -2.0], 8.0, gradient(0.02, SKEW))
    rows.add('gradient; weak; near the separatrix of the free body', [4.0, 5.0, 9.0], [3.0, 0.5, 1.0], 10.0,
             gradient(0.05, TILTED))
    rows.add('gradient; large moments; as Tiangong-1', [16403.01, 70915.56, 76392.38], [0.01, -0.02, 0.026], 60.0,
             gradient(0.00116, TILTED))
    rows.add('gradient; symmetric body', [0.8, 2.0, 2.0], [1.2, 0.1, -0.4], 20.0, gradient(0.7, SKEW))
    rows.add('gradient; spherical body; no torque', [1.25, 1.25, 1.25], [0.4, -0.6, 0.2], 30.0, gradient(0.5, TILTED))
    rows.add('gradient; negative t', [1.0, 1.7, 2.1], [0.3, -0.2, 0.6], -17.5, gradient(0.4, SKEW))
    backwards = dict(TILTED, orbit_normal=[-x for x in TILTED['orbit_normal']])
    rows.add('gradient; orbit run backwards; tensor; negative t', TENSOR, [0.5, 0.3, -0.2], -12.0,
             gradient(0.5, backwards))


def of_damping(rows):
    rows.add('damping; per axis', [1.0, 2.0, 2.5], [1.5, 2.0, -1.0], 12.0, damping([0.1, 0.25, 0.05]))
    rows.add('damping; per axis; one axis free', [1.4, 1.1, 0.6], [0.4, 0.3, 6.0], 15.0, damping([0.3, 0.0, 0.02]))
    rows.add('damping; tensor; per axis of the tensor; strong', TENSOR, [2.0, -1.0, 3.0], 6.0,
             damping([1.5, 0.2, 0.7]))
    rows.add('damping; tensor; per axis of the tensor; weak; fast spin', SLENDER, [4.0, 9.0, -3.0], 7.0,
             damping([0.01, 0.002, 0.03]))
    rows.add('damping; one number; tensor', SLENDER, [1.0, -2.0, 0.5], 10.0, damping(0.08))
    rows.add('damping; near unstable axis; per axis', [1.0, 2.0, 3.0], [0.001, 3.0, 0.001], 9.0,
             damping([0.05, 0.1, 0.2]))
    rows.add('damping; sphere; one number', [0.4, 0.4, 0.4], [1.0, -2.0, 0.5], 5.0, damping(0.15),
             formula=sphere_formula)
    rows.add('damping; spin about a principal axis; per axis', [1.0, 2.0, 2.5], [0.0, 0.0, 7.0], 20.0,
             damping([0.3, 0.2, 0.15]), formula=spin_formula)
    rows.add('damping; pendulum; tensor; per axis', TENSOR, [0.1, 0.0, 0.2], 14.0, damping([0.1, 0.3, 0.2]),
             gravity(0.8, [0.0, 0.0, -9.81], [0.3, -0.2, 0.4]))


def of_slug(rows):
    for t, when in ((12.0, 'wobble grows'), (25.0, 'on the way'), (50.0, 'in the flat spin')):
        rows.add('slug; as Explorer 1: slender; spun about its smallest axis; ' + when, [2.0, 2.1, 0.15],
                 [0.02, 0.05, 5.0], t, slug(0.4, 1.8), q0=ATTITUDES[3])
    rows.add('slug; symmetric slender body', [1.5, 1.5, 0.3], [0.1, 0.0, 3.0], 30.0, slug(0.2, 0.5))
    rows.add('slug; near unstable axis', [1.0, 2.0, 3.0], [0.01, 1.5, 0.02], 25.0, slug(0.3, 0.1))
    rows.add('slug; tight: c/J = 20 1/s', [0.9, 1.2, 0.5], [0.8, 0.3, 2.0], 12.0, slug(0.25, 5.0))
    rows.add('slug; loose; fast spin', [2.0, 3.0, 4.0], [6.0, 8.0, -1.0], 6.0, slug(0.05, 0.001))
    rows.add('slug; larger than the body; tensor', SLENDER, [1.0, 2.0, -0.5], 15.0, slug(4.0, 0.6))
    rows.add('slug; oblate body; wobble dies out', [1.0, 1.1, 1.9], [0.4, -0.3, 2.0], 60.0, slug(0.3, 0.2))
    rows.add('slug; spherical body; constant body torque', [0.7, 0.7, 0.7], [1.0, 0.2, -0.4], 9.0, slug(0.2, 0.4),
             constant('body', [0.3, -0.1, 0.2]))


def of_schedule(rows):
    rows.add('schedule; despin about a principal axis', [1.1, 1.4, 2.0], [0.0, 0.0, 6.0], 17.3,
             schedule((0.7, 3.1, 'body', [0.0, 0.0, -2.5]), (4.3, 6.7000000000000002, 'body', [0.0, 0.0, -2.25]),
                      (6.7, 7.0, 'body', [0.0, 0.0, 1.0])), formula=spin_formula)
    rows.add('schedule; body and world; gaps; odd times', [1.0, 1.6, 2.2], [0.3, 1.0, -0.5], 9.87654321,
             schedule((0.1, 0.7300000000000001, 'body', [1.0, -0.5, 0.2]),
                      (1.4142135623730951, 3.3333333333333335, 'world', [-0.3, 0.4, 0.6]),
                      (5.000000001, 5.9, 'body', [0.0, 0.8, -0.7])))
    rows.add('schedule; last segment ends after t', [0.6, 0.9, 1.3], [1.0, 0.1, 0.4], 4.0,
             schedule((0.0, 1.0, 'world', [0.2, 0.2, -0.4]), (3.2, 8.0, 'world', [0.5, -0.6, 0.1])))
    rows.add('schedule; t in a gap; segments in any order', [0.6, 0.9, 1.3], [0.2, 1.7, 0.4], 6.5,
             schedule((7.25, 9.0, 'body', [5.0, 5.0, 5.0]), (2.1, 2.9000000000000004, 'body', [-1.0, 0.7, 0.3]),
                      (0.3, 1.9, 'world', [0.0, 0.4, -0.2])))
    rows.add('schedule; segments that touch; signs change; t at a switch', [2.0, 1.5, 1.0], [0.0, 0.0, 0.0], 3.9,
             schedule((0.0, 1.3, 'body', [1.0, 0.4, -0.2]), (1.3, 2.6, 'body', [-1.0, 0.4, 0.2]),
                      (2.6, 3.9, 'world', [1.0, -0.8, 0.2]), (3.9, 5.2, 'world', [-9.0, 3.0, 1.0])))
    rows.add('schedule; short strong pulses', [0.8, 1.0, 1.7], [0.5, 0.6, 2.0], 5.0,
             schedule((0.111, 0.124, 'body', [60.0, 0.0, -20.0]), (1.7182818284590451, 1.7192818284590452, 'world',
                      [-300.0, 500.0, 100.0]), (3.0, 3.0009765625, 'body', [0.0, -800.0, 0.0])))
    rows.add('schedule; tensor; weak; fast spin', TENSOR, [7.0, -3.0, 5.0], 6.0,
             schedule((0.35, 2.05, 'world', [0.02, 0.0, -0.05]), (2.95, 4.4500000000000002, 'body',
                      [-0.04, 0.03, 0.01])))
    rows.add('schedule; negative t: before all segments', TENSOR, [0.7, -0.3, 0.5], -6.0,
             schedule((0.25, 1.0, 'world', [1.0, 2.0, 3.0]), (1.5, 2.5, 'body', [-4.0, 3.0, 1.0])))


def of_constant_and_gravity(rows):
    rows.add('heavy top; tensor', [[1.1, 0.12, -0.07], [0.12, 1.25, 0.09], [-0.07, 0.09, 0.5]], [0.3, -0.2, 8.0], 6.0,
             gravity(1.5, [0.0, 0.0, -9.81], [0.05, -0.03, 0.4]))
    rows.add('heavy top; symmetric; gravity along no axis; negative t', [1.0, 1.0, 0.4], [0.2, 0.5, 12.0], -5.0,
             gravity(2.0, [3.0, -5.5, 7.6], [0.0, 0.0, 0.35]))
    rows.add('constant torque; body; tensor; strong', SLENDER, [0.0, 0.1, 0.0], 6.0, constant('body', [2.0, -1.0, 3.0]))
    rows.add('constant torque; body and world; tensor; negative t', TENSOR, [1.0, 0.5, -2.0], -7.0,
             constant('body', [0.1, 0.3, -0.2]), constant('world', [-0.4, 0.2, 0.1]))


def of_combinations(rows):
    rows.add('gradient + slug', [1.0, 1.6, 2.2], [0.2, -0.1, 0.7], 30.0, gradient(0.4, TILTED), slug(0.3, 0.1))
    rows.add('gradient + slug; tensor', TENSOR, [0.4, 0.9, 0.3], 20.0, slug(0.6, 0.4), gradient(0.5, SKEW))
    rows.add('schedule + damping + gravity', [1.2, 1.7, 2.3], [0.4, -0.6, 2.0], 8.0,
             schedule((0.9, 2.2, 'body', [0.0, 2.0, -1.0]), (3.7, 6.1, 'world', [1.5, 0.0, 0.5])),
             damping([0.2, 0.1, 0.3]), gravity(0.6, [0.0, 0.0, -9.81], [0.2, -0.1, 0.5]))
    rows.add('schedule + slug', [0.9, 1.4, 1.1], [0.5, 0.2, 1.6], 11.0, slug(0.3, 0.3),
             schedule((1.05, 3.15, 'world', [0.3, -0.5, 0.2]), (4.2, 4.9, 'world', [-0.8, 0.1, 0.4])))
    rows.add('heavy top + slug', [1.0, 1.0, 0.5], [0.1, 0.2, 9.0], 7.0, gravity(1.0, [0.0, 0.0, -9.81],
             [0.0, 0.0, 0.3]), slug(0.1, 0.3))
    rows.add('gradient + damping; tensor; per axis', SLENDER, [0.5, -0.2, 0.3], 30.0, gradient(0.5, SKEW),
             damping([0.05, 0.02, 0.1]))
    rows.add('gradient + schedule; t after the last segment', [1.0, 1.4, 1.9], [0.0, 0.2, 0.3], 16.0,
             gradient(0.3, TILTED), schedule((1.1, 2.3, 'body', [0.4, 0.0, -0.2]), (7.7, 8.8, 'world',
             [0.0, -0.3, 0.2])))
    everything = [constant('body', [0.1, 0.2, -0.1]), constant('world', [-0.1, 0.05, 0.2]),
                  gravity(0.5, [0.3, -0.4, -6.0], [0.1, 0.2, 0.3]), gradient(0.4, TILTED)]
    dissipative = [damping([0.1, 0.04, 0.15]), slug(0.3, 0.2),
                   schedule((0.45, 1.55, 'world', [0.5, 0.4, -0.6]), (2.3, 2.75, 'body', [-1.0, 0.0, 0.7]))]
    rows.add('everything; tensor', TENSOR, [1.0, -2.0, 0.5], 3.0, *(everything + dissipative))
    rows.add('everything; tensor; longer', TENSOR, [1.0, -2.0, 0.5], 10.0, *(everything + dissipative))
    rows.add('gradient + gravity + constant torques; tensor; negative t', TENSOR, [1.0, -2.0, 0.5], -6.0, *everything)


def all_rows():
    rows = Rows()
    for kind in (of_gradient, of_damping, of_slug, of_schedule, of_constant_and_gravity, of_combinations):
        kind(rows)
    return rows.rows


# ----------------------------------------------------------------------------- a scene as text
def number_text(x):
    """The fewest digits that name the double, in a form that every YAML reader takes for a number."""
    text = repr(float(x))
    mantissa, e, exponent = text.partition('e')
    return text if not e or '.' in mantissa else mantissa + '.0e' + exponent


def flow(value):
    if isinstance(value, dict):
        return '{' + ', '.join('%s: %s' % (key, flow(v)) for key, v in value.items()) + '}'
    if isinstance(value, list):
        return '[' + ', '.join(map(flow, value)) + ']'
    return value if isinstance(value, str) else number_text(value)


def exact_moments(inertia):
    """3x3 tensor of rationals, and its inverse."""
    if not isinstance(inertia[0], list):
        inertia = [[inertia[i] if i == j else 0 for j in range(3)] for i in range(3)]
    m = [[exact(x) for x in row] for row in inertia]
    assert all(m[i][j] == m[j][i] for i in range(3) for j in range(3))
    minors = [[m[i - 2][j - 2] * m[i - 1][j - 1] - m[i - 2][j - 1] * m[i - 1][j - 2] for j in range(3)]
              for i in range(3)]
    determinant = sum(m[0][j] * minors[0][j] for j in range(3))
    inverse = [[minors[j][i] / determinant for j in range(3)] for i in range(3)]
    assert [times(m, column) for column in zip(*inverse)] == [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    return m, inverse


def of_type(scene, name):
    return [effect for effect in scene['effects'] if effect['type'] == name]


def legs(scene, t):
    """(start, end) of the pieces between 0 and t on which no torque jumps, exact, in the order of passing them."""
    t = exact(t)
    jumps = [exact(s[key]) for e in of_type(scene, 'torque_schedule') for s in e['segments'] for key in ('from', 'to')]
    ends = sorted({Fraction(0), t} | {x for x in jumps if min(t, 0) < x < max(t, 0)}, reverse=t < 0)
    return list(zip(ends, ends[1:]))


def torques_on(scene, leg, frame):
    """Constant and scheduled torques in that frame, which act on that leg."""
    middle = (leg[0] + leg[1]) / 2
    found = [e['torque'] for e in of_type(scene, 'constant_torque') if e['frame'] == frame]
    found += [s['torque'] for e in of_type(scene, 'torque_schedule') for s in e['segments']
              if s['frame'] == frame and exact(s['from']) <= middle < exact(s['to'])]
    return [sum(exact(v[i]) for v in found) for i in range(3)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def times(m, v):
    return [dot(row, v) for row in m]


def transposed(m):
    return [list(column) for column in zip(*m)]


# ----------------------------------------------------------------------------- way 1: Taylor series in body axes
to_mpfr = reference._mpfr


def per_axis(coefficient):
    return coefficient if isinstance(coefficient, list) else [coefficient] * 3


def cross_coefficient(a, b, reversed_a, reversed_b):
    """Of the product of two series of vectors, the last coefficient that is known."""
    c = lambda x, y: sum(map(mul, x, y))
    return [c(a[1], reversed_b[2]) - c(a[2], reversed_b[1]),
            c(a[2], reversed_b[0]) - c(a[0], reversed_b[2]),
            c(a[0], reversed_b[1]) - c(a[1], reversed_b[0])]


@mp.workdps(100)  # reference.py negates numbers at the caller's precision
def taylor(scene, t, digits=DIGITS):
    """q (w >= 0), Omega and sigma (None without a slug) at t: mpmath numbers."""
    precision, order = int((digits + 25) * 3.3219281), int(1.15 * digits) + 4
    with gmpy2.local_context(gmpy2.get_context(), precision=precision, emin=-10**9, emax=10**9):
        vector = lambda v: [to_mpfr(x) for x in v]
        m, inverse = ([vector(row) for row in a] for a in exact_moments(scene['inertia']))
        omega, q = vector(scene['angular_velocity']), vector(scene['attitude'])
        length = gmpy2.sqrt(sum(a * a for a in q))
        q = [a / length for a in q]
        coefficients = [vector(per_axis(e['coefficient'])) for e in of_type(scene, 'viscous_damping')]
        damped = [sum(c[i] for c in coefficients) for i in range(3)] if coefficients else None
        slugs = [(to_mpfr(e['slug_inertia']), to_mpfr(e['damping'])) for e in of_type(scene, 'internal_dissipation')]
        assert len(slugs) <= 1
        sigma = list(omega) if slugs else []
        hanging = [(vector([exact(e['mass']) * exact(x) for x in e['gravity']]), vector(e['centre_of_mass']))
                   for e in of_type(scene, 'gravity_torque')]
        orbits = []
        for e in of_type(scene, 'gravity_gradient'):
            normal, radial = (unit(vector(e[key])) for key in ('orbit_normal', 'radial_at_start'))
            orbits.append((to_mpfr(e['orbit_rate']), radial, cross(normal, radial)))
        seen = lambda v: qmul(qmul(qconj(q), [mpfr(0)] + v), q)[1:]
        # Vectors of the world in body axes: u and v on each orbit; then the weights.
        orbiting = [seen(v) for _, radial, along in orbits for v in (radial, along)]
        weights = [seen(weight) for weight, _ in hanging]
        for leg in legs(scene, t):
            body, world = (vector(torques_on(scene, leg, frame)) for frame in ('body', 'world'))
            turning = orbiting + weights + ([seen(world)] if any(world) else [])
            now, end = to_mpfr(leg[0]), to_mpfr(leg[1])
            towards = 1 if end > now else -1
            while True:
                series = [[x] for x in omega + q + sigma + sum(turning, [])]
                o, attitude, rest = series[:3], series[3:7], series[7:]
                s, rest = (rest[:3], rest[3:]) if slugs else (None, rest)
                turned = [rest[i:i + 3] for i in range(0, len(rest), 3)]
                momentum, of_gradient_field = [[], [], []], [[[], [], []] for _ in orbits]
                for k in range(order):
                    last = lambda v: [x[k] for x in v]
                    back = lambda v: [x[::-1] for x in v]
                    for x, y in zip(momentum, times(m, last(o))):
                        x.append(y)
                    ro = back(o)
                    rhs = cross_coefficient(momentum, o, None, ro)
                    if k == 0:
                        rhs = [x + y for x, y in zip(rhs, body)]
                    if damped:
                        rhs = [x - c * y for x, c, y in zip(rhs, damped, last(o))]
                    if any(world):
                        rhs = [x + y for x, y in zip(rhs, last(turned[-1]))]
                    for j, (_, centre) in enumerate(hanging):
                        rhs = [x + y for x, y in zip(rhs, cross(centre, last(turned[2 * len(orbits) + j])))]
                    for j, (rate, _, _) in enumerate(orbits):
                        u = turned[2 * j]
                        for x, y in zip(of_gradient_field[j], times(m, last(u))):
                            x.append(y)
                        torque = cross_coefficient(u, of_gradient_field[j], None, back(of_gradient_field[j]))
                        rhs = [x + 3 * rate * rate * y for x, y in zip(rhs, torque)]
                    grown = []
                    if slugs:
                        drag = [slugs[0][1] * (x - y) for x, y in zip(last(o), last(s))]
                        rhs = [x - y for x, y in zip(rhs, drag)]
                        grown = [x + y / slugs[0][0] for x, y in zip(cross_coefficient(s, o, None, ro), drag)]
                    for j, v in enumerate(turned):
                        change = cross_coefficient(v, o, None, ro)
                        if j < 2 * len(orbits):
                            other, sign = (turned[j + 1], 1) if j % 2 == 0 else (turned[j - 1], -1)
                            change = [x + sign * orbits[j // 2][0] * y for x, y in zip(change, last(other))]
                        grown += change
                    c = lambda x, y: sum(map(mul, x, y))
                    w, x, y, z = attitude
                    spun = [-(c(x, ro[0]) + c(y, ro[1]) + c(z, ro[2])) / 2,
                            (c(w, ro[0]) + c(y, ro[2]) - c(z, ro[1])) / 2,
                            (c(w, ro[1]) + c(z, ro[0]) - c(x, ro[2])) / 2,
                            (c(w, ro[2]) + c(x, ro[1]) - c(y, ro[0])) / 2]
                    for one, derivative in zip(series, times(inverse, rhs) + spun + grown):
                        one.append(derivative / (k + 1))
                spin = max([abs(x) for x in omega + sigma] + [mpfr('1e-3')])
                sizes = [spin] * 3 + [mpfr(1)] * 4 + [spin] * len(sigma)
                for v in turning:
                    sizes += [max(abs(x) for x in v)] * 3
                h = mpfr(10)**mpfr(reference._stepsize(series, sizes, order, -(digits + 5.0)))
                arrived = abs(end - now) <= h
                h = end - now if arrived else towards * h
                values = [reference._horner(x, h) for x in series]
                omega, q, values = values[:3], values[3:7], values[7:]
                if slugs:
                    sigma, values = values[:3], values[3:]
                turning = [values[i:i + 3] for i in range(0, len(values), 3)]
                now += h
                if arrived:
                    break
            orbiting, weights = turning[:2 * len(orbits)], turning[2 * len(orbits):][:len(hanging)]
        q, omega = reference._tomp(q, omega)
        return q, omega, reference._tomp(q=[mpfr(1)] * 4, O=sigma)[1] if slugs else None


def unit(v):
    length = gmpy2.sqrt(dot(v, v))
    return [x / length for x in v]


# ----------------------------------------------------------------------------- way 2: extrapolation in world axes
class World:
    """y = 9 entries of R by rows; angular momentum of the body, in world axes; that of the slug; the work for E."""

    def __init__(self, scene):
        vector = lambda v: [to_mpfr(x) for x in v]
        self.m, self.inverse = ([vector(row) for row in a] for a in exact_moments(scene['inertia']))
        self.scene = scene
        self.drag = [mpfr(0)] * 3
        for e in of_type(scene, 'viscous_damping'):
            self.drag = [x + y for x, y in zip(self.drag, vector(per_axis(e['coefficient'])))]
        self.slug = [(to_mpfr(e['slug_inertia']), to_mpfr(e['damping']))
                     for e in of_type(scene, 'internal_dissipation')]
        self.hanging = [([to_mpfr(e['mass']) * to_mpfr(x) for x in e['gravity']], vector(e['centre_of_mass']))
                        for e in of_type(scene, 'gravity_torque')]
        self.orbits = [(to_mpfr(e['orbit_rate']), unit(vector(e['orbit_normal'])), unit(vector(e['radial_at_start'])))
                       for e in of_type(scene, 'gravity_gradient')]
        self.pushes = [(None, None, e['frame'], vector(e['torque'])) for e in of_type(scene, 'constant_torque')]
        for e in of_type(scene, 'torque_schedule'):
            self.pushes += [(to_mpfr(s['from']), to_mpfr(s['to']), s['frame'], vector(s['torque']))
                            for s in e['segments']]

    def start(self):
        vector = lambda v: [to_mpfr(x) for x in v]
        a = vector(self.scene['attitude'])
        # R of a quaternion that is not normalised: no square root.
        w, x, y, z = a
        n = w * w + x * x + y * y + z * z
        r = [[(w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n],
             [2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n],
             [2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n]]
        omega = vector(self.scene['angular_velocity'])
        inside = [self.slug[0][0] * x for x in times(r, omega)] if self.slug else []
        return sum(r, []) + times(r, times(self.m, omega)) + inside + [mpfr(0)]

    def next_switch(self, now, end):
        """The end of the piece that begins now; takes the torques that act on it."""
        switches = [x for push in self.pushes if push[0] is not None for x in push[:2]]
        if end > now:
            until = min([x for x in switches if x > now] + [end])
        else:
            until = max([x for x in switches if x < now] + [end])
        low, high = min(now, until), max(now, until)
        self.body, self.world = [mpfr(0)] * 3, [mpfr(0)] * 3
        for start, stop, frame, torque in self.pushes:
            if start is None or not (stop <= low or start >= high):
                setattr(self, frame, [a + b for a, b in zip(getattr(self, frame), torque)])
        return until

    def rates(self, y):
        r = [y[0:3], y[3:6], y[6:9]]
        back = transposed(r)
        body_rate = times(self.inverse, times(back, y[9:12]))
        return r, back, body_rate, times(r, body_rate)

    def derivative(self, t, y):
        r, back, body_rate, rate = self.rates(y)
        applied = [a - b * c for a, b, c in zip(self.body, self.drag, body_rate)]
        torque = [a + b for a, b in zip(times(r, applied), self.world)]
        work = dot(torque, rate)
        inside = []
        for inertia, damping_of_slug in self.slug:
            slip = [a - b / inertia for a, b in zip(rate, y[12:15])]
            inside = [damping_of_slug * x for x in slip]
            work -= dot(inside, slip)
        for weight, centre in self.hanging:
            torque = [a + b for a, b in zip(torque, cross(times(r, centre), weight))]
        external = torque
        for n, normal, radial in self.orbits:
            work -= n * dot(normal, external)
            c, s = gmpy2.cos(n * t), gmpy2.sin(n * t)
            d = [c * a + s * b for a, b in zip(radial, cross(normal, radial))]
            field = cross(d, times(r, times(self.m, times(back, d))))
            torque = [a + 3 * n * n * b for a, b in zip(torque, field)]
        if self.slug:
            torque = [a - b for a, b in zip(torque, inside)]
        columns = [cross(rate, column) for column in back]
        return sum(transposed(columns), []) + torque + inside + [work]


def extrapolate(scene, t, digits=35, columns=16):
    """q (w >= 0), Omega, and the work for E at t: mpmath numbers. Steps of 1/2, 1/4, 1/6 ... (Gragg)."""
    with gmpy2.local_context(gmpy2.get_context(), precision=int((digits + 25) * 3.3219281)):
        body = World(scene)
        y, tolerance, h = body.start(), mpfr(10)**-digits, mpfr('0.1')
        now, finish = mpfr(0), to_mpfr(t)
        while now != finish:
            end = body.next_switch(now, finish)
            while now != end:
                last = abs(end - now) <= h
                step = end - now if last else (h if end > now else -h)
                least = mpfr('1e-3') * sum(body.m[i][i] for i in range(3))
                sizes = [mpfr(1)] * 9 + [max(abs(x) for x in y[9:-1] + [least])] * (len(y) - 10)
                first = body.derivative(now, y)
                table = []
                for j in range(1, columns + 1):
                    new = [midpoint(body, now, y, first, step, 2 * j)]
                    for k in range(1, j):
                        factor = 1 / ((mpfr(j) / (j - k))**2 - 1)
                        new.append([a + (a - b) * factor for a, b in zip(new[-1], table[k - 1])])
                    table = new
                error = max(abs(a - b) / size for a, b, size in zip(table[-1], table[-2], sizes))
                growth = mpfr('0.9') * (tolerance / max(error, tolerance / 10**12))**(mpfr(1) / (2 * columns - 1))
                if error <= tolerance:
                    y, now = table[-1], end if last else now + step
                    # A last step says little of the size that the next piece can have.
                    h = max(h, abs(step) * growth) if last else abs(step) * growth
                else:
                    h = abs(step) * growth
        r, _, body_rate, _ = body.rates(y)
        numbers = sum(r, []) + body_rate + [y[-1]]
        out = [mpf(0) if x == 0 else from_mpfr(x) for x in numbers]
    with mp.workdps(60):
        return reference.canon(reference.matq([out[0:3], out[3:6], out[6:9]])), out[9:12], out[12]


def midpoint(body, now, y, first, step, n):
    h = step / n
    before, here = y, [a + h * b for a, b in zip(y, first)]
    for i in range(1, n):
        slope = body.derivative(now + i * h, here)
        before, here = here, [a + 2 * h * b for a, b in zip(before, slope)]
    return here


def from_mpfr(x):
    mantissa, exponent = x.as_mantissa_exp()
    return mpmath.make_mpf(mpmath.libmp.from_man_exp(int(mantissa), int(exponent)))


# ----------------------------------------------------------------------------- what is known without either
class Disagreement(Exception):
    pass


def energy_and_momentum(scene, t, q, omega, sigma):
    """Energy as E has it, the size of its terms, and the total angular momentum in world axes."""
    number = lambda v: [to_mp(exact(x)) for x in v]
    m = [number(row) for row in exact_moments(scene['inertia'])[0]]
    r = qmat(q)
    inside = times(m, omega)
    terms = [dot(omega, inside) / 2]
    for e in of_type(scene, 'internal_dissipation'):
        j = to_mp(exact(e['slug_inertia']))
        terms.append(j * dot(sigma, sigma) / 2)
        inside = [a + j * b for a, b in zip(inside, sigma)]
    momentum = times(r, inside)
    for e in of_type(scene, 'gravity_torque'):
        terms.append(-to_mp(exact(e['mass'])) * dot(number(e['gravity']), times(r, number(e['centre_of_mass']))))
    for e in of_type(scene, 'gravity_gradient'):
        normal, radial = number(e['orbit_normal']), number(e['radial_at_start'])
        assert sum(exact(a) * exact(b) for a, b in zip(e['orbit_normal'], e['radial_at_start'])) == 0
        normal, radial = ([x / mpmath.sqrt(dot(v, v)) for x in v] for v in (normal, radial))
        n = to_mp(exact(e['orbit_rate']))
        angle = n * to_mp(exact(t))
        here = [mpmath.cos(angle) * a + mpmath.sin(angle) * b for a, b in zip(radial, cross(normal, radial))]
        u = times(transposed(r), here)
        terms += [3 * n * n * dot(u, times(m, u)) / 2, -n * dot(normal, momentum)]
    return sum(terms), max(abs(x) for x in terms), momentum


def check_balance(scene, t, state, work):
    """Names of the checks that apply (E, L), and their worst relative error."""
    q0 = [to_mp(exact(x)) for x in scene['attitude']]
    length = mpmath.sqrt(sum(x * x for x in q0))
    omega0 = [to_mp(exact(x)) for x in scene['angular_velocity']]
    energy0, size0, momentum0 = energy_and_momentum(scene, 0, [x / length for x in q0], omega0, omega0)
    energy, size, momentum = energy_and_momentum(scene, t, *state)
    errors = {'E': abs(energy - energy0 - work) / max(size, size0)}
    kinds = {e['type'] for e in scene['effects']}
    in_body = any(any(torques_on(scene, leg, 'body')) for leg in legs(scene, t))
    if not in_body and not kinds & {'viscous_damping', 'gravity_gradient'}:
        expected = momentum0
        for leg in legs(scene, t):
            expected = [a + to_mp(b * (leg[1] - leg[0])) for a, b in zip(expected, torques_on(scene, leg, 'world'))]
        lost = [a - b for a, b in zip(momentum, expected)]
        for e in of_type(scene, 'gravity_torque'):
            down = [to_mp(exact(x)) for x in e['gravity']]
            lost = [dot(lost, down) / mpmath.sqrt(dot(down, down)), mpf(0), mpf(0)]
        biggest = max(mpmath.sqrt(dot(v, v)) for v in (momentum0, momentum))
        errors['L'] = mpmath.sqrt(dot(lost, lost)) / biggest
    return errors


def turned(scene, axis, angle):
    """Attitude at the start, turned by the angle about an axis of the body."""
    q = [to_mp(exact(x)) for x in scene['attitude']]
    length = mpmath.sqrt(sum(x * x for x in q))
    turn = [mpmath.cos(angle / 2)] + [mpmath.sin(angle / 2) * x for x in axis]
    return reference.canon(qmul([x / length for x in q], turn))


def spin_formula(scene, t):
    """About the third principal axis, with damping or with a schedule of body torques, not both."""
    mu, rate = to_mp(exact(scene['inertia'][2])), to_mp(exact(scene['angular_velocity'][2]))
    assert not any(scene['angular_velocity'][:2]) and t > 0
    if of_type(scene, 'viscous_damping'):
        k = to_mp(exact(scene['effects'][0]['coefficient'][2])) / mu
        left = mpmath.exp(-k * to_mp(exact(t)))
        angle, rate = rate * (1 - left) / k, rate * left
    else:
        angle = rate * to_mp(exact(t))
        for s in scene['effects'][0]['segments']:
            # A torque from a on turns by (t - a)^2/2; the end of it at b takes that of (t - b) away.
            since = [max(exact(t) - exact(s[key]), 0) for key in ('from', 'to')]
            torque = to_mp(exact(s['torque'][2])) / mu
            angle += torque * to_mp(since[0]**2 - since[1]**2) / 2
            rate += torque * to_mp(since[0] - since[1])
    return turned(scene, (0, 0, 1), angle), [mpf(0), mpf(0), rate]


def sphere_formula(scene, t):
    k = to_mp(exact(scene['effects'][0]['coefficient'])) / to_mp(exact(scene['inertia'][0]))
    omega = [to_mp(exact(x)) for x in scene['angular_velocity']]
    left = mpmath.exp(-k * to_mp(exact(t)))
    size = mpmath.sqrt(dot(omega, omega))
    return turned(scene, [x / size for x in omega], size * (1 - left) / k), [x * left for x in omega]


def pitch_formula(scene, t):
    """Axis 1 at the angle a from the radius, in the plane of the orbit, and starting at rest against it:
    a'' = -3/2 n^2 (mu2 - mu1)/mu3 sin 2a, so that sin a = k cd(p t, k^2), k = sin a0, p^2 = 3 n^2 (mu2 - mu1)/mu3."""
    effect, = scene['effects']
    mu = [exact(x) for x in scene['inertia']]
    n, t = exact(effect['orbit_rate']), exact(t)
    w, x, y, z = [to_mp(exact(v)) for v in scene['attitude']]
    assert x == y == 0 and scene['angular_velocity'] == [0, 0, effect['orbit_rate']]
    p = to_mp(n) * mpmath.sqrt(to_mp(3 * (mu[1] - mu[0]) / mu[2]))
    k = mpmath.sin(2 * mpmath.atan2(z, w))
    sn, cn, dn = (mpmath.ellipfun(name, p * to_mp(t), m=k * k) for name in ('sn', 'cn', 'dn'))
    angle = mpmath.asin(k * cn / dn)
    # d cd/du = -(1 - k^2) sn/dn^2
    change = -k * (1 - k * k) * p * sn / dn**2 / mpmath.cos(angle)
    angle += to_mp(n * t)
    q = [mpmath.cos(angle / 2), mpf(0), mpf(0), mpmath.sin(angle / 2)]
    return reference.canon(q), [mpf(0), mpf(0), to_mp(n) + change]


# ----------------------------------------------------------------------------- a row
def shortly(x):
    return mpmath.nstr(x, 4) if x else '0'


def checked(row, text):
    """State by way 1; how well way 2 agrees, from the text of the scene; errors of the other checks by letter."""
    note, scene, t, formula = row
    state = taylor(scene, t)
    q, omega, work = extrapolate(yaml.safe_load(text), t)
    with mp.workdps(60):

        def errors_of(state):
            errors = check_balance(scene, t, state, work)
            if formula:
                errors['X'] = max(reference._dist(state, formula(scene, t)))
            return dict(errors, agreement=max(reference._dist(state, (q, omega))))

        errors = errors_of(state)
        for name, error in errors.items():
            if not error <= AGREEMENT:
                raise Disagreement('%s: %s' % (name, shortly(error)))
        for name, error in errors_of(spoilt(state)).items():
            if error <= AGREEMENT:
                raise Disagreement('%s: %s for a state that is wrong by 1e-25' % (name, shortly(error)))
        return state, errors.pop('agreement'), errors


def spoilt(state):
    small = mpf('1e-25')
    q = qmul(state[0], [mpf(1), small, 2 * small, 3 * small])
    return q, [x * (1 + small) for x in state[1]], state[2]


def inputs(value, path=()):
    """Paths to the numbers that are not 0; of a tensor's pairs of entries, the upper one."""
    items = value.items() if isinstance(value, dict) else enumerate(value)
    for key, x in items:
        here = path + (key,)
        if isinstance(x, (dict, list)):
            yield from inputs(x, here)
        elif not isinstance(x, str) and x != 0 and not (here[0] == 'inertia' and len(here) == 3 and here[1] > here[2]):
            yield here


def moved(scene, path):
    scene = copy.deepcopy(scene)
    paths = [path] + ([(path[0], path[2], path[1])] if path[0] == 'inertia' and len(path) == 3 else [])
    for one in set(paths):
        place = scene
        for key in one[:-1]:
            place = place[key]
        place[one[-1]] = exact(place[one[-1]]) * (1 + ULP)
    return scene


def condition(scene, t, state):
    with mp.workdps(60):
        changes = [reference._dist(state, taylor(moved(scene, path), t, DIGITS_OF_CONDITION)) for path in inputs(scene)]
        changes.append(reference._dist(state, taylor(scene, exact(t) * (1 + ULP), DIGITS_OF_CONDITION)))
        return [max(one) for one in zip(*changes)]


def cells_of(numbered):
    """The cells of a row, or a text that says what is wrong with it."""
    k, row = numbered
    note, scene, t, _ = row
    identity, text = 'R%03d' % (k + 1), flow(scene)
    try:
        state, agreement, errors = checked(row, text)
    except (Disagreement, AssertionError) as error:
        return '%s %s, t = %s: %s %s' % (identity, text, t, type(error).__name__, error)
    with mp.workdps(60):
        out = [mpmath.nstr(x, 25, strip_zeros=False) for x in state[0] + state[1]]
        return ([identity, text, number_text(t)] + out + [shortly(x) for x in condition(scene, t, state)] +
                [shortly(agreement), shortly(max(errors.values())), ''.join(sorted(errors)), note])


def main():
    out = sys.argv[1] if len(sys.argv) > 1 else os.path.join(HERE, 'torque_rows.csv')
    rows = all_rows()
    file = io.StringIO()
    file.write(HEADER)
    writer = csv.writer(file, lineterminator='\n')
    writer.writerow(COLUMNS)
    with multiprocessing.Pool() as pool:
        for k, cells in enumerate(pool.imap(cells_of, enumerate(rows))):
            if isinstance(cells, str):
                sys.exit(cells)
            writer.writerow(cells)
            if sys.stderr.isatty():
                sys.stderr.write('\r%d of %d' % (k + 1, len(rows)))
    with open(out + '.part', 'w') as written:
        written.write(file.getvalue())
    os.replace(out + '.part', out)


if __name__ == '__main__':
    main()
