"""Times of states as a person writes them: v (t_3 - t_2) for v t_3 - v t_2, t_2 + v/g for (v + g t_2)/g."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import sympy as sp


def over_durations(expr: sp.Expr, times: Sequence[sp.Symbol]) -> sp.Expr:
    """A formula with the time between two states in one bracket, and a time alone outside of fractions. `times`: of
    states, the last one first.
    """
    inside = [t for t in times if t in expr.free_symbols]
    if not inside or not isinstance(expr, sp.Add | sp.Mul):
        return expr
    total = sp.Add(*(_apart(t, inside) for t in sp.Add.make_args(expr)))
    for one, other in combinations(inside, 2):
        total = _together(total, one, other)
    return total


def _apart(term: sp.Expr, times: Sequence[sp.Symbol]) -> sp.Expr:
    """t_2 + v/g for (v + g t_2)/g."""
    sums = [f for f in sp.Mul.make_args(term) if f.is_Add]
    if not term.is_Mul or len(sums) != 1:
        return term
    before = term / sums[0]
    alone = [x for x in sums[0].args if before * x in times]
    if not alone:
        return term
    return sp.Add(*(before * x for x in alone), before * sp.Add(*(x for x in sums[0].args if x not in alone)))


def _together(total: sp.Expr, one: sp.Symbol, other: sp.Symbol) -> sp.Expr:
    """v (t_3 - t_2) for v t_3 - v t_2, and (t_3 - t_2)² for its three terms."""
    terms = list(total.args) if total.is_Add else []
    made: list[tuple[sp.Expr, sp.Expr]] = []
    for term in terms[:]:
        square = (term, term * other**2 / one**2, -2 * term * other / one)
        if one**2 in sp.Mul.make_args(term) and all(t in terms for t in square):
            terms = [t for t in terms if t not in square]
            made.append((term / one**2, (one - other) ** 2))
    for term in terms[:]:
        partner = -term * other / one
        if one not in (term, -term) and term in terms and partner in terms and one in sp.Mul.make_args(term):
            terms = [t for t in terms if t not in (term, partner)]
            made.append((term / one, one - other))
    if not made:
        return total
    return sp.Add(*terms, *(sp.Mul(factor, duration, evaluate=not factor.is_Number) for factor, duration in made))
