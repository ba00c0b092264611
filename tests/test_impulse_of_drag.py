"""The impulse of a drag over a span: what it takes of the momentum, less the impulses of the other forces."""

from __future__ import annotations

import math

import pytest
from answered import first, solve

THROWN = """
title: Puck that a drag slows
plane: horizontal
given: {c: 0.1 kg/m}
bodies: {P: {particle: [0, 0], mass: 2 kg}}
loads:
  - drag: {name: air, body: P, magnitude: c*v(P).mag^2}
states:
  1: [t = 0, v(P).x = 8 m/s, v(P).y = 0]
  2: [SECOND]
find: {J: impulse(air).x @ 1->2, W: work(air) @ 1->2, t: t @ 2}
"""
FALLS = """
title: Ball that falls through air
plane: vertical
unknowns: {c: kg/m}
bodies: {P: {particle: [0, 0], mass: 0.5 kg}}
loads:
  - drag: {name: air, body: P, magnitude: c*v(P).mag^2}
states:
  1: [t = 0, at rest]
  2: [t = 2 s, impulse(air).y @ 1->2 = 3 N*s]
find: {c: c, v: v(P).mag @ 2}
"""


@pytest.mark.parametrize("second", ["impulse(air).x @ 1->2 = -8 N*s", "work(air) @ 1->2 = -48 J", "t = 2.5 s"])
def test_each_tells_the_state(second: str) -> None:
    """1/v = 1/v₁ + c t/m: at 2.5 s it is half as fast."""
    found = solve(THROWN.replace("SECOND", second))
    assert first(found["J"]) == pytest.approx(-8)
    assert first(found["W"]) == pytest.approx(-48)
    assert first(found["t"]) == pytest.approx(2.5)


def test_tells_the_coefficient() -> None:
    """v = g t - J/m = √(m g/c) tanh(t √(c g/m))."""
    found = solve(FALLS)
    c, v = first(found["c"]), first(found["v"])
    assert v == pytest.approx(2 * 9.81 - 6)
    assert v == pytest.approx(math.sqrt(0.5 * 9.81 / c) * math.tanh(2 * math.sqrt(c * 9.81 / 0.5)))
