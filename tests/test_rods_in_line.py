"""The end of a rod strikes that of another which lies in the same line."""

from __future__ import annotations

import pytest
from answered import assert_close, solve

RODS = """
title: A swinging rod strikes the end of another
plane: vertical
given: {e: 0.4}
points: {A: [0, 0], B: [0, -0.8 m], D: [0, -0.8 m], E: [0, -1.8 m]}
bodies:
  AB: {rod: [A, B], mass: 2 kg}
  DE: {rod: [D, E], mass: 3 kg}
joints:
  - pin: {at: A, between: [ground, AB]}
  - pin: {at: E, between: [ground, DE]}
  - impact: {between: [AB, DE], at: B, normal: 0 deg, restitution: e, during: 1->2}
states:
  1: [omega(AB) = 5 rad/s, omega(DE) = 0]
  2: [just after 1]
find: {of_AB: omega(AB) @ 2, of_DE: omega(DE) @ 2}
"""
SWINGING = """
title: A rod that swings down strikes the end of another
plane: vertical
points: {A: [0, 0], B: [0.9 m, 0], D: [0, -0.9 m], E: [0, -1.2 m]}
bodies:
  AB: {rod: [A, B], mass: 2 kg}
  DE: {rod: [D, E], mass: 3 kg}
joints:
  - pin: {at: A, between: [ground, AB]}
  - pin: {at: E, between: [ground, DE]}
  - impact: {between: [AB, DE], at: B, normal: 0 deg, restitution: 0, during: 2->3}
states:
  1: [at rest]
  2: [theta(AB) = -90 deg]
  3: [just after 2]
find: {of_AB: omega(AB) @ 3, of_DE: omega(DE) @ 3}
"""


def after(speed: float, m: float, length: float, others: float, long: float, e: float) -> tuple[float, float]:
    """I_A (ω - ω′) = J l,  I_E Ω = -J L,  -L Ω - l ω′ = e l ω: ω′ and Ω of the two rods."""
    one, two = m * length**2 / 3, others * long**2 / 3
    blow = (1 + e) * length * speed / (length**2 / one + long**2 / two)
    return speed - blow * length / one, -blow * long / two


@pytest.mark.parametrize("text", [RODS, RODS.replace("[AB, DE], at", "[DE, AB], at"), RODS.replace("at: B,", "at: D,")])
def test_as_drawn(text: str) -> None:
    found = solve(text)
    one, two = after(5, 2, 0.8, 3, 1, 0.4)
    assert_close(found["of_AB"], one, 9)
    assert_close(found["of_DE"], two, 9)


def test_after_a_swing() -> None:
    found = solve(SWINGING)
    one, two = after(-((3 * 9.81 / 0.9) ** 0.5), 2, 0.9, 3, 0.3, 0)
    assert_close(found["of_AB"], one, 9)
    assert_close(found["of_DE"], two, 9)
