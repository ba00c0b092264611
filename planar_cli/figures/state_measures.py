"""Heights and ranges: what the file gives and asks of the places of states, and the ground on which a throw ends."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from planar_cli.figures.drawn import size_of
from planar_cli.figures.positions import Later
from planar_cli.problem.expression import Binary, Number, Quantity, Relation, Side
from planar_cli.problem.scene import Line, Problem
from planar_cli.problem.scene import State as Written
from planar_cli.report.blocks import Line as Words
from planar_cli.report.blocks import Name, line
from planar_cli.report.marks import Dimension, Hatched, Mark, Spot

AXES = ("x", "y")
NEAR = 1e-6
BEYOND = 0.06
"""The ground goes on beyond what stands on it by this part of its length."""


def state_measures(places: Sequence[Later], problem: Problem) -> Iterator[Mark]:
    """Of states that are drawn to scale."""
    where = {state: p for p in places for state in p.states if not any(p.shift)}
    told: set[str] = set()
    for axis, start, end, words in _lengths(where, problem):
        if words and abs(end[axis] - start[axis]) > NEAR and repr(words) not in told:
            told.add(repr(words))
            yield Dimension(start, end, words, side=-1 if axis == 0 else 1, level=True)
    yield from _ground(places, where, problem)


def _lengths(where: dict[str, Later], problem: Problem) -> Iterator[tuple[int, Spot, Spot, Words]]:
    """Along which axis, from where to where, and how it is called."""
    for state in problem.states:
        for relation in state.relations:
            if isinstance(relation, Relation) and relation.operator == "=" and state.name in where:
                if isinstance(relation.right, Number) and relation.right.value == 0:
                    # No length; and a place near it may be drawn for it.
                    continue
                yield from _between(where, state, relation)
    for find in problem.find:
        what = find.found.what
        axis, name, at = _coordinate(what) if isinstance(what, Quantity) else (0, "", None)
        if name and at in where and (end := where[at].spots.get(name)) is not None:
            yield axis, _foot(end, axis), end, line(Name(find.name))


def _between(where: dict[str, Later], state: Written, relation: Relation) -> Iterator[tuple[int, Spot, Spot, Words]]:
    left = relation.left
    one, other = (left.left, left.right) if isinstance(left, Binary) and left.operator == "-" else (left, None)
    axis, name, at = _coordinate(one)
    end = where[at or state.name].spots.get(name) if (at or state.name) in where else None
    if end is None:
        return
    if other is None:
        yield axis, _foot(end, axis), end, size_of(relation.right, end[axis])
        return
    along, first, since = _coordinate(other)
    begin = where[since or state.name].spots.get(first) if (since or state.name) in where else None
    if begin is not None and along == axis:
        yield axis, begin, end, size_of(relation.right, end[axis] - begin[axis])


def _coordinate(side: Side | None) -> tuple[int, str, str | None]:
    """x(ball) @ top: the axis, the body and the state; no name: it is something else."""
    if not isinstance(side, Quantity) or side.word not in AXES or side.parts or len(side.things) != 1:
        return 0, "", None
    return AXES.index(side.word), side.things[0], side.at if isinstance(side.at, str) else None


def _foot(spot: Spot, axis: int) -> Spot:
    """Beside a place, on the axis from which a coordinate counts."""
    return (0.0, spot[1]) if axis == 0 else (spot[0], 0.0)


def _ground(places: Sequence[Later], where: dict[str, Later], problem: Problem) -> Iterator[Mark]:
    """What flies and comes to y = 0 has come to the ground."""
    if problem.plane != "vertical" or any(isinstance(s.shape, Line) for s in problem.surfaces) or problem.joints:
        return
    lands = [n for s in problem.states if s.name in where for r in s.relations if (n := _landing(r))]
    spots = [p.spots[name] for name in lands for p in places if name in p.spots]
    if spots and min(y for _, y in spots) > -NEAR:
        low, high = min(x for x, _ in spots), max(x for x, _ in spots)
        more = BEYOND * max(high - low, *(y for _, y in spots))
        yield Hatched(((low - more, 0.0), (high + more, 0.0)))


def _landing(relation: object) -> str:
    if not isinstance(relation, Relation) or relation.operator != "=" or not isinstance(relation.right, Number):
        return ""
    axis, name, at = _coordinate(relation.left)
    return name if axis == 1 and at is None and relation.right.value == 0 else ""
