"""Angles that are found from two components are told by their tangent, or by the angle that the components repeat."""

from __future__ import annotations

from decimal import Decimal

import pytest
import sympy as sp
from conftest import PROBLEMS
from worked import page_of_file, worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.answers.directions import with_tangents
from planar_cli.report.document.blocks import Document, Equation, Math, Value
from planar_cli.report.page.narrate import narrate

FILES = {p.stem: p for p in PROBLEMS}
theta, beta, x, y = sp.symbols("theta beta x y", real=True)


def _rows(*sides: Math | Value) -> list[str]:
    blocks = tuple(with_tangents([Equation(sides)]))
    return [" ".join(row.split()) for row in Terminal(200).render(Document("", blocks)).splitlines() if row.strip()]


@pytest.mark.parametrize(
    ("numbers", "angle", "rows"),
    [
        (("3", "4"), "36.8699", ["tan θ = y/x = 3/4 = 0.7500", "θ = arctan(0.7500) = 36.87°"]),
        (("3", "-4"), "143.1301", ["tan θ = y/x = 3/(-4) = -0.7500", "θ = arctan(-0.7500) + 180° = 143.1° as x < 0"]),
        (("-3", "-4"), "-143.1301", ["tan θ = y/x = -3/(-4) = 0.7500", "θ = arctan(0.7500) - 180° = -143.1° as x < 0"]),
    ],
)
def test_the_tangent_then_the_angle(numbers: tuple[str, str], angle: str, rows: list[str]) -> None:
    formula = sp.atan2(y, x)
    sides = (Math(theta), Math(formula), Math(formula, dict(zip((y, x), numbers, strict=True))))
    assert _rows(*sides, Value(Decimal(angle), "deg")) == rows


def test_the_tangent_of_a_number() -> None:
    """An angle that is known already stands in brackets, with its unit."""
    quotient = Math(sp.atan2(y, x))
    assert _rows(Math(-theta, {theta: "2.689"}), quotient) == ["tan(-2.689 rad) = y/x"]
    assert _rows(Math(theta, {theta: "30°"}), quotient) == ["tan(30°) = y/x"]


def test_an_angle_that_components_repeat() -> None:
    formula = sp.atan2(sp.sin(beta), -sp.cos(beta))
    sides = (Math(theta), Math(formula), Math(formula, {beta: "70°"}), Value(Decimal(110), "deg"))
    assert _rows(*sides) == ["θ = 180° - β = 180° - 70° = 110°"]


def test_letters_alone() -> None:
    assert _rows(Math(theta), Math(sp.atan2(2 * y, 2 * x))) == ["tan θ = y/x"]


def test_any_other_formula_stays() -> None:
    assert _rows(Math(theta), Math(sp.atan(y))) == ["θ = arctan(y)"]


@pytest.mark.parametrize("stem", ["pucks-at-an-angle", "ladder-leaving-the-wall", "geneva-wheel", "gun-on-rails"])
def test_no_page_of_these_has_the_angle_of_a_program(stem: str) -> None:
    page = Terminal(110).render(narrate(worked(FILES[stem])[0]))
    assert "atan2" not in page
    assert "tan " in page or "180° - β" in page


def test_a_letter_that_counts_against_the_axis_says_so() -> None:
    """a_van,y = 3 m/s² and a_van = -3 m/s² are both right, as the van drives downward."""
    page = Terminal(200).render(narrate(worked(FILES["cars-on-a-road-and-in-a-bend"])[0]))
    assert "Given: a_van,y = 3 m/s²; a_van counts downward\n" in page
    assert "Given: v_van,y = -15 m/s; v_van counts downward\n" in page
    assert "counts" not in Terminal(200).render(narrate(worked(FILES["car-that-brakes-in-a-bend"])[0]))


def test_a_rod_of_known_length_is_found_by_its_sine() -> None:
    length, height = sp.symbols("l h", positive=True)
    formula = sp.atan2(-height, sp.sqrt(length**2 - height**2))
    numbers = Math(formula, {length: "2", height: "1"})
    assert _rows(Math(theta), Math(formula), numbers, Value(Decimal(-30), "deg")) == [
        "sin θ = -h/l = -1/2 = -0.5",
        "θ = arcsin(-0.5) = -30°",
    ]


def test_the_sine_of_a_datum_stands_within_its_row() -> None:
    """With words before it one row holds it: At 1, in the given position."""
    page = page_of_file("slider-crank-with-a-spring")
    assert "At 1, in the given position: θ_AB,1 = arcsin(-√3 r_c/(2 l)) = arcsin(-√3 · 0.15 / (2 · 0.45))" in page
