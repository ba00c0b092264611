"""The distance from the origin of what a state puts on a straight line through it: √(x² + y²) = 5/4 x, where y is
-3/4 x.
"""

from __future__ import annotations

import sympy as sp

from planar_cli.solve.between.trace.trace import MotionTrace

HALF = sp.Rational(1, 2)


def along_the_line(formula: sp.Expr, found: MotionTrace) -> sp.Expr | None:
    """A root of two squares by one of their letters, where an equation of the motion tells their ratio and no root is
    left; None: it is another formula.
    """
    if not formula.is_Pow or formula.exp != HALF or len(formula.free_symbols) != 2:
        return None
    for e in (e for leg in found.route.steps for e in leg.relations):
        if e.residual.free_symbols != formula.free_symbols:
            continue
        for x in sorted(e.residual.free_symbols, key=lambda s: s.name):
            (other,) = e.residual.free_symbols - {x}
            slope = sp.diff(e.residual, other)
            ratio = sp.simplify((other - e.residual / slope) / x) if slope.is_number else x
            size = sp.sqrt(sp.simplify(formula.base.xreplace({other: ratio * x}) / x**2))
            if ratio.is_Rational and size.is_Rational and found.value.known(x):
                return size * x if found.value(x) > 0 else -size * x
    return None
