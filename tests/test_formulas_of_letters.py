"""Formulas of letters: what divides by zero is refused where it is written, and a power of what is sought is solved."""

from __future__ import annotations

import pytest
from answered import first, solve

from planar_cli.errors import FileProblem, NoSolution

SIZES = "title: Sizes\ngiven: {a: 2 m, b: 2 m, beta: 90 deg, c: FORMULA}\nfind: {x: 2*c}\n"


@pytest.mark.parametrize("formula", ["1/(a - b)", "(a - b)^(-2)", "a/cos(beta)", "1/(sqrt(2)^2 - 2)"])
def test_in_the_value_of_a_letter(formula: str) -> None:
    with pytest.raises(FileProblem) as error:
        solve(SIZES.replace("FORMULA", formula))
    assert [(d.code, d.message) for d in error.value.diagnostics] == [("PL505", "the value of c: division by zero")]


def test_a_small_difference_is_none() -> None:
    assert first(solve(SIZES.replace("FORMULA", "a/(cos(beta - 0.000001 deg))"))["x"]) > 1e8


PUSHED = """
title: Block pushed by the square of a letter
plane: horizontal
unknowns: {F: N}
bodies: {b: {particle: [0, 0], mass: 2 kg}}
loads: [{force: {body: b, magnitude: F^2/(1 N), angle: 0 deg}}]
instant: [at rest, a(b).x = 2 m/s^2]
find: {F: FIND}
"""


@pytest.mark.parametrize(("find", "value"), [("F", 2), ("F^2", 4), ("a(b).mag", 2)])
def test_a_magnitude_with_the_square_of_what_is_sought(find: str, value: float) -> None:
    assert first(solve(PUSHED.replace("FIND", find))["F"]) == pytest.approx(value)


def test_what_no_real_number_fulfils_names_the_letter() -> None:
    with pytest.raises(NoSolution) as error:
        solve(PUSHED.replace("= 2 m/s^2", "= -2 m/s^2").replace("FIND", "F"))
    (told,) = error.value.diagnostics
    assert (told.code, told.message) == ("PL601", "no real F fulfils all equations")
