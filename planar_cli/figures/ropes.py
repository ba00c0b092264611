"""Ropes as they are drawn: tangents from wheel to wheel, and what holds their ends and their pulleys."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from planar_cli.figures.drawn import Drawn
from planar_cli.figures.rings import extent_of, turn
from planar_cli.figures.shapes import moved
from planar_cli.problem.sketches import Cord, CordStop
from planar_cli.records import record
from planar_cli.report.marks import Arc, Mark, Polyline, Spot, Symbol

WHEEL, STRAIGHT = 0.035, 0.02
"""The radius of a small wheel in parts of the scene; the sine of the angle up to which a rope goes straight on."""


@record
class Stop:
    """A stop of a cord in numbers; `side` as in `CordStop`."""

    center: Spot
    radius: float = 0.0
    side: int = 0
    rim: Spot | None = None
    fixed: bool = False


def cord_marks(drawn: Drawn, sketch: Cord) -> Iterator[Mark]:
    """A rope from stop to stop. A point over which it runs is a small wheel, on a hanger if it is fixed."""
    told = [s for stop in sketch.stops if (s := _stop(drawn, stop)) is not None]
    if len(told) < len(sketch.stops):
        return
    stops = _with_wheels(told, WHEEL * (extent_of(drawn.at_rest().everything()) or 1.0))
    for i, wheel in enumerate(stops):
        if wheel is not told[i]:
            # A load that hangs on a rope is seen within its wheel.
            yield Arc(wheel.center, wheel.radius, "body" if wheel.fixed else "thin")
            if wheel.fixed:
                yield Symbol("hanger", wheel.center, _hangs(told, i))
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


def _upright(angle: float, step: float) -> float:
    """The nearest of directions that are so far apart."""
    return round(angle / step) * step


def _with_wheels(stops: Sequence[Stop], radius: float) -> list[Stop]:
    """Small wheels at the bare points at which a rope turns, on the inner side of its bend."""
    found = list(stops)
    for i, stop in enumerate(stops[1:-1], 1):
        a, b = stops[i - 1].center, stops[i + 1].center
        bend, reach = turn(a, stop.center, b), math.dist(a, stop.center) * math.dist(stop.center, b)
        straight_on = abs(bend) < STRAIGHT * reach and math.dist(a, b) > max(math.dist(a, stop.center), 1e-9)
        if stop.radius or stop.rim is not None or reach < 1e-12 or straight_on:
            continue
        small = min(radius, math.dist(a, stop.center) / 3, math.dist(stop.center, b) / 3)
        found[i] = replace(stop, radius=small, side=1 if bend >= 0 else -1)
    return found


def _hangs(stops: Sequence[Stop], i: int) -> float:
    """The direction of what holds a wheel against the pull of its rope."""
    center, pull = stops[i].center, [0.0, 0.0]
    for other in (stops[i - 1].center, stops[i + 1].center):
        reach = math.dist(center, other) or 1.0
        pull = [pull[k] + (other[k] - center[k]) / reach for k in (0, 1)]
    return _upright(math.atan2(-pull[1], -pull[0]), math.pi / 4) if math.hypot(*pull) > 0.1 else math.pi / 2


def _stop(drawn: Drawn, stop: CordStop) -> Stop | None:
    center = drawn.spot(stop.center)
    if center is None:
        return None
    return Stop(
        center,
        drawn.number(stop.radius) or 0.0,
        stop.side,
        None if stop.rim is None else drawn.spot(stop.rim),
        stop.fixed,
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
