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
