"""What a page tells in several lines though one holds it: vectors of letters, places that stay, assumptions alone."""

from __future__ import annotations

from decimal import Decimal

import pytest
import sympy as sp
from worked import page_of_file

from planar_cli.report.document.blocks import Equation, Heading, Math, Name, Note, Paragraph, Value, line
from planar_cli.report.page.in_one_line import in_one_line, of_motion

x, y = sp.symbols("O_x O_y")
ASSUME = Note("Assume", line("the spring is free"))


def component(axis: str, formula: sp.Expr, value: str) -> Equation:
    return Equation((line(Name("F_O"), f", {axis}"), Math(formula), Value(Decimal(value), "N")))


def test_letters_are_one_vector() -> None:
    assert "F_O = [O_x, O_y] = [-51.82, -18.71] N |F_O| = " in page_of_file("four-bar-driven")


@pytest.mark.parametrize("formula", [x, -x])
def test_of_both_signs(formula: sp.Expr) -> None:
    (told,) = in_one_line([component("x", formula, "-1"), component("y", y, "2")])
    assert isinstance(told, Equation)
    assert told.sides[1] == line("[", Math(formula), ", ", Math(y), "]")


def test_formulas_keep_their_lines() -> None:
    blocks = [component("x", x / 2, "-1"), component("y", y, "2")]
    assert in_one_line(blocks) == blocks


def test_a_place_that_stays() -> None:
    page = page_of_file("row-of-hanging-balls")
    assert "At 3, 4: φ_B,4 = φ_B,3 = φ_B,2 = -90° nothing moves during a blow" in page
    assert "At 2: φ_B,2 = φ_B,1 = -90° it stays at rest in equilibrium" in page


def test_a_motion_that_only_assumes() -> None:
    assert of_motion([ASSUME], "from 1 to 2") == [Note("Assume", line("from 1 to 2: ", "the spring is free"))]
    step = Heading("STEP 1", "Kinetic analysis")
    assert of_motion([ASSUME, step], "from 1 to 2") == [Heading("MOTION", "from 1 to 2"), ASSUME, step]
    page = page_of_file("bungee-jump")
    assert "Assume from 1 to taut: the spring cord is free from taut to low: the spring cord pulls STEP 1" in page


@pytest.mark.parametrize(
    ("stem", "heading"),
    [
        ("bungee-jump", "From 1 to taut, constant acceleration of P downward:"),
        ("ex-1-06", "From thrown to half, constant acceleration of the ball along y:"),
    ],
)
def test_one_heading_over_equations_in_a_row(stem: str, heading: str) -> None:
    assert page_of_file(stem).count(heading) == 1


def test_a_heading_returns_after_another() -> None:
    heading, other = (Paragraph(line(f"From 1 to {n}, constant acceleration, x:")) for n in (2, 3))
    law = Equation((Math(x), Math(y)), 1)
    blocks = [heading, law, other, law, heading, law]
    assert in_one_line(blocks) == blocks
    remark = Paragraph(line("the positive root: x grows"))
    assert in_one_line([heading, law, remark, heading, law]) == [heading, law, remark, law]


@pytest.mark.parametrize("stem", ["bungee-jump", "ball-leaving-a-dome", "train-between-stations"])
def test_constant_acceleration_is_a_principle_beside_others(stem: str) -> None:
    page = page_of_file(stem)
    assert "constant acceleration" in page
    assert "Constant acceleration." in page.partition("STEP 1")[0]


def test_relative_motion_is_named_once() -> None:
    page = page_of_file("thrown-and-dropped")
    assert page.count("Relative motion") == 1
    assert "With the same acceleration the relative velocity is constant." in page


def test_a_steady_velocity_stands_in_the_heading_of_its_motion() -> None:
    page = page_of_file("body-bead-on-turning-parabola")
    assert "From 1 to 2, constant velocity of P along ξ, ξ̇ = u:" in page
    assert "For ξ of P" not in page
    # The speed along the wire is told by its components; no step finds it before.
    assert "sliding = √(ξ̇² + η̇²) = √(0.4² + 0.48²) = 0.6248 m/s" in page
    assert page.count("STEP") == 1
