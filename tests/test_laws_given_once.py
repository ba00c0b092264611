"""A law of motion that the equations have given already is not told again."""

from __future__ import annotations

import sympy as sp

from planar_cli.report.document.blocks import Equation, Math, Paragraph, line
from planar_cli.report.laws.laws import without_given

T = sp.Symbol("t", real=True)


def table(second: sp.Expr) -> sp.Expr:
    return sp.Piecewise((sp.Integer(10), T < 1), (second, T < 3), (sp.Integer(0), True))


def test_pieces_of_a_table_are_compared_term_by_term() -> None:
    factored, expanded = table(sp.Mul(5, 3 - T, evaluate=False)), table(15 - 5 * T)
    solved = Equation((Math(sp.Symbol("alpha_rotor")), Math(factored)), None, line("(1):"))
    heading, rate = Paragraph(line("For the angle of the rotor:")), Math(sp.Symbol("theta_rotor_ddot"))
    assert without_given([heading, Equation((rate, Math(expanded)))], [solved]) == []
    assert len(without_given([heading, Equation((rate, Math(table(15 - T))))], [solved])) == 2


def test_the_letter_of_a_table_stands_for_its_pieces() -> None:
    letter, inertia = sp.Symbol("M_rotor"), sp.Symbol("J")
    defined = Equation((Math(letter), Math(table(15 - 5 * T))), None, line("torque rotor:"))
    solved = Equation((Math(sp.Symbol("alpha_rotor")), Math(letter / inertia)), None, line("(1):"))
    heading, rate = Paragraph(line("For the angle of the rotor:")), Math(sp.Symbol("theta_rotor_ddot"))
    law = Equation((rate, Math(table(15 - 5 * T) / inertia)))
    assert without_given([heading, law], [defined, solved]) == []
