"""Is a place that is sought told by what the file states?

Laws of motion hold wherever the bodies are: they tell no place. Where all equations of a choice of modes can be
fulfilled in a place that is drawn at random, nothing tells it. Where the laws of a choice alone contradict each other
there, the choice stands only in special places (a ladder leaves the wall of its own accord where it lies flat), and an
answer in one of these would be about another question, unless the file states the mode.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.form import Nonlinear
from planar_cli.equation.system.conditions import POSITION, stated
from planar_cli.equation.values.exact import Unvalued
from planar_cli.errors import NoValue, Undecided
from planar_cli.problem.language.expression import Relation
from planar_cli.solve.instant.asked import names_of_directions
from planar_cli.solve.instant.by_direction import with_statements
from planar_cli.solve.instant.instant import NONLINEAR, Instant
from planar_cli.solve.instant.study import solve_velocities

IMPOSSIBLE = frozenset(("velocities", "contradiction"))
"""Objections that no equation but those of the choice raises."""
Choice = tuple[int, ...]


def open_places(instant: Instant) -> list[sp.Symbol]:
    """The sought constants and coordinates with which points and the directions of surfaces are written."""
    ledger = instant.scene.ledger
    written = {s for p in instant.scene.points.values() for e in (p.x, p.y) for s in sp.sympify(e).free_symbols}
    turned = names_of_directions(instant.scene.problem)
    return [s for s in ledger.sought if s in written or s.name in turned]


def telling(instant: Instant, choices: Iterable[Choice]) -> list[Choice] | None:
    """The choices in which statements tell the places that are sought; None: that is not asked, so that all count.

    An extreme tells a place, and so do relations between places: how far these do is for the search to say.
    """
    places = open_places(instant)
    if not places or instant.statements.extremes or instant.scene.displacement is not None:
        return None
    chosen = list(choices)
    if not chosen or _relates_places(instant, chosen[0]):
        return None
    bare = with_statements(instant, replace(instant.statements, relations=_lasting(instant), equilibrium=()))
    if _possible(bare, chosen[0], open_places(bare)) is False:
        # What has no mass balances only in some places: there the laws do tell them.
        return None
    told: list[Choice] = []
    by_forces = False
    for choice in chosen:
        here = _objection(instant, choice, places)
        if here is None:
            return None
        possible = here not in IMPOSSIBLE
        if possible and not by_forces and _holds(instant, choice):
            # It is so in this place, and in all that are near it. Where more natural modes let a force tell the place,
            # as N(A) = 0 does, those are meant: of modes in which A is apart it says nothing.
            return []
        alone = possible or _possible(bare, choice, open_places(bare))
        if not possible and (alone or alone is None or _is_stated(instant, choice)):
            told.append(choice)
            by_forces = by_forces or here == "contradiction"
    return told


def _lasting(instant: Instant) -> tuple[tuple[Relation, bool], ...]:
    """The relations that hold all the time."""
    return tuple((r, always) for r, always in instant.statements.relations if always)


def _relates_places(instant: Instant, choice: Choice) -> bool:
    """Does a relation hold nothing but places?"""
    system = instant.system(choice)
    names = {s.name for s in instant.scene.ledger.coordinates}
    quantities = system.quantities_of(system.first, None)
    relations = list(instant.statements.relations)
    return bool(stated(relations, quantities, quantities.evaluator, names, POSITION))


def _possible(instant: Instant, choice: Choice, places: list[sp.Symbol]) -> bool | None:
    """Can all equations of a choice be fulfilled in a place that is drawn? None: that is not told by numbers alone."""
    objection = _objection(instant, choice, places)
    return None if objection is None else objection not in IMPOSSIBLE


def _objection(instant: Instant, choice: Choice, places: list[sp.Symbol]) -> str | None:
    """What speaks against a choice in a place that is drawn; None: that is not told by numbers alone."""
    value = instant.scene.valuations[0]
    try:
        trial = instant.try_choice(choice, (value,), given={s: value(s) for s in places})
        nonlinear = trial.velocities[0].nonlinear if trial.velocities else ()
        open_speeds = solve_velocities(trial.system, value, False, seek=False).free if nonlinear else ()
    except (Nonlinear, Unvalued, NoValue, Undecided):
        return None
    return None if trial.objection == NONLINEAR or len(nonlinear) > len(open_speeds) else trial.objection


def _holds(instant: Instant, choice: Choice) -> bool:
    """Does a choice hold in a place that is drawn, with speeds that are told?"""
    places = set(open_places(instant))
    for value in instant.scene.valuations:
        try:
            free = solve_velocities(instant.system(choice), value, instant.at_rest, seek=False).free
            trial = instant.try_choice(choice, (value,), given={s: value(s) for s in places})
        except (Nonlinear, Unvalued, NoValue, Undecided):
            continue
        if not free and not trial.objection:
            return True
    return False


def _is_stated(instant: Instant, choice: Choice) -> bool:
    """Does the file state the modes of all that depart from their first ones?"""
    told = {joint for joint, _ in instant.statements.modes}
    departing = [j.name for (j, _), i in zip(instant.modes, choice, strict=True) if i]
    return bool(departing) and all(instant.aliases[name] in told for name in departing)


__all__ = ["open_places", "telling"]
