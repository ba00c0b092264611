"""Outlines of bodies of which a file tells only points, faces and what guides them.

A wedge or a carrier is what a lecturer draws under its face: from the face down to what it stands on, with its mass
centre inside. It is found where the file draws the scene, and goes with the body from there.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from planar_cli.equation.scene.bodies import BodyModel
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.led import led
from planar_cli.figures.partners import between, only_pushed, partners, sketch_of, touching
from planar_cli.figures.rings import (
    Ring,
    about,
    across,
    around,
    box_of,
    circle,
    ends_of,
    extent_of,
    moved_by,
    off,
    sides,
    turned_by,
    way_of,
)
from planar_cli.figures.standing import LEVEL, Face, Known, standing
from planar_cli.joints.base import Joint
from planar_cli.problem.scene.scene import Body, Line, Outline, Particle, Problem, Surface
from planar_cli.problem.scene.shapes import rim_of
from planar_cli.problem.scene.sketches import Slide
from planar_cli.records import record
from planar_cli.report.document.marks import Spot

MARGIN, LEAST = 0.12, 0.05
"""How far an outline goes beyond what it holds: in parts of its own size, and at least in parts of the scene's."""
SLIM = 0.08
"""A body is a bar as long as its mass centre is no farther off the line of its ends, in parts of their distance."""


@record
class Contour:
    """An outline, counterclockwise; or a bar through some places, if it is not `closed`."""

    places: tuple[Spot, ...]
    closed: bool


def outlines(drawn: Drawn, body: BodyModel) -> list[Contour]:
    """What a body is drawn by. None: it is drawn as a point."""
    rest = drawn.at_rest()
    was, now = rest.spot(body.center), drawn.spot(body.center)
    if was is None or now is None:
        return []
    turned = _turned_since(rest, drawn, body) if body.rigid else 0.0
    back = (-was[0], -was[1])
    return [
        Contour(tuple(moved_by(turned_by(moved_by(p, back), turned), now) for p in c.places), c.closed)
        for c in _contours(rest, body)
    ]


def _turned_since(rest: Drawn, drawn: Drawn, body: BodyModel) -> float:
    """By how much a body has turned: its points tell it, or else its angle."""
    was, now = rest.spot(body.center), drawn.spot(body.center)
    for name in _written(rest, body).points:
        before, after = rest.carried(body.name, name), drawn.carried(body.name, name)
        if was is not None and now is not None and before is not None and after is not None and before != was:
            return way_of(now, after) - way_of(was, before)
    start, end = rest.number(body.theta), drawn.number(body.theta)
    return end - start if start is not None and end is not None else 0.0


def edges(drawn: Drawn, body: BodyModel) -> frozenset[str]:
    """The surfaces on a body that are part of its outline."""
    written = _written(drawn, body)
    if not isinstance(written.shape, Outline | Particle):
        return frozenset()
    rest = drawn.at_rest()
    return frozenset(name for name, _ in (*_faces(rest, written), *_barrels(rest, written)))


def _contours(rest: Drawn, body: BodyModel) -> list[Contour]:
    written = _written(rest, body)
    if not isinstance(written.shape, Outline | Particle) or rim_of(written.shape) is not None:
        return []
    belt = _belt(rest, written)
    if belt:
        return [Contour((*belt, belt[0]), False)]
    known, slides, path = _known(rest, written), _slide(rest, body.name) is not None, led(rest, body)
    if path:
        vane = Contour(tuple(path), False)
        return [vane, _area(_under(path, known.margin))] if slides else [vane]
    if known.faces or (slides and isinstance(written.shape, Outline)):
        stands = [_area([turned_by(p, known.turned) for p in ring]) for ring in standing(known)]
        return [*(bar for _, bar in _barrels(rest, written)), *stands]
    return [] if isinstance(written.shape, Particle) else [_area(ring) for ring in _free(rest, written, known)]


def _area(ring: Ring) -> Contour:
    return Contour(tuple(ring), len(ring) > 2)


def _belt(rest: Drawn, written: Body) -> Ring:
    """The endless belt of which a face runs over wheels: a body without mass centre, and with points on that face."""
    scene, problem = rest.scene, rest.scene.problem
    if not isinstance(written.shape, Outline) or written.shape.center is not None:
        return []
    for surface in problem.surfaces:
        if surface.body != written.name or not isinstance(surface.shape, Line):
            continue
        over = set(partners(problem, surface))
        rims = [rim for b in problem.bodies if b.name in over and (rim := rim_of(b.shape)) is not None]
        wheels = [(rest.named(rim.center), rest.length(rim.radius)) for rim in rims]
        told = [circle(center, radius) for center, radius in wheels if center is not None and radius]
        at, angle = rest.carried(written.name, surface.shape.through), rest.angle(scene.surface_direction(surface))
        own = [s for p in written.points if (s := rest.carried(written.name, p)) is not None]
        if len(told) > 1 and at is not None and angle is not None and all(off(at, angle, p) < 1e-6 for p in own):
            return around([p for ring in told for p in ring])
    return []


