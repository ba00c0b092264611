"""A normal force that a check names, and that no line of the page has told: from the sum of forces along it."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.plain import longer, simplified
from planar_cli.problem.facts import Push
from planar_cli.problem.scene import GROUND
from planar_cli.report.blocks import Math
from planar_cli.report.words import Phrases
from planar_cli.solve.solution import InstantSolution

LONGEST, CERTAIN = 20, Decimal("1e-12")
"""Operations of a formula that still fits a check; what a number may be off."""


def formula_of_press(
    instant: InstantSolution, push: Push, symbol: sp.Symbol, number: Decimal, phrases: Phrases
) -> list[Math]:
    """N = m g + … of the body on which it acts; empty where a line tells it already, or where it is long."""
    stages = instant.stages
    if (
        any(symbol in b.unknowns for s in stages for b in s.blocks)
        or symbol in instant.trial.system.scene.ledger.values
    ):
        return []
    for action in push.actions:
        if action.body == GROUND or action.force is None:
            continue
        formula = _sum_along(instant, action.body, action.force, symbol)
        known = None if formula is None else phrases.value.known(formula)
        told = formula is not None and known is not None and not longer(formula, LONGEST) and not formula.is_number
        if formula is not None and told and known is not None and abs(known - number) <= CERTAIN * abs(number):
            return [phrases.math(formula)]
    return []


def _sum_along(instant: InstantSolution, body: str, way: sp.Expr, symbol: sp.Symbol) -> sp.Expr | None:
    """What a unit force has to be for the sum of forces along it; None: it is not alone."""
    system = instant.trial.system
    assert system.reactions is not None
    acting = [w.force.dot(way) for w in system.wrenches if w.body == body and w.force is not None]
    acting += [
        expr * a.force.dot(way)
        for push, expr in system.reactions.pushes
        for a in push.actions
        if a.body == body and a.force is not None
    ]
    model = system.scene.bodies[body]
    inertia = sp.S.Zero
    if not system.balanced(body) and system.motion is not None and model.mass != 0:
        a = system.motion.acceleration(model.center, body)
        values = (instant.value.known(sp.sympify(a.x)), instant.value.known(sp.sympify(a.y)))
        if None in values:
            return None
        inertia = sp.S.Zero if instant.value.is_zero(a.dot(way)) else model.mass * a.dot(way)
    whole = sp.expand(simplified(sp.Add(*acting)))
    rest = sp.Add(*(t for t in sp.Add.make_args(whole) if not t.has(symbol) and not instant.value.vanishes(t)))
    own = sp.Add(*(t for t in sp.Add.make_args(whole) if t.has(symbol)))
    return simplified(inertia - rest) if own == symbol else None
