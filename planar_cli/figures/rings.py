"""Closed outlines in numbers: round some places, what a line leaves of one, where one is met."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise

from planar_cli.report.document.marks import Spot

Ring = list[Spot]
SMOOTH = 36
"""A circle has so many corners."""


def around(places: Sequence[Spot]) -> Ring:
    """The corners of the smallest convex outline round some places, counterclockwise."""
    ordered = sorted(set(places))
    if len(ordered) < 3:
        return ordered
    halves: list[list[Spot]] = []
    for way in (ordered, ordered[::-1]):
        half: list[Spot] = []
        for p in way:
            while len(half) > 1 and turn(half[-2], half[-1], p) <= 0:
                half.pop()
            half.append(p)
        halves.append(half[:-1])
    return halves[0] + halves[1]


def turn(a: Spot, b: Spot, c: Spot) -> float:
    """Twice the area of a triangle, positive where its corners follow each other counterclockwise."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def left_of(ring: Sequence[Spot], at: Spot, angle: float) -> Ring:
    """What lies of an outline to the left of a line through a place in a direction."""
    ahead = (at[0] + math.cos(angle), at[1] + math.sin(angle))
    found: list[Spot] = []
    for a, b in sides(ring):
        one, other = turn(at, ahead, a), turn(at, ahead, b)
        if one >= 0:
            found.append(a)
        if one * other < 0:
            part = one / (one - other)
            found.append((a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])))
    return found


def sides(ring: Sequence[Spot]) -> Iterator[tuple[Spot, Spot]]:
    """The sides of an outline, from corner to corner and back to the first."""
    yield from zip(ring, (*ring[1:], *ring[:1]), strict=True)


def meets(ring: Sequence[Spot], at: Spot, angle: float) -> list[float]:
    """How far from a place along a direction (behind it: negative) the sides of an outline are, in order."""
    ahead = (at[0] + math.cos(angle), at[1] + math.sin(angle))
    found = []
    for a, b in sides(ring):
        one, other = turn(at, ahead, a), turn(at, ahead, b)
        if (one < 0) != (other < 0):
            part = one / (one - other)
            x, y = a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])
            found.append((x - at[0]) * math.cos(angle) + (y - at[1]) * math.sin(angle))
    return sorted(found)


def inside(ring: Sequence[Spot], at: Spot, margin: float = 0.0) -> bool:
    """Does a place lie within a convex outline that runs counterclockwise, so far from each of its sides?"""
    return len(ring) > 2 and all(turn(a, b, at) >= margin * math.dist(a, b) for a, b in sides(ring))


def middle_of(ring: Sequence[Spot]) -> Spot:
    """The middle of an area."""
    (x0, y0), total, mx, my = ring[0], 0.0, 0.0, 0.0
    for a, b in sides(ring):
        part = turn(ring[0], a, b)
        total += part
        mx, my = mx + part * (x0 + a[0] + b[0]) / 3, my + part * (y0 + a[1] + b[1]) / 3
    return (mx / total, my / total)


def off(at: Spot, angle: float, place: Spot) -> float:
    return abs(across(at, angle, place))


def across(at: Spot, angle: float, place: Spot) -> float:
    """How far a place is to the left of a line."""
    return turn(at, (at[0] + math.cos(angle), at[1] + math.sin(angle)), place)


def side_of(way: Sequence[Spot], places: Sequence[Spot]) -> float:
    """Positive: places lie to the left of a way, seen from its stroke that is nearest to each."""
    total = 0.0
    for place in places:
        a, b = min(pairwise(way), key=lambda ends: math.dist(ends[0], place) + math.dist(ends[1], place))
        total += turn(a, b, place) / max(math.dist(a, b), 1e-300)
    return total


def moved_by(place: Spot, by: Spot) -> Spot:
    return place[0] + by[0], place[1] + by[1]


def turned_by(place: Spot, angle: float) -> Spot:
    cos, sin = math.cos(angle), math.sin(angle)
    return place[0] * cos - place[1] * sin, place[0] * sin + place[1] * cos


def ends_of(values: Iterable[float]) -> tuple[float, float]:
    told = list(values)
    return min(told), max(told)


def extent_of(spots: Sequence[Spot]) -> float:
    """The larger side of the box round some places, m."""
    if not spots:
        return 0.0
    (left, right), (low, high) = ends_of(x for x, _ in spots), ends_of(y for _, y in spots)
    return max(right - left, high - low)


def way_of(a: Spot, b: Spot) -> float:
    return math.atan2(b[1] - a[1], b[0] - a[0])


def about(center: Spot, m: float) -> Ring:
    return [(center[0] + i * m, center[1] + j * m) for i in (-1, 1) for j in (-1, 1)]


def circle(center: Spot, radius: float) -> Ring:
    turns = [2 * math.pi * i / SMOOTH for i in range(SMOOTH)]
    return [(center[0] + radius * math.cos(a), center[1] + radius * math.sin(a)) for a in turns]


def box_of(start: Spot, way: float, length: float, across: tuple[float, float]) -> Ring:
    corners = [(x, y) for x in (0.0, length) for y in across]
    return around([moved_by(turned_by(c, way), start) for c in corners])
