"""Heights, ranges and distances: what the file gives and asks of the places of states."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import pairwise, starmap

from planar_cli.figures.drawn import size_of
from planar_cli.figures.landings import coordinate, landing_marks, spot_of
from planar_cli.figures.positions import Later
from planar_cli.figures.rings import moved_by, turned_by
from planar_cli.figures.turned_through import turned_through
from planar_cli.problem.language.expression import Binary, Number, Quantity, Relation, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.scene.scene import State as Written
from planar_cli.report.document.blocks import Line as Words
from planar_cli.report.document.blocks import Name, line
from planar_cli.report.document.marks import Dimension, Mark, Polyline, Spot, Tag

NEAR, BENT = 1e-6, 1.001
"""A way that is longer than this, in parts of the straight one, is bent."""


def state_measures(places: Sequence[Later], problem: Problem, shown: Sequence[Mark] = ()) -> Iterator[Mark]:
    """Of states that are drawn to scale. `shown`: what is drawn of the first one, with dimensions of its own."""
    before = [m for m in shown if isinstance(m, Dimension) and m.level]
    where = {state: p for p in places for state in p.states if not any(p.shift)}
    told: set[str] = set()
    for axis, start, end, words in _lengths(where, problem):
        again = any(m.words == words and _is_along(m, axis, start, end) for m in before)
        if words and not again and abs(end[axis] - start[axis]) > NEAR and repr(words) not in told:
            told.add(repr(words))
            yield Dimension(start, end, words, side=-1 if axis == 0 else 1, level=True)
    for mark in _along_lines(where, problem):
        if repr(mark.words) not in told:
            told.add(repr(mark.words))
            yield mark
    yield from landing_marks(where, problem)
    yield from turned_through(where, problem)


def lengths_of_ways(places: Sequence[Later], problem: Problem, ways: Iterable[Mark]) -> Iterator[Mark]:
    """The lengths of ways that the file gives or asks: beside the middle of a way that is bent. `ways`: as drawn."""
    where = {state: p for p in places for state in p.states if not any(p.shift)}
    given = [r for s in problem.states for r in s.relations if isinstance(r, Relation) and r.operator == "="]
    told = [(r.left, size_of(r.right, 1.0)) for r in given] + [(f.found.what, line(Name(f.name))) for f in problem.find]
    drawn = [m.places for m in ways if isinstance(m, Polyline) and m.style == "way"]
    for what, words in told:
        if not isinstance(what, Quantity) or what.word != "path_length" or not isinstance(what.at, tuple):
            continue
        ends = [spot_of(where[s], what.things[0]) for s in what.at if s in where]
        own = next((w for w in drawn if len(w) > 2 and _joins(w, ends)), None)
        if own is not None and sum(starmap(math.dist, pairwise(own))) > BENT * math.dist(own[0], own[-1]):
            yield Tag(own[len(own) // 2], words)


def _joins(way: Sequence[Spot], ends: Sequence[Spot | None]) -> bool:
    """Does a way go from one place to another? What has been gone round more than once is closed at its end."""
    near = NEAR * math.dist(way[0], way[len(way) // 2])
    if len(ends) < 2 or ends[0] is None or ends[-1] is None or math.dist(way[-1], ends[-1]) > near:
        return False
    closed = math.dist(way[0], way[-1]) <= near
    on = min(starmap(math.dist, ((s, ends[0]) for s in way))) if closed else math.dist(way[0], ends[0])
    return on <= (math.dist(*way[:2]) if closed else near)


def _is_along(one: Dimension, axis: int, start: Spot, end: Spot) -> bool:
    """Does it measure the same piece of an axis?"""
    ends, others = sorted((one.start[axis], one.end[axis])), sorted((start[axis], end[axis]))
    return all(abs(a - b) < NEAR for a, b in zip(ends, others, strict=True))


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
