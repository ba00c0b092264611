"""How near a motion comes to a state that it never reaches, and whether it passed there before."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from decimal import Decimal
from itertools import islice

from planar_cli.equation.values.exact import Unvalued, Valuation
from planar_cli.errors import NotReached, NoValue
from planar_cli.problem.language.expression import Relation
from planar_cli.problem.language.parser import parse_side
from planar_cli.problem.scene.scene import Problem
from planar_cli.simulate.measures import START
from planar_cli.simulate.run import Run
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.roots.events import FollowedSegment, events, is_zero, scale_of
from planar_cli.solve.between.roots.followed import Followed
from planar_cli.solve.diagnosis.words import has_magnitude, in_unit, unit_of
from planar_cli.solve.following.ends import is_put_in
from planar_cli.solve.following.follower import Follower
from planar_cli.solve.regimes.mode_sequence import fixed_time
from planar_cli.solve.regimes.regime_sequence import RegimeSequence
from planar_cli.solve.regimes.timeline import Demand, Stop

SAMPLES, CLOSER = 60, 5
ROOTS = 20
LOOKED = 3_000
"""A relation is evaluated so often to tell when it holds alone."""
IN_LETTERS = (
    "with none of the sizes that were tried for the letters does the motion get there; say under `assume` for which "
    "letters it does"
)
BEFORE = 1e-6
"""What happens within this part of a stretch before its end happens at its end."""


def how_near(course: MotionEquations, followed: Followed, stop: Stop, value: Valuation) -> str:
    """How near the motion comes, whether the relations hold one by one, or before the states that stand before. In
    letters no number of it says anything.
    """
    if course.symbolic and course.problem.symbols:
        return IN_LETTERS
    equations = [d for d in course.demands[stop.name] if d.kind == "equation"]
    reader = _reader(course, followed, value)
    for segment in followed.segments:
        if (when := _common(reader, equations, stop, segment, segment.t1)) is not None:
            return f"it was reached before, at t = {when:.4g} s: states stand in the order in which they happen"
    onward = followed.onward
    found = []
    for d in equations if onward is not None and onward.pieces else ():
        assert onward is not None
        try:
            found.append(_of_one(course, reader, d, stop, [*_on_the_way(course, followed), onward]))
        except (NoValue, Unvalued):
            return ""
    outcome = followed.run.trajectory.outcome if followed.run is not None else None
    if outcome is not None and outcome.kind == "repeats":
        assert followed.run is not None
        found += [outcome.words, *_that_pull_back(course.problem, followed.run)]
    return "; ".join(dict.fromkeys(found))


def _that_pull_back(problem: Problem, run: Run) -> Iterator[str]:
    """What the file may have meant otherwise: springs that are compressed at first, and are fastened."""
    for load in problem.loads:
        if load.kind == "spring" and getattr(load, "acts", None) is None and START in run.measures.moments:
            tension = parse_side(f"tension({load.name})", load.mark)
            if run.measures.number(tension, run.measures.moments[START]) < 0:
                yield f"{load.called} also pulls, where it is stretched; with `acts: push` it only pushes"


def _on_the_way(course: MotionEquations, followed: Followed) -> list[FollowedSegment]:
    """The stretches from the last state of the file to where the modes changed last."""
    ends = range(1, len(followed.segments) + 1)
    last = max((i for i in ends if i < len(course.states) and not is_put_in(course, i)), default=0)
    return list(followed.segments[last:])


def _of_one(
    course: MotionEquations, reader: Follower, d: Demand, stop: Stop, stretches: Sequence[FollowedSegment]
) -> str:
    """How near the motion comes to one relation on these stretches, the last of which goes on. NoValue, Unvalued."""
    onward = stretches[-1]
    nearest: list[tuple[float, float]] = []
    for stretch in stretches[:-1]:
        g = reader.along(d.residual, stop, stretch)
        if (root := next(events(g, stretch, stretch.t1), None)) is not None:
            return f"`{d.text}` holds at t = {root.value:.4g} s"
        nearest.append(_nearest(g, [_share(stretch.t0, stretch.t1, k) for k in range(SAMPLES + 1)]))
    g = reader.along(d.residual, stop, onward)
    run = min(20 * scale_of(onward), max(p.t1 for p in onward.pieces) - onward.t0)
    times = [_share(onward.t0, onward.t0 + run, k) for k in range(SAMPLES + 1)]
    sizes = [reader.size(d.residual, stop, onward, t) for t in times]
    if all(is_zero(g, t, onward, size) for t, size in zip(times, sizes, strict=True)):
        return f"`{d.text}` holds all the time, and tells no instant"
    first, within = _first(g, onward, run)
    if first is not None:
        return f"`{d.text}` holds at t = {first:.4g} s"
    last = _nearest(g, times)
    away, at = min(last, *nearest) if nearest else last
    lasts = away == last[0] and max(abs(g(t)) for t in times) - away <= BEFORE * away
    apart = apart_by(course, d, Decimal(repr(away)))
    if lasts and apart:
        return f"from t = {onward.t0:.4g} s on `{d.text}` stays as far off: {apart}"
    return f"{within}`{d.text}` is nearest at t = {at:.4g} s{apart and f', where {apart}'}"


def _share(start: float, end: float, k: int) -> float:
    """The k-th of the times at which a stretch is looked at."""
    return start + (end - start) * k / SAMPLES


def _first(g: Callable[[float], float], onward: FollowedSegment, run: float) -> tuple[float | None, str]:
    """When a relation first holds, and, where it was not searched all along for it, in words how far it was."""
    try:
        root = next(events(g, onward, evaluations=LOOKED), None)
    except NotReached:
        return None, f"until t = {onward.t0 + run:.4g} s "
    return (None if root is None else root.value), ""


def _reader(course: MotionEquations, followed: Followed, value: Valuation) -> Follower:
    """Who reads formulas along what was followed."""
    reader = Follower(course, value)
    reader.done.values = dict(followed.values)
    return reader


def passed_before(course: MotionEquations, followed: Followed, value: Valuation) -> bool:
    """Did what is stated of a state at a given time hold before, on the way from the state before it?"""
    reader = _reader(course, followed, value)
    for state, segment in zip(course.states[1:], followed.segments, strict=False):
        stated = fixed_time(state.relations)
        equations = [d for d in course.demands[state.name] if d.kind == "equation"]
        others = [d for d in equations if stated is not None and d.text != stated.text]
        until = segment.t1 - BEFORE * (segment.t1 - segment.t0)
        if stated is not None and _common(reader, others, course.stops[state.name], segment, until) is not None:
            return True
    return False


def _nearest(g: Callable[[float], float], times: list[float]) -> tuple[float, float]:
    """The smallest size of a function and when it has it: by samples, and again about the best of them."""
    best, at = math.inf, times[0]
    for _ in range(CLOSER):
        k, (best, at) = min(enumerate((abs(g(t)), t) for t in times), key=lambda found: found[1])
        low, high = times[max(k - 1, 0)], times[min(k + 1, len(times) - 1)]
        times = [low + (high - low) * i / SAMPLES for i in range(SAMPLES + 1)]
    return best, at


def _common(
    reader: Follower, equations: list[Demand], stop: Stop, segment: FollowedSegment, until: float
) -> float | None:
    """When all relations of a state hold on a stretch before it."""
    if until <= segment.t0 or not equations or not reader.can_read(equations, stop, segment):
        return None
    gs = [reader.along(d.residual, stop, segment) for d in equations]
    try:
        for root in islice(events(gs[0], segment, until), ROOTS):
            sizes = [reader.size(d.residual, stop, segment, root.value) for d in equations]
            if all(is_zero(g, root.value, segment, size) for g, size in zip(gs[1:], sizes[1:], strict=True)):
                return root.value
    except NoValue:
        pass
    return None


def apart_by(course: RegimeSequence, demand: Demand, number: Decimal) -> str:
    """By how much the sides of a relation differ, in its own unit; "" for what has no two sides, or squares of them,
    and in letters, where the number is a drawn one.
    """
    stated = (s for state in course.problem.states if state.name == demand.state for s in state.relations)
    relation = next((r for r in stated if isinstance(r, Relation) and r.mark == demand.mark), None)
    if relation is None or has_magnitude(relation) or course.problem.symbols:
        return ""
    unit = unit_of(course.regimes[0].general.instant, relation.left, relation.right)
    return f"the sides differ by {in_unit(abs(number), unit, course.problem.us)}"
