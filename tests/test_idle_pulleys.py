"""Light pulleys that only ropes hold: what nothing drives does not matter; ropes drawn beside where they run."""

from __future__ import annotations

import pytest
from answered import solve

BLOCKS = """
title: Three weights and a movable pulley without mass
plane: vertical
given: {m_A: 10 kg, m_B: 6 kg, m_C: 3 kg}
points: {A: [0, -2 m], D: [0.4 m, 0], E: [0.8 m, -1 m], B: [0.8 m, -2 m], C: [1.6 m, -2 m]}
bodies:
  A: {particle: A, mass: m_A}
  pulley: {particle: E, mass: 0}
  B: {particle: B, mass: m_B}
  C: {particle: C, mass: m_C}
joints:
  - rope: {path: [A, D, E], along: 90 deg, name: upper}
  - rope: {path: [B, E, C], along: 90 deg, name: lower}
states: {1: [t = 0, at rest], 2: [t = 1 s]}
find: {s: y(A) @ 2 - y(A) @ 1, T: tension(upper) @ 2}
"""


def test_three_weights_and_a_light_pulley() -> None:
    """The lower pair weighs like M = 4 m_B m_C/(m_B + m_C) = 8 kg: a = (M - m_A) g/(M + m_A), T = m_A (g + a)."""
    part = solve(BLOCKS)
    a = (8 - 10) * 9.81 / (8 + 10)
    assert [float(part[n].values[0]) for n in ("s", "T")] == pytest.approx([a / 2, 10 * (9.81 + a)])
