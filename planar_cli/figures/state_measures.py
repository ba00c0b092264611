"""Heights, ranges and distances: what the file gives and asks of the places of states."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from planar_cli.figures.drawn import size_of
from planar_cli.figures.landings import coordinate, landing_marks, spot_of
from planar_cli.figures.positions import Later
from planar_cli.figures.rings import moved_by, turned_by
from planar_cli.problem.expression import Binary, Number, Quantity, Relation, Side
from planar_cli.problem.scene import Problem
from planar_cli.problem.scene import State as Written
from planar_cli.problem.walk import walk
from planar_cli.report.blocks import Line as Words
from planar_cli.report.blocks import Name, line
from planar_cli.report.marks import Dimension, Mark, Spot

NEAR = 1e-6


def state_measures(places: Sequence[Later], problem: Problem) -> Iterator[Mark]:
    """Of states that are drawn to scale."""
    where = {state: p for p in places for state in p.states if not any(p.shift)}
    told: set[str] = set()
    for axis, start, end, words in _lengths(where, problem):
        if words and abs(end[axis] - start[axis]) > NEAR and repr(words) not in told:
            told.add(repr(words))
            yield Dimension(start, end, words, side=-1 if axis == 0 else 1, level=True)
    for mark in _along_lines(where, problem):
        if repr(mark.words) not in told:
            told.add(repr(mark.words))
            yield mark
    yield from landing_marks(where, problem)


def _lengths(where: dict[str, Later], problem: Problem) -> Iterator[tuple[int, Spot, Spot, Words]]:
    """Along which axis, from where to where, and how it is called."""
    for state in problem.states:
        for relation in state.relations:
            if isinstance(relation, Relation) and relation.operator == "=" and state.name in where:
                moving = any(isinstance(node, Quantity) for node in walk(relation.right))
                if moving or (isinstance(relation.right, Number) and relation.right.value == 0):
                    # No length; and a place near it may be drawn for it.
                    continue
                yield from _between(where, state, relation)
    for find in problem.find:
        what = find.found.what
        axis, name, at = coordinate(what) if isinstance(what, Quantity) else (0, "", None)
        if name and at in where and (end := spot_of(where[at], name)) is not None:
            yield axis, _foot(end, axis), end, line(Name(find.name))


def _between(where: dict[str, Later], state: Written, relation: Relation) -> Iterator[tuple[int, Spot, Spot, Words]]:
    left = relation.left
    one, other = (left.left, left.right) if isinstance(left, Binary) and left.operator == "-" else (left, None)
    axis, name, at = coordinate(one)
    end = spot_of(where[at or state.name], name) if (at or state.name) in where else None
    if end is None:
        return
    if other is None:
        yield axis, _foot(end, axis), end, size_of(relation.right, end[axis])
        return
    along, first, since = coordinate(other)
    begin = spot_of(where[since or state.name], first) if (since or state.name) in where else None
    if begin is not None and along == axis:
        yield axis, begin, end, size_of(relation.right, end[axis] - begin[axis])


def _along_lines(where: Mapping[str, Later], problem: Problem) -> Iterator[Dimension]:
    """Distances that are asked along a slanting line through a point, across it, and from a point."""
    for find in problem.find:
        what = find.found.what
        if not isinstance(what, Quantity) or what.word != "r" or len(what.parts) != 1:
            continue
        if not isinstance(what.at, str) or what.at not in where:
            continue
        (part,), place = what.parts, where[what.at]
        end = spot_of(place, what.things[0])
        begin = spot_of(place, what.things[1]) if len(what.things) == 2 else (0.0, 0.0)
        if begin is None or end is None or math.dist(begin, end) < NEAR:
            continue
        if part.kind == "mag":
            yield Dimension(begin, end, line(Name(find.name)), side=-1)
        elif part.kind in ("along", "across") and isinstance(part.direction, Side):
            way = place.there.length(part.direction)
            if way is not None:
                ahead = turned_by((end[0] - begin[0], end[1] - begin[1]), -way)[0]
                foot = moved_by(turned_by((ahead, 0.0), way), begin)
                ends = (begin, foot) if part.kind == "along" else (foot, end)
                yield Dimension(*ends, line(Name(find.name)), side=-1 if part.kind == "along" else 0)


def _foot(spot: Spot, axis: int) -> Spot:
    """Beside a place, on the axis from which a coordinate counts."""
    return (0.0, spot[1]) if axis == 0 else (spot[0], 0.0)
