"""A rate at a state of which the page tells a function of the place: it is what the function is there, and needs no
balance of energies of its own.

θ̇ = -√(2 g (cos θ - cos θ_0)/l), so that at θ = 0 it is θ̇_2 = -√(2 g (1 - cos θ_0)/l)
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero
from planar_cli.solve.between.trace.trace import FUNCTION, BalanceTrace, MotionTrace, Relation, RouteStep


def by_functions(motion: MotionTrace) -> MotionTrace:
    """The motion told so; as it is where more than such rates is derived between the states, or numbers stand."""
    steps = [step for step in motion.route.steps if not step.is_datum]
    if not motion.symbolic or not motion.passing or not steps:
        return motion
    told = {id(step): _told(step, motion) for step in steps}
    if any(new is None for new in told.values()):
        return motion
    changed = tuple(told.get(id(step)) or step for step in motion.route.steps)
    return replace(motion, route=replace(motion.route, steps=changed))


def _told(step: RouteStep, motion: MotionTrace) -> RouteStep | None:
    """The step by a function; None: it is no balance of energies, or none tells it."""
    (e, *others), (r, *more) = step.relations, step.results
    energies = isinstance(e.source, BalanceTrace) and bool(e.source.law.letter)
    general = motion.general.get(r.unknown)
    if others or more or not energies or r.formula is None or general is None:
        return None
    here = {
        g: motion.route.plain[s] for s, g in motion.general.items() if s in motion.route.plain and _at(s, e, motion)
    }
    for found in (x for route in motion.passing.values() for p in route.steps for x in p.results):
        places = [g for g in here if found.formula is not None and g in found.formula.free_symbols]
        if found.unknown != general or len(places) != 1 or found.formula is None:
            continue
        (place,) = places
        if identically_zero(sp.sympify(found.formula).xreplace({place: here[place]}) - r.formula):
            relation = Relation(r.unknown - sp.sympify(r.formula), FUNCTION, "", e.stop)
            return replace(step, relations=(relation,), needs=frozenset())
    return None


def _at(symbol: sp.Symbol, e: Relation, motion: MotionTrace) -> bool:
    role = motion.ledger.roles.get(symbol)
    return role is not None and role.at == e.stop
