"""Equations of a state that are put into one of them, as they come: y = -3/4 x with x = v t and y = u t - g t²/2 reads
u t - g t²/2 = -3/4 v t before it is sorted; and once x is known, y follows from y = -3/4 x.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.plain import by_name
from planar_cli.solve.between.trace.trace import Result

Others = tuple[tuple[int, Result], ...]


def put_into(
    residual: sp.Expr, formulas: Mapping[sp.Symbol, sp.Expr], time: sp.Symbol
) -> tuple[sp.Expr, sp.Expr] | None:
    """Both sides of letter = formula with everything put in; None: the time would stand on one side alone, so that what
    is sorted says as much.
    """
    for letter in by_name(residual.free_symbols & formulas.keys()):
        slope = sp.diff(residual, letter)
        if slope not in (1, -1):
            continue
        other = sp.expand(letter - residual / slope)
        for _ in formulas:
            other = other.xreplace(dict(formulas))
        sides = formulas[letter], other
        if all(time in side.free_symbols and not side.free_symbols & formulas.keys() for side in sides):
            return sides
    return None


def by_shorter(others: Others, into: int, residual: sp.Expr, unknowns: set[sp.Symbol]) -> Others:
    """Results with the equation into which all were put, where that gives one of them in fewer steps by those before.
    `into`, `residual`: that equation; `unknowns`: of the step.
    """
    found: list[tuple[int, Result]] = []
    told: set[sp.Symbol] = set()
    for i, result in others:
        x, slope = result.unknown, sp.diff(residual, result.unknown)
        own = sp.expand(x - residual / slope) if slope != 0 and slope.is_number else x
        known = own.free_symbols & unknowns <= told and bool(own.free_symbols & told)
        shorter = result.formula is not None and operations(own) < operations(result.formula)
        found.append((into, Result(x, own, result.value)) if known and shorter else (i, result))
        told.add(x)
    return tuple(found)
