"""An angle from one equation stands below its sine or cosine."""

from __future__ import annotations

from worked import page_of_file


def test_the_cosine_stands_before_the_angle() -> None:
    page = page_of_file("aircraft-in-wind")
    assert "cos β = -11.79/83.33 = -0.1414 β = 98.13°" in page


def test_an_angle_in_two_functions_has_none() -> None:
    page = page_of_file("engine-whose-piston-is-fastest")
    assert "(3): θ = 71.61°" in page
