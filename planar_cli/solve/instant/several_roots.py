"""Real roots of a few equations in as many unknowns, none of which can be expressed by the others.

Newton's method goes from many places, about zero and as far as a few ordinary sizes away; what it reaches is made
exact. Whether these are all roots nobody can say, as with any search; letters without numbers have none.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from decimal import Decimal
from typing import TypeVar

import sympy as sp

from planar_cli.equation.algebra.machine import compiled
from planar_cli.equation.algebra.plain import derivative
from planar_cli.equation.values.exact import PI, Valuation
from planar_cli.errors import NoValue

PLACES = {2: (-2.9, -1.3, -0.61, -0.23, 0.17, 0.53, 1.1, 2.7), 3: (-1.3, -0.31, 0.43, 1.1)}
"""Where a search begins, in ordinary sizes; not even, so that no axis of symmetry is hit."""
ANGLES = {2: (-2.9, -1.7, -0.9, -0.31, 0.23, 0.83, 1.6, 2.7), 3: (-2.6, -0.9, 0.7, 2.3)}
"""The same of an angle [rad]."""
STEPS, EXACT_STEPS = 50, 12
FARTHEST = 100.0
"""What runs away so many ordinary sizes finds nothing."""
NEAR, SMALL, SAME = 1e-11, Decimal("1e-45"), Decimal("1e-20")
OUTSIDE = (ValueError, ZeroDivisionError, OverflowError, TypeError)

Values = dict[sp.Symbol, Decimal]
T = TypeVar("T", float, Decimal)


def roots_together(
    residuals: Sequence[sp.Expr],
    unknowns: Sequence[sp.Symbol],
    value: Valuation,
    natural: Callable[[sp.Symbol], Decimal],
    angles: frozenset[sp.Symbol],
) -> list[Values]:
    """All roots that are found, those near zero first."""
    count = len(unknowns)
    if count not in PLACES or len(residuals) < count:
        return []
    equations = list(residuals[:count])
    slopes = [[derivative(e, x) for x in unknowns] for e in equations]
    flat = [*equations, *(d for row in slopes for d in row)]
    call = compiled(flat, list(unknowns), lambda s: float(value(s)))
    sizes = [1.0 if x in angles else float(natural(x)) for x in unknowns]
    found: list[Values] = []
    starts = (ANGLES[count] if x in angles else PLACES[count] for x in unknowns)
    for start in itertools.product(*starts):
        near = _newton(call, [s * size for s, size in zip(start, sizes, strict=True)], sizes)
        exact = None if near is None else _exact(equations, slopes, unknowns, near, value)
        if exact is not None:
            turned = {x: _in_one_turn(v) if x in angles else v for x, v in exact.items()}
            if not any(_same(turned, other, natural) for other in found):
                found.append(turned)
    found = [v for v in found if all(_holds(e, v, value) for e in residuals)]
    return sorted(found, key=lambda v: sum((abs(v[x]) / natural(x) for x in unknowns), Decimal(0)))


def _newton(call: Callable[..., Sequence[float]], at: list[float], sizes: list[float]) -> list[float] | None:
    """Newton's method in machine numbers, every step of an ordinary size at most; None: it comes nowhere."""
    n = len(at)
    for _ in range(STEPS):
        try:
            numbers = list(call(*at))
        except OUTSIDE:
            return None
        if not all(map(math.isfinite, numbers)):
            return None
        rows = [[*numbers[n + i * n : n + (i + 1) * n], numbers[i]] for i in range(n)]
        step = _solved([[a * s for a, s in zip(row, [*sizes, 1.0], strict=True)] for row in rows])
        if step is None:
            return None
        longest = max(map(abs, step))
        short = min(1.0, 0.7 / longest) if longest else 1.0
        at = [a - short * d * s for a, d, s in zip(at, step, sizes, strict=True)]
        if longest < NEAR:
            return at
        if any(abs(a) > FARTHEST * s for a, s in zip(at, sizes, strict=True)):
            return None
    return None


def _exact(
    equations: Sequence[sp.Expr],
    slopes: Sequence[Sequence[sp.Expr]],
    unknowns: Sequence[sp.Symbol],
    near: Sequence[float],
    value: Valuation,
) -> Values | None:
    """The root next to a place, to all digits; None: it does not stay there."""
    at = {x: Decimal(repr(v)) for x, v in zip(unknowns, near, strict=True)}
    for _ in range(EXACT_STEPS):
        here = value.extended(at)
        try:
            rows = [[*(here(d) for d in row), here(e)] for row, e in zip(slopes, equations, strict=True)]
        except NoValue:
            return None
        step = _solved(rows)
        if step is None:
            return None
        at = {x: at[x] - d for x, d in zip(unknowns, step, strict=True)}
        if all(abs(d) <= SMALL * max(abs(at[x]), Decimal(1)) for x, d in zip(unknowns, step, strict=True)):
            return {x: Decimal(0) if abs(v) < SMALL else v for x, v in at.items()}
    return None


def _solved(rows: list[list[T]]) -> list[T] | None:
    """The solution of linear equations, each with its right side last; None: they are singular."""
    n = len(rows)
    for i in range(n):
        pivot = max(range(i, n), key=lambda k: abs(rows[k][i]))
        if not rows[pivot][i]:
            return None
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for k in range(n):
            if k != i and rows[k][i]:
                factor = rows[k][i] / rows[i][i]
                rows[k] = [a - factor * b for a, b in zip(rows[k], rows[i], strict=True)]
    return [rows[i][n] / rows[i][i] for i in range(n)]


def _in_one_turn(v: Decimal) -> Decimal:
    return v - 2 * PI * ((v / (2 * PI)).to_integral_value())


def _same(one: Values, other: Values, natural: Callable[[sp.Symbol], Decimal]) -> bool:
    return all(abs(v - other[x]) <= SAME * natural(x) for x, v in one.items())


def _holds(residual: sp.Expr, values: Values, value: Valuation) -> bool:
    return value.extended(values).is_zero(residual)
