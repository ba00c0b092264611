"""Ropes and bars of later states, and ropes that are slack at first."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

from planar_cli.figures.drawn import Drawn
from planar_cli.figures.joints_drawn import sketch_marks
from planar_cli.figures.partners import sketch_of
from planar_cli.figures.shapes import moved
from planar_cli.joints.base import Joint
from planar_cli.problem.sketches import Bar, Cord
from planar_cli.report.marks import Arc, Mark, Polyline, Spot

WAVES, SWING = 3, 0.05
"""A slack rope hangs in so many waves, and so far to the side in parts of its length."""
FINE = 12


def held_marks(there: Drawn, before: Drawn) -> list[Mark]:
    """The ropes and bars of a later position, dashed, but for those that are as they were `before`."""
    old = _held(before)
    return [mark for mark in _held(there) if mark not in old]


def _held(drawn: Drawn) -> list[Mark]:
    found: list[Mark] = []
    for joint in drawn.scene.problem.joints:
        for sketch in sketch_of(drawn, joint):
            for mark in sketch_marks(drawn, sketch, ()) if isinstance(sketch, Bar | Cord) else ():
                if isinstance(mark, Polyline) and not mark.closed:
                    found.append(Polyline(tuple((round(x, 9), round(y, 9)) for x, y in mark.places), "hidden"))
                elif isinstance(mark, Arc) and mark.style == "rope":
                    found.append(Arc(mark.center, mark.radius, "hidden", round(mark.start, 9), round(mark.sweep, 9)))
    return found


def slack_marks(drawn: Drawn, joints: Sequence[Joint]) -> Iterator[Mark]:
    """Ropes of the file (`joints`) that do not hold in a position, as it is before they become taut: in waves."""
    holding = {joint.name for joint in drawn.scene.problem.joints}
    for joint in joints:
        for sketch in sketch_of(drawn, joint) if joint.name not in holding else ():
            marks = sketch_marks(drawn, sketch, ()) if isinstance(sketch, Cord) else ()
            for mark in marks:
                if isinstance(mark, Polyline) and mark.style == "rope":
                    yield Polyline(tuple(s for ends in pairwise(mark.places) for s in _waves(*ends)), "rope")


def _waves(start: Spot, end: Spot) -> Iterator[Spot]:
    reach, along = math.dist(start, end), math.atan2(end[1] - start[1], end[0] - start[0])
    for i in range(2 * WAVES * FINE + 1):
        part = i / (2 * WAVES * FINE)
        yield moved(start, along, reach * part, SWING * reach * math.sin(2 * math.pi * WAVES * part))
