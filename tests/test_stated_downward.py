"""A weight whose acceleration is stated downward counts so: m_B g - T = m_B a_B."""

from __future__ import annotations

from pathlib import Path

from conftest import PROBLEMS
from worked import page_of_text

(FILE,) = (p for p in PROBLEMS if p.stem == "unknown-counterweight")
TEXT = FILE.read_text(encoding="utf-8").partition("answers:")[0]


def test_a_weight_that_is_said_to_go_down(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, TEXT)
    assert "a_B = 1.2 m/s² given" in page
    assert "weight: m_B g ↓, T ↑ = m_B a_B ↓" in page
    assert "m_B = T/(g - a_B) = 36.63/(9.81 - 1.2) = 4.254 kg" in page


def test_what_is_asked_along_the_axis_keeps_it(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, TEXT.replace("mass_B: m_B", "mass_B: m_B, a: a(B).y"))
    assert "T ↑ = m_B a_By ↑" in page


def test_what_is_said_to_go_up_counts_upward(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, TEXT.replace("= -1.2 m/s^2", "= 1.2 m/s^2"))
    assert "T ↑ = m_B a_By ↑" in page


CAGE = """
title: Cage let down
plane: vertical
given: {m: 100 kg}
unknowns: {F: N}
bodies:
  cage: {particle: [0, 0], mass: m}
loads:
  - force: {body: cage, magnitude: F, angle: 90 deg}
instant: [at rest, a(cage).y = -2 m/s^2]
find: {F: F}
"""


def test_the_only_body_is_said_to_count_downward(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, CAGE)
    assert "at rest, a = -2 m/s²" in page
    assert "a = 2 m/s² a counts downward; given" in page
