"""The line of a straight face or slot on a body, as far as the body goes."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from planar_cli.figures.rings import circle, meets, off, sides, way_of
from planar_cli.figures.shapes import moved
from planar_cli.report.marks import Arc, Mark, Polyline, Spot

NEAR = 1e-6


def within(line: Mark, shape: Sequence[Mark]) -> Iterator[Mark]:
    """A line that goes through the area of a body, thin and within it; nothing where it is an edge of its outline.

    `shape`: what the body is drawn by; beside a body without area the line stays as it is.
    """
    rings = [m.places for m in shape if isinstance(m, Polyline) and m.closed]
    rings += [tuple(circle(m.center, m.radius)) for m in shape if isinstance(m, Arc)]
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
    yield Polyline((moved(start, way, found[0]), moved(start, way, found[-1])), "thin")


def _is_edge(ring: Sequence[Spot], start: Spot, way: float) -> bool:
    """Is a side of an outline part of a line?"""
    long = max(math.dist(a, b) for a, b in sides(ring))
    pairs = (pair for pair in sides(ring) if math.dist(*pair) > long / 20)
    return any(off(start, way, a) < NEAR * long and off(start, way, b) < NEAR * long for a, b in pairs)
