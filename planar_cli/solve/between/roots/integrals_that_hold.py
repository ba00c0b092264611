"""Equations with integrals that are done by numbers: which of them hold along a motion that was followed.

A time by a place holds only while the motion goes one way, and it is written for either way; machine numbers tell at
once which one is meant. What stands before an integral is taken out of it.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import mpmath
import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.solve.regimes.equations import Equation

AGREES = 1e-6


def holding(equations: Sequence[Equation], truth: Mapping[sp.Symbol, float], base: Valuation) -> tuple[Equation, ...]:
    """The equations without those whose integrals contradict the motion that was followed."""
    return tuple(e for e in equations if not e.residual.has(sp.Integral) or _holds(e, truth, base))


def _holds(equation: Equation, truth: Mapping[sp.Symbol, float], base: Valuation) -> bool:
    residual = equation.residual
    found = {s: truth[s] if s in truth else base.known(s) for s in residual.free_symbols}
    numbers = {s: sp.Float(float(v), 17) for s, v in found.items() if v is not None}
    if len(numbers) < len(found):
        return True
    parts = [_number(term.xreplace(numbers)) for term in sp.Add.make_args(residual)]
    sizes = [abs(part) for part in parts if part is not None]
    if len(sizes) < len(parts):
        return False
    return abs(sum(part for part in parts if part is not None)) <= AGREES * max(*sizes, AGREES)


def _number(term: sp.Expr) -> float | None:
    """A term in machine numbers, its integrals by quadrature; None: it is not real, or not finite."""
    inside: dict[sp.Expr, sp.Expr] = {}
    for integral in term.atoms(sp.Integral):
        (x, low, high), *others = integral.limits
        if others or not (low.is_real and high.is_real):
            return None
        f = sp.lambdify([x], integral.function, modules="mpmath")
        try:
            area = _real(mpmath.quad(f, [mpmath.mpf(e.evalf(17)) for e in (low, high)]))
        except (ZeroDivisionError, ValueError):
            # A pole where the quadrature looks.
            return None
        if area is None:
            return None
        inside[integral] = sp.Float(area, 17)
    found = term.xreplace(inside).evalf(17)
    return _real(complex(found)) if found.is_finite else None


def _real(number: complex) -> float | None:
    found = complex(number)
    real = abs(found.imag) <= AGREES * max(abs(found.real), AGREES) and math.isfinite(found.real)
    return found.real if real else None


def taken_out(expr: sp.Expr) -> sp.Expr:
    """Factors that do not vary over an integral, before it."""

    def plain(integral: sp.Expr) -> sp.Expr:
        factor, rest = integral.function.as_independent(integral.limits[0][0], as_Add=False)
        return factor * sp.Integral(rest, *integral.limits)

    found: sp.Expr = expr.replace(lambda e: isinstance(e, sp.Integral) and len(e.limits) == 1, plain)
    return found
