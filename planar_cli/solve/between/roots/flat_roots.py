"""A root at which an equation does not change has half of the digits of its numbers. Where momentum and energy both
tell a velocity, energy may be flat there, as it is least for a given momentum.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import derivative
from planar_cli.equation.values.exact import Valuation
from planar_cli.solve.regimes.equations import Equation

FLAT = Decimal("1e-12")
"""A slope of less, in parts of what the equation is made of, for an ordinary change."""


def better_told(
    own: Equation,
    x: sp.Symbol,
    rest: Sequence[tuple[Equation, frozenset[sp.Symbol]]],
    here: Valuation,
    natural: Mapping[sp.Symbol, Decimal],
) -> bool:
    """Is the root of x that `here` has a flat one of its equation, and not of another one that tells x alone?"""
    others = [e for e, unknowns in rest if unknowns == {x} and e is not own and not e.residual.has(sp.Integral)]
    if not others or own.residual.has(sp.Integral):
        return False
    size = natural.get(x, Decimal(1))
    return _is_flat(own, x, here, size) and not all(_is_flat(e, x, here, size) for e in others)


def _is_flat(equation: Equation, x: sp.Symbol, here: Valuation, size: Decimal) -> bool:
    slope = here.known(derivative(equation.residual, x))
    return slope is not None and abs(slope) * max(abs(here(x)), size) <= FLAT * here.size(equation.residual)
