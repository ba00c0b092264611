"""A rotation that enters no force is left out of the freedoms of a small oscillation."""

from __future__ import annotations

import math

import pytest
from answered import solve

ON_A_GUIDE = """
title: A disk between two springs, free to turn
plane: horizontal
given: {m: 2 kg, k: 50 N/m, R: 0.2 m}
points: {O: [0, 0], G: [0.5 m, 0], E: [1 m, 0]}
bodies: {d: {disk: G, radius: R, mass: m}}
joints: [{guide: {point: G, along: 0 deg}}]
loads:
  - spring: {between: [O, G], stiffness: k, natural_length: 0.5 m}
  - spring: {between: [G, E], stiffness: k, natural_length: 0.5 m}
states: {eq: [equilibrium]}
find: {T: period(eq), s: stable(eq)}
"""

AT_A_ROD = """
title: A disk that turns freely at the end of a light pendulum
plane: vertical
given: {m: 2 kg, l: 0.8 m, R: 0.2 m}
points: {O: [0, 0], A: [0, -l]}
bodies:
  rod: {rod: [O, A]}
  d: {disk: A, radius: R, mass: m}
joints:
  - pin: {at: O, between: [ground, rod]}
  - pin: {at: A, between: [rod, d]}
states: {eq: [equilibrium]}
find: {T: period(eq), s: stable(eq)}
"""

TWO_PENDULUMS = """
title: Two pendulums have two periods
plane: vertical
points: {O: [0, 0], A: [0, -1 m], Q: [3 m, 0], B: [3 m, -2 m]}
bodies:
  a: {rod: [O, A], mass: 1 kg}
  b: {rod: [Q, B], mass: 1 kg}
joints:
  - pin: {at: O, between: [ground, a]}
  - pin: {at: Q, between: [ground, b]}
states: {eq: [equilibrium]}
find: {T: period(eq)}
"""


@pytest.mark.parametrize(("text", "period"), [(ON_A_GUIDE, math.sqrt(2 / 100)), (AT_A_ROD, math.sqrt(0.8 / 9.81))])
def test_a_disk_that_turns_freely(text: str, period: float) -> None:
    found = solve(text)
    assert float(found["T"].values[0]) == pytest.approx(2 * math.pi * period)
    assert found["s"].word == "true"


def test_a_rotation_that_meets_a_force_is_a_freedom() -> None:
    told = solve(TWO_PENDULUMS)["T"].values
    assert told is not None
    assert [float(v) for v in told] == pytest.approx([2 * math.pi * math.sqrt(2 * x / (3 * 9.81)) for x in (2, 1)])
