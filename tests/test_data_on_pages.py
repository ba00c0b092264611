"""What is told as given is what the file gives: all else stands with what it follows from."""

from __future__ import annotations

from pathlib import Path

import pytest
from worked import page_of_file, page_of_text


@pytest.mark.parametrize(
    ("stem", "line"),
    [
        ("ex-1-11", "At launch: v_x,launch = 10 cos 45° = 7.071 m/s v_y,launch = 10 sin 45° = 7.071 m/s"),
        ("sandbag-into-a-cart", "1: v_bag,y,1 = 6 sin(-40°) = -3.857 m/s"),
        ("exercise-4-32", "At 1, as given: ω_1 = 15 rpm = 1.571 rad/s"),
        ("slider-crank-offset", "ω_crank = 240 rpm = 25.13 rad/s given"),
        ("ships-passing", "v_Bx = 24 km/h · cos 110° = -2.280 m/s given"),
        ("ship-interception", "(1) v_Bx = 5 cos 120° = -2.5 m/s"),
        ("ladder-leaving-the-wall", "At 3, y_B = 0: l sin θ_3 = 0 not 0°: θ_3 > θ_2 θ_3 = 180°"),
        ("load-on-four-strands", "|v_Ay,2|/4 = 1.5 m/s v_Ay,2 = 6 m/s"),
        ("pucks-at-an-angle", "At 1, as given: v_Ax,1 = 5 m/s"),
    ],
)
def test_data_with_what_they_follow_from(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


@pytest.mark.parametrize(
    ("stem", "line"),
    [
        ("crank-pin-in-a-slotted-arm", "α_crank = 0 ω_crank constant"),
        ("crane-truck", "a_C,boom = 0 v_C,boom constant"),
        ("ex-1-13", "v_P = v constant speed a_Pt = 0 v_P constant"),
        ("follower-with-cycloidal-lift", "differentiated: (1) v = h (1 - cos(2 π t/T)) / T"),
        ("follower-with-cycloidal-lift", "a = 2 π h sin(2 π t/T)/T² differentiated"),
    ],
)
def test_what_is_differentiated_is_not_given(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


def test_what_drives_one_body_along_another_is_not_in_the_diagram_of_both() -> None:
    assert "drive_1" not in page_of_file("man-walking-on-a-boat")


def test_a_couple_that_drives_is_no_force() -> None:
    page = page_of_file("motor-with-an-unbalanced-rotor")
    assert "drive_1 ↺, w ↓ at E = " in page
    assert "drive_1: the couple that keeps the motion as given" in page


def test_an_inertia_that_nothing_needs_is_named() -> None:
    """A car that slides without turning needs no radius of gyration."""
    page = page_of_file("car-with-locked-wheels")
    assert "Not used the radius of gyration of car, 1.2 m: not needed here" in page


def test_a_letter_that_is_sought_stands_on_the_right() -> None:
    """The file says ω = w, with w unknown: not w = ω under a line of its own."""
    page = page_of_file("whirling-collar")
    assert "(1) given, w unknown: ω = w" in page
    assert "Given: ω_rod = w" not in page


def test_what_a_wheel_carries_moves_with_it() -> None:
    page = page_of_file("roller-with-a-drag-bar")
    assert "bar moves with roller, which rolls: a_G,bar = -R α_roller" in page


def test_what_holds_at_a_state_is_told_in_sentences() -> None:
    """`At 2, as given:` and `At meet, x_A = x_B:`, without a label that has a second label behind it."""
    told = page_of_file("ex-4-11")
    assert "1: β = 45°, at rest" in told
    assert "to be found: x_max = " in told
    assert "At meet, x_A = x_B:" in page_of_file("police-chase")


def test_a_function_of_the_time_with_numbers_has_its_units() -> None:
    page = page_of_file("body-hoist-starting-softly")
    assert "ω = 3 (1 - cos(π t/4)) / 2 given, in rad/s, t in s" in page
    assert "α = 3 π/8 sin(π t/4) differentiated, in rad/s², t in s" in page


def test_in_feet_its_units_are_feet(tmp_path: Path) -> None:
    text = """
title: A law in feet
plane: vertical
bodies: {A: {particle: [0, 0], mass: 200 lb}}
joints: [guide: {point: A, along: 0 deg}]
motion: [v(A).x = (3 ft/s^2)*t + (1 ft/s^3)*t^2]
states: {0: [t = 0], 1: [t = 2 s]}
find: {v: v(A).x @ 1, a: a(A).x @ 1, x: x(A) @ 1}
"""
    page = page_of_text(tmp_path, text)
    assert "v_A = (3 + t) t given, in ft/s, t in s" in page
    assert "a_A = 3 + 2 t differentiated, in ft/s², t in s" in page
