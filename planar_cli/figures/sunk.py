"""Blocks with a rope along what they stand on, or with arrows: drawn round the place at which the file has them, with
the ground under them, so that none of that lies in the line of the ground, which ends where the rope goes down over a
wheel.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from planar_cli.figures.rings import across, extent_of, off, way_of
from planar_cli.figures.shapes import moved
from planar_cli.report.document.marks import Angle, Arc, Arrow, Hatched, Mark, Polyline, Spot, Symbol, spots_of

MIDDLE = 10.4
"""The middle of a block is so far above its foot, px."""
ALONG, NEAR = 0.2, 1e-6
"""What stands within this sine of what a block stands on goes along it; what is so near, in parts of the scene, to a
line lies on it.
"""
ROOM = 1.3
"""The ground ends so many radii before the axle of a wheel over which a rope goes down."""


def sunk(marks: Sequence[Mark]) -> list[Mark]:
    """The marks of a scene, with the straight grounds that carry pulled blocks and nothing else under these."""
    near = NEAR * (extent_of([s for m in marks for s in spots_of(m)]) or 1.0)
    found = list(marks)
    for i, ground in enumerate(marks):
        if isinstance(ground, Hatched) and (blocks := _carried(ground, marks, near)):
            found = [_lowered(m, ground, blocks) for m in found]
            found[i] = replace(_as_far(ground, blocks, marks, near), aside=-MIDDLE)
    return found


def _carried(ground: Hatched, marks: Sequence[Mark], near: float) -> list[Symbol]:
    """The blocks on a straight ground, if one is pulled along it and nothing else is on it."""
    if len(ground.places) != 2:
        return []
    start, way = ground.places[0], way_of(*ground.places)
    on_it: list[Symbol] = []
    for mark in marks:
        match mark:
            case Symbol(kind="block" | "later", at=at, angle=angle) if off(start, way, at) < near:
                if abs(math.remainder(angle - way, 2 * math.pi)) > ALONG:
                    return []
                on_it.append(mark)
            case Symbol(kind="particle" | "place", at=at) if off(start, way, at) < near:
                return []
            case Polyline(style="body", places=places) if min(abs(across(start, way, p)) for p in places) < near:
                return []
            case Arc(style="body", center=center, radius=r) if abs(across(start, way, center) - r) < near:
                return []
            case Hatched(places=places) if mark != ground and min(off(start, way, p) for p in places) < near:
                return []
    pulled = [b for b in on_it if any(_pulls(m, b) for m in marks)]
    return on_it if pulled else []


def _pulls(mark: Mark, block: Symbol) -> bool:
    """Is it an arrow at a block, or a rope from it along what it stands on?"""
    match mark:
        case Arrow(at=at):
            return at == block.at
        case Polyline(style="rope", places=(a, b)):
            return block.at in (a, b) and abs(math.sin(way_of(a, b) - block.angle)) < ALONG
        case _:
            return False


def _lowered(mark: Mark, ground: Hatched, blocks: Sequence[Symbol]) -> Mark:
    """A block, or the angle at the foot of its slope, where it is drawn."""
    if isinstance(mark, Symbol) and mark in blocks:
        return replace(mark, aside=-MIDDLE)
    if isinstance(mark, Angle) and mark.vertex in ground.places:
        way = way_of(*ground.places) - math.pi / 2
        return replace(mark, shift=(MIDDLE * math.cos(way), MIDDLE * math.sin(way)))
    return mark


def _as_far(ground: Hatched, blocks: Sequence[Symbol], marks: Sequence[Mark], near: float) -> Hatched:
    """As far as the ropes of its blocks go along it; not beyond the wheel over which one goes down."""
    start, end = ground.places
    way = way_of(start, end)
    low, high = 0.0, math.dist(start, end)
    wheels = [m for m in marks if isinstance(m, Arc) and across(start, way, m.center) <= -near]
    kept = [_ahead(start, way, b.at) for b in blocks]
    for rope in (m for m in marks if isinstance(m, Polyline) and any(_pulls(m, b) for b in blocks)):
        for tip in (p for p in rope.places if all(p != b.at for b in blocks)):
            wheel = next((w for w in wheels if abs(math.dist(w.center, tip) - w.radius) < near), None)
            if wheel is None:
                continue
            until, back = _ahead(start, way, wheel.center), ROOM * wheel.radius
            if until > max(kept):
                high = max(until - back, *kept)
            elif until < min(kept):
                low = min(until + back, *kept)
    return replace(ground, places=(moved(start, way, low), moved(start, way, high)))


def _ahead(start: Spot, way: float, at: Spot) -> float:
    return (at[0] - start[0]) * math.cos(way) + (at[1] - start[1]) * math.sin(way)
