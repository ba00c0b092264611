"""Roots of one product: √(a/(2 c³)) for √(2 a)/(2 c^(3/2)), and √(2 g L/3) for √(6 g L)/3."""

from __future__ import annotations

from typing import Any

import sympy as sp

HALF = sp.Rational(1, 2)
DEEPEST = 4
"""Deeper roots stay as they are."""


def with_whole_powers(factors: list[Any]) -> list[Any]:
    """Factors as they are read, two or more fractional powers of which one is no square root put under one root."""
    broken = [f for f in factors if _exponent(f) is not None]
    if len(broken) < 2 or all(abs(f.exp) == HALF for f in broken):
        return factors
    depth = sp.ilcm(*(f.exp.q for f in broken))
    if depth > DEEPEST or (depth > 2 and sum(f.exp.q == depth for f in broken) < 2):
        return factors
    whole = [sp.Pow(f.base, f.exp * depth) for f in broken]
    rest = [f for f in factors if f not in broken]
    if depth == 2:
        return [*rest, *(sp.Pow(w, HALF, evaluate=False) for w in whole)]
    return [*rest, sp.Pow(sp.Mul(*whole), sp.Rational(1, depth), evaluate=False)]


def _exponent(factor: Any) -> Any:
    """A fractional exponent of a factor; None: it has none."""
    return factor.exp if factor.is_Pow and factor.exp.is_Rational and factor.exp.q > 1 else None


def absorbed(coefficient: Any, inside: list[Any], below: list[Any], beside: bool) -> tuple[Any, list[Any]]:
    """A coefficient and the factors above the bar under a root, where a fraction before the root goes under it as far
    as that is shorter: √(6 g L)/3 is √(2 g L/3). `below`: those below the bar; `beside`: other factors stand before
    the root, so that only what the denominator shares with it goes: a √(6 k/m)/3 is a √(2 k/(3 m)).
    """
    number = sp.prod(f for f in inside if f.is_Integer)
    letters = [f for f in inside if not f.is_Integer]
    if not (letters or below) or not coefficient.is_Rational or coefficient.q == 1 or number == 1:
        return coefficient, inside
    moved = coefficient * coefficient * number
    before = f"{abs(coefficient.p)}{coefficient.q}{number}"
    if letters and not beside and (moved.p < number or len(f"{moved.p}{moved.q}") < len(before)):
        return sp.sign(coefficient), [moved, *letters]
    shared = number / sp.Integer(coefficient.q) ** 2
    if shared.q <= coefficient.q:
        return sp.Integer(coefficient.p), [shared, *letters]
    return coefficient, inside
