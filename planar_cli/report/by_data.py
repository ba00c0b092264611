"""Differences of places that the file gives by numbers and letters, in the letters left: (y_2 - y_1)/R = h/R."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import sympy as sp

from planar_cli.equation.counting import operations
from planar_cli.equation.plain import longer, simplified
from planar_cli.report.clean import is_clean
from planar_cli.report.origins import is_explicit
from planar_cli.solve.between.trace import MotionTrace, Result, RouteStep

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
    return put


def is_spared(
    leg: RouteStep, legs: Sequence[RouteStep], found: MotionTrace, printed: Callable[[Result], sp.Expr | None]
) -> bool:
    """Has a datum cancelled in every formula that rests on it, so that no later line holds it? `printed`: the formula
    of a result as it is told.
    """
    own = set(leg.unknowns)
    users = [x for x in legs if own & x.needs]
    asked = {s for r in found.requests for e in (*r.parts, *(f for _, f in r.beside)) for s in e.free_symbols}
    asked |= {s for x in found.spans if x.formula is not None for s in x.formula.free_symbols}
    if not users or own & asked or found.passing:
        return False
    return all(_does_without(x, own, found, printed) for x in users)


def _does_without(
    leg: RouteStep, letters: set[sp.Symbol], found: MotionTrace, printed: Callable[[Result], sp.Expr | None]
) -> bool:
    if leg.is_datum or len(leg.relations) != 1 or not is_explicit(leg.relations[0], leg, found.ledger):
        return False
    formulas = [printed(r) for r in leg.results]
    return all(f is not None and not f.free_symbols & letters for f in formulas)
