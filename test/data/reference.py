#!/usr/bin/python3
"""
reference.py - independent high-precision reference for the free rigid body (and some torques)

PROBLEM (torque free)
    mu = (mu1,mu2,mu3) > 0 principal inertias (body frame)
    R(t) in SO(3)  maps body (model) -> world,   omega_world = R Omega,   L = R diag(mu) Omega = const
    mu_i dOmega_i/dt = (mu_j - mu_k) Omega_j Omega_k   (i,j,k cyclic),    dR/dt = R hat(Omega)
    in quaternions (Hamilton, w first, R = R(q), v_world = q v_body q^-1):  dq/dt = 1/2 q (0,Omega)

INPUT CONVENTION
    every input number is an IEEE double (or int / Fraction / mpf / gmpy2.mpfr) and is converted EXACTLY
    (to a rational) before use.  q0 is a 4-vector (w,x,y,z) that need not be of unit length: it is
    normalised exactly (i.e. at the working precision) before use.

FUNCTIONS
    closed_form(mu,q0,Omega0,t,digits=60) -> (q, Omega)  mpmath numbers
        Jacobi elliptic functions by the AGM, Legendre's third integral by Carlson's R_F, R_J.
        All regime decisions (which axis the polhode encircles, exact separatrix, steady rotation,
        symmetry) are made in exact rational arithmetic.
    taylor(mu,q0,Omega0,t,digits=50)      -> (q, Omega)  gmpy2.mpfr numbers
        plain Taylor series method with recurrences, no elliptic function anywhere.
    taylor_floquet(mu,q0,Omega0,t,digits=55) -> (q, Omega, n_periods)
        same Taylor integrator over ONE period T of Omega (T found as a root of the Taylor
        polynomial), then R(nT+r) = (R(T) R(0)^-1)^n R(r).  Makes t = 1e9 feasible without closed form.
    taylor_torque(mu,q0,Omega0,t_list,par,digits=40,hscale=1) -> [(q,Omega)...]
        tau_body = b + R^T w + c x (R^T F) - d Omega
"""
from fractions import Fraction
from operator import mul
import math
import mpmath
from mpmath import mp, mpf
import gmpy2

# ----------------------------------------------------------------------------- exact conversion
def exact(x):
    """Exact rational value of a number (double, int, Fraction, mpf, mpfr)."""
    if isinstance(x, Fraction):
        return x
    if isinstance(x, (int, float)):
        return Fraction(x)
    if isinstance(x, mpf):
        s, man, ex, bc = x._mpf_
        man = int(man) * (-1 if s else 1)
        return Fraction(man) * Fraction(2) ** ex
    if isinstance(x, type(gmpy2.mpfr(0))):
        a, b = x.as_integer_ratio()
        return Fraction(int(a), int(b))
    raise TypeError(type(x))

def to_mp(f):
    """Fraction -> mpf rounded at the current mp precision."""
    return mpf(f.numerator) / mpf(f.denominator)

def sgn(x):
    return (x > 0) - (x < 0)

# ----------------------------------------------------------------------------- quaternions (generic)
def qmul(a, b):
    return [a[0]*b[0] - a[1]*b[1] - a[2]*b[2] - a[3]*b[3],
            a[0]*b[1] + a[1]*b[0] + a[2]*b[3] - a[3]*b[2],
            a[0]*b[2] - a[1]*b[3] + a[2]*b[0] + a[3]*b[1],
            a[0]*b[3] + a[1]*b[2] - a[2]*b[1] + a[3]*b[0]]

def qconj(a):
    return [a[0], -a[1], -a[2], -a[3]]

def qmat(q):
    w, x, y, z = q
    return [[1-2*(y*y+z*z), 2*(x*y-w*z), 2*(x*z+w*y)],
            [2*(x*y+w*z), 1-2*(x*x+z*z), 2*(y*z-w*x)],
            [2*(x*z-w*y), 2*(y*z+w*x), 1-2*(x*x+y*y)]]

