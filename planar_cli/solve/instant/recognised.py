"""A long coefficient that is something simple: a fraction, a length of the file, the sine or cosine of an angle of it.

What a drawing tells by several coordinates often is R cos β, or just 1. Its value to sixty digits suggests it; that it
holds for other numbers of the file too makes it so.
"""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from fractions import Fraction

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Ledger

LARGEST = 12
"""A fraction with a larger denominator is no simple one."""
CLOSE = Decimal("1e-40")
LETTERS, LONGEST = 6, 400
"""Of more letters, or from a longer formula, nothing is recognised."""
OTHERS = (Fraction(11, 10), Fraction(9, 11))
"""By such factors the letters have other numbers."""


def recognised(coefficient: sp.Expr, ledger: Ledger, value: Valuation) -> sp.Expr | None:
    """The simple formula that a coefficient is; None: none is found."""
    opened = _opened(coefficient, ledger)
    letters = sorted(opened.free_symbols & set(ledger.values), key=str)
    if opened.free_symbols - set(letters) or len(letters) > LETTERS or longer(opened, LONGEST):
        return None
    size = value.known(opened)
    if size is None:
        return None
    for simple in _simple(letters, ledger):
        unit = value.known(simple)
        factor = None if not unit else _fraction(size / unit)
        if factor is not None and all(_holds(opened - factor * simple, letters, value, k) for k in OTHERS):
            return factor * simple
    return None


def _opened(expr: sp.Expr, ledger: Ledger) -> sp.Expr:
    """With what named intermediates stand for."""
    while inside := {s: ledger.definitions[s] for s in expr.free_symbols if s in ledger.definitions}:
        expr = expr.xreplace(inside)
    return expr


def _simple(letters: list[sp.Symbol], ledger: Ledger) -> Iterator[sp.Expr]:
    """1, a length, and both times the sine or cosine of an angle."""
    angles = [s for s in letters if ledger.units[s].angle]
    turned = [sp.S.One, *(f(a) for a in angles for f in (sp.cos, sp.sin))]
    lengths = [sp.S.One, *(s for s in letters if s not in angles)]
    for turn in turned:
        for length in lengths:
            yield length * turn


def _fraction(number: Decimal) -> sp.Rational | None:
    """The simple fraction that it is."""
    near = Fraction(str(number)).limit_denominator(LARGEST)
    if not near or abs(Decimal(near.numerator) / Decimal(near.denominator) - number) > CLOSE * abs(number):
        return None
    return sp.Rational(near.numerator, near.denominator)


def _holds(expr: sp.Expr, letters: list[sp.Symbol], value: Valuation, scale: Fraction) -> bool:
    """Is it zero where each letter has another number?"""
    numbers = {s: _other(value(s), scale ** (i + 1)) for i, s in enumerate(letters)}
    found = Valuation(numbers).known(expr)
    return found is not None and abs(found) < CLOSE


def _other(number: Decimal, scale: Fraction) -> Decimal:
    return number * Decimal(scale.numerator) / Decimal(scale.denominator)
