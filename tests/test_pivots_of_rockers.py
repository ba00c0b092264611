"""A rocker turns about its own pivot; a point at two distances lies where their triangle says."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import ROOT
from worked import page_of_file, page_of_text


@pytest.mark.parametrize(
    "told",
    [
        "v_C = v_B + ω_BC × r_C/B",
        "v_C = ω_DC × r_C/D",
        "- ω_BC² r_C/B = α_DC × r_C/D - ω_DC² r_C/D",
        "(2) v_C along x: 0.3965 ω_DC - 0.2233 ω_BC = 0.1732 (-10) = -1.732",
        "C is l_BC from B and l_DC from D, the upper one; H: the foot of the perpendicular from C on BD",
        "BH = (BC² + BD² - DC²)/(2 BD) = (0.5² + 0.5292² - 0.4²) / (2 · 0.5292) = 0.3496 m",
        "HC = √(0.5² - 0.34962²) = 0.3574 m BH² + HC² = BC²",
    ],
)
def test_a_four_bar(told: str) -> None:
    page = page_of_file("four-bar")
    assert told in page
    assert page.index("v_C = v_B + ω_BC × r_C/B") < page.index("v_C = ω_DC × r_C/D")


def test_accelerations_are_solved_where_velocities_are() -> None:
    page = page_of_file("four-bar")
    assert "STEP 2" not in page
    assert "(3): α_BC = 13.533/0.4729 = 28.62 rad/s²" in page


def test_the_links_of_a_plate_have_their_own_unit_vectors() -> None:
    page = page_of_file("six-bar-class-3")
    assert "(k × r_A/O) · e_QD = 0.4472 (-0.2) + 0.8944 · 0.1 = 0 (k × r_B/A) · e_QD" in page
    assert "e_PC = [-0.6, 0.8] (k × r_A/O) · e_PC = -0.6 (-0.2) + 0.8 · 0.1 = 0.2 m" in page
    assert "(k × r_B/A) · e_PC = 0.44 m likewise (k × r_C/B) · e_PC = 0.36 m" in page
    assert "+ ω_slab (k × r_C/B) · e_PC = 0 (2) 0.44 ω_AB + 0.36 ω_slab" in page


def test_the_rocker_of_a_driven_four_bar_has_moments_about_its_pivot() -> None:
    assert "↺ ΣM_C: 1/2 m_CB g (d - x_B) + c B_t = I_C α_CB" in page_of_file("four-bar-driven")


def test_a_foot_beyond_the_first_end(tmp_path: Path) -> None:
    text = (ROOT / "problems/kinematics/four-bar.yaml").read_text(encoding="utf-8").partition("answers:")[0]
    page = page_of_text(tmp_path, text.replace("l_BC: 0.5 m, l_DC: 0.4 m", "l_BC: 0.2 m, l_DC: 0.6 m"))
    assert "= -0.03780 m negative: H lies beyond B HC = √(0.2² - 0.03780²) = 0.1964 m" in page


RIGHT_ANGLED = """
title: Four-bar linkage
points:
  A: [0, 0]
  D: [0.7 m, 0.2 m]
  B: [0.1 m, 0.2 m]
  C: {distances: {B: 0.32 m, D: 0.68 m}, side: above}
bodies:
  AB: {rod: [A, B]}
  BC: {rod: [B, C]}
  DC: {rod: [D, C]}
joints:
  - pin: {at: A, between: [ground, AB]}
  - pin: {at: B, between: [AB, BC]}
  - pin: {at: C, between: [BC, DC]}
  - pin: {at: D, between: [ground, DC]}
motion: [omega(AB) = 12 rad/s]
find: {omega_DC: omega(DC), alpha_DC: alpha(DC)}
"""


def test_a_right_angle_at_the_first_end_needs_no_foot(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, RIGHT_ANGLED)
    assert "the upper one; BC is perpendicular to BD, as BC² + BD² = DC² BD = 0.6 m" in page
    assert "C = [0.1, 0.2 + 0.32 · 1] = [0.1, 0.52] m" in page
    assert "H:" not in page
