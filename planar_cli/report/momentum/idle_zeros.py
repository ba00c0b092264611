"""Velocities that nothing changes from nought, and that nobody asks for: the sideways one of a ball that is dropped."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.values.ledger import Kind
from planar_cli.report.given.conditions_of_states import is_own_name
from planar_cli.solve.between.trace.trace import BalanceTrace, ImpactEquation, MotionTrace, Relation, RouteStep

BLOW, MOMENTUM = "blow", "momentum"
"""The kinds of equations across a blow, and of those between states, that balance momenta."""


def is_untold(step: RouteStep, found: MotionTrace) -> bool:
    """Is a step no derivation that is told: what is known anyway, another name, or an idle zero?"""
    return step.is_datum or is_own_name(step) or is_idle(step, found)


def is_idle(step: RouteStep, found: MotionTrace) -> bool:
    """Does a step only say that a velocity along a line, of which a find does not ask by itself, is still zero? What
    is told after it does without it.
    """
    if len(step.relations) > 1 or any(r.formula != 0 for r in step.results):
        return False
    asked = {part for request in found.requests for part in request.parts}
    plain = all(_is_velocity(x, found) and not asked & {x, -x} for x in step.unknowns)
    return plain and _keeps_momentum(step.relations[0], found)


def idle_zeros(found: MotionTrace) -> set[sp.Symbol]:
    """The velocities of the route that are still zero and of which nothing is told."""
    return {x for step in found.route.steps if is_idle(step, found) for x in step.unknowns}


def _keeps_momentum(e: Relation, found: MotionTrace) -> bool:
    """Is it a balance of linear momentum without an impulse, or what the velocities after a blow make of such zeros?"""
    match e.source:
        case ImpactEquation():
            return e.source.law == "force" and not e.residual.free_symbols & _impulses(found)
        case BalanceTrace():
            # Where a body turns, that its mass centre falls straight down is a reason for what follows.
            inside = e.residual.free_symbols & found.general.keys()
            return e.kind == MOMENTUM and not e.source.law.letter and all(_is_velocity(x, found) for x in inside)
    return e.source is None and e.kind == BLOW


def _impulses(found: MotionTrace) -> set[sp.Symbol]:
    """What blows give beside velocities."""
    blows = (step for step in found.route.steps if any(e.kind == BLOW for e in step.relations))
    return {x for step in blows for x in step.unknowns if not _is_velocity(x, found)}


def _is_velocity(symbol: sp.Symbol, found: MotionTrace) -> bool:
    """Is it a velocity along a line?"""
    role = found.ledger.roles.get(found.general.get(symbol, symbol))
    return role is not None and role.kind is Kind.SPEED and not symbol.name.startswith("omega")
