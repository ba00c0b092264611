"""A component of a vector that the file calls by a letter has that letter; one that is called by a word keeps it."""

from __future__ import annotations

import pytest
import sympy as sp
from worked import page_of_file

from planar_cli.report.document.blocks import Equation, Math, Name, Text, line
from planar_cli.report.page.components_beside import with_components_beside


def test_component_of_a_letter() -> None:
    page = page_of_file("vane-that-runs-before-a-jet")
    assert "F_x = F_jet cos th - F_jet = " in page
    assert "F, x" not in page


def test_letter_with_an_index() -> None:
    page = page_of_file("four-bar-driven")
    assert "F_Ax = (A_n - " in page
    assert "F_A, x" not in page


@pytest.mark.parametrize(("name", "axis", "letter"), [
    ("R", "x", "R_x"), ("F_A", "y", "F_A_y"), ("J__2", "x", "J_x__2"), ("push", "x", ""), ("F_x", "y", ""),
])  # fmt: skip
def test_letters(name: str, axis: str, letter: str) -> None:
    row = Equation((line(Name(name), f", {axis}"), Math(sp.Symbol("m"))))
    (found,) = with_components_beside([row])
    assert isinstance(found, Equation)
    assert found.sides[0] == (line(Name(letter)) if letter else row.sides[0])
    # Of a letter that is something else the component stays apart.
    own = Equation((Math(sp.Symbol(letter or "R_x")), Math(sp.Symbol("m"))))
    assert with_components_beside([row, own])[0] == row
    assert Text(f", {axis}") in row.sides[0]
