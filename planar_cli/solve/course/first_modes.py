"""The modes with which the search begins: every joint in its first mode that the file leaves open."""

from __future__ import annotations

from dataclasses import replace

from planar_cli.errors import Mark
from planar_cli.problem.scene import Problem, State
from planar_cli.solve.course.equilibria import is_equilibrium
from planar_cli.solve.course.mode_sequence import (
    ModeSequence,
    Span,
    Stretch,
    Workshop,
    arriving_at,
    blow_before,
    spans_of,
)


def first_modes(problem: Problem, workshop: Workshop) -> ModeSequence:
    """Every joint in its first mode that the file leaves open; one instant at a given time is its only state."""
    states = problem.states or (State("", problem.instant or (), _mark(problem)),)
    moving = tuple(s for s in states if not is_equilibrium(s))

    def stretch(span: Span) -> Stretch:
        return Stretch(span, next(workshop.drawn(span).choices()))

    stretches = tuple(stretch(s) for s in spans_of(problem, moving)) if moving else ()
    beyond = None
    for i, state in enumerate(moving[1:]):
        struck = blow_before(problem, moving[i], state)
        if struck is not None:
            begun = replace(stretch(arriving_at(problem, moving[i])), blow=struck[0])
            stretches = (*stretches[:i], begun, *stretches[i + 1 :])
            beyond = stretch(struck[1]) if i + 2 == len(moving) else None
    spans = spans_of(problem, states)
    beside = [(s, spans[min(i, len(spans) - 1)]) for i, s in enumerate(states) if is_equilibrium(s)]
    return ModeSequence(moving, stretches, equilibria=tuple((s, stretch(span)) for s, span in beside), beyond=beyond)


def _mark(problem: Problem) -> Mark:
    return problem.find[0].mark if problem.find else Mark(problem.file, 1, 1)
