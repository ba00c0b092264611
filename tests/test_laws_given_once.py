"""A law of motion that the equations have given already is not told again."""

from __future__ import annotations

import sympy as sp

from planar_cli.report.blocks import Equation, Math, Paragraph, line
from planar_cli.report.laws import without_given

T = sp.Symbol("t", real=True)


def table(second: sp.Expr) -> sp.Expr:
    return sp.Piecewise((sp.Integer(10), T < 1), (second, T < 3), (sp.Integer(0), True))


def test_pieces_of_a_table_are_compared_term_by_term() -> None:
    factored, expanded = table(sp.Mul(5, 3 - T, evaluate=False)), table(15 - 5 * T)
    solved = Equation((Math(sp.Symbol("alpha_rotor")), Math(factored)), None, line("(1):"))
    heading, rate = Paragraph(line("For the angle of the rotor:")), Math(sp.Symbol("theta_rotor_ddot"))
    assert without_given([heading, Equation((rate, Math(expanded)))], [solved]) == []
    assert len(without_given([heading, Equation((rate, Math(table(15 - T))))], [solved])) == 2
