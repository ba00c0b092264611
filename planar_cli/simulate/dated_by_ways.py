"""States that are told by the way that a point has gone, `path_length(P) @ 1->2 = 12 m`, put at the times at which it
has.

No step of a motion knows the way behind it. But it only grows: the motion is followed to a time, the way up to it is
measured, and the time is corrected until the way is the one that is told.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction

from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.motion.sides import has_quantity
from planar_cli.problem.expression import Found, Name, Number, Quantity, Relation, Side
from planar_cli.problem.scene import Find, Problem, State
from planar_cli.simulate.run import Settings, prepared, simulate
from planar_cli.simulate.shooting import enclosed

WAY, GOAL = "way", "goal"
"""What is asked of a motion that is followed to one time: the way up to it, and the one that is told."""
EARLY, DOUBLINGS = 16, 14
"""From this part of an ordinary time on it is doubled so often at most."""
CLOSE = 1e-12
"""The way is hit to this part of it."""


def tells_a_way(state: State) -> Quantity | None:
    """The length of a path up to a state, which alone dates it; None: something else does, or nothing."""
    told = [r for r in state.relations if isinstance(r, Relation) and r.operator == "="]
    return next((q for q, _ in _ways(state)), None) if len(told) == len(state.relations) == 1 else None


def _ways(state: State) -> Iterator[tuple[Quantity, Side]]:
    for r in state.relations:
        for way, goal in ((r.left, r.right), (r.right, r.left)) if isinstance(r, Relation) else ():
            whole = isinstance(way, Quantity) and isinstance(way.at, tuple) and way.at[1] == state.name
            if isinstance(way, Quantity) and whole and way.word == "path_length" and not has_quantity(goal):
                yield way, goal


def dated_by_ways(problem: Problem, known: Mapping[str, float]) -> Problem | None:
    """The problem with such states at their times; the same object where there are none. None: nothing begins to move,
    though something is to. `known`: numbers of finds of earlier cases. NoSolution: the way comes to an end before.
    """
    for k, state in enumerate(problem.states):
        if tells_a_way(state) is not None:
            time = _time(problem, k, known)
            if time is None:
                return None
            states = (*problem.states[:k], _at(state, time), *problem.states[k + 1 :])
            problem = replace(problem, states=states)
    return problem


def with_ways_dated(problem: Problem, known: Mapping[str, float]) -> Problem:
    """The same, where a motion is to be followed in any case. NoSolution: nothing begins to move, too."""
    dated = dated_by_ways(problem, known)
    if dated is None:
        state = next(s for s in problem.states if tells_a_way(s) is not None)
        text = f"state {state.name} is never reached: {state.relations[0].text}"
        raise NoSolution([Diagnostic(state.mark, "PL621", text, "nothing begins to move")])
    return dated


def _at(state: State, time: float) -> State:
    number = Number(Fraction(time), "s", 1, state.mark)
    return replace(state, relations=(Relation(Name("t", None, state.mark), "=", number, "", state.mark),))


def _time(problem: Problem, k: int, known: Mapping[str, float]) -> float | None:
    """When the way of the state at this place is the one that is told [s]; None: no way is gone at all. NoSolution: the
    way ends before.
    """
    state = problem.states[k]
    ((way, goal), *_) = _ways(state)
    finds = tuple(Find(n, Found(side, None, n, state.mark), state.mark) for n, side in ((WAY, way), (GOAL, goal)))
    settings = Settings(values=known, estimate=False)

    def off(time: float) -> float | None:
        """By which part of it the way is more than the one that is told; None: the motion is over before."""
        states = (*problem.states[:k], _at(state, time))
        found = simulate(replace(problem, states=states, find=finds, answers=()), settings)
        numbers = {a.name: a.values for a in found.answers}
        return numbers[WAY][0] / numbers[GOAL][0] - 1 if numbers[WAY] and numbers[GOAL] else None

    ordinary = prepared(replace(problem, states=problem.states[:k]), known).model.time_scale
    low, before = 0.0, -1.0
    high, gap = ordinary / EARLY, off(ordinary / EARLY)
    for _ in range(DOUBLINGS):
        if gap is None or gap >= 0:
            break
        low, before, high = high, gap, 2 * high
        gap = off(high)
    last = before if gap is None else gap
    if last < 0 and 1 + last <= CLOSE:
        return None
    if gap is None or gap < 0:
        reached = f"as far as the motion goes on, the way comes to {100 * (1 + last):.4g} % of that"
        text = f"state {state.name} is never reached: {state.relations[0].text}"
        raise NoSolution([Diagnostic(state.mark, "PL621", text, reached)])
    return high if gap == 0 else enclosed(off, (low, before), (high, gap), CLOSE)
