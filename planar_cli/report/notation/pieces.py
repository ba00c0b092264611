"""Formulas in pieces, as a table or a load in time makes them: only the pieces that a motion meets are printed."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.values.exact import Unvalued, Valuation
from planar_cli.errors import NoValue

Ranges = Mapping[sp.Symbol, tuple[Decimal, Decimal]]


def met(expr: sp.Expr, value: Valuation, ranges: Ranges | None = None) -> sp.Expr:
    """The expression with the pieces that hold at the numbers of its letters; under an integral those between its
    limits. `ranges`: from where to where a variable of integration runs.
    """
    if not expr.has(sp.Piecewise):
        return expr
    if isinstance(expr, sp.Integral):
        return _integral(expr, value, ranges or {})
    if isinstance(expr, sp.Piecewise):
        return _pieces(expr, value, ranges or {})
    args = [met(a, value, ranges) if isinstance(a, sp.Expr) else a for a in expr.args]
    return expr.func(*args)


def _integral(expr: sp.Integral, value: Valuation, ranges: Ranges) -> sp.Expr:
    inner = dict(ranges)
    limits = []
    for variable, low, high in expr.limits:
        ends = [_number(e, value) for e in (low, high)]
        if ends[0] is not None and ends[1] is not None:
            inner[variable] = (min(ends[0], ends[1]), max(ends[0], ends[1]))
        limits.append((variable, met(low, value, ranges), met(high, value, ranges)))
    return sp.Integral(met(expr.function, value, inner), *limits)


def _pieces(expr: sp.Piecewise, value: Valuation, ranges: Ranges) -> sp.Expr:
    kept: list[tuple[Any, Any]] = []
    for formula, condition in expr.args:
        holds = _holds(condition, value, ranges)
        if holds is False:
            continue
        kept.append((met(formula, value, ranges), sp.true if holds else condition))
        if holds:
            break
    return kept[0][0] if len(kept) == 1 else sp.Piecewise(*kept, evaluate=False)


def _holds(condition: Any, value: Valuation, ranges: Ranges) -> bool | None:
    """Does a condition hold? None: here and there, or it is not known."""
    if condition in (sp.true, sp.false):
        return bool(condition)
    if not isinstance(condition, sp.StrictLessThan | sp.LessThan):
        return None
    left, right = condition.lhs, _number(condition.rhs, value)
    if right is None:
        return None
    if left in ranges:
        low, high = ranges[left]
        return True if high <= right else False if low >= right else None
    number = _number(left, value)
    if number is None:
        return None
    return number < right or (number == right and isinstance(condition, sp.LessThan))


def _number(expr: sp.Expr, value: Valuation) -> Decimal | None:
    try:
        return value(expr)
    except (NoValue, Unvalued):
        return None
