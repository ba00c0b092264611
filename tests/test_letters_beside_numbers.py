"""Short formulas in the letters of the data before the numbers of a line; givens of a blow before its equations."""

from __future__ import annotations

import re

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate


def _page(name: str) -> str:
    return Terminal(width=110).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))


@pytest.mark.parametrize(
    ("name", "formula"),
    [
        ("friction/heaviest-weight-before-a-box-slips", "a_A = μ_s g"),
        ("friction/heaviest-weight-before-a-box-slips", "W = μ_s (W_A + W_B) / (1 - μ_s)"),
        ("rigid-bodies/beam-on-two-ropes", "T_A = 1/4 m g"),
        ("impact/where-a-bat-meets-the-ball", "d = k²/b + b"),
    ],
)
def test_what_an_answer_is_in_the_data(name: str, formula: str) -> None:
    letter, _, told = formula.partition(" = ")
    assert re.search(rf"\b{re.escape(letter)} = [^=]* = {re.escape(told)}\s+= [^=]*= ", _page(name))


@pytest.mark.parametrize(
    ("name", "line"),
    [
        ("momentum/sand-wagon", "t_2 = M (v_1 - v_2) / (v_2 q) = 800 (3 - 1.5) / (1.5 · 40) = 20 s"),
        ("motion/body-hoist-starting-softly", "v_1 = R ω_1 = 0.4 · 0.4393 = 0.1757 m/s"),
        ("motion/boat-with-two-courses", "v_boat,x = v_stream,x + w cos β = 6.928 + 5 cos 53.13° = 9.928 m/s"),
        ("textbook/ex-4-07", "ω_rod = v_O/IO = 1/0.21213 = 4.714 rad/s"),
    ],
)
def test_no_formula_that_holds_for_numbers_of_the_file_alone(name: str, line: str) -> None:
    """Of 3 m/s and 1.5 m/s only their ratio is left in it, of 1.5 rad/s and 4 s a number, of 45° a root."""
    assert f" {line}\n" in _page(name)


def test_a_part_of_a_turn_keeps_its_pi() -> None:
    page = _page("motion/body-hoist-starting-softly")
    assert "= 0.6 (1 - cos(π t/4))" in page
    assert "0.7854" not in page


def test_two_given_speeds_stay_letters() -> None:
    """With 3 m/s and 1.5 m/s it is M/q, with others it is not."""
    assert "t_2 = M (v_1 - v_2) / (v_2 q) = " in _page("momentum/sand-wagon")


@pytest.mark.parametrize("name", ["kinematics/wheel-on-conveyor", "motion/block-force-table"])
def test_no_formula_with_numbers_that_hide_units(name: str) -> None:
    assert "in letters" not in _page(name)


def test_a_grip_that_feels_no_blow() -> None:
    page = _page("impact/where-a-bat-meets-the-ball")
    assert "STEP 1  Impulse and momentum" in page
    assert page.index("as given:   J_Ay = 0\n") < page.index("momentum along y")
    assert "The impulse of A from" not in page


def test_an_angle_that_is_a_number_on_a_page_of_letters() -> None:
    page = _page("energy/toppling-pole-that-stops-pressing")
    assert "φ = π/2 - θ_2 = arccos(0.6) = 0.9273 rad = 53.13°\n" in page


def test_the_formula_of_an_angle_stands_before_its_number() -> None:
    page = _page("motion/least-speed-to-a-target")
    assert re.search(r"tan\(2 β\) = -10/3 = -3\.333\n\s+β = π/2 - 1/2 arctan\(3\.333\) = 53\.35°\n", page)
    assert not re.search(r"= [\d.]+° = [(π]", page)
