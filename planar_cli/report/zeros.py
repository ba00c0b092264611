"""Letters of states that are zero are left out of what is told after them."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.solve.between.trace import Result, RouteStep, RouteTrace


def without_zeros(step: RouteStep, route: RouteTrace, before: Sequence[RouteStep]) -> tuple[RouteStep, RouteTrace]:
    """A derivation and its route without the letters that those `before` it, or data, have found to be zero."""
    found = [r for leg in (*route.steps, *before) if leg.is_datum or leg in before for r in leg.results]
    zeros = {r.unknown: sp.S.Zero for r in found if r.formula == 0}
    inside = set().union(*(e.residual.free_symbols for e in step.relations))
    zeros = {x: zero for x, zero in zeros.items() if x in inside and x not in step.unknowns}
    if not zeros:
        return step, route
    results = tuple(_without(r, zeros) for r in step.results)
    return replace(step, results=results), replace(route, plain={**route.plain, **zeros})


def _without(result: Result, zeros: dict[sp.Symbol, sp.Expr]) -> Result:
    """A result whose formula still is one without them."""
    if result.formula is None or result.formula.is_Symbol:
        return result
    formula = result.formula.xreplace(zeros)
    return result if formula.is_number or formula.has(sp.nan, sp.zoo) else replace(result, formula=formula)


def that_vanish(product: sp.Expr, unknowns: Collection[sp.Symbol]) -> sp.Expr:
    """What can vanish of a product that is zero: sin(ω_d t) of x_0 ω_n² sin(ω_d t) exp(-ζ ω_n t)/ω_d, without factors
    that hold no unknown, and without exponentials.
    """
    factors = [f for f in sp.Mul.make_args(product) if f.free_symbols & set(unknowns) and not isinstance(f, sp.exp)]
    return sp.Mul(*factors) if factors and not any(f.is_Pow and f.exp.is_negative for f in factors) else product
