"""What a file does not say of how a motion goes on, found where the motion is followed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.joints.base import Joint, distinct

if TYPE_CHECKING:
    from planar_cli.motion.trajectory.trajectory import Outcome
    from planar_cli.problem.scene.scene import Problem

CODES = ("PL539", "PL714", "PL715", "PL717", "PL718")
"""With which a motion ends that is not told on."""
LEAVE_OUT = (
    "leave `along` out, so that the part turns with its ends, or let what hangs on it go along with its upper end"
)


def demand_told(problem: Problem, outcome: Outcome) -> None:
    """NoSolution: the motion ends where the file leaves open how it goes on."""
    if outcome.code not in CODES:
        return
    joint = next(j for j in distinct(problem.joints) if j.name == outcome.joint)
    hints = {"PL539": _leave_out, "PL714": _weld, "PL715": _again, "PL717": _blow, "PL718": _apart}
    hint = hints[outcome.code](problem, joint)
    raise NoSolution((Diagnostic(joint.mark, outcome.code, outcome.words, hint),))


def spent(problem: Problem, outcome: Outcome) -> NoSolution | None:
    """What to say where a motion ends as a free part of a rope has run out; None: it does not."""
    if outcome.code != "PL712":
        return None
    joint = next(j for j in distinct(problem.joints) if j.name == outcome.joint)
    hint = "draw the point at its end further off, or let the last state come before that"
    return NoSolution((Diagnostic(joint.mark, outcome.code, outcome.words.partition(":")[0], hint),))


def moved_by_nothing(problem: Problem) -> NoSolution | None:
    """What to say where an acceleration stays open: what has no mass goes as nothing tells it to; None: all have."""
    light = next((b for b in problem.bodies if b.is_massless), None)
    if light is None:
        return None
    text = f"nothing tells how {light.name} moves between the states: it has no mass"
    hint = f"give {light.name} a mass, or say under `motion` how it moves"
    return NoSolution([Diagnostic(light.mark, "PL451", text, hint)])


def _leave_out(problem: Problem, joint: Joint) -> str:
    return LEAVE_OUT


def _again(problem: Problem, impact: Joint) -> str:
    return "give the meeting a state, one `just after` it, and leave `during` out of the impact; or end before it"


def _blow(problem: Problem, joint: Joint) -> str:
    before, until = joint.during or ("", "")
    name = f"{before}a"
    return (
        f"if it is a blow, say so: a state `{name}: [just after {before}]` (`during: {before}->{until}` stays); "
        f"else let it hold what it holds from the beginning"
    )


def _apart(problem: Problem, joint: Joint) -> str:
    state = joint.during[0] if joint.during is not None else ""
    return f"let the state {state} be where they touch: the height of the centre of a wheel is its radius, say"


def _weld(problem: Problem, impact: Joint) -> str:
    partners = ", ".join(getattr(impact, "between", ()))
    begins = impact.during[0] if impact.during is not None else problem.states[0].name
    during = f"{begins}->{problem.states[-1].name}"
    weld = f"`weld: {{between: [{partners}], at: P, during: {during}}}` if they stay together (P: where they meet)"
    return f"write {weld}, or the `contact` on which the one slides along the other"
