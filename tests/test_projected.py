"""What slides along a body: the component across it, from the vectors that are known, with the numbers."""

from __future__ import annotations

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem


def _page(name: str) -> str:
    return " ".join(Terminal(200).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0])).split())


@pytest.mark.parametrize(
    "words",
    [
        "v_D = ω_CD × r_D/C = [-0.43094 (-2), 0] = [0.8619, 0] m/s r_D/C",
        "e = [cos 30°, sin 30°] = [0.8660, 0.5] along AB, n = [-sin 30°, cos 30°] = [-0.5, 0.8660] across it",
        "ω_AB = (v_D · n)/AD = -0.43094/0.4619 = -0.9330 rad/s",
        "α_AB = (a_D · n - a_cor · n)/AD = -0.05691/0.4619 = -0.1232 rad/s²",
        "v_D = v_D′ + v_rel e; along n: (1) ω_AB AD = v_D · n = -0.5 · 0.8619 = -0.4309 m/s",
        "a_D · n = -0.5 (-0.0861880) + 0.866025 (-1.72376) = -1.44973 m/s²",
        "along e: v_rel = v_D · e = 0.8660 · 0.8619 = 0.7464 m/s = 746.4 mm/s",
        "a_cor · n = 2 ω_AB v_rel = 2 (-0.933013) · 0.746410 = -1.39282 m/s²",
        "|a_cor| = |2 ω_AB × v_rel e| = 2 |ω_AB| |v_rel| = 2 · 0.9330 · 0.7464 = 1.393 m/s² = 1393 mm/s²",
        "a_rel = a_D · e + ω_AB² AD = 0.866025 (-0.0861880) + 0.5 (-1.72376) + 0.461880 · 0.933013²",
        "along n: a_D′ · n = α_AB AD a_D′ · e = -ω_AB² AD a_D · n =",
        "1393 mm/s² at -60°: v_rel turned by 90° clockwise, as AB turns",
        "along e: a_D · e = a_rel - ω_AB² AD so that: a_rel = a_D · e",
        "(2) α_AB AD = a_D · n - a_cor · n = -1.44973 - (-1.39282) = -0.05691 m/s²",
        "v_rel = 746.4 mm/s from A towards B",
        "a_rel = 534.4 mm/s² from B towards A",
    ],
)
def test_a_point_that_slides_along_a_bar(words: str) -> None:
    page = _page("textbook/ex-2-09")
    assert words in page
    assert page.count("v_D = ω_CD × r_D/C") == 1
    assert page.count("= [-0.5, 0.8660]") == 1
    assert "Path coordinates" not in page


def test_relative_motion_along_a_line_is_one_component() -> None:
    """Neither the point of the body nor the Coriolis acceleration has a component along the line through the pin."""
    page = _page("textbook/ex-2-09")
    assert "v_D - v_D′" not in page
    assert "a_D - a_D′" not in page
    assert "a_cor = 2 ω_AB × v_rel e; along n" in page
    assert "a_cor = [" not in page


@pytest.mark.parametrize(
    ("name", "words"),
    [
        (
            "kinematics/bar-driven-by-a-pin-on-a-rolling-wheel",
            "along u: v_rel = v_P · u = 0.8137 · 1.5 = 1.221 m/s = 1221 mm/s",
        ),
        ("kinematics/crank-pin-in-a-slotted-arm", "v_slot = v_rel = -0.5547 m/s"),
        (
            "kinematics/crank-pin-in-a-slotted-arm",
            "a_C = |a_cor| = |2 ω_arm × v_rel e| = 2 |ω_arm| |v_rel| = 2 · 0.9231 · 0.5547",
        ),
        ("kinematics/rod-through-a-swivelling-sleeve", "v_rel = -v_A · e = -0.9608 (-0.6928) - (-0.2774) (-0.4)"),
        ("kinematics/rod-drawn-over-an-edge", "e = [0.8, 0.6] along AB"),
        ("kinematics/pin-in-two-slotted-rods", "v_rel = v_P · u"),
    ],
)
def test_the_letter_the_sense_and_a_pin_that_moves(name: str, words: str) -> None:
    assert words in _page(name)


def test_no_component_is_told_by_halves() -> None:
    """The point of the arm has an acceleration of its own, which the page does not know there."""
    assert " · n = " not in _page("kinematics/rod-through-a-swivelling-sleeve")


def test_why_a_component_is_taken_stands_after_the_vectors() -> None:
    assert "with the same v_C; along DC, where ω_DC does not enter: e_DC =" in _page("kinematics/four-bar")


def test_a_point_at_rest_gives_the_turning_by_the_coriolis_acceleration_alone() -> None:
    page = _page("kinematics/rod-drawn-over-an-edge")
    assert "AD = √(1.6² + 1.2²) = 2 m" in page
    assert "a_cor · n = 2 ω v_rel = 2 (-0.24) · 0.64 = -0.3072 m/s²" in page
    assert "α = -(a_cor · n)/AD = 0.3072/2 = 0.1536 rad/s²" in page


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("kinematics/four-bar", "(k × r_C/B) · e_DC = -0.1316 (-0.2233) + 0.9913 · 0.4474 = 0.4729 m"),
        ("kinematics/four-bar", "ω_AB (k × r_B/A) · e_DC + ω_BC (k × r_C/B) · e_DC = 0 (1) 0.4729 ω_BC"),
        ("kinematics/four-bar", "- ω_BC² r_C/B · e_DC = -ω_DC² r_C/D · e_DC (3) 0.4729 α_BC"),
        ("kinematics/four-bar", "r_C/D · e_DC = 0.4 m likewise r_B/A · e_DC = 0.1585 m, r_C/B · e_DC = 0.1625 m"),
        (
            "kinematics/watts-sun-and-planet-gear",
            "the same velocity; along the contact (unit vector [0.8660, -0.5]): (3)",
        ),
    ],
)
def test_a_component_in_numbers_has_its_direction(name: str, words: str) -> None:
    assert words in _page(name)


def test_a_component_in_letters_or_along_an_axis_needs_none() -> None:
    assert "unit vector" not in _page("rigid-bodies/plate-on-parallel-links")
    assert _page("kinematics/four-bar").count("(2) v_C along x:") == 1


@pytest.mark.parametrize(
    ("centre", "pin", "sense", "way"),
    [("[300 mm, 100 mm]", "d", "cw", "0°"), ("[150 mm, -700 mm]", "-d", "ccw", "180°")],
)
def test_to_the_right_is_at_nought_degrees(centre: str, pin: str, sense: str, way: str) -> None:
    problem, wrong = load_text(f"""
title: Slotted arm straight up
given: {{d: 500 mm}}
points: {{C: [0, 0], O: {centre}, P: [0, {pin}]}}
bodies: {{crank: {{rod: [O, P]}}, arm: {{rod: [C, P]}}}}
joints:
  - pin: {{at: O, between: [ground, crank]}}
  - pin: {{at: C, between: [ground, arm]}}
  - guide: {{point: P, along: arm}}
motion: [omega(crank) = 4 rad/s {sense}]
find: {{a_C: coriolis(P/arm).mag, alpha_arm: alpha(arm)}}
""")
    assert problem is not None, wrong
    page = " ".join(Terminal(200).render(narrate(solve_problem(problem))).split())
    assert f" at {way}: v_rel turned by 90° clockwise" in page