def matq(R):
    """rotation matrix -> quaternion (Shepperd: largest component first)"""
    tr = R[0][0]+R[1][1]+R[2][2]
    d = [tr, R[0][0], R[1][1], R[2][2]]
    k = d.index(max(d))
    if k == 0:
        q = [1+tr, R[2][1]-R[1][2], R[0][2]-R[2][0], R[1][0]-R[0][1]]
    elif k == 1:
        q = [R[2][1]-R[1][2], 1+2*R[0][0]-tr, R[0][1]+R[1][0], R[0][2]+R[2][0]]
    elif k == 2:
        q = [R[0][2]-R[2][0], R[0][1]+R[1][0], 1+2*R[1][1]-tr, R[1][2]+R[2][1]]
    else:
        q = [R[1][0]-R[0][1], R[0][2]+R[2][0], R[1][2]+R[2][1], 1+2*R[2][2]-tr]
    n = mpmath.sqrt(sum(a*a for a in q))
    return [a/n for a in q]

def mm(A, B):
    return [[sum(A[i][k]*B[k][j] for k in range(3)) for j in range(3)] for i in range(3)]

def tr3(A):
    return [[A[j][i] for j in range(3)] for i in range(3)]

def canon(q):
    """w >= 0 convention (first non-zero component positive)"""
    for a in q:
        if a > 0:
            return list(q)
        if a < 0:
            return [-b for b in q]
    return list(q)

def angle_between(qa, qb):
    """rotation angle between two attitudes, in mpmath, accurate for tiny angles"""
    d = qmul(qconj(qa), qb)
    return 2*mpmath.atan2(mpmath.sqrt(d[1]**2+d[2]**2+d[3]**2), abs(d[0]))

