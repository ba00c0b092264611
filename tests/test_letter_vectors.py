"""A vector in letters is read: its size, its direction, and between which points it lies."""

from __future__ import annotations

import unicodedata
from pathlib import Path

from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.report.page.narrate import narrate

TEXTBOOK = ROOT / "problems" / "textbook"


def _page(stem: str) -> str:
    return unicodedata.normalize("NFC", Terminal(200).render(narrate(worked(TEXTBOOK / f"{stem}.yaml")[0])))


def test_an_acceleration_that_always_points_to_the_centre() -> None:
    page = _page("ex-1-05")
    assert "a_P = [r ω² sin φ, r ω² cos φ], that is r ω² along the unit vector [sin φ, cos φ], from P to G" in page
    assert page.index("φ̇ = ω") < page.index("constant, so that φ̈ = 0")
    assert "ẍ_P = r ω φ̇ sin φ = r ω² sin φ" in page


def test_a_displacement_of_a_fixed_direction() -> None:
    page = _page("ex-1-02")
    assert "that is √2 r at 75° below +x" in page
    assert "x_A2 - x_A = r cos(-30°) - r cos 60° = 1/2 (√3 - 1) r" in page


def test_what_is_shifted_parallel_to_itself_is_not_worked_out_again() -> None:
    page = _page("ex-1-02")
    assert (
        "AB keeps its length and direction (translation): r_B = r_A + [l, 0], r_B2 = r_A2 + [l, 0], subtracted:" in page
    )
    assert "r_B2_from_B = r_A2_from_A\n" in page
    assert "x_B2" not in page
    # Its size and direction stand where it was found.
    assert page.index("direction of r_A2_from_A") < page.index("AB keeps its length")


def test_special_positions_check_a_rolling_wheel() -> None:
    assert "at φ = 0, P at [0, 0]: v_P = 0; at φ = π, P at [π r, 2 r]: v_P = [2 r ω, 0]" in _page("ex-1-04")


def test_two_ways_to_the_same_speed() -> None:
    assert "√(v_r² + v_θ²) = √(0.08256² + 0.1544²) = 0.1751 m/s; |ẋ_P| = 0.1751 m/s" in _page("ex-1-14")


def test_a_constant_speed_on_a_circle() -> None:
    assert "constant speed on a circle: a_P = v_P²/R = 11.781²/15 = 9.253 m/s²" in _page("ex-1-12")


def test_a_size_that_is_no_product_is_not_read() -> None:
    """2 r ω |sin(φ/2)| is not told as a root."""
    assert "v_P = [r ω (1 - cos φ), r ω sin φ]\n" in _page("ex-1-04")


def test_a_velocity_leads_to_no_point(tmp_path: Path) -> None:
    """The velocity of P seen from G is across the arm."""
    text = (TEXTBOOK / "ex-1-05.yaml").read_text(encoding="utf-8").split("answers:", maxsplit=1)[0]
    path = tmp_path / "seen.yaml"
    path.write_text(text.replace("a_P: a(P)", "v_PG: v(P/G)"), encoding="utf-8")
    page = Terminal(200).render(narrate(solve_and_compare(read(str(path)))[0]))
    assert "from P to G" not in page.split("Answer", maxsplit=1)[1]


def test_a_point_on_a_line_at_a_height() -> None:
    page = _page("ex-1-14")
    assert "y_P = 0.5 m\n    x_P = y_P/tan θ = 0.5 m/tan θ = 0.5/tan(2.0619 rad) = -0.2674 m" in page
    assert "r = y_P/sin θ = 0.5 m/sin θ = 0.5/sin(2.062 rad) = 0.5670 m" in page
    assert "θ = π/2 + π/6 sin(3 t/2) = 2.062 rad = 118.1°" in page
    assert "a = dv/dt" not in page
