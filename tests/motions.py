"""Motions whose rates are written by hand, with reference values from computations of higher precision."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

Rates = Callable[[float, list[float]], list[float]]
GRAVITY = 9.81


@dataclass(frozen=True)
class Motion:
    """A motion from t = 0 to `end`; `reference`: what is known of its end, by component."""

    rates: Rates
    start: Sequence[float]
    end: float
    scale: Sequence[float]
    reference: dict[int, float]


def double_pendulum() -> Motion:
    """Two uniform rods, 1 m and 1 kg each, released at rest from 2 rad."""

    def rates(t: float, y: list[float]) -> list[float]:
        a, b, u, v = y
        c, s = math.cos(a - b), math.sin(a - b)
        p = -0.5 * s * v * v - 1.5 * GRAVITY * math.sin(a)
        q = 0.5 * s * u * u - 0.5 * GRAVITY * math.sin(b)
        m, k, n = 4 / 3, 0.5 * c, 1 / 3
        d = m * n - k * k
        return [u, v, (n * p - k * q) / d, (m * q - k * p) / d]

    end = {0: 1.15669981380890820601715956, 1: 16.5027013733208995444428934}
    return Motion(rates, [2.0, 2.0, 0.0, 0.0], 10.0, [1.0, 1.0, 3.0, 3.0], end)


def chain(n: int, end: float, reference: dict[int, float]) -> Motion:
    """A chain of n uniform rods, 1 m and 1 kg each, released at rest from 1.2 rad: M(θ) ω' = f(θ, ω)."""
    # Rod i carries all those after it: kinetic energy Σ_ij A_ij cos(θ_i - θ_j) ω_i ω_j/2, weights W_i g cos θ_i.
    weight = [n - i - 0.5 for i in range(n)]
    coupling = [[n - max(i, j) - (2 / 3 if i == j else 0.5) for j in range(n)] for i in range(n)]

    def rates(t: float, y: list[float]) -> list[float]:
        sin, cos = [math.sin(a) for a in y[:n]], [math.cos(a) for a in y[:n]]
        square = [w * w for w in y[n:]]
        rows = []
        for i in range(n):
            k, s, c = coupling[i], sin[i], cos[i]
            row = [k[j] * (c * cos[j] + s * sin[j]) for j in range(n)]
            pull = sum(k[j] * (s * cos[j] - c * sin[j]) * square[j] for j in range(n))
            rows.append([*row, -pull - GRAVITY * weight[i] * s])
        for i in range(n):
            top = rows[i]
            for j in range(i + 1, n):
                factor = rows[j][i] / top[i]
                rows[j] = [a - factor * b for a, b in zip(rows[j], top, strict=True)]
        found = [0.0] * n
        for i in reversed(range(n)):
            row = rows[i]
            found[i] = (row[n] - sum(row[j] * found[j] for j in range(i + 1, n))) / row[i]
        return [*y[n:], *found]

    return Motion(rates, [1.2] * n + [0.0] * n, end, [1.0] * n + [3.0] * n, reference)


def chain_of_five() -> Motion:
    """Five links for 5 s."""
    return chain(5, 5.0, {0: -0.139550759585331403803741622, 1: 0.149334165967901599004458326})


def kepler(eccentricity: float) -> Motion:
    """One period of an orbit with a = μ = 1 from its periapsis."""

    def rates(t: float, z: list[float]) -> list[float]:
        x, y, u, v = z
        cube = (x * x + y * y) ** 1.5
        return [u, v, -x / cube, -y / cube]

    fastest = math.sqrt((1 + eccentricity) / (1 - eccentricity))
    near = 1 - eccentricity
    return Motion(rates, [near, 0.0, 0.0, fastest], 2 * math.pi, [1.0] * 4, {0: near, 1: 0.0, 2: 0.0, 3: fastest})


def pendulum(turned: float, end: float) -> Motion:
    """A point on a massless rod of 1 m, released at rest at this angle from the lower vertical."""
    return Motion(lambda t, y: [y[1], -GRAVITY * math.sin(y[0])], [turned, 0.0], end, [1.0, math.sqrt(GRAVITY)], {})


def two_springs(stiffness: float, end: float) -> Motion:
    """A mass of 1 kg on a soft spring (10 N/m), and one of 1 kg hung from it by a stiff one, released from rest."""

    def rates(t: float, y: list[float]) -> list[float]:
        a, b, u, v = y
        stretch = stiffness * (b - a)
        return [u, v, -10.0 * a + stretch - GRAVITY, -stretch - GRAVITY]

    return Motion(rates, [0.0] * 4, end, [1.0, 1.0, 3.0, 3.0], {})


RR, RA, D, DA, E, EA, ZF, FA, ZT, TA, TB = (
    0.007,
    0.00092,
    0.028,
    0.0115,
    0.02,
    0.01421,
    0.02,
    0.01421,
    0.04,
    0.02308,
    0.00916,
)
SS, SA, SB, SC, SD, U, UA, UB = 0.035, 0.01874, 0.01043, 0.018, 0.02, 0.04, 0.01228, 0.00449
XB, YB, XC, YC = -0.03635, 0.03273, 0.014, 0.072
MASS = (0.04325, 0.00365, 0.02373, 0.00706, 0.07050, 0.00706, 0.05498)
INERTIA = (2.194e-6, 4.410e-7, 5.255e-6, 5.667e-7, 1.169e-5, 5.667e-7, 1.912e-5)
STIFFNESS, FREE_LENGTH, MOTOR = 4530.0, 0.07785, 0.033
"""The names are those of the test set."""


