"""The woodpecker toy: a sleeve on a pole, a bird on a spring, three contacts with friction, impacts and jamming.

C. Glocker, Dynamik von Starrkörpersystemen mit Reibung und Stößen (1995); numbers as in the examples of Siconos.
Coordinates (y, φ_M, φ_S), transformed so that the mass matrix is the unit matrix.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import pytest
from automata import Always, Condition, Law, Scene, modes

from planar_cli.integrators.base import Setting
from planar_cli.motion.follow.follow import Follower
from planar_cli.motion.terms.complementarity import solved
from planar_cli.motion.trajectory.automaton import Choice, Start
from planar_cli.motion.trajectory.impact import StruckContact
from planar_cli.motion.trajectory.schedule import Schedule

GRAVITY, MU = 9.81, 0.3
R_O, R_M, H_M, L_M, L_G, H_S, L_S = 0.0025, 0.0031, 0.0058, 0.010, 0.015, 0.02, 0.0201
M_M, M_S, J_M, J_S, C = 0.0003, 0.0045, 5e-9, 7e-7, 0.0056
MASSES = [
    [M_S + M_M, M_S * L_M, M_S * L_G],
    [M_S * L_M, J_M + M_S * L_M**2, M_S * L_M * L_G],
    [M_S * L_G, M_S * L_M * L_G, J_S + M_S * L_G**2],
]
NORMALS = ([0.0, 0.0, -H_S], [0.0, H_M, 0.0], [0.0, -H_M, 0.0])
GAPS = (L_M + L_G - L_S - R_O, R_M - R_O, R_M - R_O)
TANGENTS = ([1.0, L_M, L_G - L_S], [1.0, R_M, 0.0], [1.0, R_M, 0.0])
RESTITUTION = (0.5, 0.0, 0.0)
NAMES = ("beak", "lower", "upper")
START = ((0.0, -(R_M - R_O) / H_M, -0.2788), (-0.3411, 0.0, -7.4583))
APART, STICK, UP, DOWN = range(4)


def factor() -> list[list[float]]:
    """L with M = L Lᵀ."""
    low = [[0.0] * 3 for _ in range(3)]
    for i in range(3):
        for j in range(i + 1):
            rest = MASSES[i][j] - sum(low[i][k] * low[j][k] for k in range(j))
            low[i][j] = math.sqrt(rest) if i == j else rest / low[j][j]
    return low


LOWER = factor()


def inward(w: Sequence[float]) -> list[float]:
    """A generalized force in the new coordinates: L⁻¹ w."""
    found: list[float] = []
    for i in range(3):
        found.append((w[i] - sum(LOWER[i][k] * found[k] for k in range(i))) / LOWER[i][i])
    return found


def onward(q: Sequence[float]) -> list[float]:
    """Coordinates or rates in the new coordinates: Lᵀ q."""
    return [sum(LOWER[k][i] * q[k] for k in range(3)) for i in range(3)]


def back(z: Sequence[float]) -> list[float]:
    """The old coordinates."""
    transposed = [[LOWER[k][i] for k in range(3)] for i in range(3)]
    found = solved(transposed, list(z))
    assert found is not None
    return found


N, T = [inward(w) for w in NORMALS], [inward(w) for w in TANGENTS]


def dot(a: Sequence[float], b: Sequence[float]) -> float:
    return sum(x * y for x, y in zip(a, b, strict=True))


def free(y: Sequence[float]) -> list[float]:
    """Accelerations without contacts."""
    _, sleeve, bird = back(y[:3])
    twist = C * (sleeve - bird)
    return inward([-(M_S + M_M) * GRAVITY, -twist - M_S * GRAVITY * L_M, twist - M_S * GRAVITY * L_G])


def gap(k: int, y: Sequence[float]) -> float:
    return GAPS[k] + dot(N[k], y[:3])


def speed(k: int, y: Sequence[float]) -> float:
    return dot(T[k], y[3:])


def forces(choice: Choice, y: Sequence[float]) -> tuple[list[float], dict[int, tuple[float, float]]]:
    """Accelerations, and normal and friction force of every contact."""
    columns, rows, base = [], [], free(y)
    for k, mode in enumerate(choice):
        if mode == STICK:
            columns += [N[k], T[k]]
            rows += [N[k], T[k]]
        elif mode != APART:
            friction = -MU if mode == UP else MU
            columns.append([a + friction * b for a, b in zip(N[k], T[k], strict=True)])
            rows.append(N[k])
    matrix = [[dot(row, column) for column in columns] for row in rows]
    sizes = solved(matrix, [-dot(row, base) for row in rows])
    # Contacts that hold each other in two ways: their forces are not determined.
    values = iter(sizes if sizes is not None else [math.nan] * len(rows))
    found: dict[int, tuple[float, float]] = {}
    for k, mode in enumerate(choice):
        if mode == STICK:
            found[k] = (next(values), next(values))
        elif mode != APART:
            n = next(values)
            found[k] = (n, (-MU if mode == UP else MU) * n)
    total = list(base)
    for k, (n, f) in found.items():
        total = [a + n * x + f * z for a, x, z in zip(total, N[k], T[k], strict=True)]
    return total, found


WEIGHT = (M_S + M_M) * GRAVITY


def laws(choice: Choice) -> Law:
    conditions: list[Condition] = []
    for k, mode in enumerate(choice):
        name = NAMES[k]
        if mode == APART:
            conditions.append(Condition(name, "gap", f"{name} apart", lambda t, y, k=k: gap(k, y), scale=0.01))
            continue

        def pressing(t: float, y: Sequence[float], k: int = k) -> float:
            return forces(choice, y)[1][k][0]

        conditions.append(Condition(name, "presses", f"{name} presses", pressing, scale=WEIGHT))
        if mode == STICK:
            for s in (1, -1):

                def within(t: float, y: Sequence[float], k: int = k, s: int = s) -> float:
                    n, f = forces(choice, y)[1][k]
                    return MU * n + s * f

                conditions.append(Condition(name, "limit", f"{name} sticks", within, scale=WEIGHT))
        else:
            sense = 1 if mode == UP else -1

            def slips(t: float, y: Sequence[float], k: int = k, sense: int = sense) -> float:
                return sense * speed(k, y)

            conditions.append(Condition(name, "slips", f"{name} slips", slips, True, 0.3))

    def mend(t: float, y: Sequence[float]) -> list[float]:
        place, rate = list(y[:3]), list(y[3:])
        held = [(N[k], GAPS[k]) for k, mode in enumerate(choice) if mode != APART]
        place = moved(place, held)
        rows = [row for row, _ in held] + [T[k] for k, mode in enumerate(choice) if mode == STICK]
        return [*place, *moved(rate, [(row, 0.0) for row in rows])]

    return Law(lambda t, y: forces(choice, y)[0], tuple(conditions), mend, energy)


def moved(z: list[float], held: list[tuple[list[float], float]]) -> list[float]:
    """The nearest point at which row · z + constant = 0 for all of them; redundant ones left out."""
    matrix = [[dot(a, b) for b, _ in held] for a, _ in held]
    sizes = solved(matrix, [-dot(a, z) - c for a, c in held])
    if sizes is None:
        return moved(z, held[:-1])
    for (row, _), size in zip(held, sizes, strict=True):
        z = [a + size * b for a, b in zip(z, row, strict=True)]
    return z


def energy(t: float, y: Sequence[float]) -> float:
    height, sleeve, bird = back(y[:3])
    stored = (M_S + M_M) * GRAVITY * height + M_S * GRAVITY * (L_M * sleeve + L_G * bird) + C * (sleeve - bird) ** 2 / 2
    return dot(y[3:], y[3:]) / 2 + stored


def contacts(choice: Choice, t: float, y: Sequence[float]) -> list[StruckContact]:
    return [
        StruckContact(NAMES[k], tuple(N[k]), 0.0, tuple(T[k]), 0.0, RESTITUTION[k], MU)
        for k in range(3)
        if choice[k] != APART or abs(gap(k, y)) <= 1e-10
    ]


@dataclass(frozen=True)
class Toy(Scene):
    """With what each contact misses."""

    def misfits(self, choice: Choice, t: float, y: Sequence[float]) -> Mapping[str, float]:
        found = {}
        for k, mode in enumerate(choice):
            if mode != APART:
                rates = [dot(N[k], y[3:]), speed(k, y) if mode == STICK else 0.0]
                found[NAMES[k]] = max(abs(gap(k, y)) / 0.01, *(abs(v) / 0.3 for v in rates))
        return found


def test_the_woodpecker_comes_down_in_jerks() -> None:
    """One cycle takes 0.1460 s and 19.45 mm."""
    scale = (*([0.001] * 3), *([0.05] * 3))
    names = dict.fromkeys(NAMES, modes("apart", "stick", "slip", "slip"))
    scene = Toy(names, laws, (1.0,) * 3, scale, contacts, time_scale=0.01, energy_scale=1e-4)
    start = Start(0.0, (*onward(START[0]), *onward(START[1])))
    found = Follower(Always(scene), start, Schedule(), 1.5, Setting(scale, 1e-9), check=False).trajectory()
    assert found.outcome.kind == "until"
    beats = [x for x in found.transitions if "beak" in x.impulses]
    assert len(beats) == 10
    # Two cycles: one is a little shorter, the next a little longer than those to which they tend.
    last, before = beats[-1], beats[-3]
    assert (last.t - before.t) / 2 == pytest.approx(0.1460, abs=5e-5)
    drop = back(before.before[:3])[0] - back(last.before[:3])[0]
    assert drop / 2 == pytest.approx(0.01945, abs=5e-6)