# ----------------------------------------------------------------------------- way 1: closed form
def closed_form(mu, q0, Omega0, t, digits=60):
    """Attitude quaternion (w>=0) and body angular velocity at time t; see module doc.

    Axes are renamed (1,2,3) so that 2 is the middle inertia and 3 is the axis the polhode encircles:
      3 = largest if L^2 > 2E mu_mid, smallest if L^2 < 2E mu_mid (renaming made a proper rotation by one
      sign flip if odd).  Then
        Omega = (a1 cn u, a2 sn u, a3 dn u),  u = u0 + p t
        a1^2 = (L^2-2E I3)/(I1(I1-I3)), a2^2 = (L^2-2E I3)/(I2(I2-I3)), a3^2 = (L^2-2E I1)/(I3(I3-I1))
        p^2 = (I3-I2)(L^2-2E I1)/(I1 I2 I3)
        m   = (I2-I1)(2E I3-L^2)/((I3-I2)(L^2-2E I1)),   1-m = (I3-I1)(L^2-2E I2)/((I3-I2)(L^2-2E I1))
      R(t) = A0 Rz(psi) S(u),  S(u) rows: b1 = e3 x L_body (normalised), b2 = L_body/L x b1, b3 = L_body/L
        psi = L t/I3 + L (I3-I1)/(I1 I3 p) [Pi(n; am u | m) - Pi(n; am u0 | m)],
        n = I3(I2-I1)/(I1(I2-I3)) <= 0
    """
    I = [exact(x) for x in mu]
    W = [exact(x) for x in Omega0]
    T = exact(t)
    Q = [exact(x) for x in q0]
    # exact Euler right-hand sides: steady rotation?
    steady = all((I[(i+1) % 3]-I[(i+2) % 3])*W[(i+1) % 3]*W[(i+2) % 3] == 0 for i in range(3))
    if steady:
        mag = _l10(max(abs(w) for w in W)*abs(T))
        with mp.workdps(int(digits+25+max(0, mag))):
            q = [to_mp(x) for x in Q]
            nq = mpmath.sqrt(sum(a*a for a in q)); q = [a/nq for a in q]
            om2 = sum(w*w for w in W)
            om = mpmath.sqrt(to_mp(om2))
            if om2 == 0 or T == 0:
                return canon(q), [to_mp(w) for w in W]
            h = om*to_mp(T)/2
            s = mpmath.sin(h)/om
            q = qmul(q, [mpmath.cos(h)]+[s*to_mp(w) for w in W])
            return canon(q), [to_mp(w) for w in W]
    lo, mid, hi = sorted(range(3), key=lambda i: I[i])
    D2 = sum(I[i]*(I[i]-I[mid])*W[i]**2 for i in range(3))          # L^2 - 2E I_mid, exact
    i1, i3 = (lo, hi) if D2 >= 0 else (hi, lo)
    perm = (i1, mid, i3)
    even = perm in ((0, 1, 2), (1, 2, 0), (2, 0, 1))
    f = 1 if even else -1
    P = [[0]*3 for _ in range(3)]
    P[0][i1] = f; P[1][mid] = 1; P[2][i3] = 1                        # proper rotation: W' = P W
    I1, I2, I3 = I[i1], I[mid], I[i3]
    W1, W2, W3 = f*W[i1], W[mid], W[i3]
    D1 = I2*(I2-I1)*W2**2 + I3*(I3-I1)*W3**2                         # L^2 - 2E I1
    D3 = I1*(I1-I3)*W1**2 + I2*(I2-I3)*W2**2                         # L^2 - 2E I3
    a1q = D3/(I1*(I1-I3)); a2q = D3/(I2*(I2-I3)); a3q = D1/(I3*(I3-I1))
    pq = (I3-I2)*D1/(I1*I2*I3)
    mq = -(I2-I1)*D3/((I3-I2)*D1)
    m1q = (I3-I1)*D2/((I3-I2)*D1)
    nq_ = I3*(I2-I1)/(I1*(I2-I3))
    L2 = I1**2*W1**2+I2**2*W2**2+I3**2*W3**2
    assert a1q > 0 and a2q > 0 and a3q > 0 and pq > 0 and mq >= 0 and m1q >= 0 and nq_ <= 0
    # guard digits
    lp = _l10(pq)/2
    g = max(0, lp+_l10(T)) * 2 + max(0, _l10(L2)/2+_l10(T)-_l10(min(I)))
    g += max(0, _l10(L2)/2+_l10(abs((I3-I1)/(I1*I3)))-lp)
    g += max(0, _l10(1-nq_))
    if m1q > 0:
        g += max(0, -_l10(m1q))
    g += max(0, _l10(L2/(a1q*I1**2)), _l10(L2/(a2q*I2**2)), _l10(L2/(a3q*I3**2)))
    with mp.workdps(int(digits+30+g)):
        i1f, i2f, i3f = to_mp(I1), to_mp(I2), to_mp(I3)
        s1 = -1 if W1 < 0 else 1
        s3 = -1 if W3 < 0 else 1
        # Euler: sign(a1 a2 a3) = + if I3 is the largest, - if it is the smallest
        s2 = s1*s3*(1 if I3 > I2 else -1)
        a1 = s1*mpmath.sqrt(to_mp(a1q)); a2 = s2*mpmath.sqrt(to_mp(a2q)); a3 = s3*mpmath.sqrt(to_mp(a3q))
        p = mpmath.sqrt(to_mp(pq)); m = to_mp(mq); m1 = to_mp(m1q); n = to_mp(nq_)
        L = mpmath.sqrt(to_mp(L2)); tt = to_mp(T)
        w = [to_mp(W1), to_mp(W2), to_mp(W3)]
        c, s, d = w[0]/a1, w[1]/a2, w[2]/a3                         # cn, sn, dn at t=0  (cn, dn >= 0)
        coef = L*(i3f-i1f)/(i1f*i3f*p)
        if m1q == 0:                                                # exact separatrix
            v0 = mpmath.asinh(s/c)
            v = v0+p*tt
            nu = -n; rn = mpmath.sqrt(nu)
            pi0 = (v0+rn*mpmath.atan(rn*mpmath.tanh(v0)))/(1+nu)
            pi1 = (v+rn*mpmath.atan(rn*mpmath.tanh(v)))/(1+nu)
            dpi = pi1-pi0
            c = d = mpmath.sech(v); s = mpmath.tanh(v)
        else:
            K = mpmath.pi/(2*mpmath.agm(1, mpmath.sqrt(m1)))
            u0 = s*mpmath.elliprf(c*c, d*d, 1)                      # F(phi0|m)
            pi0 = _pi_inc(c, s, d, n)
            u = u0+p*tt
            j = int(mpmath.nint(u/(2*K)))
            v = u-2*K*j
            phi = _am(v, m, m1)
            c, s = mpmath.cos(phi), mpmath.sin(phi)
            d = mpmath.sqrt(m1+m*c*c)
            pi1 = _pi_inc(c, s, d, n)
            if j:
                pic = mpmath.elliprf(0, m1, 1)
                if n != 0:
                    pic += n/3*mpmath.elliprj(0, m1, 1, 1-n)
                pi1 += 2*j*pic
                if j & 1:
                    c, s = -c, -s
            dpi = pi1-pi0
        psi = L*tt/i3f+coef*dpi
        wt = [a1*c, a2*s, a3*d]
        q = [to_mp(x) for x in Q]
        nrm = mpmath.sqrt(sum(a*a for a in q)); q = [a/nrm for a in q]
        R0 = mm(qmat(q), tr3(P))                                    # renamed body axes -> world
        Ii = (i1f, i2f, i3f)
        A0 = mm(R0, tr3(_S([Ii[k]*w[k] for k in range(3)])))
        cz, sz = mpmath.cos(psi), mpmath.sin(psi)
        Rt = mm(mm(A0, [[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]]), _S([Ii[k]*wt[k] for k in range(3)]))
        qt = matq(mm(Rt, P))
        Om = [sum(P[k][i]*wt[k] for k in range(3)) for i in range(3)]
        return canon(qt), [+x for x in Om]

