"""Two equations in two unknowns of which one goes as its square: m v_A² + m v_B² = c and v_A + v_B = u."""

from __future__ import annotations

import itertools
from collections.abc import Callable

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.solve.between.roots.substitution import square
from planar_cli.solve.between.trace.trace import Result
from planar_cli.solve.instant.elimination import Pending, alone, subtracted

Single = Callable[[sp.Expr, sp.Symbol], Result]
"""What an equation gives for its one unknown."""


def by_squares(pool: list[sp.Expr], left: list[sp.Symbol], value: Valuation, single: Single) -> list[Result]:
    """Two equations from which the square of one unknown goes; empty: it does not."""
    if not len(pool) == len(left) == 2:
        return []
    made = subtracted([Pending(r, ()) for r in pool], left, value, True)
    index = None if made is None else alone(made, left)
    if made is None or index is None:
        return _square_put_in(pool, left, value, single)
    x, y = sorted(left, key=lambda s: s not in made[index].residual.free_symbols)
    return [single(made[index].residual, x), single(made[1 - index].residual, y)]


def _square_put_in(pool: list[sp.Expr], left: list[sp.Symbol], value: Valuation, single: Single) -> list[Result]:
    """The same where one unknown enters as its square alone: that is put into the other equation."""
    for x, (first, second) in itertools.product(left, (pool, pool[::-1])):
        own, other = square(first, x), square(second, x)
        if own is None or other is None or value.is_zero(own[1]):
            continue
        (y,) = (s for s in left if s != x)
        found = single(simplified(other[0] - other[1] * own[0] / own[1]), y)
        if found.formula is not None:
            return [found, single(first, x)]
    return []
