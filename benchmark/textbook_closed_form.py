"""The closed form of the free rigid body as textbooks print it (Landau & Lifshitz, Mechanics, section 37), in plain
double precision: E and L^2 from the start, the modulus from them, elliptic functions and integrals by the AGM and by
Carlson's duplication. For comparison only; doc/closed_form.md says where it fails and why.
"""
import math

NONE = None  # no answer: for the separatrix, or a start that roundoff moves onto it


def carlson_f(x, y, z):
    """R_F by duplication (Carlson 1979)."""
    while True:
        mean = (x + y + z) / 3
        if max(abs(x - mean), abs(y - mean), abs(z - mean)) < 1e-3 * mean:
            break
        step = math.sqrt(x * y) + math.sqrt(y * z) + math.sqrt(z * x)
        x, y, z = (x + step) / 4, (y + step) / 4, (z + step) / 4
    a, b = 1 - x / mean, 1 - y / mean
    c = -(a + b)
    e2, e3 = a * b - c * c, a * b * c
    return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / math.sqrt(mean)


def carlson_c(x, y):
    """R_C for y > 0."""
    if y > x:
        return math.atan(math.sqrt((y - x) / x)) / math.sqrt(y - x) if x > 0 else math.pi / 2 / math.sqrt(y)
    if y == x:
        return 1 / math.sqrt(x)
    return math.atanh(math.sqrt((x - y) / x)) / math.sqrt(x - y)


def carlson_j(x, y, z, p):
    """R_J by duplication."""
    total, factor = 0.0, 1.0
    while True:
        mean = (x + y + z + 2 * p) / 5
        if max(abs(x - mean), abs(y - mean), abs(z - mean), abs(p - mean)) < 1e-3 * mean:
            break
        rx, ry, rz = math.sqrt(x), math.sqrt(y), math.sqrt(z)
        step = rx * ry + ry * rz + rz * rx
        total += 3 * factor * carlson_c((p * (rx + ry + rz) + rx * ry * rz) ** 2, p * (p + step) ** 2)
        factor /= 4
        x, y, z, p = (x + step) / 4, (y + step) / 4, (z + step) / 4, (p + step) / 4
    a, b, c = 1 - x / mean, 1 - y / mean, 1 - z / mean
    d = -(a + b + c) / 2
    e2 = a * b + b * c + c * a - 3 * d * d
    e3 = a * b * c + 2 * e2 * d + 4 * d ** 3
    e4 = (2 * a * b * c + e2 * d + 3 * d ** 3) * d
    e5 = a * b * c * d * d
    series = (1 - 3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 - 9 * e2 * e3 / 52 + 3 * e5 / 26)
    return total + factor * series / (mean * math.sqrt(mean))


def third_kind(sine, cosine, delta, n):
    """Legendre's Pi(n; phi) for |phi| <= pi/2, from sin phi, cos phi, sqrt(1 - m sin^2 phi)."""
    c2, d2 = cosine * cosine, delta * delta
    return sine * carlson_f(c2, d2, 1) + n / 3 * sine ** 3 * carlson_j(c2, d2, 1, 1 - n * sine * sine)


def jacobi(u, m):
    """sn, cn, dn by the descending Landen transformation (Abramowitz & Stegun 16.4)."""
    a, b, ratios, means = 1.0, math.sqrt(1 - m), [], []
    while a - b > 1e-15 * a:
        c = (a - b) / 2
        a, b = (a + b) / 2, math.sqrt(a * b)
        ratios.append(c / a)
        means.append(a)
    phi = a * u * 2 ** len(means)
    for ratio in reversed(ratios):
        phi = (phi + math.asin(ratio * math.sin(phi))) / 2
    sine = math.sin(phi)
    return sine, math.cos(phi), math.sqrt(1 - m * sine * sine)


def frame(M):
    """A matrix of three rows: perpendicular to the third axis and M; perpendicular to that and M; along M."""
    length = math.sqrt(sum(x * x for x in M))
    u = [x / length for x in M]
    across = math.hypot(u[0], u[1])
    e = [-u[1] / across, u[0] / across, 0.0]
    return [e, [u[1] * e[2] - u[2] * e[1], u[2] * e[0] - u[0] * e[2], u[0] * e[1] - u[1] * e[0]], u]


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def transposed(a):
    return [list(row) for row in zip(*a)]


