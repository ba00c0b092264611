"""Forces at contacts that a page compares with what bounds them, and that no line has told: from sums of forces."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.system.system import System
from planar_cli.problem.scene.facts import Push, Test
from planar_cli.problem.scene.scene import GROUND
from planar_cli.report.document.blocks import Math
from planar_cli.report.words.words import Phrases
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
    for formula in sum_of_forces(instant, push, symbol):
        known = phrases.value.known(formula)
        if known is not None and not formula.is_number and abs(known - number) <= CERTAIN * abs(number):
            return [phrases.math(formula)]
    return []


def sum_of_forces(instant: InstantSolution, push: Push, symbol: sp.Symbol) -> Iterator[sp.Expr]:
    """What a push is by the sum of forces along it, of each body on which it acts, where that is short."""
    for action in push.actions:
        if action.body != GROUND and action.force is not None:
            formula = _sum_along(instant, action.body, action.force, symbol)
            if formula is not None and not longer(formula, LONGEST):
                yield formula


def bounded_in(system: System, test: Test) -> str | None:
    """The name of the friction, or of the couple of a normal force on a face, that a test bounds; None: it is about
    something else.
    """
    bounded = {p.name for p in system.pushes if p.kind in ("friction", "couple")}
    return next((n for n, factor in test.pushes if n in bounded and abs(factor) == 1), None)


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