def _l10(x):
    """log10 of a positive rational (works outside double range); -400 for 0"""
    x = abs(x)
    if x == 0:
        return -400.0
    x = Fraction(x)
    a, b = x.numerator, x.denominator
    def lg(k):
        sh = max(0, k.bit_length()-60)
        return math.log10(k >> sh)+sh*0.3010299956639812
    return lg(a)-lg(b)

def _S(M):
    """rows b1,b2,b3 of the moving frame built on the body angular momentum M and the body axis e3"""
    L = mpmath.sqrt(sum(x*x for x in M))
    u = [x/L for x in M]
    r = mpmath.sqrt(u[0]**2+u[1]**2)
    b1 = [-u[1]/r, u[0]/r, mpf(0)]
    b2 = [u[1]*b1[2]-u[2]*b1[1], u[2]*b1[0]-u[0]*b1[2], u[0]*b1[1]-u[1]*b1[0]]
    return [b1, b2, u]

def _pi_inc(c, s, d, n):
    """Pi(n; phi | m) from c=cos phi>=0, s=sin phi, d=dn (convention 1/(1-n sin^2))"""
    r = s*mpmath.elliprf(c*c, d*d, 1)
    if n != 0 and s != 0:
        r += n/3*s**3*mpmath.elliprj(c*c, d*d, 1, 1-n*s*s)
    return r

def _am(v, m, m1):
    """Jacobi amplitude by descending Landen / AGM (A&S 16.4), |v| <= K"""
    a, b, cc = mpf(1), mpmath.sqrt(m1), mpmath.sqrt(m)
    A, C = [a], [cc]
    eps = mpf(10)**(-mp.dps)
    while abs(C[-1]) > eps:
        a, b, cc = (a+b)/2, mpmath.sqrt(a*b), (a-b)/2
        A.append(a); C.append(cc)
        if cc == 0:
            break
    N = len(A)-1
    phi = A[N]*v*2**N
    for k in range(N, 0, -1):
        x = C[k]/A[k]*mpmath.sin(phi)
        phi = (phi+mpmath.asin(x))/2
    return phi

