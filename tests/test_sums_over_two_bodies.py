"""The forces on two bodies that are joined are summed along an axis, with the friction that is known by then."""

from __future__ import annotations

from pathlib import Path

from worked import page_of_text

PAIR = """
title: Two blocks by their weights
plane: vertical
given: {m_A: 2 kg, m_B: 3 kg, mu: 0.3}
points: {A: [0, 0], B: [1 m, 0]}
surfaces: {floor: {through: A, angle: 0 deg}}
bodies:
  left: {particle: A, mass: m_A}
  right: {particle: B, mass: m_B}
joints:
  - contact: {between: [left, floor], at: A, mu: mu}
  - contact: {between: [right, floor], at: B, mu: mu}
  - rope: {path: [A, B], name: cord}
loads:
  - force: {body: right, at: B, magnitude: 40 N, angle: 0 deg}
instant: [at rest]
find: {a: a(right).x, T: tension(cord)}
"""


def test_no_slant_is_sought_that_leaves_friction_out(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, PAIR)
    assert "left, right: (4) → ΣF_x: F - μ N_A - μ N_B = m_A a_A + m_B a_B" in page
    assert "common virtual motion" not in page
