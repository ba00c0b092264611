"""Differences of places that the file gives by numbers and letters, in the letters left: (y_2 - y_1)/R = h/R.

Only where the numbers go whatever they are: with v_1 = 3 m/s and v_2 = 1.5 m/s, M (v_1 - v_2)/(q v_2) is M/q by chance.
"""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.plain import identically_zero, longer, simplified
from planar_cli.report.notation.clean import is_clean
from planar_cli.solve.between.trace.trace import MotionTrace

LONGEST = 26
"""Of more operations nothing is put in."""


def by_data(formula: sp.Expr, unknown: sp.Symbol, found: MotionTrace) -> sp.Expr:
    """A formula with two or more letters of states put in that are given, where their numbers cancel."""
    given = {
        r.unknown: r.formula for leg in found.route.steps if leg.is_datum for r in leg.results if r.formula is not None
    }
    inside = {s: given[s] for s in formula.free_symbols if s in given and not given[s].is_Symbol}
    if len(inside) < 2 or longer(formula, LONGEST):
        return formula
    put = simplified(formula.xreplace(inside))
    if put.is_number or operations(put) >= operations(formula) or not is_clean(found.ledger, unknown, put):
        return formula
    return put if identically_zero(formula.xreplace(_with_letters(inside)) - put) else formula


def _with_letters(given: dict[sp.Symbol, sp.Expr]) -> dict[sp.Symbol, sp.Expr]:
    """What is given with a letter for each of its numbers: c + h for 1 m + h, the same for the same."""
    letters: dict[sp.Expr, sp.Symbol] = {}
    found = {}
    for symbol, formula in given.items():
        number, rest = formula.as_coeff_Add()
        letter = letters.setdefault(abs(number), sp.Dummy(real=True)) if number else sp.S.Zero
        found[symbol] = rest + (letter if number > 0 else -letter)
    return found
