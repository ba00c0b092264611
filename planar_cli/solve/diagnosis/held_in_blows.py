"""What to write where a state just after another contradicts the rest: a joint may hold in the blow where it lets go,
nothing strikes, or what should push bodies apart is an impact, which only answers an approach.
"""

from __future__ import annotations

from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.problem.language.expression import JustAfter
from planar_cli.problem.scene.scene import Problem

LEAVE_OUT = "leave one of them out, or declare what they hold under `unknowns`"


def what_to_write(problem: Problem, state: str) -> str:
    """The hint for a statement of this state that contradicts others: a joint that acts for a blow alone holds in it,
    and what comes of that may be denied by any state from there on.
    """
    for known in problem.states:
        before = next((r.state for r in known.relations if isinstance(r, JustAfter)), None)
        held = [j for j in problem.joints if not j.strikes and before is not None and j.during == (before, known.name)]
        if held:
            write = "leave it out" if before == problem.states[0].name else f"let its `during` end at {before}"
            blow = f"the blow from {before} to {known.name}"
            return f"{held[0].name} holds in {blow} itself: where it lets go in it, {write}"
        if known.name == state:
            if before is not None and not _strikes(problem, before, state):
                write = f"an `impulse` of unknown magnitude with `during: {before}->{state}`"
                return (
                    f"nothing strikes from {before} to {state}, so that velocities stay as they are; else write {write}"
                )
            if before is not None and (hint := push_off(problem, before, state)):
                return hint
            break
    return LEAVE_OUT


def push_off(problem: Problem, before: str, after: str) -> str:
    """How bodies that push each other off are written, where an impact of open restitution is all that acts between
    them in this blow; "" where there is none. From no approach no restitution makes a separation.
    """
    blow = (None, (before, after))
    if any(x.strikes and x.during in blow for x in problem.loads):
        return ""
    for j in problem.joints:
        if j.strikes and j.during in blow and getattr(j, "restitution", 0) is None:
            first, second = getattr(j, "between", ("one body", "the other"))
            return (
                f"an impact answers an approach alone; where {first} and {second} push each other off, give each an"
                f" `impulse` of the same unknown magnitude, in opposite directions, `during: {before}->{after}`"
            )
    return ""


def no_motion(problem: Problem, text: str) -> NoSolution:
    """The states are told to have no motion, with what to write in the first blow in which bodies may push off."""
    hint = ""
    for state in problem.states:
        before = next((r.state for r in state.relations if isinstance(r, JustAfter)), None)
        if before is not None and not hint:
            hint = push_off(problem, before, state.name)
    return NoSolution([Diagnostic(problem.states[0].mark, "PL620", text, hint)])


def _strikes(problem: Problem, before: str, after: str) -> bool:
    """May velocities change in this blow: by an impulse or impact, or a joint that begins to hold there?"""
    loads = any(x.strikes and x.during in (None, (before, after)) for x in problem.loads)
    joints = any(
        (j.strikes and j.during in (None, (before, after)))
        or (j.during is not None and (before in j.during or after in j.during))
        for j in problem.joints
    )
    return loads or joints
