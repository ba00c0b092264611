"""The order of states of which the first is not the earliest, by the times that the file gives them."""

from __future__ import annotations

from planar_cli.problem.expression import Name, Number, Relation
from planar_cli.problem.scene import State
from planar_cli.units import parse_unit


def in_time(states: tuple[State, ...]) -> tuple[State, ...]:
    """The states with the earliest of those at given times in front, if another one at a given time stands there: a
    motion begins with its first state. What is listed before that one comes last.
    """
    times = {i: t for i, s in enumerate(states) if (t := _time(s)) is not None}
    if 0 not in times or times[0] <= min(times.values()):
        return states
    first = min(times, key=lambda i: times[i])
    return (*states[first:], *states[:first])


def _time(state: State) -> float | None:
    """The time at which a state is, where it is written as a number [s]."""
    for r in state.relations:
        if not isinstance(r, Relation) or r.operator != "=" or not isinstance(r.right, Number):
            continue
        if isinstance(r.left, Name) and r.left.name == "t":
            factor = float(parse_unit(r.right.unit).factor) if r.right.unit else 1.0
            return float(r.right.value) * factor * r.right.sense
    return None
