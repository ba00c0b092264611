"""Springs and dampers beside each other and up to the bodies that they hold, not on one another or on the ground."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from planar_cli.figures.rings import inside, meets, off, way_of
from planar_cli.report.document.marks import Coil, Dashpot, Mark, Polyline, Spot, Symbol

LANE = 20.0
"""So far apart are two between the same places, px."""
HALF, RAISED, HIGH = 13.0, 10.0, 20.8
"""Half the width of a block or slider, and the height of its middle and its top above what it stands on, px."""
ALONG = 0.2
"""What stands within this sine of its own direction is met at its side."""
NEAR = 1e-6
Strut = Coil | Dashpot


def settled(marks: Sequence[Mark]) -> Iterator[Mark]:
    """The marks of a scene, with its springs and dampers at their places."""
    every = [m for m in marks if isinstance(m, Strut)]
    struts = [m for m in every if not m.later]
    blocks = [m for m in marks if isinstance(m, Symbol) and m.kind in ("block", "slider", "rail", "later")]
    areas = [m.places for m in marks if isinstance(m, Polyline) and m.closed and m.style == "body"]
    bars = [m.places for m in marks if isinstance(m, Polyline) and not m.closed and m.style == "body"]
    raised = {(s.start, s.end): _raised(s, blocks) for s in every}
    lanes = {(s.start, s.end): _lane(s, struts, bars) for s in struts}
    for mark in marks:
        if isinstance(mark, Strut):
            lane = 0.0 if mark.later else _lane(mark, struts, bars)
            yield _up_to(replace(mark, aside=raised[mark.start, mark.end], lane=lane), blocks, areas)
        elif isinstance(mark, Symbol) and mark.kind == "plate":
            beside = {ends: aside + lanes.get(ends, 0.0) for ends, aside in raised.items()}
            yield replace(mark, aside=_wall(mark, beside))
        elif isinstance(mark, Symbol) and mark.kind == "wall":
            yield replace(mark, aside=_wall(mark, raised))
        else:
            yield mark


def _raised(strut: Strut, blocks: Sequence[Symbol]) -> float:
    """How far it lies to the left of the line between its ends: with a block on the ground at its middle."""
    way, length = way_of(strut.start, strut.end), math.dist(strut.start, strut.end)
    for block in blocks:
        in_line = off(strut.start, way, block.at) < NEAR * length
        if block.kind == "block" and not block.aside and in_line and abs(math.sin(way - block.angle)) < ALONG:
            return RAISED if math.cos(way - block.angle) > 0 else -RAISED
    return 0.0


def _wall(wall: Symbol, raised: dict[tuple[Spot, Spot], float]) -> float:
    """How far a wall lies to the left of its way to go with its spring."""
    for (start, end), aside in raised.items():
        if math.dist(wall.at, start) < NEAR:
            return aside
        if math.dist(wall.at, end) < NEAR:
            return -aside
    return 0.0


def _lane(strut: Strut, struts: Sequence[Strut], bars: Sequence[tuple[Spot, ...]]) -> float:
    """Where it lies among all between the same two places or one in another, or beside a bar along the same line."""
    way, length = way_of(strut.start, strut.end), math.dist(strut.start, strut.end)
    beside = [s for s in struts if s is strut or _lies_on(s, strut)]
    along = any(max(off(strut.start, way, p) for p in bar) < NEAR * length and _overlap(strut, bar) for bar in bars)
    if len(beside) == 1:
        return LANE * 0.7 if along else 0.0
    place = next(i for i, s in enumerate(beside) if s is strut)
    lane = LANE * (place - (len(beside) - 1) / 2)
    return lane if math.cos(way - way_of(beside[0].start, beside[0].end)) > 0 else -lane


def _lies_on(one: Strut, other: Strut) -> bool:
    """Would one lie on the other from a common end on, as springs that are set in each other do?"""
    ends, others = (one.start, one.end), (other.start, other.end)
    way, length = way_of(*ends), math.dist(*ends)
    in_line = all(off(one.start, way, spot) < NEAR * length for spot in others)
    meet = any(math.dist(a, b) < NEAR * length for a in ends for b in others)
    return meet and in_line and _overlap(one, others)


def _overlap(strut: Strut, bar: Sequence[Spot]) -> bool:
    """Do two that lie in one line have more than an end in common?"""
    way, length = way_of(strut.start, strut.end), math.dist(strut.start, strut.end)
    cos, sin = math.cos(way), math.sin(way)
    ahead = [(x - strut.start[0]) * cos + (y - strut.start[1]) * sin for x, y in bar]
    return min(max(ahead), length) - max(min(ahead), 0.0) > NEAR * length


def _up_to(strut: Strut, blocks: Sequence[Symbol], areas: Sequence[tuple[Spot, ...]]) -> Strut:
    """One that ends at the edge of what it holds."""
    ends, cuts = [strut.start, strut.end], [0.0, 0.0]
    for i, (end, other) in enumerate(((strut.start, strut.end), (strut.end, strut.start))):
        way = way_of(end, other)
        block = next((b for b in blocks if math.dist(b.at, end) < NEAR), None)
        if block is not None and abs(math.sin(way - block.angle)) < ALONG:
            cuts[i] = HALF
        elif block is not None and block.kind == "block" and math.sin(way - block.angle) > 1 - ALONG:
            cuts[i] = HIGH
        for area in areas if block is None else ():
            ahead = [far for far in meets(area, end, way) if far > NEAR]
            if inside(area, end, NEAR) and not inside(area, other) and ahead:
                ends[i] = (end[0] + ahead[0] * math.cos(way), end[1] + ahead[0] * math.sin(way))
    return replace(strut, start=ends[0], end=ends[1], cuts=(cuts[0], cuts[1]))
