"""The distance of a point from the origin in place of its two coordinates, where it stays what it is drawn: what is
carried round by a disk.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import combinations

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import simplified


def with_kept_radius(
    expr: sp.Expr,
    drawn: Mapping[sp.Symbol, sp.Expr],
    rates: Mapping[sp.Symbol, sp.Expr],
    stays: Callable[[sp.Symbol, sp.Symbol], bool],
) -> sp.Expr:
    """The expression with x² + y² as the drawn one, wherever that stays and x and y enter in this way alone. `drawn`:
    the coordinates of the position drawn; `rates`: those of all coordinates; `stays`: is the distance the drawn one?
    """
    for x, y in _pairs(expr, drawn):
        change = 2 * x * rates.get(x, sp.S.Zero) + 2 * y * rates.get(y, sp.S.Zero)
        if simplified(change) != 0 or not stays(x, y):
            continue
        square = sp.Dummy("square", positive=True)
        found = expanded(expanded(expr).xreplace({y**2: square - x**2, y**4: (square - x**2) ** 2}))
        if not {x, y} & found.free_symbols:
            return simplified(found.xreplace({square: simplified(drawn[x] ** 2 + drawn[y] ** 2)}))
    return expr


def _pairs(expr: sp.Expr, drawn: Mapping[sp.Symbol, sp.Expr]) -> Sequence[tuple[sp.Symbol, sp.Symbol]]:
    """Two coordinates x_P and y_P of one point."""
    inside = sorted((s for s in expr.free_symbols if s in drawn), key=lambda s: s.name)
    return [
        (a, b) for a, b in combinations(inside, 2) if (a.name[0], b.name[0]) == ("x", "y") and a.name[1:] == b.name[1:]
    ]
