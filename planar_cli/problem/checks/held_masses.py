"""A mass that a stream changes in time stays what it is where the stream does not flow.

Of a body with `mass: M - q*t` on which a stream acts `during: 1->2` the formula is that of the times from state 1 to
state 2. Before them and after them t in it is the time of the nearer of these states.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

from planar_cli.problem.language.expression import Binary, Function, Name, Number, Quantity, Relation, Side
from planar_cli.problem.language.walk import changed, walk
from planar_cli.problem.scene.order_of_states import as_listed
from planar_cli.problem.scene.scene import Body, Problem, State

Held = tuple[tuple[str, str], ...]
"""Bodies, each with the state whose time is that of its mass."""


def flows(problem: Problem) -> dict[str, tuple[str, str]]:
    """From which state to which the streams flow on a body whose mass is written with the time, where all of them flow
    between two states.
    """
    streams = [x for x in problem.loads if x.brings_mass]
    if not streams or not problem.states:
        return {}
    found = {}
    for body in problem.bodies:
        spans = [x.during for x in streams if getattr(x, "body", None) == body.name]
        span = spans[0] if spans else None
        if span is not None and all(s == span for s in spans) and _runs(body):
            found[body.name] = span
    return found


def held_from(problem: Problem, state: State) -> tuple[Problem, Held]:
    """The problem with the masses as they are from a state on, to the next; and what stays."""
    spans = flows(problem)
    if not spans:
        return problem, ()
    order = {s.name: i for i, s in enumerate(as_listed(problem.states))}
    here = order.get(state.name, 0)
    held = {b: since for b, (since, until) in spans.items() if here < order[since]}
    held |= {b: until for b, (since, until) in spans.items() if here >= order[until]}
    times = {b: time for b, name in held.items() if (time := time_of(problem, name)) is not None}
    if not times:
        return problem, ()
    return _with_times(problem, lambda body, _: times.get(body)), tuple((b, held[b]) for b in times)


def while_flowing(problem: Problem) -> Problem:
    """The problem with masses that change while their streams flow, and not before or after."""
    spans = flows(problem)
    if not spans:
        return problem
    order = as_listed(problem.states)
    first, last = order[0].name, order[-1].name

    def clock(body: str, t: Name) -> Side | None:
        if body not in spans:
            return None
        since, until = spans[body]
        time: Side = t
        end = time_of(problem, until) if until != last else None
        begin = time_of(problem, since) if since != first else None
        time = time if end is None else _middle(time, end, "-")
        return time if begin is None else _middle(time, begin, "+")

    return _with_times(problem, clock)


def time_of(problem: Problem, name: str) -> Side | None:
    """The time that the file gives a state; of the first one zero, unless it says otherwise. None: none is given, or
    the file has no such state, which is told elsewhere.
    """
    state = next((s for s in problem.states if s.name == name), None)
    if state is None:
        return None
    for r in state.relations:
        if isinstance(r, Relation) and r.operator == "=":
            for one, other in ((r.left, r.right), (r.right, r.left)):
                if _is_clock(one) and not any(isinstance(n, Quantity) or _is_time(n) for n in walk(other)):
                    return other
    return Number(Fraction(0), "s", 1, state.mark) if name == as_listed(problem.states)[0].name else None


def _with_times(problem: Problem, clock: Callable[[str, Name], Side | None]) -> Problem:
    """Another time in the formulas of masses: that which `clock` gives for a body, None: as it is."""

    def written(body: Body, side: Side | None) -> Side | None:
        if side is None:
            return None
        return changed(side, lambda n: clock(body.name, n) if isinstance(n, Name) and _is_clock(n) else None)

    bodies = (
        replace(b, mass=written(b, b.mass), weight=written(b, b.weight), inertia=written(b, b.inertia))
        for b in problem.bodies
    )
    return replace(problem, bodies=tuple(bodies))


def _middle(time: Side, limit: Side, sign: str) -> Side:
    """The smaller of two times, (t + T - |t - T|)/2; with + the larger."""
    mark = limit.mark
    gap = Function("abs", Binary("-", time, limit, mark), None, mark)
    total = Binary(sign, Binary("+", time, limit, mark), gap, mark)
    return Binary("/", total, Number(Fraction(2), None, 1, mark), mark)


def _runs(body: Body) -> bool:
    """Is its mass or moment of inertia written with the time?"""
    return any(_is_clock(n) for side in (body.mass, body.weight, body.inertia) if side is not None for n in walk(side))


def _is_time(node: object) -> bool:
    return isinstance(node, Name) and node.name == "t"


def _is_clock(node: object) -> bool:
    """The running time, and not that of a state."""
    return isinstance(node, Name) and node.name == "t" and node.at is None
