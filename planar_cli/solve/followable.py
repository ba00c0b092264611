"""What of a solved motion can be followed anew: its file with what only equations have told, and how far."""

from __future__ import annotations

from dataclasses import replace

from planar_cli.integrators.base import MOST_STEPS
from planar_cli.problem.checks.unused import used_names
from planar_cli.problem.language.expression import JustAfter, Quantity
from planar_cli.problem.language.walk import is_endless, walk
from planar_cli.problem.scene.scene import Problem
from planar_cli.simulate.answers import NOT_FOLLOWED
from planar_cli.solve.following.dated import begun, dated, is_told_by_a_span, told_by_what_follows
from planar_cli.solve.following.traced import BEYOND, SEARCHED_STEPS
from planar_cli.solve.taken import Taken


def not_followed(problem: Problem, taken: Taken) -> str:
    """Why the motion of a file can not be followed at all; "" where it can."""
    following = told_by_what_follows(problem)
    for state in problem.states:
        if any(isinstance(r, JustAfter) for r in state.relations):
            continue
        if state.name in following and state.name not in taken.times:
            return f"state {state.name} is told by a later one, which it leads to"
        if is_told_by_a_span(state) and state.name not in taken.times:
            return f"state {state.name} is told by a quantity over a span, which is not looked for step by step"
        for node in (n for r in state.relations for n in walk(r)):
            if isinstance(node, Quantity) and node.word in NOT_FOLLOWED:
                return f"state {state.name} is told by {node.word}(…), which no motion has"
    used = used_names(problem)
    names = [s.name for s in (*problem.symbols, *problem.unknowns)]
    without = [n for n in names if n not in taken.letters and n in used]
    return f"no number tells {', '.join(without)}" if without else ""


def closed(problem: Problem, taken: Taken) -> Problem:
    """The file with the constants that joints leave open and a blow has told, and with times that spans have told."""
    told = replace(problem, joints=tuple(j.told(taken.opened) for j in problem.joints))
    return begun(dated(told, taken.times), taken.times)


def end_of(problem: Problem, taken: Taken) -> float | None:
    """A little beyond the last state; None where that is not known, or no time passes, or there is no end."""
    if any(is_endless(state.relations) or state.name not in taken.times for state in problem.states):
        return None
    first, last = min(taken.times.values(), default=0.0), max(taken.times.values(), default=0.0)
    return last + BEYOND * (last - first) if last > first else None


def most_steps(problem: Problem, taken: Taken) -> int:
    """How many steps are enough, as long as it is not known when the last state is."""
    return MOST_STEPS if all(s.name in taken.times for s in problem.states) else SEARCHED_STEPS
