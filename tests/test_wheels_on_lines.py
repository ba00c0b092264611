"""Accelerations of wheels on straight lines go by way of the centre, which moves along the line."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import PROBLEMS
from worked import page_of_file, page_of_text


def test_the_mass_centre_of_a_wheel_is_reached_from_its_middle() -> None:
    page = page_of_file("wheel-with-its-mass-centre-off-the-middle")
    assert "a_O = R α ↘ O moves along a straight line" in page
    assert "a_G = a_O + α × r_G/O - ω² r_G/O r_G/O = [e cos β, -e sin β]" in page


def test_a_pin_on_a_wheel_has_its_acceleration_told() -> None:
    page = page_of_file("wheel-that-pushes-a-rod")
    assert "a_O = 0 O moves along a straight line at constant speed a_A = -ω_wheel² r_A/O" in page
    assert "a_A = -ω_wheel² r_A/O = [-0.4 · 3.75², 0] = [-5.625, 0] m/s²" in page


def test_what_a_gear_carries_has_its_acceleration_along_the_contact_only() -> None:
    page = page_of_file("gear-between-racks")
    assert page.count("a_K = α_gear") == page.count("differentiated: a_K = α_gear") == 1
    assert "never slips at T: v_K = ω_gear × r_T/C at all times, differentiated: a_K = α_gear × r_T/C. The" in page


@pytest.mark.parametrize(
    ("old", "new", "line"),
    [
        ("v(K).x = 1.2 m/s", "v(K).x = 0 m/s", "never slips at T; gear does not turn now: a_K = α_gear × r_T/C Given"),
        ("angle: 0 deg}", "angle: 0 deg, speed: 0.3 m/s}", "v_K = v_C + ω_gear × r_T/C at all times, differentiated"),
    ],
)
def test_what_a_gear_carries_that_does_not_turn_or_runs_on_a_belt(
    tmp_path: Path, old: str, new: str, line: str
) -> None:
    (path,) = (p for p in PROBLEMS if p.stem == "gear-between-racks")
    text = path.read_text(encoding="utf-8").partition("answers:")[0]
    assert old in text
    assert line in page_of_text(tmp_path, text.replace(old, new))


def test_an_answer_is_not_its_own_name() -> None:
    """v_A of the only particle is called v_A on the page, as the file calls what it asks."""
    page = page_of_file("satellite-perigee-apogee")
    assert "Answer v_A = 8110 m/s v_B = 6308 m/s" in page


def test_a_denominator_that_is_made_of_given_lengths_is_positive() -> None:
    page = page_of_file("wheel-that-pushes-a-rod")
    assert "α_rod = -R ω_rod² / (x_B - R) = -0.4 · 1.3258² / (1.53137 - 0.4) = -0.6215 rad/s²" in page