def matrix(q):
    w, x, y, z = q
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]


def quaternion(r):
    trace = r[0][0] + r[1][1] + r[2][2]
    squares = [trace, r[0][0], r[1][1], r[2][2]]
    k = squares.index(max(squares))
    if k == 0:
        q = [1 + trace, r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]]
    else:
        i, j, l = k - 1, k % 3, (k + 1) % 3
        q = [r[l][j] - r[j][l], 0, 0, 0]
        q[1 + i] = 1 + 2 * r[i][i] - trace
        q[1 + j] = r[i][j] + r[j][i]
        q[1 + l] = r[i][l] + r[l][i]
    length = math.sqrt(sum(x * x for x in q))
    return [x / length for x in q]


def textbook(moments, attitude, omega, t):
    """(attitude, omega) at t, or NONE. Moments in ascending order, all different; no steady spins."""
    momentum2 = sum((i * w) ** 2 for i, w in zip(moments, omega))
    energy2 = sum(i * w * w for i, w in zip(moments, omega))
    order = (0, 1, 2) if momentum2 > energy2 * moments[1] else (2, 1, 0)
    odd = order[0] == 2
    I1, I2, I3 = (moments[i] for i in order)
    w = [omega[i] for i in order]
    if odd:
        w[0] = -w[0]  # an exchange of two axes alone is no rotation
    try:
        m = (I2 - I1) * (energy2 * I3 - momentum2) / ((I3 - I2) * (momentum2 - energy2 * I1))
        p = math.sqrt((I3 - I2) * (momentum2 - energy2 * I1) / (I1 * I2 * I3))
        sign1, sign3 = math.copysign(1, w[0]), math.copysign(1, w[2])
        a1 = sign1 * math.sqrt((momentum2 - energy2 * I3) / (I1 * (I1 - I3)))
        a2 = sign1 * sign3 * math.copysign(1, I3 - I2) * math.sqrt((momentum2 - energy2 * I3) / (I2 * (I2 - I3)))
        a3 = sign3 * math.sqrt((momentum2 - energy2 * I1) / (I3 * (I3 - I1)))
        quarter = math.pi / 2 / agm(1, math.sqrt(1 - m))
        n = I3 * (I2 - I1) / (I1 * (I2 - I3))
        phi = math.atan2(w[1] / a2, w[0] / a1)
        s, c = math.sin(phi), math.cos(phi)
        d = math.sqrt(1 - m * s * s)
        u0 = s * carlson_f(c * c, d * d, 1)
        u = u0 + p * t
        whole = math.floor(u / (2 * quarter) + 0.5)
        s1, c1, d1 = jacobi(u - 2 * quarter * whole, m)
        turns = third_kind(s1, c1, d1, n) - third_kind(s, c, d, n) + 2 * whole * third_kind(1, 0, math.sqrt(1 - m), n)
    except (ValueError, ZeroDivisionError, OverflowError):
        return NONE
    if whole % 2:
        s1, c1 = -s1, -c1
    length = math.sqrt(momentum2)
    psi = length * t / I3 + length * (I3 - I1) / (I1 * I3 * p) * turns
    after = [a1 * c1, a2 * s1, a3 * d1]
    M0 = [i * x for i, x in zip((I1, I2, I3), w)]
    M1 = [i * x for i, x in zip((I1, I2, I3), after)]
    rename = [[0.0] * 3 for _ in range(3)]
    for k in range(3):
        rename[k][order[k]] = -1.0 if odd and k == 0 else 1.0
    cos, sin = math.cos(psi), math.sin(psi)
    start = product(product(matrix(attitude), transposed(rename)), transposed(frame(M0)))
    moved = product(product(start, [[cos, -sin, 0], [sin, cos, 0], [0, 0, 1]]), product(frame(M1), rename))
    return quaternion(moved), [sum(rename[k][i] * after[k] for k in range(3)) for i in range(3)]


def agm(a, b):
    while abs(a - b) > 1e-9 * a:
        a, b = (a + b) / 2, math.sqrt(a * b)
    return (a + b) / 2
