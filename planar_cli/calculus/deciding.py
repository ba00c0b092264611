"""Signs and zeros of expressions by their letters or their values, and closed forms confirmed at drawn points."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import MANY, identically_zero, longer
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.sample import generator

CONFIRMED, DRAWS = 2, 16
"""So many points must confirm a closed form, of so many that are tried."""
_NUMBERS = Valuation({})


def sign(expr: sp.Expr, value: Valuation | None = None) -> int | None:
    """-1, 0 or 1: by the assumptions on its letters, else by its value; None: undecided."""
    if expr.is_zero or vanishes(expr):
        return 0
    if expr.is_positive:
        return 1
    if expr.is_negative:
        return -1
    numbers = value or _NUMBERS
    number = numbers.known(expr)
    return None if number is None else 0 if numbers.is_zero(expr) else int(Decimal(1).copy_sign(number))


def vanishes(expr: sp.Expr, value: Valuation | None = None) -> bool:
    """Is the expression zero, identically or with the values at hand?"""
    if expr.is_zero:
        return True
    if expr.is_Symbol or expr.is_Rational:
        if value is None or expr.is_Rational:
            return False
    elif not longer(expr, MANY) and identically_zero(expr):
        return True
    return value is not None and value.vanishes(expr)


def confirmed(difference: sp.Expr, value: Valuation | None = None, free: tuple[sp.Symbol, ...] = ()) -> bool:
    """Does the difference vanish at drawn points? The letters `free` are drawn even if they have values."""
    if difference == 0:
        return True
    draw = generator(4)
    found = 0
    for trial in range(DRAWS):
        numbers = {}
        for symbol in sorted(difference.free_symbols, key=lambda s: s.name):
            drawn = Decimal(draw.randint(2000, 19999)) / 10000
            if symbol in free:
                drawn = drawn.scaleb(-(trial // 3))
            if symbol in free and not symbol.is_positive and trial % 3 == 2:
                drawn = -drawn
            numbers[symbol] = drawn if symbol in free else _value(symbol, value, drawn)
        point = Valuation(numbers)
        if point.known(difference) is None:
            continue
        if not point.is_zero(difference):
            return False
        found += 1
        if found == CONFIRMED:
            return True
    return False


def _value(symbol: sp.Symbol, value: Valuation | None, drawn: Decimal) -> Decimal:
    if value is None:
        return drawn
    known = value.known(symbol)
    return known if known is not None else -drawn if symbol.is_negative else drawn
