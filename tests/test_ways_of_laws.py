"""A law for a later span that gives a speed by its size: it goes on in the way in which the motion arrives."""

from __future__ import annotations

import math

import pytest
from answered import solve

TURNED_BACK = """
title: Particle that has turned round, and then keeps its speed
points: {O: [0, 0]}
bodies: {P: {particle: O}}
joints:
  - guide: {point: O, along: 0 deg}
motion:
  - a(P).x = -3 m/s^2 during 1->2
  - v(P).mag = SIZE during 2->3
states:
  1: [t = 0, v(P).x = 6 m/s]
  2: [t = 4 s]
  3: [t = 6 s]
find: {v: v(P).x @ 3, d: x(P) @ 3 - x(P) @ 2}
"""
ROD = """
title: Rod that has turned round, and the speed of its end then
plane: vertical
given: {L: 1.2 m}
points: {A: [0, 0], B: [0, -L]}
bodies: {rod: {rod: [A, B], mass: 2 kg}}
joints:
  - pin: {at: A, between: [ground, rod]}
motion:
  - alpha(rod) = -2 rad/s^2 during 1->2
  - v(B).mag = 7.2 m/s + (0.5 m/s^2)*(t - 5 s) during 2->3
states:
  1: [t = 0, omega(rod) = 4 rad/s]
  2: [t = 5 s]
  3: [t = 6 s]
find: {v: omega(rod) @ 3, d: theta(rod) @ 3 - theta(rod) @ 2}
"""


@pytest.mark.parametrize(
    ("text", "v", "d"),
    [
        (TURNED_BACK.replace("SIZE", "6 m/s"), -6, -12),
        (TURNED_BACK.replace("SIZE", "6 m/s").replace("2: [t = 4 s]", "2: [t = 4 s, v(P).x < 0]"), -6, -12),
        (TURNED_BACK.replace("SIZE", "18 m/s").replace("= -3 m", "= 3 m"), 18, 36),
        (TURNED_BACK.replace("SIZE", "(6 m/s)*exp((4 s - t)/(2 s))"), -6 / math.e, -12 * (1 - 1 / math.e)),
        (ROD, -6 - 0.5 / 1.2, -6 - 0.25 / 1.2),
    ],
)
def test_it_goes_on_as_it_arrives(text: str, v: float, d: float) -> None:
    found = solve(text)
    assert [float(found[name].values[0]) for name in ("v", "d")] == pytest.approx([v, d])
