"""Which bodies go one way along a straight line through a whole motion: then that way counts as positive.

A lecturer counts the fall of a parachutist, or the way of a pile into the ground, downward; what is thrown up and falls
back goes both ways, and keeps the axes of the file.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from planar_cli.motion.terms.layout import Frame
from planar_cli.problem.language.expression import JustAfter, Quantity, Relation
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.going import Going
from planar_cli.problem.scene.scene import Body, Problem, State
from planar_cli.solve.between.branches.solved_motion import SolvedMotion
from planar_cli.solve.following.traced import Traced
from planar_cli.solve.regimes.mode_sequence import Workshop

STRAIGHT = 1e-9
"""Speeds below this part of the largest one are none."""
AXES, PLACES = ("x", "y"), ("x", "y", "r", "v", "a", "path_length")
"""The axes, and quantities of places and motion along a line."""


def along_straight_ways(problem: Problem, workshop: Workshop, motion: Traced | None) -> tuple[Problem, Workshop]:
    """The problem of a motion that is known, in which what goes one way counts so, and a workshop for it."""
    if motion is None or workshop.by_axes or not (ways := straight_ways(problem, motion)):
        return problem, workshop
    workshop.left = True
    return _counted(problem, ways, motion), Workshop(workshop.earlier)


def along_straight_ways_found(problem: Problem, solved: SolvedMotion, workshop: Workshop) -> Problem | None:
    """The same of a motion that is known once a constant has been found: it is solved again so. None: it is not."""
    run = solved.followed.run if solved.followed is not None else None
    if run is None or workshop.by_axes or workshop.left or not solved.course.states:
        return None
    motion = Traced(run)
    ways = straight_ways(solved.course.problem, motion)
    workshop.left = bool(ways)
    return _counted(problem, ways, motion) if ways else None


def _counted(problem: Problem, ways: tuple[tuple[str, Going], ...], motion: Traced) -> Problem:
    """The problem in which bodies count the ways they go, and clockwise where they turn so."""
    clockwise = tuple(b for b, senses in _turns(motion, _all_states(problem, motion)).items() if senses == {False})
    return replace(problem, going=ways, turning=(*problem.turning, *clockwise))


def straight_ways(problem: Problem, motion: Traced) -> tuple[tuple[str, Going], ...]:
    """Bodies that go along a straight line and never back; none, where all go along the axes of the file, and where
    another body moves otherwise: then they have the axes of the file in common.
    """
    moments = [motion.moment(s.name) for s in problem.states]
    if problem.coordinates or None in moments:
        return ()
    layout, states = motion.run.model.layout, _all_states(problem, motion)
    n = layout.count
    moving = {b for b, f in layout.frames.items() if any(y[n + i] != 0 for y in states for i in (f.x, f.y))}
    if not moving or not _keep_their_places(problem, motion, states):
        return ()
    found = {b: way for b in moving if (way := _way(states, layout.frames[b], n)) is not None}
    if len(layout.frames) == 1 and not found:
        return _until_a_blow(problem, motion, states)
    fits = found.keys() == moving and _may_count_so(problem, tuple(found.values()))
    return tuple(sorted(found.items())) if fits and not _is_asked_along_axes(problem, found) else ()


def _may_count_so(problem: Problem, ways: Sequence[Going]) -> bool:
    """Do some go against an axis, all of them the same way or tied by ropes, with springs on the axes of the file?"""
    plain = len(ways) == 1 or all(0 in (way.x, way.y) for way in ways)
    roped = any(j.kind == "rope" for j in problem.joints)
    springs = any(load.kind == "spring" for load in problem.loads)
    placed = not springs or all(map(_has_zero_of_file, ways))
    return any(min(way.x, way.y) < 0 for way in ways) and plain and placed and (roped or _is_one_way(ways))


def _keep_their_places(problem: Problem, motion: Traced, states: Sequence[Sequence[float]]) -> bool:
    """Do bodies that turn keep to one sense each, about centres that rest, as drums from which loads hang, or held by
    cords alone, as a spool that unwinds?
    """
    turns, layout = {b: senses for b, senses in _turns(motion, states).items() if senses}, motion.run.model.layout
    if not turns:
        return True
    kinds = {j.kind for j in problem.joints}
    frames = [layout.frames[b] for b in turns]
    rest = all(y[layout.count + i] == 0 for f in frames for y in states for i in (f.x, f.y))
    held = kinds == {"rope"} or (rest and "rope" in kinds and "guide" not in kinds)
    return held and all(len(senses) == 1 for senses in turns.values())


def _until_a_blow(problem: Problem, motion: Traced, states: Sequence[Sequence[float]]) -> tuple[tuple[str, Going], ...]:
    """The way of the only body until its one blow, on a rough slope: after it speeds count along the slope, and across
    it, if all that follows is that it comes back there.
    """
    blows = [i for i, s in enumerate(problem.states) if any(isinstance(r, JustAfter) for r in s.relations)]
    rough = any(j.strikes and getattr(j, "mu", None) is not None for j in problem.joints)
    if len(blows) != 1 or not rough or not all(map(_is_on_a_slope, problem.states[blows[0] + 1 :])):
        return ()
    ((body, frame),), n = motion.run.model.layout.frames.items(), motion.run.model.layout.count
    since = next(r.state for r in problem.states[blows[0]].relations if isinstance(r, JustAfter))
    if not all(any(y[n + i] != 0 for y in states) for i in (frame.x, frame.y)):
        return ()
    way = _way(list(_states(motion, since)), frame, n)
    return ((body, replace(way, until=since)),) if way is not None and min(way.x, way.y) < 0 else ()


def _is_on_a_slope(state: State) -> bool:
    """Is the state a place on a line that the file gives by its direction?"""
    nodes = (node for r in state.relations if isinstance(r, Relation) for node in walk(r.left))
    return any(isinstance(q, Quantity) and any(p.kind == "across" for p in q.parts) for q in nodes)


def _is_asked_along_axes(problem: Problem, ways: Mapping[str, Going]) -> bool:
    """Is more asked of what goes against an axis along that axis, v(P).y, than otherwise, v(P).mag or -y(P)?"""
    things = {x for b in problem.bodies if min(*_parts(ways, b.name)) < 0 for x in (b.name, *_centers(b))}
    along = others = 0
    for find in problem.find:
        side = find.found.what
        own = [q for q in walk(side) if isinstance(q, Quantity) and q.word in PLACES and things & set(q.things)]
        along += own == [side] and _is_along_an_axis(own[0])
        others += bool(own) and not (own == [side] and _is_along_an_axis(own[0]))
    return along > others


def _parts(ways: Mapping[str, Going], body: str) -> tuple[float, float]:
    return (ways[body].x, ways[body].y) if body in ways else (0.0, 0.0)


def _centers(body: Body) -> tuple[str, ...]:
    """The names of its place or centre."""
    names = (getattr(body.shape, key, None) for key in ("place", "center"))
    return tuple(n for n in names if isinstance(n, str))


def _is_along_an_axis(q: Quantity) -> bool:
    """Is it a component as it stands?"""
    return q.word in AXES or (bool(q.parts) and q.parts[-1].kind in AXES)


def _has_zero_of_file(way: Going) -> bool:
    """Is its way counted from the origin of the file? From where it starts otherwise."""
    return way.past_zero or way.from_zero


def _is_one_way(ways: Sequence[Going]) -> bool:
    """Do all go the same way?"""
    first = ways[0]
    return all(first.x * way.x + first.y * way.y > 1 - STRAIGHT for way in ways)


def _way(states: Sequence[Sequence[float]], frame: Frame, n: int) -> Going | None:
    """How a body goes through these states; None: not at all, or not straight on."""
    velocities = [(y[n + frame.x], y[n + frame.y]) for y in states]
    fastest = max(velocities, key=lambda v: math.hypot(*v), default=(0.0, 0.0))
    top = math.hypot(*fastest)
    if top == 0:
        return None
    x, y = (0.0 if abs(c) < STRAIGHT * top else c / top for c in fastest)
    aside = max(abs(v_x * y - v_y * x) for v_x, v_y in velocities)
    back = min(v_x * x + v_y * y for v_x, v_y in velocities)
    if aside > STRAIGHT * top or back < -STRAIGHT * top:
        return None
    i = frame.x if y == 0 else frame.y
    return Going(x, y, _changes_sign(states[0][i], states[-1][i]), from_zero=states[0][i] == 0)


def _time(motion: Traced, name: str) -> float:
    moment = motion.moment(name)
    return 0.0 if moment is None else moment.t


def _all_states(problem: Problem, motion: Traced) -> list[tuple[float, ...]]:
    """What the motion is after all steps up to its last state, and after each blow."""
    moments = [motion.moment(s.name) for s in problem.states]
    states = list(_states(motion, max((s.name for s in problem.states), key=lambda name: _time(motion, name))))
    return states + [m.after[1] for m in moments if m is not None and m.after is not None]


def _turns(motion: Traced, states: Sequence[Sequence[float]]) -> dict[str, set[bool]]:
    """Of each body that can turn, in which senses it does: counterclockwise, True, or clockwise."""
    layout = motion.run.model.layout
    spins = {b: layout.count + f.theta for b, f in layout.frames.items() if f.theta is not None}
    return {b: {y[i] > 0 for y in states if y[i] != 0} for b, i in spins.items()}


def _states(motion: Traced, last: str) -> Iterator[tuple[float, ...]]:
    """What the motion is after all steps up to a state."""
    end = _time(motion, last)
    for piece in motion.run.trajectory.segments:
        if piece.t0 >= end:
            break
        yield piece.start
        for step in piece.steps:
            if step.t1 < min(piece.t1, end):
                yield tuple(step.at(step.t1))
        yield tuple(piece.at(min(piece.t1, end)))


def _changes_sign(first: float, last: float) -> bool:
    """Do two places lie on both sides of zero? One that is only off by rounding lies at it."""
    return first * last < 0 and abs(last) > STRAIGHT * abs(first)
