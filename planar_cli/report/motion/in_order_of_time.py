"""A motion in the order of time, where a blow or other forces part it: what leads to the state just after the blow, and
the blow itself, or the whole way up of a ball in air, come before the forces that act from there on.

    STEP 1  Impulse and momentum        the cue strikes
    STEP 2  Kinetic analysis            then the ball slides

So does the speed at the one state at which forces are asked: first the energy, then what the forces are there.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

from planar_cli.report.motion.at_one_state import state_of
from planar_cli.solve.between.trace.trace import BalanceTrace, ImpactEquation, MotionTrace, RegimeTrace, RouteStep


def steps_before(
    found: MotionTrace, regime: RegimeTrace, legs: Sequence[RouteStep], early: Collection[RouteStep]
) -> list[RouteStep]:
    """The steps that lead up to the first state of a regime; empty: no blow comes before it that was not told, and no
    motion. `legs`: all steps that are told; `early`: those that were.
    """
    if found.turnings or not regime.stretches:
        return []
    alone = state_of(found, regime) or last_by_energy(found, regime, legs)
    start = _place(alone, found) if alone else min(_place(since, found) for since, _ in regime.stretches)
    known = {x for leg in early for x in leg.unknowns} | found.route.plain.keys()
    led: list[RouteStep] = []
    for leg in legs:
        if leg not in early and _last(leg, found) <= start and (leg.needs & found.unknowns) <= known:
            led.append(leg)
            known |= set(leg.unknowns)
    sources = [(e.source, e.law) for leg in led for e in leg.relations]
    balanced = alone and any(isinstance(source, BalanceTrace) for source, _ in sources)
    if not balanced and not any(isinstance(source, ImpactEquation) or law is not None for source, law in sources):
        return []
    needed = {s for leg in led if not leg.is_datum for s in leg.needs}
    kept = [leg for leg in led if not leg.is_datum or needed & set(leg.unknowns)]
    return in_time(kept, found)


def in_time(legs: Sequence[RouteStep], found: MotionTrace) -> list[RouteStep]:
    """Steps by the last states of which they speak."""
    return sorted(legs, key=lambda leg: _last(leg, found))


def last_by_energy(found: MotionTrace, regime: RegimeTrace, legs: Sequence[RouteStep]) -> str:
    """The last state of a motion of one regime whose forces and accelerations are the same all the time, where balances
    alone lead to its states, so that nothing rests on these; "": there is none. With the accelerations first, two ways
    to the same speeds would stand side by side.
    """
    if len(found.regimes) > 1 or not regime.constants or regime.resting is None:
        return ""
    if regime.resting & {s.name for s in regime.constants}:
        return ""
    asked = {s for finds in regime.asked.values() for parts in finds.values() for e in parts for s in e.free_symbols}
    balanced = all(isinstance(e.source, BalanceTrace) for leg in legs if not leg.is_datum for e in leg.relations)
    stops = [stop for _, stop in regime.stretches]
    return stops[-1] if balanced and stops[-1] and asked and asked <= regime.constants.keys() else ""


def in_turn(legs: Sequence[RouteStep], found: MotionTrace) -> list[list[RouteStep]]:
    """Steps in the order of time, each blow by itself, with the data on which it rests."""
    blows = {e.stop for leg in legs for e in leg.relations if isinstance(e.source, ImpactEquation)}
    turns: list[list[RouteStep]] = []
    struck = ""
    for i, leg in enumerate(legs):
        last = found.states[_last(leg, found)]
        now = last if last in blows else ""
        if not turns or (now != struck and (now or not leg.is_datum or not legs[i + 1 :])):
            turns.append([])
            struck = now
        turns[-1].append(leg)
    return turns


def states_of(legs: Sequence[RouteStep], found: MotionTrace) -> list[str]:
    """The states that steps join, in their order."""
    joined = {s for leg in legs for e in leg.relations if not leg.is_datum for s in (e.since, e.stop)}
    return [name for name in found.states if name in joined]


def states_told(names: Sequence[str], before: Sequence[str]) -> str:
    """The states of a step as its heading names them. `before`: those of earlier ones, of which it goes on from the
    last.
    """
    own = [name for name in names if name and name not in before[:-1]]
    return "states " + ", ".join(own) if len(own) > 1 else ""


def _last(leg: RouteStep, found: MotionTrace) -> int:
    """The place of the last state of which a step speaks."""
    roles = found.ledger.roles
    states = {e.stop for e in leg.relations}
    letters = (*leg.unknowns, *leg.needs, *(s for e in leg.relations for s in e.residual.free_symbols))
    states |= {roles[s].at or "" for s in letters if s in roles}
    return max(_place(name, found) for name in states)


def _place(state: str, found: MotionTrace) -> int:
    return found.states.index(state) if state in found.states else -1
