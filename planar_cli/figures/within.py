"""The line of a straight face on a body, or a slot in it, as far as the body goes."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from planar_cli.figures.rings import Ring, circle, meets, off, sides, way_of
from planar_cli.figures.shapes import moved
from planar_cli.report.document.marks import Arc, Mark, Polyline, Slot, Spot

NEAR = 1e-6
RIM, BESIDE = 0.07, 0.12
"""So far within the edge of a body a slot in it ends, and so far beside what holds the body, in parts of what a line
through it has inside.
"""


def within(line: Mark, shape: Sequence[Mark], slotted: bool = False) -> Iterator[Mark]:
    """A line that goes through the area of a body, thin and within it; nothing where it is an edge of its outline.

    `shape`: what the body is drawn by; beside a body without area the line stays as it is. `slotted`: it is a slot,
    which is drawn with what runs in it.
    """
    rings = _areas(shape)
    if not rings or not isinstance(line, Polyline) or len(line.places) != 2:
        yield line
        return
    start, way = line.places[0], way_of(*line.places)
    if any(_is_edge(ring, start, way) for ring in rings):
        return
    found = sorted(far for ring in rings for far in meets(ring, start, way))
    if len(found) < 2:
        yield line
        return
    if slotted:
        return
    yield Polyline((moved(start, way, found[0]), moved(start, way, found[-1])), "thin")


def slot_within(at: Spot, along: float, shape: Sequence[Mark], holds: Sequence[Spot]) -> Slot | None:
    """A slot in a body, in which something is at a place: from edge to edge, or to what holds the body there. None: the
    body has no area, or it is an edge along which something slides.
    """
    rings = _areas(shape)
    found = sorted(far for ring in rings for far in meets(ring, at, along))
    if any(_is_edge(ring, at, along) for ring in rings) or not found or not found[0] < 0 < found[-1]:
        return None
    low, high = found[0], found[-1]
    length = high - low
    ends = [low + RIM * length, high - RIM * length]
    for place in holds:
        ahead = (place[0] - at[0]) * math.cos(along) + (place[1] - at[1]) * math.sin(along)
        if off(at, along, place) > NEAR * length or abs(ahead) < NEAR * length:
            continue
        ends = (
            [max(ends[0], ahead + BESIDE * length), ends[1]]
            if ahead < 0
            else [ends[0], min(ends[1], ahead - BESIDE * length)]
        )
    return Slot(moved(at, along, min(ends[0], 0.0)), moved(at, along, max(ends[1], 0.0)), along, False)


def _areas(shape: Sequence[Mark]) -> list[Ring]:
    """The outlines of what a body is drawn by."""
    rings = [list(m.places) for m in shape if isinstance(m, Polyline) and m.closed]
    return rings + [list(circle(m.center, m.radius)) for m in shape if isinstance(m, Arc)]


def _is_edge(ring: Sequence[Spot], start: Spot, way: float) -> bool:
    """Is a side of an outline part of a line?"""
    long = max(math.dist(a, b) for a, b in sides(ring))
    pairs = (pair for pair in sides(ring) if math.dist(*pair) > long / 20)
    return any(off(start, way, a) < NEAR * long and off(start, way, b) < NEAR * long for a, b in pairs)
