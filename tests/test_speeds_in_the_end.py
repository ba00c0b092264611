"""A speed that is only approached, with drag: a coefficient that is sought for it, and states that speak of it."""

from __future__ import annotations

import math

import pytest
from answered import first, solve

FALL = """
title: Parachutist who falls from rest
plane: vertical
{head}
bodies: {{P: {{particle: [0, 0], mass: 80 kg}}}}
loads:
  - drag: {{body: P, {drag}}}
states:
  1: [t = 0, at rest]
  2: [t = infinity{ends}]
  3: [v(P).mag = 0.9*v(P).mag @ 2]
find: {{{find}}}
"""
WEIGHT = 80 * 9.81


@pytest.mark.parametrize("drag", ["magnitude: c*v(P).mag", "magnitude: (2*c)*v(P).mag/2", "linear: c"])
def test_resistance_in_proportion_to_the_speed_is_not_negative(drag: str) -> None:
    found = solve(FALL.format(head="unknowns: {c: kg/s}", drag=drag, ends=", v(P).mag = 6 m/s", find="c: c, t: t @ 3"))
    c = WEIGHT / 6
    assert first(found["c"]) == pytest.approx(c)
    assert first(found["t"]) == pytest.approx(80 / c * math.log(10))


@pytest.mark.parametrize("drag", ["magnitude: 0.25 kg/m * v(P).mag^2", "quadratic: 0.25 kg/m"])
def test_a_state_may_speak_of_a_later_one_that_is_only_approached(drag: str) -> None:
    found = solve(FALL.format(head="", drag=drag, ends="", find="t: t @ 3, y: y(P) @ 3, v: v(P).mag @ 2"))
    v = math.sqrt(WEIGHT / 0.25)
    assert first(found["v"]) == pytest.approx(v)
    assert first(found["t"]) == pytest.approx(v / 9.81 * math.atanh(0.9))
    assert first(found["y"]) == pytest.approx(v * v / (2 * 9.81) * math.log(1 - 0.9**2))
