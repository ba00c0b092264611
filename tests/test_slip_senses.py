"""What begins to slip does so against the friction drawn; what slides on a body has its own acceleration by itself."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import PROBLEMS
from worked import page_of_file, page_of_text

LADDER = "a_B = -l α cos β = -4 · 1.299 cos 50° = -3.340 m/s² < 0: ladder slides at B downward, against its friction"
SPOOL = "a_C = a_G + R α = 4.5285 + 0.4 · 9.782 = 8.441 m/s² > 0: spool slides at C to the right, against its friction"
BLOCKS = "a_A - a_B = 2.943 - 7.8165 = -4.8735 m/s² < 0: upper slides on lower to the left, against its friction"
WALL = """
title: Block pushed along a wall on a table
plane: horizontal
given: {m: 4 kg, beta: 35 deg, mu: 0.2, N: 30 N, P: 20 N}
points: {A: [0, 0]}
surfaces: {wall: {through: A, angle: beta}}
bodies: {block: {particle: A, mass: m}}
joints:
  - contact: {between: [block, wall], at: A, mu: mu}
loads:
  - force: {body: block, at: A, magnitude: N, angle: beta - 90 deg}
  - force: {body: block, at: A, magnitude: P, angle: beta}
instant: [at rest]
find: {slips: mode(A) = slip, a: a(block).along(beta)}
"""


@pytest.mark.parametrize(
    ("name", "line"),
    [
        ("spool-rolls-or-slips", SPOOL),
        ("stacked-blocks", BLOCKS),
        ("ladder-sliding", LADDER),
        ("ladder-sliding", "slides: it slips, at A to the right"),
        ("stacked-blocks", "upper_90: upper slides on lower, to the left relative to it"),
        ("two-blocks-joined-by-a-cord", "a_A = -3.859 m/s² < 0: upper slides down the slope, against its friction"),
    ],
)
def test_the_sense_of_a_slip_is_told(name: str, line: str) -> None:
    assert line in page_of_file(name)


def test_what_slides_on_a_body_has_its_acceleration_by_its_own_forces() -> None:
    page = page_of_file("stacked-blocks")
    assert "a_A = μ_A N_A/m_A = μ_A g = 0.3 · 9.81 = 2.943 m/s²" in page
    assert "a_A,lower" not in page


def test_its_component_is_that_of_its_acceleration_along_a_slope(tmp_path: Path) -> None:
    (path,) = (p for p in PROBLEMS if p.stem == "stacked-blocks")
    text = path.read_text(encoding="utf-8").partition("cases:")[0]
    page = page_of_text(tmp_path, text.replace("angle: 0 deg", "angle: 20 deg"))
    assert "a_A = (μ_A N_A - m_A g sin 20°)/m_A" in page
    assert "a_A in the sense → = a_A cos 20° = -0.5897 cos 20° = -0.5541 m/s²" in page
    assert "upper: → ΣF_x = -15.7644 + 12.9937 = -2.771 N, m_A a_A cos 20° = -2.771 N" in page
    assert "a_A,lower" not in page


def test_nothing_is_said_of_what_does_not_slip() -> None:
    assert "against its friction" not in page_of_file("crate-on-cart")


def test_a_wall_on_a_level_table_is_no_slope(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, WALL)
    assert "block slides at 35° above +x, against its friction" in page
    assert "the slope" not in page
