"""What of the accelerations and reactions of a regime a motion rests on: only that is told before it."""

from __future__ import annotations

import sympy as sp

from planar_cli.solve.between.balances import StateBalance
from planar_cli.solve.between.derivation import Route
from planar_cli.solve.between.stated_motion import StatedMotion
from planar_cli.solve.instant.stages import acceleration_unknowns
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.regime_sequence import RegimeSequence
from planar_cli.solve.solution import InstantSolution


def wanted_of(course: StatedMotion, route: Route, instant: InstantSolution) -> frozenset[str] | None:
    """Names of unknowns of a general position on which a route rests; None: all of them."""
    regimes = [r for r in course.distinct_regimes() if r.general.solution is instant]
    if not regimes or course.modes.turnings or course.modes.equilibria:
        return None
    regime = regimes[0]
    system = regime.general.trial.system
    kinetic = set(acceleration_unknowns(system)) | set(system.symbols.values())
    used = {s for e in course.said.get(id(regime), ()) for s in sp.sympify(e).free_symbols}
    names = {s.name for s in used & kinetic}
    own = {id(law) for i, r in enumerate(course.regimes) if r is regime for law in course.laws[i].laws}
    for step in route.steps:
        for e in step.derivation.equations:
            if e.law is not None and id(e.law) in own and e.law.f != 0:
                names |= {regime.general.rate_of(u).name for u in regime.free}
            if isinstance(e.source, StateBalance) and _acts(course, regime, e.source):
                names |= _speeds(course, regime)
    names |= {s.name for s in used & set(system.tree.velocity_unknowns())}
    return frozenset(names)


def _acts(course: RegimeSequence, regime: Regime, source: StateBalance) -> bool:
    """Does a law end in this regime?"""
    states = [s.name for s in course.states]
    return course.regimes[states.index(source.stop.name) - 1] is regime


def _speeds(course: StatedMotion, regime: Regime) -> set[str]:
    """The velocities of which the amounts of balances are made."""
    offered = course.between.offered.get(id(regime), [])
    return {s.name for o in offered for _, e in o.balance.amounts for s in e.free_symbols}
