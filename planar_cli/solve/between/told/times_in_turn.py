"""Where blows part a motion, the time of each stretch is told with its stretch, and not all times at the end: the path
is walked once.
"""

from __future__ import annotations

from collections.abc import Sequence

from planar_cli.equation.values.ledger import Ledger
from planar_cli.solve.between.trace.trace import ImpactEquation, Relation, RouteStep

LINK = "link"


def times_in_turn(
    steps: Sequence[RouteStep], states: Sequence[str], times: Sequence[str], ledger: Ledger
) -> tuple[RouteStep, ...]:
    """The steps in such an order. `times`: the names of the times of states."""
    blows = [e for step in steps for e in step.relations if isinstance(e.source, ImpactEquation)]
    if not blows:
        return tuple(steps)
    found: list[RouteStep] = []
    for step in steps:
        last = _last(step, states, ledger)
        where = len(found)
        if len(step.unknowns) == 1 and step.unknowns[0].name in times and all(map(_of_time, step.relations)):
            while (
                where
                and not (set(found[where - 1].unknowns) & step.needs)
                and (_last(found[where - 1], states, ledger) > last)
            ):
                where -= 1
        found.insert(where, step)
    return tuple(found)


def _last(step: RouteStep, states: Sequence[str], ledger: Ledger) -> int:
    """The place of the last state of which a step speaks."""
    letters = (*step.unknowns, *(s for e in step.relations for s in e.residual.free_symbols))
    named = {e.stop for e in step.relations} | {ledger.roles[s].at or "" for s in letters if s in ledger.roles}
    return max((states.index(name) for name in named if name in states), default=-1)


def _of_time(e: Relation) -> bool:
    """Is it an integral of a law of motion, or that a blow takes no time?"""
    return e.law is not None or e.kind == LINK
