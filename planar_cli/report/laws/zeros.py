"""Letters of states that are zero are left out of what is told after them; of angles that are known the sine and cosine
are put in where that is simple: 0, 1, -1 of whole quarters of a turn, -cos β at β - 90°.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.solve.between.trace.trace import Result, RouteStep, RouteTrace


def without_zeros(step: RouteStep, route: RouteTrace, before: Sequence[RouteStep]) -> tuple[RouteStep, RouteTrace]:
    """A derivation and its route without the letters that those `before` it, or data, have found to be zero."""
    found = [r for leg in (*route.steps, *before) if leg.is_datum or leg in before for r in leg.results]
    inside = set().union(*(e.residual.free_symbols for e in step.relations)).difference(step.unknowns)
    known = {r.unknown: r.formula for r in found if r.unknown in inside and r.formula is not None}
    zeros = {x: sp.S.Zero for x, f in known.items() if f == 0}
    for x, f in known.items():
        zeros |= _waves(x, known.get(f, f))
    if not zeros:
        return step, route
    results = tuple(_without(r, zeros) for r in step.results)
    return replace(step, results=results), replace(route, plain={**route.plain, **zeros})


def _waves(angle: sp.Symbol, known: sp.Expr) -> dict[sp.Expr, sp.Expr]:
    """The sine and cosine of an angle that is known, if both are simple: neither a root nor a longer formula."""
    if known == 0 or not (known.is_number or known.has(sp.atan2) or known.is_Add):
        return {}
    found = {w(angle): simplified(w(known)) for w in (sp.sin, sp.cos)}
    simple = (f.is_Rational or _is_wave(-f if f.could_extract_minus_sign() else f) for f in found.values())
    return found if all(simple) else {}


def _is_wave(expr: sp.Expr) -> bool:
    return expr.func in (sp.sin, sp.cos) and expr.args[0].is_Symbol


def _without(result: Result, zeros: dict[sp.Symbol, sp.Expr]) -> Result:
    """A result whose formula still is one without them."""
    if result.formula is None or result.formula.is_Symbol:
        return result
    formula = result.formula.xreplace(zeros)
    if formula.is_number or formula.has(sp.nan, sp.zoo):
        return result
    roots = (r if r.expression is None else replace(r, expression=r.expression.xreplace(zeros)) for r in result.roots)
    return replace(result, formula=formula, roots=tuple(roots))


def that_vanish(product: sp.Expr, unknowns: Collection[sp.Symbol]) -> sp.Expr:
    """What can vanish of a product that is zero: sin(ω_d t) of x_0 ω_n² sin(ω_d t) exp(-ζ ω_n t)/ω_d, without factors
    that hold no unknown, and without exponentials.
    """
    factors = [f for f in sp.Mul.make_args(product) if f.free_symbols & set(unknowns) and not isinstance(f, sp.exp)]
    return sp.Mul(*factors) if factors and not any(f.is_Pow and f.exp.is_negative for f in factors) else product
