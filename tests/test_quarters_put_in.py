"""Sine and cosine of an angle that a state fixes at a whole quarter of a turn, or at such from a letter, are put in."""

from __future__ import annotations

import pytest
import sympy as sp
from worked import page_of_file

from planar_cli.report.laws.zeros import _waves

PHI, BETA = sp.symbols("phi__1 beta", real=True)


@pytest.mark.parametrize(
    ("known", "found"),
    [
        (-sp.pi / 2, (-1, 0)),
        (sp.pi, (0, -1)),
        (BETA - sp.pi / 2, (-sp.cos(BETA), sp.sin(BETA))),
        (sp.atan2(-sp.cos(BETA), -sp.sin(BETA)), (-sp.cos(BETA), -sp.sin(BETA))),
        (sp.pi / 6, None),
        (BETA, None),
        (sp.asin(BETA), None),
    ],
)
def test_what_is_put_in(known: sp.Expr, found: tuple[sp.Expr, sp.Expr] | None) -> None:
    expected = {} if found is None else dict(zip((sp.sin(PHI), sp.cos(PHI)), found, strict=True))
    assert _waves(PHI, known) == expected


def test_the_lowest_place_of_a_bob() -> None:
    page = page_of_file("string-that-goes-slack")
    assert "At 1, in the given position: φ_B,1 = -90°" in page
    assert "v_B,1 = √(7 g l/2)" in page
    assert "U of the weight of bob = -m g l (1 + sin φ_B,2)" in page


def test_the_speed_of_what_moves_along_one_line_is_no_root() -> None:
    """Below its pivot the bar's centre moves along x, as the pivot does."""
    page = page_of_file("bar-that-swings-down-from-a-rolling-disk")
    assert "v_G,bar,2 = 1/2 l ω_bar,2 + R ω_disk,2" in page
