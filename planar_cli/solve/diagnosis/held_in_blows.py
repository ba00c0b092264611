"""What to write where a state just after a blow contradicts the rest: a joint may hold in the blow where it lets go."""

from __future__ import annotations

from planar_cli.problem.expression import JustAfter
from planar_cli.problem.scene import Problem

LEAVE_OUT = "leave one of them out, or declare what they hold under `unknowns`"


def what_to_write(problem: Problem, state: str) -> str:
    """The hint for a statement of this state that contradicts others."""
    relations = next((s.relations for s in problem.states if s.name == state), ())
    before = next((r.state for r in relations if isinstance(r, JustAfter)), None)
    held = [j for j in problem.joints if not j.strikes and before is not None and j.during == (before, state)]
    if not held:
        return LEAVE_OUT
    write = "leave it out" if before == problem.states[0].name else f"let its `during` end at {before}"
    return f"{held[0].name} holds in the blow from {before} to {state} itself: where it lets go in it, {write}"
