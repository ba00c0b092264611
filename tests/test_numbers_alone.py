"""An equation of a later state of which an earlier one stood in letters comes with its numbers at once."""

from __future__ import annotations

import sympy as sp

from planar_cli.report.document.blocks import Equation, Math, Name, Paragraph, line
from planar_cli.report.page.numbers_alone import numbers_alone

R, NUMBER = sp.symbols("r number", positive=True)


def of_state(state: int, number: int) -> Equation:
    return Equation((Math(sp.S.Zero), Math(R * sp.Symbol(f"x__{state}"))), number)


def in_numbers(state: int, number: int) -> Equation:
    sides = (Math(sp.S.Zero), Math(NUMBER * sp.Symbol(f"x__{state}"), {NUMBER: "0.5"}))
    return Equation(sides, None, line(f"({number}) in numbers:"), line("in m"))


def test_the_first_stands_in_letters_and_in_numbers() -> None:
    head = Paragraph(line("At 3:"))
    first, later = [of_state(2, 1), in_numbers(2, 1)], [head, of_state(3, 2), in_numbers(3, 2)]
    (put,) = (b for b in numbers_alone([*first, *later]) if isinstance(b, Equation) and b.number == 2)
    assert (put.sides, put.lead, put.note) == (later[2].sides, (), line("in m"))
    assert numbers_alone([*first, *later]) == [*first, head, put]


def test_what_is_new_stands_in_letters() -> None:
    own = [of_state(2, 1), Equation((Math(R), Math(sp.Symbol("y__3"))), 2), in_numbers(3, 2)]
    assert numbers_alone(own) == own
    assert numbers_alone(own[:2]) == own[:2]


def test_a_balance_that_takes_three_rows_is_left_to_its_parts() -> None:
    lead = line(Name("T__1"), " + ", Name("U"), " = ", Name("T__2"), ":")
    work = Equation((line(Name("U"), " of the weight"), Math(R)))
    for rows, numbers in ((1, False), (3, True)):
        whole = Equation((line("x" * 100 * rows), Math(R * sp.Symbol("v__2"))), 1, lead)
        told = numbers_alone([work, whole, in_numbers(2, 1)])
        assert (len(told) == 2) is numbers
        assert numbers_alone([whole, in_numbers(2, 1)]) == [whole, in_numbers(2, 1)]
