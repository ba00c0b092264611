"""Particles that hang on ropes over pulleys or drums, or on pulleys: loads, drawn as blocks under the end of the rope.

What swings on a thread from a fixed point, or between two threads, is a bob and stays a point.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from planar_cli.figures.drawn import Drawn
from planar_cli.figures.partners import sketch_of
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import Body, Particle, Round
from planar_cli.problem.scene.sketches import Absorber, Bar, Cord, Hinge, Sketch, Slide, Spiral
from planar_cli.report.document.marks import Mark, Polyline, Spot, Symbol

NEAR = 1e-9
HOOK = 1.6
"""How far under the centre of a wheel its load hangs, in radii."""
UPRIGHT = 0.05
"""A rope that is off the upright by no more, as a sine, hangs straight down."""
DOWN = math.pi
"""A block along this direction lies under its place."""


def hanging(drawn: Drawn) -> dict[str, Symbol]:
    """The blocks of particles that hang so, by the names of these."""
    problem = drawn.scene.problem
    if problem.plane == "horizontal":
        return {}
    cords = [s for j in problem.joints for s in sketch_of(drawn, j) if isinstance(s, Cord)]
    held = [drawn.spot(place) for place in _held(drawn)]
    loads = {b.name for b in problem.bodies if _is_load(drawn, b)}
    found: dict[str, Symbol] = {}
    while True:
        more = {
            name: Symbol("block", at, DOWN)
            for name, at in (*_ends(drawn, cords, found), *_on_hooks(drawn))
            if name in loads and name not in found and not _is_among(at, held)
        }
        if not more:
            return found
        found |= more


def _is_load(drawn: Drawn, body: Body) -> bool:
    """Is it a particle with mass, or one in a scene where no mass matters?"""
    light = all(b.is_massless for b in drawn.scene.problem.bodies)
    return isinstance(body.shape, Particle) and (light or not body.is_massless)


def _held(drawn: Drawn, wheels: bool = True) -> Iterator[Vec]:
    """Where something else than a rope holds or guides what is there, or a rope runs over a wheel."""
    problem = drawn.scene.problem
    for entry in (*problem.joints, *problem.loads):
        for sketch in sketch_of(drawn, entry):
            match sketch:
                case Slide() if _is_upright(drawn, sketch):
                    # It leads a load as its rope does, and is not drawn.
                    continue
                case Hinge(at=at) | Slide(at=at):
                    yield at
                case Bar() if (hook := _hook(drawn, sketch)) is not None:
                    yield hook[0]
                case Bar(start=a, end=b) | Spiral(start=a, end=b) | Absorber(start=a, end=b):
                    yield from (a, b)
                case Cord(stops=stops) if wheels:
                    yield from (stop.center for stop in stops[1:-1])


def _ends(drawn: Drawn, cords: Sequence[Cord], found: Mapping[str, Symbol]) -> Iterator[tuple[str, Spot]]:
    """Bodies straight under the last wheel or drum of a rope, or under a load that hangs itself, with their places."""
    for cord in cords:
        for stops in (cord.stops, cord.stops[::-1]):
            upper, lower = stops[-2:]
            at, above = drawn.spot(lower.center), drawn.spot(upper.rim or upper.center)
            runs = len(stops) > 2 or upper.rim is not None or upper.body in found
            if at is not None and above is not None and runs and lower.rim is None:
                wide = drawn.number(upper.radius) or 0.0 if upper.rim is None else 0.0
                upright = cord.along is not None or abs(above[0] - at[0]) <= wide + UPRIGHT * (above[1] - at[1])
                if upright and above[1] > at[1]:
                    yield lower.body, at


def _hook(drawn: Drawn, bar: Bar) -> tuple[Vec, Vec] | None:
    """Upper and lower end of a light rod straight under the axle of a wheel."""
    for upper, lower in ((bar.start, bar.end), (bar.end, bar.start)):
        above, at = drawn.spot(upper), drawn.spot(lower)
        if above is None or at is None or any(bar.fixed) or not _is_among(above, [*_axles(drawn).values()]):
            continue
        if above[1] > at[1] and abs(above[0] - at[0]) <= UPRIGHT * (above[1] - at[1]):
            return upper, lower
    return None


def _on_hooks(drawn: Drawn) -> Iterator[tuple[str, Spot]]:
    """Particles at the lower ends of such rods."""
    bars = [s for j in drawn.scene.problem.joints for s in sketch_of(drawn, j) if isinstance(s, Bar)]
    ends = [drawn.spot(hook[1]) for bar in bars if (hook := _hook(drawn, bar)) is not None]
    for body in drawn.scene.problem.bodies:
        at = drawn.center(body.name)
        if at is not None and _is_among(at, ends):
            yield body.name, at


def _axles(drawn: Drawn) -> dict[str, Spot]:
    """The centres of round bodies."""
    rounds = [b.name for b in drawn.scene.problem.bodies if isinstance(b.shape, Round)]
    return {name: spot for name in rounds if (spot := drawn.center(name)) is not None}


def under_axles(drawn: Drawn) -> Iterator[Mark]:
    """A load that is a particle on the axle of a pulley in the loop of a rope, under that pulley."""
    problem = drawn.scene.problem
    cords = [s for j in problem.joints for s in sketch_of(drawn, j) if isinstance(s, Cord)]
    held = [
        drawn.spot(s.at) for j in problem.joints for s in sketch_of(drawn, j) if isinstance(s, Hinge) and s.grounded
    ]
    for body in problem.bodies if problem.plane != "horizontal" else ():
        at = drawn.center(body.name) if _is_load(drawn, body) else None
        for cord in cords if at is not None and not _is_among(at, held) else ():
            for i, stop in enumerate(cord.stops):
                radius = drawn.number(stop.radius) or 0.0
                if 0 < i < len(cord.stops) - 1 and stop.body != body.name and drawn.spot(stop.center) == at and radius:
                    yield from _in_loop(drawn, cord, i, radius)


def hangs_along(drawn: Drawn, sketch: Sketch, hung: Mapping[str, Symbol]) -> bool:
    """Is it a guide that leads a load upright, as its rope does? `hung`: the loads at ends of ropes."""
    if not isinstance(sketch, Slide) or not _is_upright(drawn, sketch):
        return False
    cords = [s for j in drawn.scene.problem.joints for s in sketch_of(drawn, j) if isinstance(s, Cord)]
    loops = {c.stops[i].body for c in cords for i in range(1, len(c.stops) - 1) if any(in_its_loop(drawn, c, i, 0.0))}
    return sketch.body in hung or sketch.body in loops


def _is_upright(drawn: Drawn, slide: Slide) -> bool:
    way = drawn.angle(slide.along)
    return slide.grounded and not slide.drawn and way is not None and abs(math.cos(way)) < UPRIGHT


def in_its_loop(drawn: Drawn, cord: Cord, i: int, radius: float) -> Iterator[Mark]:
    """A load whose wheel hangs in the loop of a rope, under that wheel. `i`: the stop; `radius`: of the wheel, m."""
    body = next((b for b in drawn.scene.problem.bodies if b.name == cord.stops[i].body), None)
    if body is not None and _is_load(drawn, body) and drawn.scene.problem.plane != "horizontal":
        at = drawn.spot(cord.stops[i].center)
        yield from () if at is None or _is_below(drawn, cord, at) else _in_loop(drawn, cord, i, radius)


def _in_loop(drawn: Drawn, cord: Cord, i: int, radius: float) -> Iterator[Mark]:
    places = [drawn.spot(stop.center) for stop in cord.stops[i - 1 : i + 2]]
    if None in places:
        return
    before, at, after = places
    if before is None or at is None or after is None or min(before[1], after[1]) <= at[1]:
        return
    hook = (at[0], at[1] - HOOK * radius)
    yield Polyline((at, hook), "thin")
    yield Symbol("block", hook, DOWN)


def _is_below(drawn: Drawn, cord: Cord, at: Spot) -> bool:
    """Does something else begin there, so that there is no room under it?"""
    problem = drawn.scene.problem
    cords = [s for j in problem.joints for s in sketch_of(drawn, j) if isinstance(s, Cord) and s.name != cord.name]
    ends = [drawn.spot(stop.center) for c in cords for stop in c.stops]
    return _is_among(at, [*ends, *map(drawn.spot, _held(drawn, wheels=False))])


def _is_among(at: Spot, places: Sequence[Spot | None]) -> bool:
    return any(p is not None and math.dist(p, at) < NEAR for p in places)
