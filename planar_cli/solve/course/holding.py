"""Equations with integrals that are done by numbers: which of them hold along a motion that was followed.

A time by a place holds only while the motion goes one way, and it is written for either way; machine numbers tell at
once which one is meant. What stands before an integral is taken out of it.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import mpmath
import sympy as sp

from planar_cli.equation.exact import Unvalued, Valuation
from planar_cli.solve.course.equations import Equation

AGREES = 1e-6


def holding(equations: Sequence[Equation], truth: Mapping[sp.Symbol, float], base: Valuation) -> tuple[Equation, ...]:
    """The equations without those whose integrals contradict the motion that was followed."""
    return tuple(e for e in equations if not e.residual.has(sp.Integral) or _holds(e, truth, base))


def _holds(equation: Equation, truth: Mapping[sp.Symbol, float], base: Valuation) -> bool:
    residual = equation.residual
    try:
        numbers = {s: sp.Float(truth[s] if s in truth else float(base(s)), 17) for s in residual.free_symbols}
    except Unvalued:
        return True
    total, size = 0.0, 0.0
    try:
        for term in sp.Add.make_args(residual):
            part = _number(term.xreplace(numbers))
            total, size = total + part, max(size, abs(part))
    except (ArithmeticError, ValueError, TypeError):
        return False
    return abs(total) <= AGREES * max(size, AGREES)


def _number(term: sp.Expr) -> float:
    """A term in machine numbers; its integrals by quadrature."""
    inside: dict[sp.Expr, sp.Expr] = {}
    for integral in term.atoms(sp.Integral):
        (x, low, high), *others = integral.limits
        if others:
            raise ValueError("an integral over several variables")
        f = sp.lambdify([x], integral.function, modules="mpmath")
        inside[integral] = sp.Float(_real(mpmath.quad(f, [mpmath.mpf(low), mpmath.mpf(high)])), 17)
    return _real(complex(term.xreplace(inside).evalf(17)))


def _real(number: complex) -> float:
    found = complex(number)
    if abs(found.imag) > AGREES * max(abs(found.real), AGREES) or not math.isfinite(found.real):
        raise ValueError("not real")
    return found.real


def taken_out(expr: sp.Expr) -> sp.Expr:
    """Factors that do not vary over an integral, before it."""

    def plain(integral: sp.Expr) -> sp.Expr:
        factor, rest = integral.function.as_independent(integral.limits[0][0], as_Add=False)
        return factor * sp.Integral(rest, *integral.limits)

    found: sp.Expr = expr.replace(lambda e: isinstance(e, sp.Integral) and len(e.limits) == 1, plain)
    return found