def andrews() -> Motion:
    """Andrews' squeezing mechanism (IVP Test Set): seven bodies in three loops, a spring and a motor, 0.03 s.

    q = β, Θ, γ, Φ, δ, Ω, ε. The accelerations follow from M a + Gᵀ λ = f and the twice differentiated constraints. The
    reference was computed with 34 digits; the published end differs from it by up to 1.4e-9.
    """
    start = [-0.0617138900142764496, 0.0, 0.4552798191630703803, 0.2226683901658858847, 0.4873649795438425502]
    start += [-0.2226683901658858847, 1.230547444549821192, *[0.0] * 7]
    end = [15.8107711951537071, -15.7563710584118395, 0.0408222401196458049, -0.5347301163420795938]
    end += [0.5244099658799540694, 0.5347301163420795938, 1.0480807410419378731]
    return Motion(_andrews_rates, start, 0.03, [1.0] * 7 + [1e3] * 7, dict(enumerate(end)))


def _andrews_rates(t: float, y: list[float]) -> list[float]:
    v = y[7:]
    mass, force = _andrews_kinetics(y)
    slopes, rest = _andrews_loops(y)
    rows = [[*mass[i], *(g[i] for g in slopes), force[i]] for i in range(7)]
    rows += [[*g, *[0.0] * 6, -r] for g, r in zip(slopes, rest, strict=True)]
    for k in range(13):
        best = max(range(k, 13), key=lambda i: abs(rows[i][k]))
        rows[k], rows[best] = rows[best], rows[k]
        top = rows[k]
        for i in range(k + 1, 13):
            if rows[i][k]:
                factor = rows[i][k] / top[k]
                rows[i] = [a - factor * b for a, b in zip(rows[i], top, strict=True)]
    found = [0.0] * 13
    for i in reversed(range(13)):
        row = rows[i]
        found[i] = (row[13] - sum(row[j] * found[j] for j in range(i + 1, 13))) / row[i]
    return [*v, *found[:7]]


def _andrews_kinetics(y: list[float]) -> tuple[list[list[float]], list[float]]:
    """The mass matrix and the generalized forces."""
    _, theta, gamma, phi, _, omega, _, db, dt, _, dp, dd, do, de = y
    m1, m2, m3, m4, m5, m6, m7 = MASS
    i1, i2, i3, i4, i5, i6, i7 = INERTIA
    st, ct, sg, cg = math.sin(theta), math.cos(theta), math.sin(gamma), math.cos(gamma)
    sp, cp, so, co = math.sin(phi), math.cos(phi), math.sin(omega), math.cos(omega)
    e, f = E - EA, ZF - FA
    mass = [[0.0] * 7 for _ in range(7)]
    mass[0][0] = m1 * RA**2 + m2 * (RR**2 - 2 * DA * RR * ct + DA**2) + i1 + i2
    mass[0][1] = mass[1][0] = m2 * (DA**2 - DA * RR * ct) + i2
    mass[1][1] = m2 * DA**2 + i2
    mass[2][2] = m3 * (SA**2 + SB**2) + i3
    mass[3][3] = m4 * e**2 + i4
    mass[3][4] = mass[4][3] = m4 * (e**2 + ZT * e * sp) + i4
    mass[4][4] = m4 * (ZT**2 + 2 * ZT * e * sp + e**2) + m5 * (TA**2 + TB**2) + i4 + i5
    mass[5][5] = m6 * f**2 + i6
    mass[5][6] = mass[6][5] = m6 * (f**2 - U * f * so) + i6
    mass[6][6] = m6 * (f**2 - 2 * U * f * so + U**2) + m7 * (UA**2 + UB**2) + i6 + i7
    xd, yd = SD * cg + SC * sg + XB, SD * sg - SC * cg + YB
    length = math.hypot(xd - XC, yd - YC)
    pull = -STIFFNESS * (length - FREE_LENGTH) / length
    force = [
        MOTOR - m2 * DA * RR * dt * (dt + 2 * db) * st,
        m2 * DA * RR * db**2 * st,
        pull * ((xd - XC) * (SC * cg - SD * sg) + (yd - YC) * (SD * cg + SC * sg)),
        m4 * ZT * e * dd**2 * cp,
        -m4 * ZT * e * dp * (dp + 2 * dd) * cp,
        -m6 * U * f * de**2 * co,
        m6 * U * f * do * (do + 2 * de) * co,
    ]
    return mass, force


def _andrews_loops(y: list[float]) -> tuple[list[list[float]], list[float]]:
    """The slopes of the six constraints, and what their second derivatives are without accelerations.

    Every constraint is a sum of a cos(angle), with angles shifted by a quarter turn for a sine.
    """
    b, th, g, p, d, o, ep = range(7)
    arm = [(RR, (b,), 0.0), (-D, (b, th), 0.0)]
    quarter = math.pi / 2
    ends = [
        [(SS, (g,), quarter)],
        [(E, (p, d), quarter), (-ZT, (d,), 0.0)],
        [(-ZF, (o, ep), 0.0), (U, (ep,), quarter)],
    ]
    slopes, rest = [], []
    for end in ends:
        for turn in (0.0, -quarter):
            row, second = [0.0] * 7, 0.0
            for size, parts, shift in [*arm, *end]:
                angle, rate = sum(y[i] for i in parts) + shift + turn, sum(y[7 + i] for i in parts)
                for i in parts:
                    row[i] -= size * math.sin(angle)
                second -= size * rate**2 * math.cos(angle)
            slopes.append(row)
            rest.append(second)
    return slopes, rest
