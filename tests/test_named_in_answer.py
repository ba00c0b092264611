"""A letter of the solution that is asked by another name: the answer says so, and no line before it."""

from __future__ import annotations

from decimal import Decimal

import pytest
import sympy as sp
from worked import page_of_file

from planar_cli.report.answers.named_in_answer import named_in_answer
from planar_cli.report.document.blocks import Answer, Block, Equation, Math, Name, Paragraph, Value, line

X, Y = sp.symbols("x_2 y_2", real=True)
VALUE = Value(Decimal(3), "m", 4)
FOUND = Equation((Math(X), Math(Y), VALUE))
HENCE = Paragraph(line("Hence:"))
AGAIN = Equation((line(Name("d")), Math(X), VALUE))
ANSWER = Answer("d", line(VALUE))


def test_the_line_goes_into_the_answer() -> None:
    assert named_in_answer([FOUND, HENCE, AGAIN, ANSWER]) == [FOUND, Answer("d", line(Math(X), " = ", VALUE))]


@pytest.mark.parametrize("blocks", [
    [HENCE, AGAIN, ANSWER],
    [FOUND, HENCE, AGAIN, Equation((Math(Y), Math(2 * sp.Symbol("d")), VALUE)), ANSWER],
    [FOUND, HENCE, AGAIN, Answer("e", line(VALUE))],
])  # fmt: skip
def test_it_stays(blocks: list[Block]) -> None:
    """The letter has no line of its own, a formula has the name, or nothing answers it."""
    assert named_in_answer(blocks) == blocks


def test_on_a_page() -> None:
    page = page_of_file("pulley-pulled-against-a-spring")
    assert "Hence: turned" not in page
    assert "turned = θ_2 = -0.25 rad" in page.partition("Answer")[2]
