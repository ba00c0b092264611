"""`--why NAME`: one answer with all on which it rests, of a motion also Newton's law behind its acceleration."""

from __future__ import annotations

from pathlib import Path

import pytest
from worked import page_of_text

SLED = """
title: A sled that is pulled
plane: vertical
given: {m: 40 kg, F: 200 N, beta: 30 deg, mu: 0.25, d: 6 m}
points: {P: [0, 0]}
surfaces: {floor: {through: P, angle: 0 deg}}
bodies: {sled: {particle: P, mass: m}}
joints:
  - contact: {between: [sled, floor], at: P, mu: mu}
loads:
  - force: {body: sled, magnitude: F, angle: beta}
states: {1: [t = 0, at rest], 2: [x(sled) = d]}
find: {v: v(sled).x @ 2, t_d: t @ 2, a: a(sled).x @ 1, N: N(P) @ 1}
"""
LAW, SUM, TIME = "F cos β - μ N_P = m a", "F sin β + N_P - m g = 0", "v_2 = a t_2"


@pytest.mark.parametrize(("why", "told", "untold"), [
    ("t_d", ["Principle Newton's second law. Constant acceleration.", LAW, SUM, TIME], []),
    ("v", [LAW, SUM], [TIME]),
    ("N", [SUM.replace("N_P", "N")], [LAW, TIME, "Constant acceleration"]),
])  # fmt: skip
def test_what_an_answer_rests_on(why: str, told: list[str], untold: list[str], tmp_path: Path) -> None:
    page = page_of_text(tmp_path, SLED, why)
    assert not [words for words in told if words not in page]
    assert not [words for words in untold if words in page]


def test_of_several_cases_one_is_told(tmp_path: Path) -> None:
    """Of the others it has no principle either."""
    harder = "cases: {harder: {given: {F: 300 N}, instant: [v(sled).x = 1 m/s], find: {b: a(sled).x}}}\n"
    page = page_of_text(tmp_path, SLED + harder, "b")
    assert "Principle Newton's second law. CASE harder" in page
