"""Two bodies that roll on each other: their points of contact have one velocity, but not one acceleration."""

from __future__ import annotations

import pytest
from worked import page_of_file


def test_each_point_has_the_name_of_its_body() -> None:
    page = page_of_file("planetary-gear").partition("STEP 1")[2]
    assert "a_C,sun = -ω_sun² r_C/O =" in page
    assert "a_C,planet = a_P + α_planet × r_C/P" in page
    assert "a_C = " not in page


def test_of_wheels_on_fixed_axles_only_the_tangential_accelerations_are_told() -> None:
    page = page_of_file("gear-pair")
    assert "At C gear_A and gear_B have the same tangential acceleration: (1) r_A α_A = -r_B α_B" in page
    assert "a_C" not in page


def test_across_the_contact_the_accelerations_differ() -> None:
    """Of 15 mm on 60 mm: 15 · 60 / 75 = 12 mm."""
    page = page_of_file("eccentric-cam-with-roller-follower")
    assert "same acceleration along the contact, across it they differ by (ω_roller - ω_cam)² ρ, ρ = 0.012 m;" in page


def test_at_rest_they_do_not() -> None:
    assert "at T both have the same acceleration; along y:" in page_of_file("slab-on-rollers")


@pytest.mark.parametrize(("stem", "told"), [
    ("two-wheels-pressed-together", "(11) differentiated: (12) R α_large = -r α_small"),
    ("watts-sun-and-planet-gear", "(3), differentiated: (6) 0.3 α_link - 0.15 α_rod - 0.15 α_sun = 0 in m/s²"),
])  # fmt: skip
def test_wheels_in_mesh(stem: str, told: str) -> None:
    """R ω_1 = -r ω_2 holds all the time."""
    assert told in page_of_file(stem)


def test_a_centre_that_moves_is_told() -> None:
    """The acceleration of the centre of a planet is needed further down."""
    assert "a_P = α_arm × r_P/O - ω_arm² r_P/O" in page_of_file("planetary-gear")
