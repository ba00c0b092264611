"""Velocities that are asked stand before the accelerations; a fixed line says which component is zero; velocities alone
are told by the instantaneous centre.
"""

from __future__ import annotations

import pytest
from conftest import ROOT
from worked import page_of_file, worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import Voice, narrate


@pytest.mark.parametrize(("stem", "velocity", "acceleration"), [
    ("gear-between-racks", "v_G = ω_gear × r_G/C = [-0.2 (-3), 0] = [0.6, 0] m/s", "a_G ="),
    ("disk-on-fixed-disk", "v_B = -(r ω_disk + (R + r) ω_arm) = -2 w (R + r)", "a_G ="),
    ("wheel-that-pushes-a-rod", "= [2.030, 0] m/s", "a_A ="),
])  # fmt: skip
def test_velocities_stand_before_accelerations(stem: str, velocity: str, acceleration: str) -> None:
    page = page_of_file(stem)
    assert page.index(velocity) < page.index("Accelerations:") < page.index(acceleration)
    assert page.count(velocity) == 1


def test_a_relative_velocity_is_told_once_in_the_unit_that_is_asked() -> None:
    page = page_of_file("ex-2-09")
    assert page.count("v_rel = v_D · e = 0.8660 · 0.8619 = 0.7464 m/s = 746.4 mm/s") == 1
    assert page.count("746.4 mm/s") == 2  # in its line and in the answer


def test_a_fixed_line_says_which_component_is_zero() -> None:
    assert "B moves along the floor, so that v_By = 0:" in page_of_file("wheel-that-pushes-a-rod")
    assert "B moves horizontally, so that a_By = 0:" in page_of_file("slider-crank-offset")


def test_what_touches_a_fixed_surface_is_at_rest_there() -> None:
    page = page_of_file("gear-between-racks")
    assert page.index("C touches the fixed floor: v_C = 0") < page.index("v_T = ω_gear × r_T/C")


def test_a_given_component_keeps_its_sign() -> None:
    page = page_of_file("gear-between-racks")
    assert "-2 r_g ω_gear = 1.2 m/s" in page
    assert "-2 r_g α_gear = -0.8 m/s²" in page


def test_a_place_and_its_one_open_coordinate_are_one_line() -> None:
    page = page_of_file("wheel-that-pushes-a-rod")
    assert "B is l from A and at y = 0, on the right: x_B = R + √(l² - R²) = 0.4 + √(1.2² - 0.4²) = 1.531 m" in page
    assert "x of B" not in page


def test_where_velocities_alone_are_sought_the_instantaneous_centre_is_the_road() -> None:
    page = page_of_file("ex-4-07")
    assert "Principle The instantaneous centre I of a body: v_P = IP ω" in page
    assert (
        "E moves along the wall; the perpendiculars to v_O and v_E cross at I, the instantaneous centre of rod:" in page
    )
    assert "IO = √2 l/2 = √2 · 0.3 / 2 = 0.2121 m above O, at the height of E; I = [0, 0.3121] m" in page
    assert "ω_rod = v_O/IO = 1/0.21213 = 4.714 rad/s" in page
    assert "IG = l/2 = 0.3/2 = 0.15 m G is the midpoint of OE, angle OIE is 90°" in page
    assert "v_G,rod = IG ω_rod = 0.15 · 4.714 = 0.7071 m/s" in page
    assert "Check along OE" in page


def test_the_centre_of_oblique_directions_and_what_is_asked_by_it() -> None:
    page = page_of_file("instantaneous-centre")
    assert "IA = |r_B/A · e|/sin 60° = |0.5 · 0.8660 - 1.2 · 0.5|/sin 60° = 0.1928 m" in page
    assert "ω = v_A/IA = -0.8/0.1928 = -4.149 rad/s" in page
    assert "centre = I = [-0.1928, 1.2] m" in page
    assert "v_M = IM |ω| = 0.7457 · 4.149 = 3.094 m/s" in page


def test_the_size_of_a_vector_along_an_axis_needs_no_root() -> None:
    assert "v_P = ω_arm × r_P/O = [0, 0.09 · 3.333] = [0, 0.3] m/s |v_P| = 0.3 m/s" in page_of_file("planetary-gear")


def test_a_key_names_the_centre_as_well() -> None:
    solution, _ = worked(ROOT / "problems" / "kinematics" / "instantaneous-centre.yaml")
    key = " ".join(Terminal(200).render(narrate(solution, Voice(audience="exam"))).split())
    assert "Principle The instantaneous centre I of a body" in key


def test_with_accelerations_the_relative_velocity_is_the_road() -> None:
    assert "cross at I" not in page_of_file("slider-crank-offset")


def test_a_given_velocity_that_was_put_in_is_named() -> None:
    assert "v_By = R ω_wheel + (x_B - R) ω_rod = 0 (2) v = (x_B - R) ω_rod by (1)" in page_of_file(
        "wheel-that-pushes-a-rod"
    )
