"""Checks of kinematics that a person can make: polar coordinates about a pin, and special places."""

from __future__ import annotations

import pytest
from conftest import ROOT
from worked import page_of_file, worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate


@pytest.mark.parametrize(
    ("name", "lines"),
    [
        (
            "kinematics/collar-on-rotating-rod",
            [
                "x = r cos θ, differentiated twice: ẍ = r̈ cos θ - 2 ṙ ω sin θ - r α sin θ - r ω² cos θ",
                "= -0.2 · 0.8192 - 2 · 0.6 · 4 · 0.5736 - 0.5 (-3) · 0.5736 - 0.5 · 4² · 0.8192 = -8.610 m/s² = a_Px",
            ],
        ),
        ("kinematics/ring-on-two-turning-rods", ["polar coordinates about A: a_r = r̈ - r ω² = -1.467 - 0.4 · 3²"]),
        (
            "kinematics/pin-in-a-limacon-groove",
            [
                "at θ = 0: v_r = 0, v_th = b w, a_r = 0, a_th = 0; at θ = π: v_r = 0, v_th = 3 b w, a_r = -4 b w²",
                # At an instant the components along and across the radius, by those along x and y.
                "a_ur = a_Px cos θ + a_Py sin θ = -2 b w²",
                "a_uth = a_Py cos θ - a_Px sin θ = 2 b w²",
            ],
        ),
        ("kinematics/geneva-wheel", ["at θ = 0: ω_wheel = -(1 + √2) w, α_wheel = 0"]),
    ],
)
def test_a_check_that_a_person_can_make(name: str, lines: list[str]) -> None:
    page = Terminal(width=240).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))
    for told in lines:
        assert told in page


def test_of_a_chord_that_misses_the_pin_there_are_no_polar_coordinates() -> None:
    page = Terminal(width=240).render(narrate(worked(ROOT / "problems/kinematics/slider-in-a-chord-of-a-disk.yaml")[0]))
    assert "polar coordinates" not in page


def test_the_same_assumption_is_not_told_to_fail() -> None:
    """A ball in a loop that does not press outwards presses inwards: the contact holds all the same."""
    page = Terminal(width=240).render(narrate(worked(ROOT / "problems/particles/bead-in-loop.yaml")[0]))
    assert "Fails" not in page
    assert "Assume      ball at P stays in contact, inside loop\n" in page


def test_energies_that_were_solved_together_with_other_equations_are_put_in() -> None:
    told = page_of_file("satellite-perigee-apogee")
    assert "work and energy: T_A + U = 2.631×10¹⁰ - 1.039×10¹⁰ = 1.592×10¹⁰ J = T_B" in told


def test_a_check_whose_letters_would_hide_units_has_numbers() -> None:
    page = page_of_file("ex-1-11")
    assert "- 1/2 g t_parallel² = 7.071 · 1.2614 - 1/2 · 9.81 · 1.2614² = 1.115 m" in page
    assert "10.9375" not in page


def test_a_place_that_the_file_gives_has_its_number_beside_a_mass_that_cancels() -> None:
    assert "rise = y_B,2 - y_B,1 = 2.379 - 2.6 = -0.2210 m" in page_of_file("bolt-that-drops-in-a-lift")
