"""States that no following finds by themselves, put at their times: those told by a quantity over a span or by a later
state that what begins with them leads to, and a first state that is not at t = 0.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from planar_cli.problem.checks.scope import members_of
from planar_cli.problem.language.expression import JustAfter, Name, Number, Quantity, Relation
from planar_cli.problem.language.walk import is_endless, walk
from planar_cli.problem.scene.scene import Problem, State
from planar_cli.simulate.foretold import spoken_before
from planar_cli.solve.regimes.mode_sequence import fixed_time


def is_told_by_a_span(state: State) -> bool:
    """Does a state say something of what happens between states?"""
    if any(isinstance(r, JustAfter) for r in state.relations):
        return False
    nodes = (n for r in state.relations for n in walk(r))
    return any(isinstance(n, Quantity) and isinstance(n.at, tuple) for n in nodes)


def told_by_what_follows(problem: Problem) -> set[str]:
    """States that a later one tells, and with which something begins or ends: without them that one is another."""
    spans = [*(law.during for law in problem.motion), *(m.during for m in members_of(problem))]
    bounds = {name for span in spans for name in span or ()}
    endless = {s.name for s in problem.states if is_endless(s.relations)}
    return {name for name, later in spoken_before(problem).items() if name in bounds and later - endless}


def dated(problem: Problem, times: Mapping[str, float]) -> Problem:
    """The problem with such states at their times [s], where these are known."""
    following = told_by_what_follows(problem)
    alone = {s.name for s in problem.states if s.name not in following and not is_told_by_a_span(s)}
    states = tuple(_at(s, times[s.name]) if s.name in times and s.name not in alone else s for s in problem.states)
    return replace(problem, states=states)


def begun(problem: Problem, times: Mapping[str, float]) -> Problem:
    """The problem with its first state at its time [s], where what moves it in time has told that."""
    if not problem.states or not times.get(problem.states[0].name) or fixed_time(problem.states[0].relations):
        return problem
    first, *others = problem.states
    dated = replace(first, relations=(*first.relations, *_at(first, times[first.name]).relations))
    return replace(problem, states=(dated, *others))


def _at(state: State, time: float) -> State:
    mark = state.mark
    number = Number(Fraction(abs(time)), "s", -1 if time < 0 else 1, mark)
    return replace(state, relations=(Relation(Name("t", None, mark), "=", number, f"t = {time:.9g} s", mark),))
