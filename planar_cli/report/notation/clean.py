"""Is an equation written in letters alone, or do its numbers hide lengths, masses and other quantities?"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

import sympy as sp

from planar_cli.equation.values.ledger import Ledger
from planar_cli.units import PURE, Dimension

SIMPLE = 60
"""A fraction with a numerator and a denominator up to this size is one that a person would write."""


class Mixed(ValueError):
    """Terms of different dimensions stand in one sum: a number among them has a unit that is not written."""


def dimension_of(expr: sp.Expr, ledger: Ledger) -> Dimension:
    """The dimension that the symbols of an expression make. Raises Mixed where a sum has terms of several."""
    if expr.is_Symbol:
        unit = ledger.units.get(expr)
        return PURE if unit is None else unit.dimension
    if expr.is_Add:
        found = {dimension_of(a, ledger) for a in expr.args}
        if len(found) > 1:
            raise Mixed(expr)
        return found.pop()
    if expr.is_Mul:
        product = PURE
        for factor in expr.args:
            product = product * dimension_of(factor, ledger)
        return product
    if expr.is_Pow and expr.exp.is_Rational:
        return dimension_of(expr.base, ledger) ** Fraction(int(expr.exp.p), int(expr.exp.q))
    inside = {dimension_of(a, ledger) for a in expr.args}
    if isinstance(expr, sp.Abs):
        return inside.pop()
    # A logarithm of a quantity is one part of that of a ratio, a direction is that of two components.
    if not (isinstance(expr, sp.log | sp.sign) or (isinstance(expr, sp.atan2) and len(inside) == 1)) and inside - {
        PURE
    }:
        raise Mixed(expr)
    return PURE


def common_dimension(ledger: Ledger, *exprs: sp.Expr) -> Dimension | None:
    """The one dimension of all that is not zero; None: there are several, or a number hides a unit."""
    try:
        found = {dimension_of(e, ledger) for e in exprs if e != 0}
    except Mixed:
        return None
    return found.pop() if len(found) == 1 else None


def is_clean(ledger: Ledger, *exprs: sp.Expr, dimension: Dimension | None = None) -> bool:
    """Is it written in letters and such numbers as a person would write, with no unit swallowed by a number?
    `dimension`: what all of it must be, where that is known.
    """
    dimensions = {dimension} if dimension is not None else set()
    for expr in exprs:
        if expr == 0:
            continue
        if not all(_simple(n) for n in _numbers(expr)):
            return False
        try:
            dimensions.add(dimension_of(expr, ledger))
        except Mixed:
            return False
    return len(dimensions) <= 1


def _numbers(expr: sp.Expr) -> Iterator[sp.Expr]:
    """The largest parts of an expression that are numbers."""
    if expr.is_number:
        yield expr
        return
    known = [a for a in expr.args if a.is_number] if expr.is_Add or expr.is_Mul else []
    if known:
        yield expr.func(*known)
    for argument in expr.args:
        if not argument.is_number:
            yield from _numbers(argument)
        elif not known:
            yield argument


def _simple(number: sp.Expr) -> bool:
    """A fraction of small whole numbers, such a root, π, or a product of these."""
    if number.is_Rational:
        return abs(int(number.p)) <= SIMPLE and int(number.q) <= SIMPLE
    if number.is_Add:
        return False
    if number.is_Pow or number.is_Mul:
        return all(_simple(a) for a in number.args)
    return True