# ----------------------------------------------------------------------------- way 2: Taylor
def _mpfr(f):
    f = exact(f)
    return gmpy2.mpfr(gmpy2.mpq(f.numerator, f.denominator))

def _coefs(g, O, q, N):
    """Taylor coefficients to order N of Omega (3 lists) and q (4 lists); g_i=(mu_j-mu_k)/mu_i"""
    O1, O2, O3 = [O[0]], [O[1]], [O[2]]
    w, x, y, z = [q[0]], [q[1]], [q[2]], [q[3]]
    g1, g2, g3 = g
    for k in range(N):
        k1 = k+1
        r1, r2, r3 = O1[::-1], O2[::-1], O3[::-1]
        o1 = g1*sum(map(mul, O2, r3))/k1
        o2 = g2*sum(map(mul, O3, r1))/k1
        o3 = g3*sum(map(mul, O1, r2))/k1
        kk = 2*k1
        dw = -(sum(map(mul, x, r1))+sum(map(mul, y, r2))+sum(map(mul, z, r3)))/kk
        dx = (sum(map(mul, w, r1))+sum(map(mul, y, r3))-sum(map(mul, z, r2)))/kk
        dy = (sum(map(mul, w, r2))+sum(map(mul, z, r1))-sum(map(mul, x, r3)))/kk
        dz = (sum(map(mul, w, r3))+sum(map(mul, x, r2))-sum(map(mul, y, r1)))/kk
        O1.append(o1); O2.append(o2); O3.append(o3)
        w.append(dw); x.append(dx); y.append(dy); z.append(dz)
    return (O1, O2, O3), (w, x, y, z)

def _horner(c, h):
    r = c[-1]
    for a in reversed(c[:-1]):
        r = r*h+a
    return r

def _stepsize(series, scales, N, tol_l10):
    """largest h with |c_k| h^k <= tol*scale for the last three k, all components (log10 arithmetic)"""
    best = None
    for c, sc in zip(series, scales):
        lsc = float(gmpy2.log10(sc))
        for k in (N-2, N-1, N):
            a = abs(c[k])
            if a == 0:
                continue
            lh = (tol_l10+lsc-float(gmpy2.log10(a)))/k
            if best is None or lh < best:
                best = lh
    return best          # log10(h) or None

class TooLong(Exception):
    pass

