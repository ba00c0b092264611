"""The order of the states of a file: a motion begins with its first state.

That is the earliest of those to which the file gives times, and none that is an equilibrium beside the motion.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from planar_cli.problem.language.expression import Equilibrium, JustAfter, Name, Number, Relation
from planar_cli.problem.scene.scene import State
from planar_cli.units import parse_unit


def in_order(states: tuple[State, ...]) -> tuple[State, ...]:
    """The states with the one in front with which the motion begins; what is listed before it comes last."""
    return _in_time(_begun(states))


def stands_beside(state: State, states: tuple[State, ...]) -> bool:
    """Is a state an equilibrium to which no motion has to lead? What is struck in its equilibrium moves from there."""
    balanced = any(isinstance(r, Equilibrium) for r in state.relations)
    return balanced and not any(isinstance(r, JustAfter) and r.state == state.name for s in states for r in s.relations)


def struck_at_once(states: tuple[State, ...]) -> bool:
    """Does the second state stand just after the first? Then what takes hold there has not held before."""
    return any(isinstance(r, JustAfter) and r.state == states[0].name for s in states[1:2] for r in s.relations)


def runs_back(span: tuple[str, str], states: tuple[State, ...]) -> bool:
    """Does a span surely end before it begins? Of states without times the list tells the order; a state at a given
    time may stand anywhere in it, and an equilibrium beside the motion has no time.
    """
    named = {s.name: s for s in states}
    start, end = (named[name] for name in span)
    if any(stands_beside(s, states) for s in (start, end)):
        return False
    times = [_dated(s, named) for s in (start, end)]
    if times[0] is not None and times[1] is not None:
        return times[1] < times[0]
    listed = [s.name for s in as_listed(states)]
    untimed = times[0] is None and times[1] is None
    return end.name == listed[0] or (untimed and listed.index(end.name) < listed.index(start.name))


def _dated(state: State, named: Mapping[str, State]) -> float | None:
    """The time of a state, or of that which it stands just after; None: no number tells it."""
    for _ in named:
        before = next((r.state for r in state.relations if isinstance(r, JustAfter)), None)
        if before is None or before not in named:
            break
        state = named[before]
    return _time(state)


def as_listed(states: tuple[State, ...]) -> tuple[State, ...]:
    """The states with those equilibria first that the file lists before the beginning of the motion: what acts from
    there on acts in it, and it is they that are drawn.
    """
    return tuple(sorted(states, key=lambda s: not s.before))


def _begun(states: tuple[State, ...]) -> tuple[State, ...]:
    """The states with those equilibria last that are listed before the beginning of the motion."""
    first = next((i for i, s in enumerate(states) if not stands_beside(s, states)), 0)
    return (*states[first:], *(replace(s, before=True) for s in states[:first]))


def _in_time(states: tuple[State, ...]) -> tuple[State, ...]:
    """The states with the earliest of those at given times in front, if another one at a given time stands there."""
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
