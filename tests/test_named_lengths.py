"""Springs and dampers on a turning bar: lengths with letters, moments by their derivatives, no idle acceleration."""

from __future__ import annotations

import math
import re

import pytest
import sympy as sp
from sympy.parsing.sympy_parser import implicit_multiplication_application, parse_expr, standard_transformations
from worked import page_of_file

MOMENT = "↺ ΣM_O: -F_coil AK′ - F_dashpot DW′ = I_O α"


def test_lengths_have_letters_and_derivatives() -> None:
    page = page_of_file("bar-with-spring-and-damper").partition("CASE heavy")[0]
    lines = (
        "AK = √(l² (1 - cos θ)² + (h + l sin θ)²)",
        "AK′ = d(AK)/dθ = l (l sin(θ) (1 - cos θ) + cos(θ) (h + l sin θ)) / AK",
        "F_coil = k (AK - h)",
        "DW = √(l² (1 - cos θ)² + (2 h + l sin θ)²)/2",
        "F_dashpot = c ω DW′",
        MOMENT,
    )
    places = [page.index(told) for told in lines]
    assert places == sorted(places)


def test_weight_stands_beside_such_a_moment() -> None:
    assert "↺ ΣM_O: -1/2 m g l cos θ - F_spring BW′ = I_O α" in page_of_file("bar-let-go-on-a-spring")


@pytest.mark.parametrize("angle", [0.1, 0.5, 1.2])
def test_the_derivative_is_the_arm(angle: float) -> None:
    """Of the spring from A(l cos θ, l sin θ) to K(l, -h): the distance of O from the line AK."""
    size, h = 0.6, 0.4
    a, k = (size * math.cos(angle), size * math.sin(angle)), (size, -h)
    length = math.hypot(a[0] - k[0], a[1] - k[1])
    arm = abs(a[0] * k[1] - a[1] * k[0]) / length
    (told,) = set(re.findall(r"d\(AK\)/dθ = (.*?) / AK ", page_of_file("bar-with-spring-and-damper")))
    values = {"l": size, "h": h, "θ": angle, "sin": sp.sin, "cos": sp.cos}
    formula = parse_expr(told, values, (*standard_transformations, implicit_multiplication_application))
    assert formula / length == pytest.approx(arm)


def test_moments_about_an_axis_need_no_acceleration_of_the_centre() -> None:
    assert "a_G" not in page_of_file("bar-with-spring-and-damper")
    assert "a_G = α × r_G/A" in page_of_file("rod-falling-against-a-couple")
