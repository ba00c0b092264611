"""Checks of streams that flow for some time only."""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.errors import Diagnostic
from planar_cli.problem.checks.held_masses import flows, time_of
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.scene.order_of_states import as_listed


def flows_are_dated(scope: Scope) -> Iterator[Diagnostic]:
    """What mass is left of a body when its stream has ended, or before it begins, is told by the time of that state."""
    problem = scope.problem
    spans = flows(problem)
    if not spans:
        return
    order = [s.name for s in as_listed(problem.states)]
    for body, span in spans.items():
        for state, verb in zip(span, ("begins", "ends"), strict=True):
            if state in order[1:-1] and time_of(problem, state) is None:
                text = f"the stream on {body} {verb} in state {state}, and the file does not tell when"
                mark = next(b.mark for b in problem.bodies if b.name == body)
                yield Diagnostic(mark, "PL468", text, f"give state {state} a time, `{state}: [t = 20 s]`")
