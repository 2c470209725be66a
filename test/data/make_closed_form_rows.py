#!/usr/bin/python3
"""Makes closed_form_rows.csv: starts of free rigid bodies and the truth at t, of the kinds that public.csv lacks.

Usage: make_closed_form_rows.py [OUT]      (default: closed_form_rows.csv beside this script)

Needs Debian's python3-mpmath and python3-gmpy2, about five minutes of one core, and gives the same file in every run.
The truth is reference.closed_form with 60 digits. Every row is checked in other ways, all that are feasible:
  T  plain Taylor series: no elliptic function in it
  F  Taylor series over one period, then the power of that turn (long times)
  C  the closed form in two legs: to 3/8 t, and from that state on
  A  on the separatrix, long after the flip: a steady spin about the axis of intermediate moment, from where the motion
     has come within 1e-80 of it
  P  95 digits instead of 60
A row on which two ways differ by more than 1e-28 (rad, or relative to |Omega|) stops the script, and so does one that
none of T, F, C, A can check; a row at t = 0 needs none.
"""
import math
import os
import sys
from fractions import Fraction

from mpmath import mp, mpf
import mpmath

import reference
from reference import exact

HERE = os.path.dirname(os.path.abspath(__file__))
AGREEMENT = mpf('1e-28')     # between two ways; 25 digits are written
MOST_WORK = 1e6              # of a Taylor integration, about a second
MOST_WORK_OF_THOROUGH = 3e7  # of rows that ask for it
SMALLEST = mpf('1e-400')     # what is below is written as 0: no double comes near
LARGEST_PHASE_OF_CONDITION = 1e13  # |Omega t|: beyond, conditioning is hopeless for any double and slow to get

COLUMNS = ['id', 'mu1', 'mu2', 'mu3', 'q0w', 'q0x', 'q0y', 'q0z', 'O01', 'O02', 'O03', 't', 'qw', 'qx', 'qy', 'qz',
           'O1', 'O2', 'O3', 'note', 'cond_rad', 'cond_omega', 'worst_input', 'condn_rad', 'condn_omega', 'regime',
           'check', 'maxdiff_taylor', 'maxdiff_self']
INPUTS = COLUMNS[1:12]

HEADER = """\
# closed_form_rows.csv - free rigid bodies, of the kinds that public.csv lacks; made by make_closed_form_rows.py
# columns and conventions as in public.csv: inputs are doubles taken exactly, q0 is normalised exactly, 25 digits out
# numbers out below 1e-400 are written as 0; cond_*: empty where |Omega t| > 1e13
# check, besides T F C P: A=steady spin that the separatrix tends to
"""

ATTITUDES = [[0.5, 0.5, 0.5, 0.5], [0.6, 0.0, 0.8, 0.0], [-0.61, -0.14, 0.73, 0.28], [0.9, 0.22, 0.34, 0.16],
             [-0.37, 0.74, -0.33, -0.46], [0.03, -0.7, 0.2, 0.68], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, -1.0, 0.0]]
# Every way to hand sorted moments to the three axes: axis i gets the moment of that rank.
ORDERS = [(0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)]
OCTANTS = [(a, b, c) for a in (1, -1) for b in (1, -1) for c in (1, -1)]


# ----------------------------------------------------------------------------- the rows
class Rows:
    def __init__(self):
        self.rows = []

    def add(self, note, mu, omega, t, q0=None, order=0, signs=(1, 1, 1), thorough=False):
        """mu and omega belong to one another; `order` then hands the pairs to other axes, `signs` turn omega's."""
        assert ',' not in note
        omega = [s * w for s, w in zip(signs, omega)]
        ranks = ORDERS[order % 6]
        if q0 is None:
            q0 = ATTITUDES[len(self.rows) % len(ATTITUDES)]
        self.rows.append((note, [float(mu[k]) for k in ranks], [float(x) for x in q0], [float(omega[k]) for k in ranks],
                          float(t), thorough))


