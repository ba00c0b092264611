"""Motions with a mass that grows or shrinks in time, in letters: speed and way by the integrating factor."""

from __future__ import annotations

import math

import pytest
import sympy as sp
from answered import solve

NUMBERS = {"M": 2.0, "q": 0.3, "P": 5.0, "k": 0.7, "u": 4.0, "w": 1.5, "g": 9.81, "T": 1.7}
STREAM = {
    "falls in": "  - stream: {body: car, rate: q, enters: {at: A, speed: v(car).x, angle: 180 deg}}",
    "leaks": "  - stream: {body: car, rate: q, leaves: {at: A, speed: 0 m/s, angle: -90 deg}}",
    "is thrown out": "  - stream: {body: car, rate: q, leaves: {at: A, speed: u, angle: 180 deg}}",
}
PULL = "  - force: {body: car, magnitude: P, angle: 0 deg}"
AIR = "  - drag: {body: car, magnitude: k*v(car).mag}"


def car(mass: str, loads: list[str], start: str, letters: str, plane: str = "horizontal", along: str = "0 deg") -> str:
    return "\n".join([
        "title: Car of changing mass",
        f"plane: {plane}",
        f"symbols: {{M: kg, q: kg/s, T: s, {letters}}}",
        "points: {A: [0, 0]}",
        f"bodies: {{car: {{particle: A, mass: {mass}}}}}",
        "joints:",
        f"  - guide: {{point: A, along: {along}}}",
        "loads:",
        *loads,
        f"states: {{1: [t = 0, {start}], 2: [t = T]}}",
        "find: {v: v(car).x @ 2, d: x(car) @ 2}",
    ])  # fmt: skip


def followed(sign: float, stream: float, pull: float, drag: float, v: float) -> tuple[float, float]:
    """Speed and way after T, step by step: dv/dt = (pull + stream q - drag v)/(M ± q t)."""
    mass, rate, steps = NUMBERS["M"], NUMBERS["q"], 4000
    h, x = NUMBERS["T"] / steps, 0.0

    def a(t: float, speed: float) -> float:
        return (pull + stream - drag * speed) / (mass + sign * rate * t)

    for i in range(steps):
        t = i * h
        k1 = a(t, v)
        k2 = a(t + h / 2, v + h / 2 * k1)
        k3 = a(t + h / 2, v + h / 2 * k2)
        k4 = a(t + h, v + h * k3)
        x += h * (v + h / 6 * (k1 + k2 + k3))
        v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return v, x


@pytest.mark.parametrize(("text", "truth"), [
    (car("M + q*t", [PULL, STREAM["falls in"]], "at rest", "P: N"), followed(1, 0, 5, 0.3, 0)),
    (car("M + q*t", [STREAM["falls in"]], "v(car).x = w", "w: m/s"), followed(1, 0, 0, 0.3, 1.5)),
    (car("M + q*t", [PULL, AIR, STREAM["falls in"]], "at rest", "P: N, k: N*s/m"), followed(1, 0, 5, 1.0, 0)),
    (car("M - q*t", [PULL, STREAM["leaks"]], "at rest", "P: N"), followed(-1, 0, 5, 0, 0)),
    (car("M - q*t", [AIR, STREAM["is thrown out"]], "at rest", "u: m/s, k: N*s/m"), followed(-1, 1.2, 0, 0.7, 0)),
    (car("M - q*t", [PULL, AIR, STREAM["leaks"]], "v(car).x = w", "P: N, k: N*s/m, w: m/s"),
     followed(-1, 0, 5, 0.7, 1.5)),
])  # fmt: skip
def test_speed_and_way_of_a_changing_mass(text: str, truth: tuple[float, float]) -> None:
    found = solve(text)
    for name, want in zip(("v", "d"), truth, strict=True):
        (formula,) = found[name].expressions
        value = formula.xreplace({s: sp.Float(NUMBERS[s.name]) for s in formula.free_symbols})
        assert math.isclose(float(value), want, rel_tol=1e-6), (name, formula)
