"""Ropes as they are drawn: tangents from wheel to wheel, and what holds their ends and their pulleys."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from planar_cli.figures.drawn import Drawn
from planar_cli.figures.hanging import in_its_loop
from planar_cli.figures.partners import between, sketch_of
from planar_cli.figures.rings import extent_of, moved_by, turn, way_of
from planar_cli.figures.shapes import moved
from planar_cli.problem.scene.scene import Particle, Round
from planar_cli.problem.scene.sketches import Bar, Cord, CordStop
from planar_cli.records import record
from planar_cli.report.document.marks import Arc, Mark, Polyline, Spot, Symbol

BENT, PLUMB = math.radians(20), 1e-6
"""Half of the angle between two parts of a rope from which on its wheel stands within its bend; the cosine up to which
a part is upright.
"""
WHEEL, STRAIGHT, OFF = 0.035, 0.02, 1e-3
"""The radius of a small wheel in parts of the scene; the sine of the angle up to which a rope goes straight on; how far
a part of it may be off its direction, in parts of the scene.
"""


@record
class Stop:
    """A stop of a cord in numbers; `side` as in `CordStop`; `hangs`: is it a load in the bight of the rope?"""

    center: Spot
    radius: float = 0.0
    side: int = 0
    rim: Spot | None = None
    fixed: bool = False
    hangs: bool = False


@record
class Strand:
    """Where a part of a rope leaves a body that it pulls: `off` the place of the file, of the centre of a wheel, along
    `angle`; `small`: it is a wheel that only the drawing has.
    """

    body: str
    center: Spot
    off: Spot
    radius: float
    angle: float
    small: bool


def cord_marks(drawn: Drawn, sketch: Cord) -> Iterator[Mark]:
    """A rope from stop to stop. A point over which it runs is a small wheel, on a hanger if it is fixed."""
    told = [s for stop in sketch.stops if (s := _stop(drawn, stop)) is not None]
    if len(told) < len(sketch.stops):
        return
    lies_flat, along = _lies_flat(drawn), _along(drawn, sketch)
    parallel = _in_parallel(drawn, sketch, told)
    stops = parallel or _with_wheels(told, WHEEL * _size(drawn), lies_flat)
    # In a horizontal plane nothing hangs: there it runs round a peg or through a hole.
    yield from (Symbol("ring", s.center) for s in stops[1:-1] if s.fixed and not s.radius and lies_flat)
    for i, wheel in enumerate(stops):
        if wheel.radius and not told[i].radius and not _is_disk(drawn, sketch.stops[i]):
            # A load that hangs on a rope is seen within its wheel.
            yield Arc(wheel.center, wheel.radius, "body" if wheel.fixed else "thin")
            if wheel.fixed:
                yield from _hung(wheel, _hangs(told, i, along if parallel else None))
            elif i == min(alike := [k for k, s in enumerate(sketch.stops) if s.body == sketch.stops[i].body]):
                # Under several wheels of a body one load hangs.
                yield from in_its_loop(drawn, sketch, i, max(stops[k].radius for k in alike))
        if wheel.center != told[i].center and parallel:
            yield Polyline((told[i].center, wheel.center), "body")
    parts = [straight(a, b) for a, b in pairwise(stops) if (a.rim or a.center) != (b.rim or b.center)]
    for part in parts:
        yield Polyline(part, "rope")
    if len(parts) == len(stops) - 1:
        for (before, after), stop in zip(pairwise(parts), stops[1:-1], strict=True):
            if stop.radius:
                yield _wrapped(stop, before[1], after[0])
    if parts:
        for held, (at, other) in zip(sketch.fixed, (parts[0], parts[-1][::-1]), strict=True):
            if held:
                yield Symbol("wall", at, _upright(math.atan2(other[1] - at[1], other[0] - at[0]), math.pi / 2))


def ropes_within(drawn: Drawn, bodies: frozenset[str]) -> Iterator[Mark]:
    """The ropes and light rods between bodies that are drawn together."""
    for joint in drawn.scene.problem.joints:
        ends = [(drawn.scene.owner(name), drawn.named(name)) for name in between(joint)]
        if any(isinstance(s, Bar) for s in sketch_of(drawn, joint)) and all(owner in bodies for owner, _ in ends):
            yield Polyline(tuple(spot for _, spot in ends if spot is not None), "thin")
        for sketch in sketch_of(drawn, joint):
            if isinstance(sketch, Cord) and all(not s.fixed and s.body in bodies for s in sketch.stops):
                yield from cord_marks(drawn, sketch)


def strands(drawn: Drawn, sketch: Cord) -> Iterator[Strand]:
    """Where the straight parts of a rope leave what they pull."""
    told = [s for stop in sketch.stops if (s := _stop(drawn, stop)) is not None]
    if len(told) < len(sketch.stops):
        return
    stops = _in_parallel(drawn, sketch, told) or _with_wheels(told, WHEEL * _size(drawn), _lies_flat(drawn))
    for i, (one, other) in enumerate(pairwise(stops)):
        start, end = straight(one, other)
        for k, at, to in ((i, start, end), (i + 1, end, start)):
            (x, y), stop = stops[k].center, sketch.stops[k]
            yield Strand(
                stop.body, told[k].center, (at[0] - x, at[1] - y), stops[k].radius, way_of(at, to), not told[k].radius
            )


def _along(drawn: Drawn, sketch: Cord) -> float | None:
    return drawn.angle(sketch.along) if sketch.along is not None else None


def _in_parallel(drawn: Drawn, sketch: Cord, told: Sequence[Stop]) -> list[Stop] | None:
    along = _along(drawn, sketch)
    return None if along is None else _parallel(drawn, sketch, told, along, OFF * _size(drawn))


def _hung(wheel: Stop, angle: float) -> Iterator[Mark]:
    """What holds a fixed wheel, from its rim on, and an arm from there to its axle."""
    at = moved(wheel.center, angle, wheel.radius)
    yield Polyline((wheel.center, at), "thin")
    yield Symbol("hanger", at, angle)


def _is_disk(drawn: Drawn, stop: CordStop) -> bool:
    """Is a pulley drawn as a body?"""
    body = drawn.body(stop.body)
    return body is not None and isinstance(body.shape, Round)


def _parallel(drawn: Drawn, sketch: Cord, told: Sequence[Stop], along: float, near: float) -> list[Stop] | None:
    """The stops with the wheels that make all parts of a rope run along one direction; None: none make them."""
    cos, sin = math.cos(along), math.sin(along)
    stops = [replace(s, center=moved_by(s.center, _sheave(drawn, sketch, i)), radius=0.0) for i, s in enumerate(told)]
    places = [s.rim or s.center for s in stops]
    aside, ahead = [x * sin - y * cos for x, y in places], [x * cos + y * sin for x, y in places]
    found, part = [stops[0]], aside[0]
    for i, stop in enumerate(stops[1:-1], 1):
        comes, goes = ahead[i] - ahead[i - 1], ahead[i + 1] - ahead[i]
        if comes * goes > 0:
            if abs(part - aside[i]) > near:
                return None
            found.append(stop)
            continue
        side = 1 if (part - aside[i]) * comes > 0 else -1
        found.append(replace(stop, radius=abs(part - aside[i]), side=side))
        part = 2 * aside[i] - part
    return [*found, stops[-1]] if abs(part - aside[-1]) <= near else None


def _sheave(drawn: Drawn, sketch: Cord, i: int) -> Spot:
    return drawn.beside.sheaves.get((sketch.name, i), (0.0, 0.0))


def _upright(angle: float, step: float) -> float:
    """The nearest of directions that are so far apart."""
    return round(angle / step) * step


def _with_wheels(stops: Sequence[Stop], radius: float, lies_flat: bool) -> list[Stop]:
    """Small wheels at the bare points at which a rope turns, on the inner side of its bend; not at fixed ones in a
    scene that `lies_flat`.
    """
    found = list(stops)
    for i, stop in enumerate(stops[1:-1], 1):
        a, b = stops[i - 1].center, stops[i + 1].center
        bend, reach = turn(a, stop.center, b), math.dist(a, stop.center) * math.dist(stop.center, b)
        straight_on = abs(bend) < STRAIGHT * reach and math.dist(a, b) > max(math.dist(a, stop.center), 1e-9)
        if stop.radius or stop.rim is not None or reach < 1e-12 or straight_on or (stop.fixed and lies_flat):
            continue
        small = min(radius, math.dist(a, stop.center) / 3, math.dist(stop.center, b) / 3)
        wheel = replace(stop, radius=small, side=1 if bend >= 0 else -1)
        found[i] = wheel if stop.hangs else _within_its_bend(wheel, stops[i - 1], stops[i + 1])
    return found


def _within_its_bend(wheel: Stop, before: Stop, after: Stop) -> Stop:
    """A wheel that touches both parts of its rope where the file has them, so that what hangs hangs straight down, and
    what slides is drawn along its line; where these are nearly parallel, at least the upright one.
    """
    point = Stop(wheel.center)
    comes, goes = straight(before, point)[0], straight(point, after)[1]
    (a, b), (x, y) = (way_of(wheel.center, end) for end in (comes, goes)), wheel.center
    half = abs(math.remainder(b - a, 2 * math.pi)) / 2
    if half < BENT:
        pairs = [pair for pair in ((a, b), (b, a)) if abs(math.cos(pair[0])) < PLUMB]
        if len(pairs) != 1:
            return wheel
        ((upright, other),) = pairs
        aside = math.copysign(wheel.radius, math.remainder(other - upright, 2 * math.pi))
        return replace(wheel, center=moved(wheel.center, upright, 0.0, aside))
    longest = min(math.dist(comes, wheel.center), math.dist(wheel.center, goes)) / 3
    radius = min(wheel.radius, longest * math.tan(half))
    middle = math.atan2(math.sin(a) + math.sin(b), math.cos(a) + math.cos(b))
    reach = radius / math.sin(half)
    return replace(wheel, center=(x + reach * math.cos(middle), y + reach * math.sin(middle)), radius=radius)


def bends(drawn: Drawn, sketch: Cord) -> set[Spot]:
    """The points at which a rope turns on wheels that stand within its bend: nothing is there."""
    told = [s for stop in sketch.stops if (s := _stop(drawn, stop)) is not None]
    if len(told) < len(sketch.stops) or sketch.along is not None:
        return set()
    stops = _with_wheels(told, WHEEL * _size(drawn), _lies_flat(drawn))
    return {s.center for s, wheel in zip(told, stops, strict=True) if wheel.center != s.center}


def _size(drawn: Drawn) -> float:
    return extent_of(drawn.at_rest().everything()) or 1.0


def _lies_flat(drawn: Drawn) -> bool:
    """Is it a scene in which nothing hangs?"""
    return bool(drawn.scene.problem.plane == "horizontal")


def _hangs(stops: Sequence[Stop], i: int, along: float | None) -> float:
    """The direction of what holds a wheel against the pull of its rope. `along`: of all parts of the rope."""
    if along is not None:
        (x, y), (u, v) = stops[i].center, stops[i - 1].rim or stops[i - 1].center
        return along if (x - u) * math.cos(along) + (y - v) * math.sin(along) > 0 else along + math.pi
    center, pull = stops[i].center, [0.0, 0.0]
    for other in (stops[i - 1].center, stops[i + 1].center):
        reach = math.dist(center, other) or 1.0
        pull = [pull[k] + (other[k] - center[k]) / reach for k in (0, 1)]
    return _upright(math.atan2(-pull[1], -pull[0]), math.pi / 4) if math.hypot(*pull) > 0.1 else math.pi / 2


def _stop(drawn: Drawn, stop: CordStop) -> Stop | None:
    center, body = drawn.spot(stop.center), drawn.body(stop.body)
    if center is None:
        return None
    return Stop(
        center,
        drawn.number(stop.radius) or 0.0,
        stop.side,
        None if stop.rim is None else drawn.spot(stop.rim),
        stop.fixed,
        body is not None and isinstance(body.shape, Particle),
    )


def straight(a: Stop, b: Stop) -> tuple[Spot, Spot]:
    """The straight part between two stops: from rim to rim, as a tangent."""
    if a.rim is not None or b.rim is not None:
        return (a.rim or _touch(a, b.rim or b.center, 1), b.rim or _touch(b, a.rim or a.center, -1))
    reach = math.dist(a.center, b.center)
    along = math.atan2(b.center[1] - a.center[1], b.center[0] - a.center[0])
    offset = b.side * b.radius - a.side * a.radius
    if reach <= abs(offset):
        return a.center, b.center
    # The rope is to the right of a centre that lies to its left.
    way = along - math.asin(offset / reach)
    return moved(a.center, way, 0.0, -a.side * a.radius), moved(b.center, way, 0.0, -b.side * b.radius)


def _touch(stop: Stop, other: Spot, sense: int) -> Spot:
    """Where the tangent from a stop to a place leaves its rim; `sense` -1: the rope comes from that place."""
    if not stop.radius:
        return stop.center
    ends = straight(Stop(stop.center, stop.radius, stop.side * sense), Stop(other))
    return ends[0]


def _wrapped(stop: Stop, comes: Spot, goes: Spot) -> Arc:
    """The part of a rim on which a rope lies."""
    first, last = (math.atan2(p[1] - stop.center[1], p[0] - stop.center[0]) for p in (comes, goes))
    # With its centre to the left of it the rope turns counterclockwise.
    sweep = (last - first) % (2 * math.pi) if stop.side > 0 else -((first - last) % (2 * math.pi))
    return Arc(stop.center, stop.radius, "rope", first, sweep)