def _integrate(mu, q0, Omega0, t, digits, maxsteps, want_period, hscale=1.0):
    I = [exact(v) for v in mu]
    T = exact(t)
    extra = max(0, _l10(T)+_l10(max(abs(exact(v)) for v in Omega0)))
    prec = int((digits+25+extra)*3.3219281)
    N = int(1.15*digits)+4
    with gmpy2.local_context(gmpy2.get_context(), precision=prec, emin=-10**9, emax=10**9):
        g = [_mpfr((I[1]-I[2])/I[0]), _mpfr((I[2]-I[0])/I[1]), _mpfr((I[0]-I[1])/I[2])]
        muf = [_mpfr(v) for v in I]
        O = [_mpfr(v) for v in Omega0]
        q = [_mpfr(v) for v in q0]
        nq = gmpy2.sqrt(sum(a*a for a in q)); q = [a/nq for a in q]
        Os, qs = list(O), list(q)
        tt = _mpfr(T)
        if tt == 0 or all(a == 0 for a in O):
            return q, O, 0, 0, prec
        sg = 1 if tt > 0 else -1
        M0 = gmpy2.sqrt(sum((a*b)**2 for a, b in zip(muf, O)))
        E2 = gmpy2.sqrt(sum(a*b*b for a, b in zip(muf, O)))
        # scale of each Omega_i: it cannot exceed either L/mu_i or sqrt(2E/mu_i)
        osc = [min(M0/a, E2/gmpy2.sqrt(a)) for a in muf]
        one = gmpy2.mpfr(1)
        scales = osc+[one]*4
        now = gmpy2.mpfr(0)
        segs = []
        steady = None
        Gn = None
        gl = None
        lh_tol = -(digits+3.0)
        for step in range(maxsteps):
            CO, Cq = _coefs(g, O, q, N)
            lh = _stepsize(list(CO)+list(Cq), scales, N, lh_tol)
            h = gmpy2.mpfr(10)**gmpy2.mpfr(lh)*gmpy2.mpfr(hscale)
            if step == 0:
                d0 = [c[1] for c in CO]
                steady = all(a == 0 for a in d0)
                s2 = [a*a for a in osc]
                Gn = [a/b*sg for a, b in zip(d0, s2)]
                gl = None
            if want_period:
                if steady:
                    if abs(tt) > h:      # any T is a period
                        segs.append((now, h, CO, Cq))
                        return _finish(segs, h*sg, sg, tt, qs, 1) + (prec,)
                segs.append((now, h, CO, Cq))
            elif step == 3 and abs(tt)/h > 2*maxsteps:
                raise TooLong
            elif step in (20, 60, 150) and abs(tt)/abs(now)*step > 1.2*maxsteps:   # projected number of steps
                raise TooLong
            if abs(tt-now) <= h:
                hh = tt-now
                return [_horner(c, hh) for c in Cq], [_horner(c, hh) for c in CO], 0, step+1, prec
            hs = h*sg
            On = [_horner(c, hs) for c in CO]
            qn = [_horner(c, hs) for c in Cq]
            if want_period and not steady:
                gn = sum(a*(b-c) for a, b, c in zip(Gn, On, Os))
                if step > 0 and gl is not None and gl < 0 and gn >= 0:
                    # root in [0,h] of G(s) = Gn . (Omega(now+s)-Omega0): bisection then Newton
                    G = [sum(a*c[k] for a, c in zip(Gn, CO)) for k in range(N+1)]
                    G[0] -= sum(a*b for a, b in zip(Gn, Os))
                    dG = [k*G[k] for k in range(1, N+1)]
                    lo, hi = gmpy2.mpfr(0), hs
                    for _ in range(40):
                        md = (lo+hi)/2
                        if _horner(G, md) < 0:
                            lo = md
                        else:
                            hi = md
                    s = (lo+hi)/2
                    for _ in range(6):
                        s = s-_horner(G, s)/_horner(dG, s)
                    Or = [_horner(c, s) for c in CO]
                    err = max(abs(a-b)/c for a, b, c in zip(Or, Os, osc))
                    if err < gmpy2.mpfr(10)**(-int(digits*0.6)):
                        return _finish(segs, now+s, sg, tt, qs, step+1) + (prec,)
                gl = gn
            O, q, now = On, qn, now+hs
        raise TooLong

def _finish(segs, T, sg, tt, qs, steps):
    """R(nT+r) = (R(T)R0^-1)^n R(r)"""
    def at(x):
        k = len(segs)-1
        while k > 0 and abs(segs[k][0]) > abs(x):
            k -= 1
        st, h, CO, Cq = segs[k]
        return [_horner(c, x-st) for c in Cq], [_horner(c, x-st) for c in CO]
    n = int(gmpy2.floor(tt/T))
    r = tt-n*T
    qT, _ = at(T)
    C = qmul(qT, qconj(qs))
    nv = gmpy2.sqrt(C[1]**2+C[2]**2+C[3]**2)
    half = gmpy2.atan2(nv, C[0])*n
    if nv == 0:
        Cn = [gmpy2.cos(half), nv, nv, nv]
    else:
        s = gmpy2.sin(half)/nv
        Cn = [gmpy2.cos(half), C[1]*s, C[2]*s, C[3]*s]
    qr, Or = at(r)
    return qmul(Cn, qr), Or, n, steps

def taylor(mu, q0, Omega0, t, digits=50, maxsteps=3000, hscale=1.0):
    """plain Taylor integration from 0 to t; raises TooLong if more than maxsteps steps are needed"""
    q, O, n, steps, prec = _integrate(mu, q0, Omega0, t, digits, maxsteps, False, hscale)
    return _tomp(q, O)

