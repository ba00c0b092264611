"""Limits of the formulas of a motion for infinite time or place; SymPy's own general method may take minutes."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.values.exact import Valuation


def limit(expr: sp.Expr, letter: sp.Symbol, value: Valuation) -> sp.Expr | None:
    """The finite limit as `letter` grows beyond all bounds; None where there is none, or where it is not certain.

    `value` tells the signs of rates: e^(-kt) vanishes for k > 0 together with every power of t that multiplies it.
    """
    if letter not in expr.free_symbols:
        return expr
    if expr.is_Add:
        parts = [limit(a, letter, value) for a in expanded(expr).args] if expanded(expr).is_Add else None
        if parts is None:
            return limit(expanded(expr), letter, value)
        return None if any(p is None for p in parts) else sp.Add(*parts)
    return _product(expr, letter, value)


def _sign(expr: sp.Expr, value: Valuation) -> int:
    number = value.known(expr) or 0
    return 1 if number > 0 else -1 if number < 0 else 0


def _product(expr: sp.Expr, letter: sp.Symbol, value: Valuation) -> sp.Expr | None:
    """Exponential rates decide first, then powers, then what stays bounded."""
    rate: sp.Expr = sp.S.Zero
    degree: sp.Expr = sp.S.Zero
    kept: sp.Expr = sp.S.One
    for factor in sp.Mul.make_args(expr):
        if letter not in factor.free_symbols:
            kept *= factor
            continue
        found = _growth(factor, letter, value)
        if found is None:
            return None
        rate, degree, kept = rate + found[0], degree + found[1], kept * found[2]
    sense = _sign(rate, value) if rate != 0 else 0
    if sense == 0 and rate != 0:
        return None
    if sense:
        return sp.S.Zero if sense < 0 else None
    if degree != 0:
        return sp.S.Zero if _sign(degree, value) < 0 else None
    return kept


def _growth(factor: sp.Expr, letter: sp.Symbol, value: Valuation) -> tuple[sp.Expr, sp.Expr, sp.Expr] | None:
    """(exponential rate, power, bounded rest) of one factor."""
    zero, one = sp.S.Zero, sp.S.One
    base, exponent = factor.as_base_exp() if factor.is_Pow else (factor, one)
    if isinstance(factor, sp.exp):
        return _exponential(factor.args[0], letter)
    if letter in exponent.free_symbols:
        return None
    if isinstance(base, sp.exp):
        found = _exponential(base.args[0], letter)
        return None if found is None else (found[0] * exponent, zero, found[2] ** exponent)
    if base == letter:
        return zero, exponent, one
    if isinstance(base, sp.tanh | sp.atan):
        slope = expanded(base.args[0]).coeff(letter, 1)
        sense = _sign(slope, value)
        bound = one if isinstance(base, sp.tanh) else sp.pi / 2
        return None if not sense else (zero, zero, (sense * bound) ** exponent)
    inner = limit(base, letter, value) if base.is_Add else None
    if base.is_Add and inner is None:
        return _polynomial(base, letter, exponent)
    if isinstance(base, sp.log | sp.acos | sp.asin):
        inside = limit(base.args[0], letter, value)
        return None if inside is None or inside == 0 else (zero, zero, base.func(inside) ** exponent)
    if inner is None or (inner == 0 and _sign(exponent, value) <= 0):
        return None
    return zero, zero, inner**exponent


def _exponential(argument: sp.Expr, letter: sp.Symbol) -> tuple[sp.Expr, sp.Expr, sp.Expr] | None:
    whole = expanded(argument)
    if not whole.is_polynomial(letter) or sp.degree(whole, letter) != 1:
        return None
    slope = whole.coeff(letter, 1)
    return slope, sp.S.Zero, sp.exp(expanded(whole - slope * letter))


def _polynomial(base: sp.Expr, letter: sp.Symbol, exponent: sp.Expr) -> tuple[sp.Expr, sp.Expr, sp.Expr] | None:
    """A polynomial grows like its leading term."""
    if not base.is_polynomial(letter):
        return None
    poly = sp.Poly(base, letter)
    return sp.S.Zero, poly.degree() * exponent, poly.LC() ** exponent
