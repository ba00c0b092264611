"""What is assumed of an unknown selects among the roots, at an instant as in a motion."""

from __future__ import annotations

from math import atan

import pytest
from answered import first, solve

AT_AN_INSTANT = """
title: A rod whose end is at a height
plane: vertical
given: {l: 1 m}
unknowns: {phi: deg}
assume: [phi > 90 deg]
points: {O: [0, 0], B: {from: O, distance: l, angle: phi}}
bodies: {OB: {rod: [O, B], mass: 2 kg}}
joints: [{pin: {at: O, between: [ground, OB]}}]
instant: [at rest, y(B) = 0.5 m]
find: {phi: phi}
"""

THROWN = """
title: A throw at a target
plane: vertical
given: {v0: 50 m/s, h: 20 m, d: 150 m}
unknowns: {alpha: deg}
assume: [alpha %s 50 deg]
bodies: {ball: {particle: [0, 0], mass: any}}
states:
  A: [t = 0, v(ball).mag = v0, v(ball).angle = alpha]
  B: [x(ball) = d, y(ball) = h]
find: {alpha: alpha}
"""


def test_at_an_instant() -> None:
    assert first(solve(AT_AN_INSTANT)["phi"]) == pytest.approx(2.617993877991494)


@pytest.mark.parametrize("sign", [">", "<"])
def test_in_a_motion(sign: str) -> None:
    # h = d tan α - g d²/(2 v0² cos² α): a quadratic equation for tan α.
    c = 9.81 * 150**2 / (2 * 50**2)
    root = (150**2 - 4 * c * (c + 20)) ** 0.5
    found = first(solve(THROWN % sign)["alpha"])
    assert found == pytest.approx(atan((150 + (root if sign == ">" else -root)) / (2 * c)))
