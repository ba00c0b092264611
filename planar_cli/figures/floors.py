"""What a guided body stands on, where the file names no surface: a floor under its outline, or rails."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from planar_cli.equation.scene.bodies import BodyModel
from planar_cli.figures.axes_of_turning import is_axis
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.outlines import level, lying
from planar_cli.figures.partners import between, is_lane, sketch_of
from planar_cli.figures.rings import extent_of, off, turned_by
from planar_cli.figures.shapes import body_marks, moved
from planar_cli.figures.within import slot_within
from planar_cli.problem.scene.scene import Particle, Rod
from planar_cli.problem.scene.sketches import Absorber, Bar, Cord, Hinge, Slide, Spiral
from planar_cli.report.document.marks import Hatched, Mark, Slot, Spot, Symbol, spots_of

BEYOND = 0.15
"""A floor goes on behind a body by this part of the scene."""
NEAR = 1e-6
"""What is as near to the side of a body, in parts of the scene, touches it there."""
LEANING = math.radians(60)
"""A guide that is turned by more from upright on a face leads along it."""
STEEP = 0.7
"""The sine of the angle from which on a track is no floor."""


def slide_marks(drawn: Drawn, slide: Slide, later: Sequence[Spot] = ()) -> Iterator[Mark]:
    """The floor or the slot of a guide, and a block for a particle that stands on it. `later`: where what slides, or
    its outline, is in further positions.
    """
    at, along = drawn.spot(slide.at), drawn.angle(slide.along)
    if at is None or along is None:
        return
    body = drawn.body(slide.body) if slide.body is not None else None
    if body is not None and is_axis(drawn.scene.problem, body.name):
        return
    if is_lane(drawn.scene.problem, slide.track):
        yield from _in_lane(drawn, slide, at, along)
        return
    if body is not None and body.name in lying(drawn):
        if slide.grounded and not slide.drawn and _lean(lying(drawn)[body.name], along) is not None:
            yield Symbol("guides", at, _away(lying(drawn)[body.name], along))
        return
    if body is None or (isinstance(body.shape, Particle) and not (slide.grounded and _stands(drawn, body, at, along))):
        yield from _slot(drawn, slide, at, along, later)
        yield Symbol("slider", at, along)
        return
    shape = [s for m in body_marks(drawn, body) if not isinstance(m, Symbol) for s in spots_of(m)]
    lies = [turned_by((x - at[0], y - at[1]), -along)[1] for x, y in shape]
    if isinstance(body.shape, Rod) and max(map(abs, lies)) < 1e-6:
        # A rod that slides along itself runs through a sleeve.
        yield Symbol("rail" if slide.grounded and not slide.drawn else "slider", at, along)
        return
    if not shape:
        yield Symbol("block", at, level(along))
    if slide.grounded and not slide.drawn:
        yield from _floor(drawn, shape or [at], along, later, [*_touched(drawn, body.name)])


def _in_lane(drawn: Drawn, slide: Slide, at: Spot, along: float) -> Iterator[Mark]:
    """What runs along a lane, in it: a pin where a slot leads it too."""
    others = (s for s in _sketches(drawn) if isinstance(s, Slide) and s.track != slide.track)
    if not any(_is_at(drawn.spot(s.at), at) for s in others):
        yield Symbol("slider", at, along)


def _slot(drawn: Drawn, slide: Slide, at: Spot, along: float, later: Sequence[Spot]) -> Iterator[Mark]:
    """The slot in which something slides, as far as it comes, or as the body goes in which it is."""
    if slide.grounded and not slide.drawn:
        spots = [*later, *_on_its_track(drawn, slide, at, along)]
        ahead = [0.0, *(turned_by((x - at[0], y - at[1]), -along)[0] for x, y in spots)]
        yield Slot(moved(at, along, min(ahead)), moved(at, along, max(ahead)), along, True)
    carrier = drawn.body(slide.carrier) if slide.carrier is not None else None
    if carrier is not None:
        holds = [s for h in _sketches(drawn) if isinstance(h, Hinge) and (s := drawn.spot(h.at)) is not None]
        slot = slot_within(at, along, [*body_marks(drawn, carrier)], holds)
        yield from () if slot is None else (slot,)


def _on_its_track(drawn: Drawn, slide: Slide, at: Spot, along: float) -> Iterator[Spot]:
    """Where other guides lead the same body along the same line, as both rollers of a door run on one rail."""
    tracks = {
        p: s
        for j in drawn.scene.problem.joints
        if isinstance(p := getattr(j, "point", None), str)
        for s in sketch_of(drawn, j)
        if isinstance(s, Slide) and s.grounded and not s.drawn
    }
    bodies = {drawn.scene.owner(p) for p, s in tracks.items() if s == slide}
    for name, other in tracks.items():
        spot, way = drawn.spot(other.at), drawn.angle(other.along)
        if other == slide or spot is None or way is None or drawn.scene.owner(name) not in bodies:
            continue
        if abs(math.sin(way - along)) < NEAR and off(at, along, spot) < NEAR * math.dist(at, spot):
            yield spot


def blocks_on_faces(drawn: Drawn) -> dict[str, Symbol]:
    """What lies on faces of bodies, by name: blocks; the sides of one between guides are parallel to these."""
    found = {}
    for name, angle in lying(drawn).items():
        spot = drawn.spot(drawn.scene.bodies[name].center)
        slides = (s for s in _sketches(drawn) if isinstance(s, Slide) and s.body == name and s.grounded and not s.drawn)
        ways = [way for s in slides if (way := drawn.angle(s.along)) is not None]
        lean = _lean(angle, ways[0]) if ways else None
        if spot is not None:
            found[name] = Symbol("block", spot, angle, lean=lean or 0.0)
    return found


def _away(face: float, along: float) -> float:
    """The direction of a guide away from the face on whose left something lies."""
    return along if math.sin(along - face) > 0 else along + math.pi


def _lean(face: float, along: float) -> float | None:
    """By how much a guide is turned from upright on a face; None: it goes along it."""
    lean = math.remainder(_away(face, along) - face - math.pi / 2, 2 * math.pi)
    return lean if abs(lean) < LEANING else None


def _stands(drawn: Drawn, body: BodyModel, at: Spot, along: float) -> bool:
    """Is a particle a block or a carriage on a floor, and no piston or collar? It is none on a steep track, nor where
    something holds it that does not lie along the track.
    """
    if abs(math.sin(along)) > STEEP:
        return False
    return not any(_holds(drawn, sketch, at, along) for sketch in _sketches(drawn))


def _sketches(drawn: Drawn) -> Iterator[object]:
    problem = drawn.scene.problem
    for entry in (*problem.joints, *problem.loads):
        yield from sketch_of(drawn, entry)


def _holds(drawn: Drawn, sketch: object, at: Spot, along: float) -> bool:
    """Does something pull or push at a place across a track?"""
    match sketch:
        case Hinge(at=place):
            return _is_at(drawn.spot(place), at)
        case Bar(start=a, end=b) | Spiral(start=a, end=b) | Absorber(start=a, end=b):
            pairs = [(a, b), (b, a)]
        case Cord(stops=stops):
            places = [stop.center for stop in stops]
            pairs = [(places[0], places[1]), (places[-1], places[-2])]
        case _:
            return False
    for one, other in pairs:
        here, there = drawn.spot(one), drawn.spot(other)
        if there is not None and _is_at(here, at):
            x, y = turned_by((there[0] - at[0], there[1] - at[1]), -along)
            if abs(y) > 0.1 * math.hypot(x, y):
                return True
    return False


def _is_at(place: Spot | None, at: Spot) -> bool:
    return place is not None and math.dist(place, at) < 1e-9


def _touched(drawn: Drawn, body: str) -> Iterator[Spot]:
    """Where others touch a body, as a gear its rack."""
    for joint in drawn.scene.problem.joints:
        place = getattr(joint, "at", None)
        if body in between(joint) and isinstance(place, str) and not sketch_of(drawn, joint):
            spot = drawn.named(place)
            if spot is not None:
                yield spot


def _floor(
    drawn: Drawn, shape: Sequence[Spot], along: float, later: Sequence[Spot], touched: Sequence[Spot]
) -> Iterator[Mark]:
    """A floor under an outline, as far as it comes; beside one that goes up and down, a wall on either side. None on a
    side on which another body is.
    """
    size = extent_of(drawn.at_rest().everything()) or 1.0
    up = level(along) if abs(math.sin(along)) <= STEEP else along
    seen = [turned_by(s, -up) for s in shape]
    ways = [*(x for x, _ in seen), *(turned_by(s, -up)[0] for s in later)]
    low, high = min(ways), max(ways)
    more = BEYOND * size if abs(math.sin(along)) <= STEEP else 0.0
    for below in (True, False) if abs(math.sin(along)) > STEEP else (True,):
        y = min(y for _, y in seen) if below else max(y for _, y in seen)
        if any(abs(turned_by(s, -up)[1] - y) < NEAR * size for s in touched):
            continue
        ends = [turned_by(p, up) for p in ((low - more, y), (high + more, y))]
        yield Hatched(tuple(ends if below else ends[::-1]))
