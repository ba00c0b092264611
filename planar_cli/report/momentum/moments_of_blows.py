"""Equations of a blow in the letters of a course: arms that are numbers of the file by their ends, J AS for 1.5 J,
moments of inertia as I, and an impulse as m ((R - h) ω - v).
"""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.values.ledger import NAMED
from planar_cli.records import record
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import ImpactEquation
from planar_cli.units import parse_unit

IMPULSE = "J_"
"""Begins the names of impulses."""


@record
class Named:
    """Both sides of an equation of moments or momenta, and the numbers of the letters that only it has."""

    left: sp.Expr
    right: sp.Expr
    sizes: dict[sp.Symbol, Decimal]

    def solved(self, unknown: sp.Symbol) -> sp.Expr | None:
        """The unknown by these letters; None: it does not enter plainly."""
        residual = self.left - self.right
        rate = sp.diff(residual, unknown)
        if rate == 0 or unknown in rate.free_symbols:
            return None
        rest, rate = residual.subs(unknown, 0), sp.factor_terms(rate)
        # By what counts as positive: (m v_0 (R - h) + I_G ω_1)/I_K, without a minus before a difference.
        if not self.sizes:
            return sp.factor_terms(-rest / rate) if unknown.name.startswith(IMPULSE) else None
        return sp.Mul(rest, 1 / -rate) if rate.could_extract_minus_sign() else sp.Mul(-rest, 1 / rate)


def with_letters(e: ImpactEquation, left: sp.Expr, right: sp.Expr, phrases: Phrases) -> Named | None:
    """An equation of moments with the letters of its arms and moments of inertia; None: it has none of its own. One of
    momenta as it stands, where an impulse by its terms is shorter than what comes of it: m ((R - h) ω - v).
    """
    solution = e.impact.solution
    if e.law == "force":
        impulses = [s for s in (left - right).free_symbols if s.name.startswith(IMPULSE)]
        own = Named(left, right, {})
        short = len(impulses) == 1 and (formula := own.solved(impulses[0])) is not None and _is_shorter(formula)
        return own if short else None
    if e.law != "moment" or solution is None:
        return None
    sizes: dict[sp.Symbol, Decimal] = {}
    for impulse, letter, distance in _arms(e):
        factor = sp.expand(left).coeff(impulse)
        if factor.is_number and distance.is_number and abs(factor) == distance != 0:
            phrases.ledger.know(letter, parse_unit("m"), NAMED)
            sizes[letter] = phrases.value(distance)
            left = sp.expand(left) - factor * impulse + sp.sign(factor) * letter * impulse
    ledger = solution.instant.scene.ledger
    for symbol in (left - right).free_symbols & ledger.definitions.keys():
        phrases.ledger.know(symbol, ledger.units[symbol], NAMED)
        sizes[symbol] = solution.value(symbol)
    return Named(left, right, sizes) if sizes else None


def _is_shorter(formula: sp.Expr) -> bool:
    """Has a formula fewer operations than it has multiplied out and simplified?"""
    if not any(p.is_Add and p is not formula for p in sp.preorder_traversal(formula)):
        return False
    return operations(formula) < operations(simplified(sp.expand(formula)))


def _arms(e: ImpactEquation) -> Iterator[tuple[sp.Symbol, sp.Symbol, sp.Expr]]:
    """The impulses of an equation that act at named points, with the letter AS and the length of their arms from a
    named centre A.
    """
    assert e.impact.solution is not None
    solution = e.impact.solution
    scene, value, system = solution.instant.scene, solution.value, solution.trial.system
    if e.lead not in scene.points:
        return
    for w in system.wrenches:
        if w.kind != "impulse" or w.body not in e.bodies or not sp.sympify(w.magnitude).is_Symbol:
            continue
        for name, place in scene.points.items():
            apart, arm = place - w.point, w.point - scene.points[e.lead]
            if "_" not in name and value.is_zero(apart.x) and value.is_zero(apart.y):
                yield w.magnitude, sp.Symbol(f"{e.lead}{name}", positive=True), sp.sqrt(arm.dot(arm))
                break