def _under(path: Ring, m: float) -> Ring:
    """The carrier under a vane."""
    (left, right), low = ends_of(x for x, _ in path), min(y for _, y in path)
    return box_of((left - m, low - m), 0.0, right - left + 2 * m, (0.0, m))


def lying(drawn: Drawn) -> dict[str, float]:
    """What lies on a face of a body, with the direction of the face, up on the left."""
    found = {}
    for written in drawn.scene.problem.bodies:
        if isinstance(written.shape, Outline | Particle):
            for _, face in _faces(drawn, written):
                found.update(dict.fromkeys(face.by, face.angle + math.pi))
    return found


def _written(drawn: Drawn, body: BodyModel) -> Body:
    return next(b for b in drawn.scene.problem.bodies if b.name == body.name)


def _known(rest: Drawn, written: Body) -> Known:
    told = not isinstance(written.shape, Outline) or written.shape.center is not None
    center = rest.center(written.name) if told else None
    shaping = [name for name in written.points if not only_pushed(rest, name)]
    own = [s for name in shaping if (s := rest.carried(written.name, name)) is not None]
    own += list(_slots(rest, written))
    faces = [face for _, face in _faces(rest, written)]
    size = extent_of([*own, *([center] if center else []), *(s for f in faces for s in (f.at, *f.spots))])
    whole = extent_of(rest.everything()) or 1.0
    turned, floor = _stands(rest, written, faces)
    back = [
        Face(turned_by(f.at, -turned), f.angle - turned, tuple(turned_by(s, -turned) for s in f.spots), f.by)
        for f in faces
    ]
    seen = turned_by(center, -turned) if center else None
    return Known(
        turned, tuple(turned_by(s, -turned) for s in own), seen, tuple(back), floor, max(MARGIN * size, LEAST * whole)
    )


def _stands(rest: Drawn, written: Body, faces: Sequence[Face]) -> tuple[float, float | None]:
    """The direction of what a body stands on, the body above it, and its level where something tells it."""
    scene = rest.scene
    for surface in scene.problem.surfaces:
        if (
            surface.body is None
            and isinstance(surface.shape, Line)
            and written.name in partners(scene.problem, surface)
        ):
            at, angle = rest.carried(None, surface.shape.through), rest.angle(scene.surface_direction(surface))
            if at is not None and angle is not None:
                return level(angle), turned_by(at, -level(angle))[1]
    slide = _slide(rest, written.name)
    angle = rest.angle(slide.along) if slide is not None else None
    if angle is not None and abs(math.sin(angle)) < 0.7:
        angle = level(angle)
        # Heights are measured from a road that lies below everything.
        above = abs(angle) < 1e-9 and all(y >= 0 for _, y in rest.everything()) and rest.center(written.name)
        return angle, 0.0 if above and above[1] > 1e-9 and not faces else None
    # What is beneath a floor that touches from below hangs from it.
    hangs = any(math.cos(f.angle) > math.cos(LEVEL) for f in faces)
    return (math.pi if hangs else 0.0), None


def level(angle: float) -> float:
    """The same line in the direction in which up is on the left."""
    return angle if math.cos(angle) > 0 else math.remainder(angle + math.pi, 2 * math.pi)


def _slide(rest: Drawn, body: str) -> Slide | None:
    """What a whole body slides along, unable to turn."""
    found = (s for j in rest.scene.problem.joints if between(j)[-1:] == (body,) for s in sketch_of(rest, j))
    return next((s for s in found if isinstance(s, Slide) and s.body == body), None)


def _faces(rest: Drawn, written: Body) -> Iterator[tuple[str, Face]]:
    """The straight surfaces on a body, with the body on the left of each; not the slots in it."""
    scene, problem = rest.scene, rest.scene.problem
    for surface in problem.surfaces:
        if surface.body != written.name or not isinstance(surface.shape, Line):
            continue
        at, angle = rest.carried(written.name, surface.shape.through), rest.angle(scene.surface_direction(surface))
        if at is None or angle is None:
            continue
        near_it = set(partners(problem, surface))
        by = [b for b in problem.bodies if b.name in near_it]
        named = (p for p in touching(problem, surface) if p != surface.shape.through)
        places = [*map(rest.named, named), *(rest.center(b.name) for b in by if b.is_particle)]
        spots = [s for s in places if s is not None]
        center = rest.center(written.name)
        if center is None or _is_slot(rest, surface, written, center, at, angle):
            continue
        side = _inner_side(center, at, angle, [s for b in by if (s := rest.center(b.name)) is not None])
        kept = tuple(spots) or (at,)
        yield surface.name, Face(at, angle if side > 0 else angle + math.pi, kept, frozenset(b.name for b in by))


