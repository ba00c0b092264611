"""What moves along a fixed curve: a constant speed, y′ and y″ by x, unit vectors, numbers with their unit."""

from __future__ import annotations

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate


def _page(name: str) -> str:
    return " ".join(Terminal(200).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0])).split())


@pytest.mark.parametrize(
    "words",
    [
        "v_P = v constant speed a_Pt = 0 v_P constant",
        "y′ = x = 2 lengths in m y″ = 1 in 1/m ρ",
        "e_t = [1, y′]/√(1 + y′²) = [√5/5, 2 √5/5]",
        "at right angles to e_t, to the concave side",
        "a_P = v_P²/ρ e_n = [-(0.08/m) v², (0.04/m) v²]",
        "that is (0.08944/m) v² at 26.6° above -x",
        "= (0.2/m) v² - (0.16/m) v² = (0.04/m) v²",
    ],
)
def test_a_constant_speed_along_a_parabola(words: str) -> None:
    page = _page("textbook/ex-1-13")
    assert words in page
    assert "other root" not in page
    assert "unknowns" not in page


def test_an_angle_by_the_components_across_the_line_of_sight() -> None:
    page = _page("textbook/ex-1-15")
    assert "t_collide = t_meet = D/(50 m/s)" in page
    assert "150° - β = 60° or 120°" in page
    assert "cos² + sin²" not in page
    assert "1/2 g" not in page, "it drops out of the relative motion"


def test_a_curve_in_letters_keeps_its_formulas() -> None:
    page = _page("particles/skier-in-a-parabolic-dip")
    assert "y″ = 2 c = 2 · 0.00625 = 0.0125/ft" in page
    assert "a_t = a_Pt = -14.40 ft/s², that is 14.40 ft/s² against the direction of motion" in page


def test_a_speed_counts_the_way_that_the_body_moves() -> None:
    """The state says v_taxi,x > 0."""
    page = _page("kinematics/cars-on-a-road-and-in-a-bend")
    assert "v_taxi = 10 m/s speed" in page
    assert "(3) a_taxi,t = 2 m/s²" in page
    assert "other roots" not in page
