"""Two bodies that roll on each other: their points of contact have one velocity, but not one acceleration."""

from __future__ import annotations

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
