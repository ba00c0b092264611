"""Formulas with numbers that have too many digits for a page."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.report.notation.numbers import as_printed

LONG = 7
"""A rational with more digits than this is shown rounded."""


def rounded(expr: sp.Expr, figures: int) -> sp.Expr:
    """The expression with long rationals and roots of numbers rounded for print."""
    if expr.is_Rational:
        if len(str(expr.p)) + len(str(expr.q)) <= LONG or expr.is_Integer:
            return expr if len(str(expr.p)) <= LONG + 4 else _short(expr, figures)
        return _short(expr, figures)
    if not expr.args:
        return expr
    args = [rounded(a, figures) for a in expr.args]
    return expr.func(*args) if any(a is not b for a, b in zip(args, expr.args, strict=True)) else expr


def _short(number: sp.Expr, figures: int) -> sp.Expr:
    return sp.Rational(str(as_printed(Decimal(int(number.p)) / Decimal(int(number.q)), figures)))