def taylor_floquet(mu, q0, Omega0, t, digits=55, maxsteps=3000, hscale=1.0):
    q, O, n, steps, prec = _integrate(mu, q0, Omega0, t, digits, maxsteps, True, hscale)
    q, O = _tomp(q, O)
    return q, O, n

def _tomp(q, O):
    # exact conversion mpfr -> mpf
    def cv(v):
        if v == 0:
            return mpf(0)
        man, ex = v.as_mantissa_exp()
        return mpmath.make_mpf(mpmath.libmp.from_man_exp(int(man), int(ex)))
    return canon([cv(a) for a in q]), [cv(a) for a in O]

# ----------------------------------------------------------------------------- torques
def taylor_torque(mu, q0, Omega0, t_list, par, digits=40, hscale=1.0, maxsteps=20000):
    """mu_i Omega_i' = (mu_j-mu_k) Omega_j Omega_k + tau_i,   q' = q (0,Omega)/2
       tau = b + R^T w + c x (R^T F) - d Omega
       par: dict with b,w,c,F (3-vectors of doubles; b,c body, w,F world) and d (scalar).
       R^T w and R^T F are carried as extra unknowns (v' = v x Omega), so everything is quadratic.
       t_list increasing, >0. returns list of (q,Omega)."""
    I = [exact(v) for v in mu]
    prec = int((digits+25)*3.3219281)
    N = int(1.15*digits)+4
    out = []
    with gmpy2.local_context(gmpy2.get_context(), precision=prec, emin=-10**9, emax=10**9):
        g = [_mpfr((I[1]-I[2])/I[0]), _mpfr((I[2]-I[0])/I[1]), _mpfr((I[0]-I[1])/I[2])]
        inv = [_mpfr(1/v) for v in I]
        O = [_mpfr(v) for v in Omega0]
        q = [_mpfr(v) for v in q0]
        nq = gmpy2.sqrt(sum(a*a for a in q)); q = [a/nq for a in q]
        b = [_mpfr(v) for v in par['b']]; c = [_mpfr(v) for v in par['c']]
        d = _mpfr(par['d'])
        wv = [_mpfr(v) for v in par['w']]; Fv = [_mpfr(v) for v in par['F']]
        def back(v):                       # R^T v
            return qmul(qmul(qconj(q), [0]+v), q)[1:]
        A, B = back(wv), back(Fv)
        zero = gmpy2.mpfr(0); one = gmpy2.mpfr(1)
        now = gmpy2.mpfr(0)
        targets = [_mpfr(v) for v in t_list]
        lh_tol = -(digits+5.0)
        for step in range(maxsteps):
            S = [[v] for v in O+q+A+B]
            O1, O2, O3, w, x, y, z, A1, A2, A3, B1, B2, B3 = S
            hasA = any(v != 0 for v in A); hasB = any(v != 0 for v in B)
            for k in range(N):
                r1, r2, r3 = O1[::-1], O2[::-1], O3[::-1]
                k1 = k+1
                dot = lambda u, v: sum(map(mul, u, v))
                a = (A1[k], A2[k], A3[k]); f = (B1[k], B2[k], B3[k])
                tau = [a[0]+c[1]*f[2]-c[2]*f[1]-d*O1[k],
                       a[1]+c[2]*f[0]-c[0]*f[2]-d*O2[k],
                       a[2]+c[0]*f[1]-c[1]*f[0]-d*O3[k]]
                if k == 0:
                    tau = [u+v for u, v in zip(tau, b)]
                n1 = (g[0]*dot(O2, r3)+inv[0]*tau[0])/k1
                n2 = (g[1]*dot(O3, r1)+inv[1]*tau[1])/k1
                n3 = (g[2]*dot(O1, r2)+inv[2]*tau[2])/k1
                kk = 2*k1
                dw = -(dot(x, r1)+dot(y, r2)+dot(z, r3))/kk
                dx = (dot(w, r1)+dot(y, r3)-dot(z, r2))/kk
                dy = (dot(w, r2)+dot(z, r1)-dot(x, r3))/kk
                dz = (dot(w, r3)+dot(x, r2)-dot(y, r1))/kk
                if hasA:
                    na = ((dot(A2, r3)-dot(A3, r2))/k1, (dot(A3, r1)-dot(A1, r3))/k1, (dot(A1, r2)-dot(A2, r1))/k1)
                else:
                    na = (zero, zero, zero)
                if hasB:
                    nb = ((dot(B2, r3)-dot(B3, r2))/k1, (dot(B3, r1)-dot(B1, r3))/k1, (dot(B1, r2)-dot(B2, r1))/k1)
                else:
                    nb = (zero, zero, zero)
                for lst, v in zip(S, (n1, n2, n3, dw, dx, dy, dz)+na+nb):
                    lst.append(v)
            om = max(max(abs(v) for v in O), gmpy2.mpfr('1e-3'))
            fa = max([abs(v) for v in A]+[gmpy2.mpfr('1e-300')]); fb = max([abs(v) for v in B]+[gmpy2.mpfr('1e-300')])
            lh = _stepsize(S, [om]*3+[one]*4+[fa]*3+[fb]*3, N, lh_tol)
            h = gmpy2.mpfr(10)**gmpy2.mpfr(lh)*gmpy2.mpfr(hscale)
            while targets and targets[0]-now <= h:
                hh = targets.pop(0)-now
                v = [_horner(cc, hh) for cc in S[:7]]
                out.append(_tomp(v[3:7], v[0:3]))
            if not targets:
                return out
            vals = [_horner(cc, h) for cc in S]
            O, q, A, B = vals[0:3], vals[3:7], vals[7:10], vals[10:13]
            now += h
        raise TooLong

