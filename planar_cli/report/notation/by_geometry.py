"""Formulas made shorter by relations of geometry that stand beside them: with 0 = r sin φ + l sin θ, the height
r sin φ + l sin θ is none.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import longer
from planar_cli.equation.values.ledger import Kind
from planar_cli.solve.between.trace.trace import MotionTrace, RouteStep, RouteTrace

LONGEST = 40
"""A longer formula is left as it is."""


def geometry_beside(leg: RouteStep, route: RouteTrace, found: MotionTrace) -> list[sp.Expr]:
    """What vanishes by the relations of places in a step; a condition of forces, which holds speeds, is none."""
    roles = found.ledger.roles
    speeds = {own for own, general in found.general.items() if roles[general].kind is Kind.SPEED}
    placed = (e.residual.xreplace(route.plain) for e in leg.relations if e.source is None and e.span is None)
    return [residual for residual in placed if not speeds & residual.free_symbols]


def by_geometry(expr: sp.Expr, residuals: Collection[sp.Expr], unknowns: Collection[sp.Symbol]) -> sp.Expr:
    """The shortest form of an expression that differs from it by multiples of residuals, which vanish."""
    if not residuals or longer(expr, LONGEST) or not expr.free_symbols & set(unknowns):
        return expr
    opened = found = expanded(expr)
    for residual in residuals:
        found = min((found, *_without(found, residual, unknowns)), key=operations)
    return expr if found == opened else found


def _without(expr: sp.Expr, residual: sp.Expr, unknowns: Collection[sp.Symbol]) -> Iterator[sp.Expr]:
    """The expression without each of the terms that both have."""
    if longer(residual, LONGEST):
        return
    own, other = _terms(expr, unknowns), _terms(residual, unknowns)
    for part, factor in other.items():
        if part != 1 and part in own:
            yield expanded(expr - own[part] / factor * residual)


def _terms(expr: sp.Expr, unknowns: Collection[sp.Symbol]) -> dict[sp.Expr, sp.Expr]:
    """The coefficients of what holds unknowns."""
    found: dict[sp.Expr, sp.Expr] = {}
    for term in sp.Add.make_args(expanded(expr)):
        known, part = term.as_independent(*unknowns, as_Add=False)
        found[part] = found.get(part, sp.S.Zero) + known
    return found
