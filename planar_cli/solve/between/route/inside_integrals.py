"""What stands inside an integral: the speed at the start of a swing that takes so long to an angle."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import sympy as sp

from planar_cli.equation.algebra.plain import by_name, derivative
from planar_cli.equation.values.exact import Valuation
from planar_cli.solve.between.trace.derivation import Edge
from planar_cli.solve.regimes.equations import Equation

COST = 4.5
"""What it costs to find a letter by trial: more than any equation that tells it plainly."""


def inside_integrals(
    equations: Sequence[Equation],
    inside: Callable[[Equation], frozenset[sp.Symbol]],
    residual: Callable[[Equation], sp.Expr],
    value: Valuation,
) -> list[Edge]:
    """Letters in the integrals of times over ways, each from the time that is known. `inside`: the unknowns of an
    equation; `residual`: what vanishes in it; `value`: numbers of everything.
    """
    found: list[Edge] = []
    for e in (e for e in equations if e.kind == "t(q)" and e.residual.has(sp.Integral)):
        for x in by_name(inside(e) - outside_integrals(residual(e))):
            rate = value.known(derivative(residual(e), x))
            if rate is not None and rate.is_finite() and rate:
                found.append(((e,), (x,), inside(e) - {x}, e.cost + COST))
    return found


def outside_integrals(residual: sp.Expr) -> set[sp.Symbol]:
    """Symbols outside of integrals."""
    return set().union(*(a.free_symbols for a in sp.Add.make_args(residual) if not a.has(sp.Integral)))