def _is_slot(rest: Drawn, surface: Surface, written: Body, center: Spot, at: Spot, angle: float) -> bool:
    """Does a pin run in it, or does it go through the mass centre of a body that has no other point, and nothing lie
    on it?
    """
    problem = rest.scene.problem
    if any(surface.name in between(j) and _is_pinned(rest, j) for j in problem.joints):
        return True
    lies = any(
        (j.touches or j.strikes or j in problem.strikers) and surface.name in between(j) for j in _meetings(problem)
    )
    if lies or off(at, angle, center) > 1e-6:
        return False
    own = [rest.carried(written.name, p) for p in written.points]
    return all(p is None or math.dist(p, center) < 1e-9 for p in own)


def _slots(rest: Drawn, written: Body) -> Iterator[Spot]:
    """Where pins run in slots of a body."""
    scene = rest.scene
    own = {surface.name for surface in scene.problem.surfaces if surface.body == written.name}
    for joint in scene.problem.joints:
        if own & set(between(joint)) and _is_pinned(rest, joint):
            spot = rest.named(getattr(joint, "point", ""))
            yield from () if spot is None else (spot,)


def _is_pinned(rest: Drawn, joint: Joint) -> bool:
    """Is what a joint guides a point of a body that can turn?"""
    point = getattr(joint, "point", None)
    bodies = [b.name for b in rest.scene.problem.bodies]
    return isinstance(point, str) and any(b in rest.scene.owners.get(point, ()) and rest.scene.rigid(b) for b in bodies)


def _meetings(problem: Problem) -> Iterator[Joint]:
    """What joins bodies, and what makes them strike each other."""
    yield from problem.joints
    yield from (j for j in problem.strikers if isinstance(j, Joint))


def _barrels(rest: Drawn, written: Body) -> Iterator[tuple[str, Contour]]:
    """The lines that lead something away from a body: from its mass centre as far as that is now."""
    scene, center = rest.scene, rest.center(written.name)
    for surface in scene.problem.surfaces:
        if surface.body == written.name and isinstance(surface.shape, Line) and center is not None:
            end, angle = rest.carried(written.name, surface.shape.through), rest.angle(scene.surface_direction(surface))
            if end is None or angle is None or math.dist(end, center) < 1e-9:
                continue
            if _is_slot(rest, surface, written, center, end, angle) and off(end, angle, center) < 1e-6:
                yield surface.name, Contour((center, end), False)


def _inner_side(center: Spot, at: Spot, angle: float, others: Sequence[Spot]) -> float:
    """Positive: the body is to the left of its face, where its mass centre is, or else away from what touches it."""
    own = across(at, angle, center)
    if abs(own) > 1e-6:
        return own
    away = -sum(across(at, angle, s) for s in others)
    return away if abs(away) > 1e-6 else -math.cos(angle) or math.sin(angle)


def _free(rest: Drawn, written: Body, known: Known) -> list[Ring]:
    """A body that nothing but its points tells of."""
    center, m = known.center, known.margin
    ring = around(known.own)
    if len(ring) > 2:
        corners = {(x, y) for x in ends_of(p[0] for p in ring) for y in ends_of(p[1] for p in ring)}
        box = len(ring) == 3 and all(min(math.dist(p, c) for c in corners) < 1e-9 for p in ring)
        ring = around([*corners]) if box else ring
        held = center is None or min(across(a, way_of(a, b), center) for a, b in sides(ring)) > m / 4
        return [ring if held or center is None else around([*ring, *about(center, m)])]
    if len(ring) == 2:
        return _between_two(rest, written, ring, center, m)
    if center is None:
        return []
    reach = math.dist(ring[0], center) if ring else 0.0
    if reach < 1e-9:
        return [] if _has_surface(rest, written) else [circle(center, 1.5 * m)]
    # With its mass centre in the middle it ends as far beyond it.
    way = way_of(ring[0], center)
    return [box_of(ring[0], way, 2 * reach, (-0.2 * reach, 0.2 * reach))]


def _between_two(rest: Drawn, written: Body, ring: Ring, center: Spot | None, m: float) -> list[Ring]:
    """A bar, a box over two axles, or a plate with its mass centre off the line of its ends."""
    (a, b), length = ring, math.dist(*ring)
    off = across(a, way_of(a, b), center) if center is not None else 0.0
    if center is None or abs(off) < SLIM * length:
        return [ring]
    if _rolls(rest, written):
        return [box_of(a, way_of(a, b), length, (0.0, 2 * off))]
    return [around([a, b, *about(center, max(m, abs(off) / 4))])]


def _rolls(rest: Drawn, written: Body) -> bool:
    """Does it stand on wheels, or on points that touch the ground?"""
    problem = rest.scene.problem
    hubs = {b.hub_point for b in problem.bodies}
    touched = {getattr(j, "at", "") for j in problem.joints if j.unilateral and written.name in between(j)}
    return any(p in hubs or p in touched for p in written.points)


def _has_surface(rest: Drawn, written: Body) -> bool:
    return any(s.body == written.name for s in rest.scene.problem.surfaces)