def on_separatrix(rows):
    """I1 (I2-I1) O1^2 = I3 (I3-I2) O3^2 in exact numbers: (I1, I2, I3), (O1, O3)."""
    times = [0.5, -2.0, 7.0, -15.0, 40.0, -100.0]
    n = 0
    for mu, o1, o3 in (([4, 5, 9], 3, 1), ([3, 4, 6], 2, 1)):
        for signs in OCTANTS:
            rows.add('separatrix; exact; signs', mu, [o1, 1, o3], times[n % 6], order=n // 2, signs=signs)
            n += 1
        for a, c in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
            rows.add('separatrix; exact; middle component 0', mu, [o1, 0, o3], times[n % 6], order=n, signs=(a, 1, c))
            n += 1
    others = [([1, 2.5, 3], 1, 1), ([1, 2, 2.25], 0.75, 1), ([1, 6.25, 7], 1, 1), ([3, 3.3125, 5], 3, 1),
              ([1, 2**20 - 2 + 2.0**-19, 2**20 - 1], 1, 1),            # moments a million apart
              ([2**20 - 1, 2**20 + 2.0**-20, 2**20 + 1], 1, 1),        # moments a millionth apart
              ([2**26 - 1, 2**26 + 2.0**-26, 2**26 + 1], 1, 1)]        # 1.5e-8 apart
    for k, (mu, o1, o3) in enumerate(others):
        p = math.sqrt((mu[1] - mu[0]) * (mu[2] - mu[1]) / (mu[0] * mu[2]))  # the rate, about
        for t in (0.7 / p, -9 / p):
            rows.add('separatrix; exact; other ratios', mu, [o1, 0.7, o3], float('%.3g' % t), order=n,
                     signs=OCTANTS[(3 * n) % 8])
            n += 1
    # From far out on it through the flip and far out again, and for ever.
    tiny = 2.0**-30
    for t, signs in ((10.0, (1, 1, -1)), (50.0, (1, -1, 1)), (-50.0, (-1, 1, 1)), (100.0, (-1, -1, 1))):
        rows.add('separatrix; exact; along the unstable axis', [4, 5, 9], [3 * tiny, 1, tiny], t, order=n, signs=signs)
        n += 1
    for t in (1e3, -1e3, 1e6, 1e9, -1e9):
        rows.add('separatrix; exact; long', [4, 5, 9], [3, 0.5, 1], t, order=n, signs=OCTANTS[n % 8])
        n += 1
    for k, t in ((-660, 2.0**660), (-660, 2.0**668), (490, 2.0**-490), (490, 2.0**-480)):
        s = 2.0**k
        rows.add('separatrix; exact; huge or tiny', [3, 4, 6], [2 * s, -s, s], t, order=n)
        n += 1


def near_separatrix(rows):
    n = 0
    for delta in (1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13, 1e-15):
        for side in (1, -1):
            mu, o = (([4, 5, 9], [3, 0.5, 1]), ([3, 4, 6], [2, -0.7, 1]))[n % 2]
            rows.add('near separatrix; %g' % delta, mu, [o[0] * (1 + side * delta), o[1], o[2]],
                     [10.0, -30.0, 300.0, 1e3, -1e3][n % 5], order=n, signs=OCTANTS[(5 * n + 1) % 8])
            n += 1
    up, down = lambda x: math.nextafter(x, math.inf), lambda x: math.nextafter(x, 0)
    for step in (up, down):
        for i in range(3):
            mu = [4.0, 5.0, 9.0]
            mu[i] = step(mu[i])
            rows.add('near separatrix; one moment an ulp off', mu, [3, 0.5, 1], (20.0, -500.0, 1e3)[n % 3], order=n,
                     signs=OCTANTS[n % 8])
            n += 1
        for i in (0, 2):
            o = [3.0, -0.5, 1.0]
            o[i] = step(o[i])
            rows.add('near separatrix; one rate an ulp off', [4, 5, 9], o, (-20.0, 500.0, -1e3)[n % 3], order=n,
                     signs=OCTANTS[n % 8])
            n += 1
    for o1, t in ((3.003, 1e6), (3.000003, 1e9), (up(3.0), 1e6), (up(3.0), 1e9), (down(3.0), -1e6), (down(3.0), 1e9),
                  (2.9999999997, -1e9)):
        rows.add('near separatrix; long', [4, 5, 9], [o1, 0.5, 1], t, order=n, signs=OCTANTS[n % 8])
        n += 1


def near_unstable_axis(rows):
    root3 = math.sqrt(3)  # with mu = (1,2,3) and O2 = 1 the distance from the axis grows as exp(t/root3)
    first_flip = lambda eps: root3 * (math.log(2.75) - math.log(eps))
    n = 0
    for eps in (1e-3, 1e-6, 1e-10, 1e-15, 1e-20, 1e-40, 1e-80, 1e-140, 1e-160, 1e-200, 1e-300, 4e-320):
        t1 = first_flip(eps)
        before, during, after, later = 0.6 * t1, t1 + 0.3, -1.03 * t1, 4.7 * t1
        for t in ((before, after), (during, later))[n // 2 % 2]:
            ratio = (1, -0.5, 2, -1, root3)[n % 5]
            rows.add('near unstable axis; %g' % eps, [1, 2, 3], [eps, 1, eps * ratio], round(t, 2), order=n,
                     signs=OCTANTS[(3 * n) % 8], thorough=eps in (1e-20, 1e-40))
            n += 1
    for eps in (1e-3, 1e-140, 1e-300):
        for omega in ([eps, 1, 0], [0, 1, eps]):
            t1 = first_flip(eps)
            rows.add('near unstable axis; one component 0; %g' % eps, [1, 2, 3], omega,
                     round((t1, -3.1 * t1)[n % 2], 2), order=n, signs=OCTANTS[(3 * n) % 8])
            n += 1
    for eps, t in ((1e-6, 1e6), (1e-20, -1e6), (1e-140, 1e6), (1e-300, 1e6), (1e-3, 1e9), (1e-15, 1e9), (1e-140, 1e9),
                   (1e-200, -1e9), (5e-324, 1e9)):
        rows.add('near unstable axis; long', [1, 2, 3], [eps, 1, eps], t, order=n, signs=OCTANTS[n % 8])
        n += 1
    rows.add('near unstable axis; uneven', [1, 2, 3], [1e-300, 1, 1e-3], 50.0)
    rows.add('near unstable axis; uneven', [1, 2, 3], [1e-3, 1, -1e-300], -50.0)
    rows.add('near unstable axis; uneven', [1, 2, 3], [1e-140, 1, 1e-150], 900.0)


def sizes(rows):
    n = 0
    for size, times in ((1e-200, (1.0, 1e200, -1e203, 1e209)), (1e150, (1e-150, -1e-147, 1e-141)),
                        (1e-300, (1.0, 1e300, 1e303)), (1e-310, (-1.0, 1e303, 1e308)), (5e-324, (1.0, 1e308))):
        for t in times:
            mu, o = ([1, 2, 3], [1, -2, 1.5]) if n % 2 else ([2, 3, 4.5], [0.4, 1, -0.3])
            o = [x * size if size > 5e-324 else math.ceil(abs(x)) * size for x in o]
            rows.add('rates of %g' % size, mu, o, t, order=n, signs=OCTANTS[n % 8])
            n += 1
    rows.add('rates of 1e-200; near separatrix', [4, 5, 9], [3.0000000001e-200, 5e-201, 1e-200], 3e201)
    rows.add('rates of 1e150; near separatrix', [4, 5, 9], [3e150, -5e149, 1e150], 1e-148)
    rows.add('rates of 1e150; near unstable axis', [1, 2, 3], [1e-10, 1e150, 1e-10], -3e-147)
    rows.add('rates of 1e-200; near unstable axis', [1, 2, 3], [1e-310, 1e-200, 3e-311], 5e202)
    for scale, t in ((1e-30, 12.0), (1e30, -300.0), (1e-300, 1e3), (1e300, 1e6), (5e-324 * 2**20, -40.0)):
        rows.add('moments of %g' % scale, [1 * scale, 2 * scale, 3 * scale], [0.4, 0.8, -0.6], t, order=n)
        n += 1
    for s in (3.0, 1e-3, 1e-200, 1e200, 1e-310):
        rows.add('attitude of length %g' % s, [2, 3, 4.5], [0.4, 1, -0.3], 17.0 * s / abs(s),
                 q0=[0.5 * s, -0.3 * s, 0.7 * s, 0.1 * s], order=n)
        n += 1


def axes_and_signs(rows):
    n = 0
    for order in range(6):
        for mu, o in (([1, 2, 3], [0.7, 0.4, 0.9]), ([0.004, 0.009, 0.0105], [0.3, 6, 0.2])):
            rows.add('axes and signs', mu, [o[k] for k in ((0, 1, 2), (2, 1, 0))[n // 2 % 2]], (2.5, -70.0)[n // 3 % 2],
                     order=order, signs=OCTANTS[(n * 5) % 8])
            n += 1


def symmetric(rows):
    n = 0
    for mu in ([2, 2, 1], [1, 1, 1.8]):
        for place in ((0, 1, 2), (0, 2, 1), (2, 0, 1)):
            for t in (3.0, -1e3):
                m = [mu[k] for k in place]
                rows.add('symmetric', m, [0.3, -0.8, 1.5], t, signs=OCTANTS[n % 8])
                n += 1
    rows.add('symmetric; spin about its axis', [2, 2, 1], [0, 0, -0.7], 1e5)
    rows.add('symmetric; spin across its axis', [2, 2, 1], [0.3, -0.7, 0], 1e4)
    rows.add('spherical', [1.5, 1.5, 1.5], [0.3, -0.8, 1.5], -1e4)
    rows.add('spherical', [1e-12, 1e-12, 1e-12], [-0.3, 0.8, 0.5], 1e9)
    for delta in (2.0**-52, 1e-15, 1e-12, 1e-7):
        for mu in ([1, 1 + delta, 2], [0.5, 1, 1 + delta]):
            o, t = (([0.4, 0.5, 0.6], 100.0), ([0.4, 0.7, 0.1], -1e6))[n // 2 % 2]
            rows.add('nearly symmetric; %g' % delta, mu, o, t, order=n, signs=OCTANTS[n % 8])
            n += 1
    rows.add('nearly spherical', [1, 1 + 2.0**-52, 1 + 2.0**-51], [0.4, -0.5, 0.6], 1e3)
    rows.add('nearly spherical', [1, 1 + 1e-12, 1 + 3e-12], [0.4, 0.5, -0.6], 1e9)
    rows.add('nearly spherical', [1 + 1e-15, 1, 1 - 1e-15], [1e-8, 0.5, -0.6], 1e6)


def steady(rows):
    for i in range(3):
        for rate, t in ((0.7, 1e6), (-1.3, 12.0)):
            o = [0.0, 0.0, 0.0]
            o[i] = rate
            rows.add('spin about a principal axis', [1, 2, 3], o, t)
    rows.add('spin about the unstable axis', [2, 1, 3], [1, 0, 0], 1e9)
    rows.add('spin about the unstable axis', [2, 1, 3], [-1, -0.0, 0], -1e3)
    rows.add('spin about the unstable axis', [1, 2, 3], [0, -1e-200, 0], 1e205)
    rows.add('rest', [1, 2, 3], [0, 0, 0], 1e9)
    rows.add('rest', [1, 1, 3], [0, -0.0, 0], -5.0, q0=[3, 1, -2, 0.5])


def extreme_ratios(rows):
    n = 0
    for mu in ([1e-12, 1, 1], [1e-12, 1, 2], [1, 1, 1e-12], [1, 1e6, 1e6 + 0.5], [1e12, 1, 3], [1e-12, 1, 1e12],
               [1e-6, 1, 1 + 1e-6], [1e-9, 1, 1 + 2.0**-52]):
        for t in (1.0, (-1e3, 1e6)[n // 2 % 2]):
            rows.add('extreme ratios', mu, [0.5, 0.2, -0.3], t, order=n, signs=OCTANTS[n % 8])
            n += 1
    for mu in ([1e-12, 1, 2], [1, 1e6, 1e6 + 0.5], [1e-9, 1, 1 + 1e-9], [1, 2, 1e12]):
        i1, i2, i3 = (exact(float(x)) for x in mu)
        o1 = mpmath.sqrt(reference.to_mp(i3 * (i3 - i2) / (i1 * (i2 - i1))))
        p = mpmath.sqrt(reference.to_mp((i3 - i2) * (i2 - i1) / (i1 * i3)))  # for O2 = 1
        for factor, turns in ((1, 3), (1 + 1e-12, -40), (1 - 1e-6, 300)):
            t = float('%.3g' % float(turns / (p + mpmath.sqrt(reference.to_mp((i3 - i1) * (i3 - i2) / (i1 * i2))))))
            rows.add('extreme ratios; near separatrix', mu, [float(o1) * factor, 0.7, 1.0], t, order=n,
                     signs=OCTANTS[n % 8])
            n += 1
    rows.add('extreme ratios; near unstable axis', [1e-6, 1, 1e6], [1e-9, 1, 1e-9], 0.1)
    rows.add('extreme ratios; near unstable axis', [1e-12, 1, 1.5], [1e-9, 1, -1e-9], 3e-5)
    rows.add('extreme ratios; near unstable axis', [1, 1e6, 1e6 + 0.5], [1e-9, -1, 1e-9], 100.0)
    rows.add('extreme ratios; beyond', [1e-100, 1, 1e100], [0.5, 0.2, -0.3], 1e-90)
    rows.add('extreme ratios; beyond', [1e-30, 1, 1e30], [0.5, 0.2, -0.3], 1.0)


def far_along(rows):
    """A tiny moment makes the largest part of Omega there where cn and dn have fallen to e^-10 or less: found by search
    as those on which a double x = Xd, rounded, showed most."""
    for mu, o, t in (([366587.885268914, 1.2663150462898837e-12, 1.0], [3.0809048892428e-08, 10036.56089811464, -1.0],
                      -3.0946361506407395e-05),
                     ([1.0, 1.9351790149746716e-12, 44124797965.87742],
                      [-1.0, -0.0003363837716291042, -1.0605053865803348e-20], -0.00012597715682702556),
                     ([1.0011731207520629, 1.0, 2.627799645510594e-12],
                      [1.8877845365220116e-05, 1.0, -0.39910047876801663], 0.0013730835537770687),
                     ([137696367669.65247, 1.0, 116582707759.80424],
                      [-1.790564852963518e-22, -2.8275870878210766e-17, -1.0], 0.00046425056662382906),
                     ([2.5979771361259605, 1.0, 3.0287225180673087e-12],
                      [-1.442034827939413e-12, -1.0, 1.688297386572267e-06], -8.098454434780077e-05),
                     ([1.0, 7.595110005603941e-12, 19020121.595213972],
                      [-1.0, 56.2707985783658, 8.153364069596523e-12], -0.00013855333540163566),
                     ([1.1114043913058653e-11, 1.0, 2.6269556623881125],
                      [2.7583045644883026e-06, -1.0, -4.447992456117038e-12], 0.00023193109289959654),
                     ([1.0, 3.001765333423271e-11, 3.5233155546668504],
                      [1.0, 1.1680673440259603e-07, -2.1463210973228098e-13], 0.00024063845687686105)):
        rows.add('extreme ratios; far along', mu, o, t)


BODIES = [('generic', [2, 3, 4.5], [0.4, 1, -0.3]), ('symmetric', [2, 2, 1], [0.3, -0.8, 1.5]),
          ('near separatrix', [4, 5, 9], [3.0000000003, 0.5, 1])]


def times(rows):
    for name, mu, o in BODIES:
        for t in (0.0, -0.0, 1e-300, 1e-10, 1.0, 1e3, 1e6, -1e9, 1e10, 1e12):
            rows.add('times; ' + name, mu, o, t)
        for t in (1e18, 1e30, 1e100, 1e300):
            rows.add('times; far; ' + name, mu, o, t, thorough=t < 1e50 or name != 'near separatrix')


def grids(rows):
    for (name, mu, o), q0 in zip(BODIES, ATTITUDES[2:]):
        for k in range(9):
            rows.add('grid; ' + name, mu, o, 1e9 + k / 64, q0=q0)


def all_rows():
    rows = Rows()
    for kind in (on_separatrix, near_separatrix, near_unstable_axis, sizes, axes_and_signs, symmetric, steady,
                 extreme_ratios, times, grids, far_along):
        kind(rows)
    return rows.rows


# ----------------------------------------------------------------------------- the truth and its checks
class Motion:
    """What must be known in advance: how many digits a check needs."""

    def __init__(self, mu, omega, t):
        i, w, log = [exact(x) for x in mu], [exact(x) for x in omega], reference._l10
        self.regime, self.log_rate, log_distance = 'steady', -400.0, 0.0
        lo, self.mid, hi = sorted(range(3), key=lambda k: i[k])
        phase = log(max(abs(x) for x in w)) + log(exact(t))
        if any((i[k - 2] - i[k - 1]) * w[k - 2] * w[k - 1] != 0 for k in range(3)):
            d2 = sum(i[k] * (i[k] - i[self.mid]) * w[k]**2 for k in range(3))
            a, c = (lo, hi) if d2 >= 0 else (hi, lo)
            d1 = sum(i[k] * (i[k] - i[a]) * w[k]**2 for k in range(3))
            self.regime = 'general' if d2 != 0 else 'separatrix'
            self.log_rate = log((i[c] - i[self.mid]) * d1 / (i[0] * i[1] * i[2])) / 2
            log_distance = log((i[c] - i[a]) * d2 / ((i[c] - i[self.mid]) * d1)) if d2 else -math.inf
            momentum = log(sum((x * y)**2 for x, y in zip(i, w))) / 2
            phase = momentum - log(min(i)) + log(exact(t))
        turns = 10**min(self.log_rate + log(exact(t)), 12.0)
        # Errors grow as exp(p t) at most, and no further than the inverse distance from the separatrix; then linearly.
        growth = min(2 * turns / math.log(10), -log_distance)
        spread = log(max(i) / min(i))
        self.digits = max(0.0, phase) + max(0.0, growth) + spread


def work(steps, digits):
    """Squared order of the series, times what a product costs."""
    return steps * (1.15 * digits)**2 * (1 + digits / 100)


def shortly(x):
    """Positive number with 4 digits."""
    return mpmath.nstr(x, 4) if x else '0'


def asymptotic(mu, q0, omega, t, motion):
    """The separatrix long after its flip: a steady spin from where e^-pt is below 1e-80. No formula of elliptic kind is
    used behind that point, nor a phase of the closed form."""
    with mp.workdps(130):
        i = [exact(x) for x in mu]
        p = mpf(10)**mpf(motion.log_rate)
        start = exact(math.copysign(float((750 + 200) / p), t))
        q, o = reference.closed_form(mu, q0, omega, start, 100)
        m = motion.mid
        momentum = mpmath.sqrt(sum((reference.to_mp(a) * b)**2 for a, b in zip(i, o)))
        rate = momentum / reference.to_mp(i[m]) * mpmath.sign(o[m])
        half = rate * reference.to_mp(exact(t) - start) / 2
        turn = [mpmath.cos(half), mpf(0), mpf(0), mpf(0)]
        turn[1 + m] = mpmath.sin(half)
        spin = [mpf(0)] * 3
        spin[m] = rate
        return reference.canon(reference.qmul(q, turn)), spin


class Disagreement(Exception):
    pass


@mp.workdps(150)  # reference.py negates numbers at the caller's precision
def checked(mu, q0, omega, t, thorough):
    """The truth, and which checks it passed by how much."""
    motion = Motion(mu, omega, t)
    truth = reference.closed_form(mu, q0, omega, t, 60)
    done, by_taylor, by_itself = '', [], []

    def compare(letter, other, where):
        difference = max(reference._dist(truth, other))
        if not difference <= AGREEMENT:
            raise Disagreement('%s differs by %s' % (letter, shortly(difference)))
        where.append(difference)
        return letter

    if t == 0:
        done += 'T'
        compare('T', reference.taylor(mu, q0, omega, t), by_taylor)
    else:
        digits = int(45 + motion.digits)
        steps = int((MOST_WORK_OF_THOROUGH if thorough else MOST_WORK) / work(1, digits))
        for letter, way in (('T', reference.taylor), ('F', reference.taylor_floquet)):
            if steps < 3 or letter == 'F' and ('T' in done or motion.regime == 'separatrix'):
                continue
            try:
                done += compare(letter, way(mu, q0, omega, t, digits, steps)[:2], by_taylor)
            except reference.TooLong:
                pass
        if motion.digits < 2000:
            leg = exact(t) * 3 / 8
            q, o = reference.closed_form(mu, q0, omega, leg, int(70 + motion.digits))
            done += compare('C', reference.closed_form(mu, q, o, exact(t) - leg, 60), by_itself)
        elif motion.regime == 'separatrix':
            done += compare('A', asymptotic(mu, q0, omega, t, motion), by_itself)
    if not done:
        raise Disagreement('no check is feasible')
    done += compare('P', reference.closed_form(mu, q0, omega, t, 95), by_itself)
    return truth, motion, done, by_taylor, by_itself


def text_of(identity, row):
    note, mu, q0, omega, t, thorough = row
    truth, motion, done, by_taylor, by_itself = checked(mu, q0, omega, t, thorough)
    cond = [''] * 5
    if math.hypot(*omega) * abs(t) <= LARGEST_PHASE_OF_CONDITION:
        c = reference.condition(mu, q0, omega, t, truth)
        cond = [shortly(c[0]), shortly(c[1]), c[2], shortly(c[3]), shortly(c[4])]
    given = mu + q0 + omega + [t]
    with mp.workdps(60):
        out = [mpmath.nstr(x if abs(x) >= SMALLEST else mpf(0), 25, strip_zeros=False) for x in truth[0] + truth[1]]
    cells = ([identity] + ['%.17g' % x for x in given] + out + [note] + cond + [motion.regime, done] +
             [shortly(max(by_taylor)) if by_taylor else '', shortly(max(by_itself)) if by_itself else ''] +
             [x.hex() for x in given])
    return ','.join(cells)


def main():
    out = sys.argv[1] if len(sys.argv) > 1 else os.path.join(HERE, 'closed_form_rows.csv')
    temporary = out + '.part'
    rows = all_rows()
    with open(temporary, 'w') as file:
        file.write(HEADER + ','.join(COLUMNS + [name + '_hex' for name in INPUTS]) + '\n')
        for k, row in enumerate(rows):
            identity = 'C%03d' % (k + 1)
            try:
                file.write(text_of(identity, row) + '\n')
            except (Disagreement, AssertionError) as error:
                sys.exit('%s %s: %s' % (identity, row, error))
            if sys.stderr.isatty():
                sys.stderr.write('\r%d of %d' % (k + 1, len(rows)))
    os.replace(temporary, out)


if __name__ == '__main__':
    main()
