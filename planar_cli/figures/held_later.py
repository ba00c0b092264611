"""Ropes, bars, springs and dampers of later states, and ropes that are slack at first."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from planar_cli.figures.drawn import Drawn
from planar_cli.figures.joints_drawn import sketch_marks
from planar_cli.figures.partners import sketch_of
from planar_cli.figures.rings import off, way_of
from planar_cli.figures.shapes import moved
from planar_cli.figures.springs import Strut
from planar_cli.joints.base import Joint
from planar_cli.problem.scene.sketches import Absorber, Bar, Cord, Spiral
from planar_cli.report.document.marks import Arc, Mark, Polyline, Spot, Symbol

WAVES, SWING = 3, 0.05
"""A slack rope hangs in so many waves, and so far to the side in parts of its length."""
FINE = 12
BESIDE = 0.15
"""A spring whose ends come so near to the line of its first position, in parts of its length, would lie on it."""


def held_marks(there: Drawn, first: Drawn, between: Sequence[Drawn] = ()) -> list[Mark]:
    """What holds bodies in a later position, dashed, but for what is as it was in the `first` one, or in one of those
    `between`. Of springs and dampers none that would lie on an earlier one: beside that it would be taken for another.
    """
    before = [(name, mark) for drawn in (first, *between) for name, mark in _held(drawn)]
    new = [pair for pair in _held(there, touched=True) if pair not in before]
    return [mark for name, mark in new if not (isinstance(mark, Strut) and _again(name, mark, before))]


def _again(name: str, strut: Strut, before: Sequence[tuple[str, Mark]]) -> bool:
    return any(n == name and isinstance(m, Strut) and _in_line(strut, m) for n, m in before)


def _in_line(one: Strut, other: Strut) -> bool:
    """Would one lie on the other, or nearly?"""
    way, length = way_of(one.start, one.end), math.dist(one.start, one.end)
    return all(off(one.start, way, place) < BESIDE * length for place in (other.start, other.end))


def _held(drawn: Drawn, touched: bool = False) -> list[tuple[str, Mark]]:
    """With what they are of. `touched`: without buffers that nothing touches."""
    found: list[tuple[str, Mark]] = []
    for load in drawn.scene.problem.loads:
        for sketch in sketch_of(drawn, load):
            free = touched and isinstance(sketch, Spiral) and _is_free(drawn, sketch)
            for mark in sketch_marks(drawn, sketch, ()) if isinstance(sketch, Spiral | Absorber) else ():
                if isinstance(mark, Strut) and not free:
                    ends = _rounded(mark.start), _rounded(mark.end)
                    found.append((load.name, replace(mark, start=ends[0], end=ends[1], words=(), later=True)))
    for joint in drawn.scene.problem.joints:
        for sketch in sketch_of(drawn, joint):
            for mark in sketch_marks(drawn, sketch, ()) if isinstance(sketch, Bar | Cord) else ():
                if isinstance(mark, Polyline) and not mark.closed:
                    found.append((joint.name, Polyline(tuple(map(_rounded, mark.places)), "hidden")))
                elif isinstance(mark, Arc) and mark.style == "rope":
                    turned = Arc(mark.center, mark.radius, "hidden", round(mark.start, 9), round(mark.sweep, 9))
                    found.append((joint.name, turned))
    return found


def _is_free(drawn: Drawn, spring: Spiral) -> bool:
    """Is it one that only pushes, and does nothing touch it?"""
    free = None if spring.free is None else drawn.number(spring.free)
    start, end = drawn.spot(spring.start), drawn.spot(spring.end)
    return free is not None and start is not None and end is not None and math.dist(start, end) > free * (1 - 1e-9)


def _rounded(spot: Spot) -> Spot:
    return round(spot[0], 9), round(spot[1], 9)


def slack_marks(drawn: Drawn, joints: Sequence[Joint]) -> Iterator[Mark]:
    """Of ropes and rods of the file (`joints`) that do not hold in a position yet: ropes in waves, as they are before
    they become taut, and the nails on which rods will turn.
    """
    holding = {joint.name for joint in drawn.scene.problem.joints}
    for joint in joints:
        for sketch in sketch_of(drawn, joint) if joint.name not in holding else ():
            if isinstance(sketch, Bar):
                ends = (
                    (drawn.spot(end), held) for end, held in zip((sketch.start, sketch.end), sketch.fixed, strict=True)
                )
                yield from (Symbol("pin", at) for at, held in ends if held and at is not None)
            marks = sketch_marks(drawn, sketch, ()) if isinstance(sketch, Cord) else ()
            for mark in marks:
                if isinstance(mark, Polyline) and mark.style == "rope":
                    yield Polyline(tuple(s for ends in pairwise(mark.places) for s in _waves(*ends)), "rope")


def _waves(start: Spot, end: Spot) -> Iterator[Spot]:
    reach, along = math.dist(start, end), math.atan2(end[1] - start[1], end[0] - start[0])
    for i in range(2 * WAVES * FINE + 1):
        part = i / (2 * WAVES * FINE)
        yield moved(start, along, reach * part, SWING * reach * math.sin(2 * math.pi * WAVES * part))
