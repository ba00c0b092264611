"""The modes with which the search begins: every joint in its first mode that the file leaves open."""

from __future__ import annotations

from dataclasses import replace

from planar_cli.errors import Mark
from planar_cli.problem.scene.order_of_states import as_listed, stands_beside
from planar_cli.problem.scene.scene import Problem, State
from planar_cli.solve.regimes.after import asked_after
from planar_cli.solve.regimes.mode_sequence import (
    ModeSequence,
    Span,
    Stretch,
    Workshop,
    acting_after,
    arriving_at,
    blow_before,
    spans_of,
)


def first_modes(problem: Problem, workshop: Workshop) -> ModeSequence:
    """Every joint in its first mode that the file leaves open; one instant at a given time is its only state."""
    states = problem.states or (State("", problem.instant or (), _mark(problem)),)
    moving = tuple(s for s in states if not stands_beside(s, states))

    def stretch(span: Span) -> Stretch:
        return Stretch(span, next(workshop.drawn(span).choices()))

    stretches = tuple(stretch(s) for s in spans_of(problem, moving)) if moving else ()
    after = _beyond(problem, moving[-1], stretches[-1].span) if len(moving) > 1 else None
    beyond = None if after is None else stretch(after)
    for i, state in enumerate(moving[1:]):
        struck = blow_before(problem, moving[i], state)
        if struck is not None:
            begun = replace(stretch(arriving_at(problem, moving[i])), blow=struck[0])
            stretches = (*stretches[:i], begun, *stretches[i + 1 :])
            beyond = stretch(struck[1]) if i + 2 == len(moving) else beyond
    listed = as_listed(states)
    spans = spans_of(problem, listed)
    beside = [(s, spans[min(i, len(spans) - 1)]) for i, s in enumerate(listed) if stands_beside(s, states)]
    return ModeSequence(moving, stretches, equilibria=tuple((s, stretch(span)) for s, span in beside), beyond=beyond)


def _beyond(problem: Problem, last: State, before: Span) -> Span | None:
    """What acts after the last state, where that is not what acts before it and something asked may jump with it.

    A law of motion that ends with its last state is the last that is known of what has no mass.
    """
    after = acting_after(problem, last)
    heavy = any(b.mass is not None or b.weight is not None or b.any_mass for b in problem.bodies)
    if after.always != before.always and not heavy:
        return None
    lasting = {load.name for load in after.problem.loads if load in before.problem.loads}
    return after if after.key != before.key and asked_after(problem, last.name, lasting) else None


def _mark(problem: Problem) -> Mark:
    return problem.find[0].mark if problem.find else Mark(problem.file, 1, 1)
