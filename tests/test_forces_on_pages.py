"""Forces on a page: what the diagrams hold, and where the normal forces of the checks come from."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking import read, solve_and_compare
from planar_cli.report.narrate import narrate


def _page(name: str) -> str:
    return Terminal(width=110).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))


@pytest.mark.parametrize(
    ("name", "row"),
    [
        ("friction/heaviest-weight-before-a-box-slips", "load:  m_load g ↓,  T_cord ↑   =   m_load a_Hy ↑\n"),
        ("particles/unknown-counterweight", "weight:  m_B g ↓,  T_cord ↑   =   m_B a_By ↑\n"),
    ],
)
def test_an_acceleration_that_is_zero_is_not_drawn(name: str, row: str) -> None:
    """What hangs has no acceleration along which nothing acts."""
    assert row in _page(name)


def test_a_normal_force_of_a_check_has_its_sum_of_forces() -> None:
    page = _page("friction/heaviest-weight-before-a-box-slips")
    assert "N_A = m_cart g + N_B = 42 lbf > 0" in page
    assert " · N_B = 12 lbf > 0" in page
    assert "N_C = m g = 490.5 N > 0" in _page("textbook/ex-4-05")


def test_a_limit_speaks_of_the_extreme_that_is_asked() -> None:
    page = _page("friction/heaviest-weight-before-a-box-slips")
    assert "At the largest W: friction at B reaches its limit, it is about to slip:" in page


@pytest.mark.parametrize(
    ("name", "rows"),
    [
        # The ball starts at the lowest point to the right; the pole falls to the right.
        ("energy/ball-that-just-rolls-round-a-loop", ["N_K ↖ at C,  F_K ↗ at C", "    (1)  ↖ ΣF:   N_K - m g"]),
        ("energy/toppling-pole-that-stops-pressing", ["1/2 m l α ↖ at G,  1/2 m l ω² ↙ at G"]),
    ],
)
def test_arrows_are_those_of_a_position_that_occurs(name: str, rows: list[str]) -> None:
    page = _page(name)
    assert all(row in page for row in rows)


BOWL = """\
title: Particle let go at a rim of a bowl
plane: vertical
given: {R: 0.8 m, m: 0.5 kg}
points: {O: [0, 0], P: [%sR, 0]}
surfaces: {bowl: {center: O, radius: R}}
bodies: {P: {particle: P, mass: m}}
joints: [{guide: {point: P, along: bowl}}]
states:
  1: [at rest]
  2: ["y(P) = -R*sin(45 deg)"]
find: {N: N(P) @ 2}
"""


@pytest.mark.parametrize(("side", "row"), [("", "↖"), ("-", "↗")])
def test_the_side_on_which_a_body_slides_down_tells_the_arrows(tmp_path: Path, side: str, row: str) -> None:
    file = tmp_path / "bowl.yaml"
    file.write_text(BOWL % side)
    page = Terminal(width=110).render(narrate(solve_and_compare(read(str(file)), None)[0]))
    assert f"P:  m g ↓,  N_P {row}   =   m a_Pt" in page
    assert f"(1)  {row} ΣF:   m g sin φ_P + N_P = m v_P²/R" in page


def test_a_rope_that_keeps_its_end_at_rest() -> None:
    """Why the end has no acceleration at all, the vector once, and a check by moments about the mass centre."""
    page = _page("rigid-bodies/beam-on-two-ropes")
    assert "no force acts across the rope A, and A has no acceleration along it:" in page
    assert "a_B along y" not in page
    assert "Check       beam: ↺ ΣM_G = -44.145 N·m, I α = -44.145 N·m · " in page


def test_a_check_by_moments_needs_no_force_through_the_centre() -> None:
    assert "spool: ↺ ΣM_G = -30 + 17.63 = -12.37 N·m, I_G α = -12.37 N·m" in _page("textbook/ex-4-05")