# ----------------------------------------------------------------------------- conditioning
U = Fraction(1, 2**53)

def _dist(r, s):
    """(attitude angle, |dOmega|_2/|Omega|_2) between two (q,Omega) results"""
    n = mpmath.sqrt(sum(a*a for a in r[1]))
    dO = mpmath.sqrt(sum((a-b)**2 for a, b in zip(r[1], s[1])))
    return angle_between(r[0], s[0]), (dO/n if n else mpf(0))

def condition(mu, q0, Omega0, t, base, digits=40, fn=None):
    """returns (cond_rad, cond_omega, worst input name, condn_rad, condn_omega)
    cond_*  : worst change over x -> x(1 +- 2^-53), x each of the 11 inputs, in the attitude angle [rad] and in
              |dOmega|/|Omega|   (actual finite change, not a derivative; saturates at pi)
    condn_* : the same, but Omega0_i -> Omega0_i +- 2^-53 |Omega0| (normwise; differs if components are tiny or 0)
    """
    fn = fn or closed_form
    names = ['mu1', 'mu2', 'mu3', 'q0w', 'q0x', 'q0y', 'q0z', 'O01', 'O02', 'O03', 't']
    x = [exact(v) for v in list(mu)+list(q0)+list(Omega0)+[t]]
    run = lambda y: fn(y[0:3], y[3:7], y[7:10], y[10], digits)
    cr = co = mpf(0); who = '-'
    with mp.workdps(digits+20):
        for k in range(11):
            if x[k] == 0:
                continue
            for sg in (1, -1):
                y = list(x); y[k] = x[k]*(1+sg*U)
                a, o = _dist(base, run(y))
                co = max(co, o)
                if a > cr:
                    cr, who = a, names[k]
        nr, no = cr, co
        om = to_mp(sum(v*v for v in x[7:10]))
        om = exact(mpmath.sqrt(om))
        for k in (7, 8, 9):
            for sg in (1, -1):
                y = list(x); y[k] = x[k]+sg*U*om
                a, o = _dist(base, run(y))
                nr = max(nr, a); no = max(no, o)
    return cr, co, who, nr, no
