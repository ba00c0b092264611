"""The root of an equation beside what a motion that was followed shows."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.calculus.polish import polish
from planar_cli.equation.values.exact import Valuation
from planar_cli.solve.instant.roots import Root

REACHES = (Decimal("1e-10"), Decimal("1e-8"), Decimal("5e-7"))
"""So far about what was followed, in parts of its size, a root is looked for."""


def root_beside(residual: sp.Expr, x: sp.Symbol, here: Valuation, at: Decimal, size: Decimal) -> list[Root] | None:
    """The root next to a place; None: its sign does not change so near, and all roots have to be looked at. A way in
    time has its roots where its sign changes: if it does not there, none of them is meant.
    """

    def value(v: Decimal) -> Decimal:
        return here.extended({x: v})(residual)

    for reach in REACHES:
        low, high = at - reach * size, at + reach * size
        a, b = (here.extended({x: v}).known(residual) for v in (low, high))
        if a and b and (a > 0) != (b > 0):
            return [Root(None, polish(value, low, high))]
    timed = residual.is_Add and any(x in i.free_symbols for i in residual.atoms(sp.Integral))
    return [] if timed else None
