"""Guides that hold nothing: they only say along which line something goes, and are not drawn.

So it is with a weight that falls on a spring below it, and with the end of a cable that is drawn straight out.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from planar_cli.figures.drawn import Drawn
from planar_cli.figures.partners import between, sketch_of
from planar_cli.figures.rings import off
from planar_cli.joints.base import Joint
from planar_cli.problem.scene.entry import Entry
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import Particle
from planar_cli.problem.scene.sketches import Absorber, Bar, Cord, Fastening, Hinge, Push, Sketch, Slide, Spiral
from planar_cli.report.document.marks import Spot, Symbol

NEAR = 1e-6
UPRIGHT = 0.05
"""A guide that is off the upright by no more, as a cosine, leads straight down."""


def is_idle(drawn: Drawn, entry: Entry, sketch: Sketch) -> bool:
    """Does a guide hold nothing, as all that acts on what it leads acts along it?"""
    if not isinstance(sketch, Slide) or not sketch.grounded or sketch.drawn or not _is_smooth(drawn, entry):
        return False
    written = next((b for b in drawn.scene.problem.bodies if b.name == sketch.body), None)
    at, along = drawn.spot(sketch.at), drawn.angle(sketch.along)
    if written is None or not isinstance(written.shape, Particle) or at is None or along is None:
        return False
    if any(_leans(drawn, joint, written.name) for joint in drawn.scene.problem.joints if joint is not entry):
        return False
    others = [s for other in _entries(drawn) if other is not entry for s in sketch_of(drawn, other)]
    drawn_out = written.is_massless and any(_ends_at(drawn, s, at) for s in others)
    falls = drawn.scene.problem.plane == "vertical" and abs(math.cos(along)) < UPRIGHT and not written.is_massless
    return (drawn_out or falls) and not any(_is_across(drawn, s, at, along) for s in others)


def led_blocks(drawn: Drawn) -> dict[str, Symbol]:
    """What such guides lead: weights on springs and dampers are blocks, on what is below them or under what is above;
    an end of a cable is no more than a place.
    """
    found = {}
    for joint in drawn.scene.problem.joints:
        for sketch in sketch_of(drawn, joint):
            if isinstance(sketch, Slide) and sketch.body is not None and is_idle(drawn, joint, sketch):
                at = drawn.spot(sketch.at)
                ways = [
                    way for other in _entries(drawn) for s in sketch_of(drawn, other) for way in _from(drawn, s, at)
                ]
                light = any(b.name == sketch.body and b.is_massless for b in drawn.scene.problem.bodies)
                if at is not None and light:
                    found[sketch.body] = Symbol("ring", at)
                elif at is not None and ways:
                    found[sketch.body] = Symbol("block", at, 0.0 if min(ways) < 0 else math.pi)
    return found


def _is_smooth(drawn: Drawn, entry: Entry) -> bool:
    """Has a guide no friction?"""
    return not any(getattr(entry, key, None) is not None for key in ("mu", "mu_s", "mu_k"))


def _leans(drawn: Drawn, joint: Joint, body: str) -> bool:
    """Does something that is in touch with a body press on it?"""
    return body in between(joint) and not joint.strikes and not sketch_of(drawn, joint)


def _entries(drawn: Drawn) -> tuple[Entry, ...]:
    problem = drawn.scene.problem
    return (*problem.joints, *problem.loads)


def _from(drawn: Drawn, sketch: Sketch, at: Spot | None) -> Iterator[float]:
    """How far above a place a spring or damper that ends there is fastened."""
    if at is not None and isinstance(sketch, Spiral | Absorber):
        ends = drawn.spot(sketch.start), drawn.spot(sketch.end)
        for here, there in (ends, ends[::-1]):
            if _is_at(here, at) and there is not None and math.dist(there, at) > NEAR:
                yield there[1] - at[1]


def _ends_at(drawn: Drawn, sketch: Sketch, at: Spot) -> bool:
    return isinstance(sketch, Cord) and any(_is_at(drawn.spot(sketch.stops[i].center), at) for i in (0, -1))


def _is_across(drawn: Drawn, sketch: Sketch, at: Spot, along: float) -> bool:
    """Does something at a place hold, push or pull across a line?"""
    match sketch:
        case Hinge(at=place) | Slide(at=place):
            return _is_at(drawn.spot(place), at)
        case Fastening(at=place):
            particles = all(isinstance(b.shape, Particle) for b in drawn.scene.problem.bodies)
            return not particles and _is_at(drawn.spot(place), at)
        case Push(at=place, direction=direction):
            way = drawn.angle(direction)
            return _is_at(drawn.spot(place), at) and (way is None or abs(math.sin(way - along)) > NEAR)
        case Bar(start=a, end=b) | Spiral(start=a, end=b) | Absorber(start=a, end=b):
            pairs: list[tuple[Vec, Vec]] = [(a, b), (b, a)]
        case Cord(stops=stops):
            ends = [stop.rim or stop.center for stop in stops]
            if any(_is_at(drawn.spot(stop.center), at) for stop in stops[1:-1]):
                return True
            pairs = [(ends[0], ends[1]), (ends[-1], ends[-2])]
        case _:
            return False
    told = [(drawn.spot(one), drawn.spot(other)) for one, other in pairs]
    return any(_is_at(here, at) and (there is None or off(at, along, there) > NEAR) for here, there in told)


def _is_at(place: Spot | None, at: Spot) -> bool:
    return place is not None and math.dist(place, at) < NEAR
