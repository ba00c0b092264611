"""A simple harmonic motion a quarter or half a period after it began: its sine and cosine are then numbers that
everybody knows, so that times, places and velocities follow without an inverse function.
"""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.calculus.linear_laws import UNDAMPED
from planar_cli.equation.algebra.plain import derivative, simplified
from planar_cli.equation.values.exact import PI, Valuation
from planar_cli.solve.regimes.equations import Equation


def is_harmonic(e: Equation) -> bool:
    """Is it the place or the velocity of a simple harmonic motion over time?"""
    return e.span is not None and e.kind in ("q(t)", "v(t)") and e.span.words == UNDAMPED


def quarters(residual: sp.Expr, value: Valuation) -> tuple[sp.Expr, int] | None:
    """The sine or cosine in such an equation, and how many quarters of a turn its angle is. None: no whole number; or
    it has both, as it began neither at rest nor in its middle, so that the angle would not be seen.
    """
    (wave, *more) = residual.atoms(sp.sin, sp.cos) or (None,)
    number = None if wave is None or more else value.known(wave.args[0])
    if wave is None or number is None:
        return None
    count = round(number * 2 / PI)
    return (wave, count) if abs(number * 2 / PI - count) < Decimal("1e-20") else None


def at_quarters(residual: sp.Expr, x: sp.Symbol, value: Valuation) -> tuple[sp.Expr, sp.Expr] | None:
    """Such an equation with the number that its sine or cosine is, and its unknown by the number that the angle is.
    None: it is none, or that gives nothing.
    """
    if (found := quarters(residual, value)) is None:
        return None
    (wave, count) = found
    told = sp.pi * count / 2
    dated = x in wave.free_symbols
    plain = wave - wave.func(told) if dated else residual.xreplace({wave: wave.func(told)})
    linear = wave.args[0] - told if dated else plain
    rate = derivative(linear, x)
    if x in rate.free_symbols or value.known(rate) is None or value.is_zero(rate):
        return None
    return plain, simplified(-linear.xreplace({x: sp.S.Zero}) / rate)
