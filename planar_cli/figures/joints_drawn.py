"""Joints and loads as they are drawn: what each kind says of its looks (problem/scene/sketches.py), in numbers."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import singledispatch
from typing import Any

from planar_cli.figures.drawn import Drawn, brief, size_of, words_of
from planar_cli.figures.floors import STEEP, slide_marks
from planar_cli.figures.partners import pivot_of
from planar_cli.figures.rings import extent_of
from planar_cli.figures.ropes import Stop, cord_marks, straight
from planar_cli.figures.shapes import moved
from planar_cli.problem.language.expression import Name, Quantity, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.keys import Table
from planar_cli.problem.scene.scene import Particle
from planar_cli.problem.scene.sketches import (
    Absorber,
    Bar,
    Cord,
    Fastening,
    Hinge,
    Loop,
    Push,
    Sketch,
    Slide,
    Spiral,
    Twist,
)
from planar_cli.report.document.blocks import Line
from planar_cli.report.document.marks import Arrow, Coil, Dashpot, Mark, Polyline, Spot, Symbol, Turn

CORD = 0.6
"""So long is the cord at whose end something pulls, in parts of the scene."""
HANGING = 0.45
"""The sine of the angle below the level from which on what a support holds hangs."""


def sketch_marks(drawn: Drawn, sketch: Sketch, name: Line, later: Sequence[Spot] = ()) -> Iterator[Mark]:
    """What a joint or load looks like. `name`: what a force is called whose size the file does not give in short;
    `later`: where what slides along a track comes to.
    """
    if not isinstance(sketch, Slide):
        yield from _drawn(sketch, drawn, name)
        return
    yield from slide_marks(drawn, sketch, later)
    at, along = drawn.spot(sketch.at), drawn.angle(sketch.along)
    if sketch.pinned and at is not None and along is not None:
        yield Symbol("support", at, _beside(drawn, at) if abs(math.sin(along)) > STEEP else 0.0)


def _beside(drawn: Drawn, at: Spot) -> float:
    """How a support is turned that stands beside something upright, on the side where less of the scene is."""
    xs = [x for x, _ in drawn.everything()]
    return -math.pi / 2 if sum(xs) > len(xs) * at[0] else math.pi / 2


@singledispatch
def _drawn(sketch: Any, drawn: Drawn, name: Line) -> Iterator[Mark]:
    raise TypeError(type(sketch).__name__)


@_drawn.register
def _hinge(sketch: Hinge, drawn: Drawn, name: Line) -> Iterator[Mark]:
    at = drawn.spot(sketch.at)
    if at is not None:
        if not sketch.grounded:
            yield Symbol("pin", at)
            return
        centers = (drawn.spot(b.center) for name in sketch.bodies if (b := drawn.body(name)) is not None)
        yield _support(at, [c for c in centers if c is not None])


def _support(at: Spot, others: Sequence[Spot]) -> Symbol:
    """A fixed support, below what it holds; above what hangs on it. `others`: where that is."""
    reaches = [(y - at[1], math.dist(at, (x, y))) for x, y in others]
    hangs = any(down < -HANGING * reach for down, reach in reaches)
    stands = any(down > HANGING * reach for down, reach in reaches)
    return Symbol("support", at, math.pi if hangs and not stands else 0.0)


def one_support(marks: Sequence[Mark]) -> list[Mark]:
    """The marks with one support for all that is pinned at a place: above, if something hangs there."""
    fixed = [m for m in marks if isinstance(m, Symbol) and m.kind == "support"]
    found: list[Mark] = []
    for mark in marks:
        own = [m for m in fixed if isinstance(mark, Symbol) and mark.kind == "support" and m.at == mark.at]
        if not own:
            found.append(mark)
        elif mark is own[0]:
            found.append(max(own, key=lambda m: m.angle))
    return found


@_drawn.register
def _fastening(sketch: Fastening, drawn: Drawn, name: Line) -> Iterator[Mark]:
    at = drawn.spot(sketch.at)
    if at is not None:
        yield Symbol("weld", at)


@_drawn.register
def _bar(sketch: Bar, drawn: Drawn, name: Line) -> Iterator[Mark]:
    ends = _ends(drawn, sketch)
    if ends is not None:
        yield Polyline(ends, "body")
        # A particle at its end is seen as such.
        bobs = [drawn.center(b.name) for b in drawn.scene.problem.bodies if isinstance(b.shape, Particle)]
        for (end, other), fixed in zip((ends, ends[::-1]), sketch.fixed, strict=True):
            if fixed:
                yield _support(end, [other])
            elif end not in bobs:
                yield Symbol("pin", end)


@_drawn.register
def _spiral(sketch: Spiral, drawn: Drawn, name: Line) -> Iterator[Mark]:
    ends = _ends(drawn, sketch)
    if ends is not None:
        free = None if sketch.free is None else drawn.number(sketch.free)
        words = _strength(drawn, sketch.size)
        if free is not None:
            yield from _buffer(ends, sketch.fixed, free, words)
            return
        yield Coil(*ends, words=words)
        yield from _walls(ends, sketch.fixed)


def _strength(drawn: Drawn, size: Side | None) -> Line:
    """What stands beside a spring or damper; nothing of one that a case leaves out by a zero."""
    return () if size is None or drawn.length(size) == 0 else brief(size)


def _buffer(ends: tuple[Spot, Spot], fixed: tuple[bool, bool], free: float, words: Line) -> Iterator[Mark]:
    """A spring that only pushes: from where it is fastened as far as it goes, with a plate at its end."""
    held, other = ends[::-1] if fixed[1] or not fixed[0] else ends
    reach = min(free, math.dist(held, other))
    way = math.atan2(other[1] - held[1], other[0] - held[0])
    tip = (held[0] + reach * math.cos(way), held[1] + reach * math.sin(way))
    yield Coil(held, tip, words=words)
    yield Symbol("plate", tip, way)
    yield from _walls((held, other), (any(fixed), False))


@_drawn.register
def _absorber(sketch: Absorber, drawn: Drawn, name: Line) -> Iterator[Mark]:
    ends = _ends(drawn, sketch)
    if ends is not None:
        yield Dashpot(*ends, words=_strength(drawn, sketch.size))
        yield from _walls(ends, sketch.fixed)


def _walls(ends: tuple[Spot, Spot], fixed: tuple[bool, bool]) -> Iterator[Mark]:
    """What the ends of something straight are fastened to: a piece of wall across it, behind each end."""
    for (at, other), held in zip((ends, ends[::-1]), fixed, strict=True):
        if held:
            yield Symbol("wall", at, math.atan2(other[1] - at[1], other[0] - at[0]))


def _ends(drawn: Drawn, sketch: Bar | Spiral | Absorber) -> tuple[Spot, Spot] | None:
    """The two ends, where they are told and apart."""
    start, end = drawn.spot(sketch.start), drawn.spot(sketch.end)
    return None if start is None or end is None or start == end else (start, end)


@_drawn.register
def _loop(sketch: Loop, drawn: Drawn, name: Line) -> Iterator[Mark]:
    (a, b), radii = (drawn.spot(c) for c in sketch.centers), [drawn.number(r) for r in sketch.radii]
    if a is None or b is None or radii[0] is None or radii[1] is None:
        return
    for side in (1, -1):
        ends = (Stop(a, radii[0], side), Stop(b, radii[1], -side if sketch.crossed else side))
        yield Polyline(straight(*ends), "rope")


@_drawn.register
def _push(sketch: Push, drawn: Drawn, name: Line) -> Iterator[Mark]:
    at, angle = drawn.spot(sketch.at), drawn.angle(sketch.direction)
    # What is nothing, as the speed of what leaks out, has no arrow; what is nothing only at first has one.
    size = None if isinstance(sketch.size, Table) else sketch.size
    idle = size is not None and drawn.length(size) == 0 and (sketch.flows or not _varies(size))
    if at is not None and angle is not None and not idle:
        words = name if size is None else size_of(size) or name
        # What is written with a minus is drawn the way it acts.
        angle += math.pi if size is not None and size_of(size) != words_of(size) else 0.0
        if sketch.unwinds:
            drum, at = at, moved(at, angle, CORD * (extent_of(drawn.at_rest().everything()) or 1.0))
            yield Polyline((drum, at), "rope")
        yield Arrow(at, angle, "velocity" if sketch.flows else "force", words, inward=sketch.inward)


def _varies(size: Side) -> bool:
    """Does it go with the time or with the motion?"""
    return any(isinstance(n, Quantity) or (isinstance(n, Name) and n.name == "t") for n in walk(size))


@_drawn.register
def _twist(sketch: Twist, drawn: Drawn, name: Line) -> Iterator[Mark]:
    at = pivot_of(drawn, sketch.body) or drawn.spot(sketch.at)
    # A moment that goes with the motion has no number, and no sense, in a drawing.
    known = not isinstance(sketch.size, Table) and not any(isinstance(n, Quantity) for n in walk(sketch.size))
    size = None if isinstance(sketch.size, Table) or not known else drawn.length(sketch.size)
    if at is not None:
        # Without a number a minus sign stays: it is not seen from the arrow.
        words = name if isinstance(sketch.size, Table) else size_of(sketch.size, size or 0.0) or name
        sense = -1 if size is not None and size < 0 else 1
        yield Turn(at, -sense if sketch.reversed else sense, "force", words)


@_drawn.register
def _cord(sketch: Cord, drawn: Drawn, name: Line) -> Iterator[Mark]:
    yield from cord_marks(drawn, sketch)
