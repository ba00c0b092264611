"""Contacts that begin in a later state: a line or a circle that is met on the way, where it is nearest."""

from __future__ import annotations

import math

import pytest
from answered import solve

from planar_cli.errors import PlanarError

G = 9.81
BOWL = """
title: Ball that slides down a bowl, and then along a rough floor
plane: vertical
given: {m: 2 kg, R: 1.5 m, mu: 0.2}
points: {C: [0, R], A: [-R, R], B: [0, 0]}
surfaces: {bowl: {center: C, radius: R}, floor: {through: B, angle: 0 deg}}
bodies: {ball: {particle: A, mass: m}}
joints:
  - contact: {between: [ball, bowl], at: A, mu: 0, during: 1->2, name: first}
  - contact: {between: [ball, floor], mu: mu, during: 2->3, name: second}
states: {1: [t = 0, at rest], 2: [x(ball) = 0], 3: [v(ball).x = 0]}
find: {v: v(ball).mag @ 2, N: N(second) @ 2, d: x(ball) @ 3}
"""
RAMP = """
title: Block that slides along a rough floor, and then up a circular ramp
plane: vertical
given: {m: 2 kg, R: 1.5 m, mu: 0.2, d: 1 m, v_0: 5 m/s}
points: {C: [0, R], A: [-d, 0], B: [0, 0]}
surfaces: {ramp: {center: C, radius: R}, floor: {through: B, angle: 0 deg}}
bodies: {block: {particle: A, mass: m}}
joints:
  - contact: {between: [block, floor], at: A, mu: mu, during: 1->2, name: first}
  - contact: {between: [block, ramp], mu: 0, during: 2->3, name: second}
states: {1: [t = 0, v(block).x = v_0], 2: [x(block) = 0], 3: [v(block).mag = 0]}
find: {v: v(block).mag @ 2, N: N(second) @ 2, h: y(block) @ 3}
"""


def _first(text: str) -> dict[str, float]:
    return {name: float(f.values[0]) for name, f in solve(text).items() if f.values}


def test_a_bowl_and_then_a_floor() -> None:
    """v² = 2 g R, and d = v²/(2 μ g)."""
    found = _first(BOWL)
    assert found == pytest.approx({"v": math.sqrt(2 * G * 1.5), "N": 2 * G, "d": 1.5 / 0.2})


def test_a_floor_and_then_a_ramp() -> None:
    """v² = v_0² - 2 μ g d; just after it N = m g + m v²/R; h = v²/(2 g)."""
    square = 25 - 2 * 0.2 * G
    expected = {"v": math.sqrt(square), "N": 2 * (G + square / 1.5), "h": square / (2 * G)}
    assert _first(RAMP) == pytest.approx(expected)


def test_a_force_of_a_contact_that_is_over() -> None:
    """What is asked at a state where something changes is asked of what begins."""
    with pytest.raises(PlanarError, match="first does not act then"):
        solve(BOWL.replace("N(second)", "N(first)"))
