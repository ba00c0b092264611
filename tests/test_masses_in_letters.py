"""A mass that is a multiple of a letter of the file is written so wherever it stands: 4 m g, 1/12 (3 m) l²."""

from __future__ import annotations

from pathlib import Path

from worked import page_of_file, page_of_text

ATWOOD = """\
title: Two blocks on a rope
plane: vertical
symbols: {m: kg}
points: {Q: [1 m, 0]}
bodies: {a: {particle: [0, -1 m], mass: 4*m}, b: {particle: [2 m, -1 m], mass: m}}
joints:
  - rope: {path: [a, over Q, b], along: 90 deg}
instant: [at rest]
find: {a_a: a(a).y}
"""


def test_in_equations(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, ATWOOD)
    assert "4 m g ↓" in page
    assert "- 4 m g = 4 m a_ay" in page


def test_in_a_moment_of_inertia() -> None:
    assert "I_rod = 1/12 (3 m) l² = 1/4 m l²" in page_of_file("collar-let-loose-on-a-turning-rod")
