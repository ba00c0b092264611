"""Two bodies that roll on each other: their points of contact have one velocity, but not one acceleration."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(
    ("stem", "lines"),
    [
        ("planetary-gear", ("a_C,sun = -ω_sun² r_C/O =", "a_C,planet = a_P + α_planet × r_C/P")),
        ("gear-pair", ("a_C,gear,A = α_A × r_C/A", "a_C,gear,B = α_B × r_C/B")),
    ],
)
def test_each_point_has_the_name_of_its_body(stem: str, lines: tuple[str, ...]) -> None:
    page = page_of_file(stem)
    assert all(one in page for one in lines)
    assert "a_C = " not in page


def test_across_the_contact_the_accelerations_differ() -> None:
    """Of 15 mm on 60 mm: 15 · 60 / 75 = 12 mm."""
    page = page_of_file("eccentric-cam-with-roller-follower")
    assert "same acceleration along the contact, across it they differ by (ω_roller - ω_cam)² ρ, ρ = 0.012 m;" in page


def test_at_rest_they_do_not() -> None:
    assert "at T both have the same acceleration; along y:" in page_of_file("slab-on-rollers")
