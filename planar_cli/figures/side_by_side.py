"""Particles that meet are at one place: just before that they are drawn side by side, each where it comes from, and one
that strikes a body, or will stick in it, beside the place where it does.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence

from planar_cli.equation.scene.meeting import meeting_of
from planar_cli.errors import PlanarError
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.given_motion import Moving, Told
from planar_cli.figures.partners import sketch_of
from planar_cli.figures.rings import extent_of
from planar_cli.figures.shapes import body_marks, moved
from planar_cli.joints.base import Joint
from planar_cli.problem.scene.scene import Composite, Particle
from planar_cli.problem.scene.sketches import Slide
from planar_cli.report.document.marks import Spot, Symbol, spots_of

DOT, BOX, EDGE = 5.5, 13.0, 7.5
"""Half of how far apart they are drawn, on paper; of those that slide in a guide; and how far beside a body."""
WIDE, POINT = 400.0, 300.0
"""A scene is about so wide on paper; of one that is a point a metre is so long."""
OUT, RAISED = 22.0, 10.0
"""So far beside the place of a block, and above it, is what comes to the middle of its side."""
CLOSE = 1e-9


def side_by_side(
    drawn: Drawn, moving: Moving | None, joints: Sequence[Joint], blocks: Mapping[str, Symbol]
) -> Mapping[str, Spot]:
    """By so much particles are drawn beside the place at which they meet, m. `blocks`: those drawn as blocks."""
    found: dict[str, Spot] = {}
    scale = scale_of(drawn)
    for joint in joints:
        between = tuple[str, ...](getattr(joint, "between", ()))
        angle = _normal(drawn, joint, between) if joint.strikes and len(between) == 2 else None
        if angle is None or found.keys() & set(between):
            continue
        closing = _closing(moving, between, angle)
        if _meet(drawn, between):
            way = (BOX if guided(drawn, joints) else DOT) * scale * (-1 if closing >= 0 else 1)
            low = _lower(drawn, joints, between) if abs(closing) < CLOSE else None
            ways = dict.fromkeys(between, 0.0) if low else {between[0]: way, between[1]: -way}
            if low:
                # What lies on the floor stays there.
                ways |= {n: math.copysign(2 * way, math.sin(angle)) for n in between if n != low}
            found |= {n: (w * math.cos(angle), w * math.sin(angle)) for n, w in ways.items()}
        elif abs(closing) > CLOSE and (name := striker(drawn, between)) and not _is_edge(blocks.get(name)):
            first = between[0] == name
            way = _beside(drawn, between, name) * scale * (-1 if (closing > 0) == first else 1)
            found[name] = (way * math.cos(angle), way * math.sin(angle))
    for joint in joints:
        for name, other, angle in _sticking(drawn, joint, guided(drawn, joints) | blocks.keys()):
            base = blocks[other].angle if other in blocks else _guide(drawn, joints, other)
            far = _beside(drawn, (name, other), name) if base is None else OUT
            up = moved((0.0, 0.0), base or 0.0, 0.0, 0.0 if base is None else RAISED)
            x, y = moved(up, angle, -far)
            found.setdefault(name, (scale * x, scale * y))
    return found


def _is_edge(sign: Symbol | None) -> bool:
    return sign is not None and sign.kind == "edge"


def scale_of(drawn: Drawn) -> float:
    """About how much of a scene a px is on paper, m."""
    shapes = (s for b in drawn.scene.bodies.values() for m in body_marks(drawn, b) for s in spots_of(m))
    size = extent_of([*drawn.everything(), *shapes])
    return size / WIDE if size > CLOSE else 1 / POINT


def _sticking(drawn: Drawn, joint: Joint, held: Collection[str]) -> Iterator[tuple[str, str, float]]:
    """A particle that comes to what it will stick in, this, and the direction of its way to it. `held`: what stands on
    or in something, which is drawn at its place.
    """
    bodies, between = drawn.scene.bodies, tuple[str, ...](getattr(joint, "between", ()))
    if joint.kind != "weld" or len(between) != 2 or any(n not in bodies for n in between):
        return
    told = [Told(drawn).vector("v", n) or (0.0, 0.0) for n in between]
    ones = [n for n in between if isinstance(bodies[n].shape, Particle) and n not in held]
    if not ones or math.dist(*told) < CLOSE:
        return
    name = max(ones, key=lambda n: math.hypot(*told[between.index(n)]))
    own, others = told[between.index(name)], told[1 - between.index(name)]
    yield name, between[1 - between.index(name)], math.atan2(own[1] - others[1], own[0] - others[0])


def is_apart(entry: object, aside: Mapping[str, Spot]) -> bool:
    """Is it a joint in which a body will stick that is drawn before it comes there?"""
    return (
        isinstance(entry, Joint) and entry.kind == "weld" and not aside.keys().isdisjoint(getattr(entry, "between", ()))
    )


def guided(drawn: Drawn, joints: Sequence[Joint]) -> frozenset[str]:
    """The bodies in guides: carriages or sliders, and no balls."""
    slides = (s for j in joints for s in sketch_of(drawn, j) if isinstance(s, Slide))
    return frozenset(s.body or "" for s in slides)


def _guide(drawn: Drawn, joints: Sequence[Joint], name: str) -> float | None:
    """The direction of the guide in which a body is; None: it is in none."""
    slides = (s for j in joints for s in sketch_of(drawn, j) if isinstance(s, Slide) and s.body == name)
    return next((drawn.angle(s.along) for s in slides), None)


def striker(drawn: Drawn, between: Sequence[str]) -> str:
    """The particle that strikes a body with a size, or a face of one, and is nowhere else; "": none does."""
    bodies, faces = drawn.scene.bodies, {s.name: s for s in drawn.scene.problem.surfaces if s.body is not None}
    names = [n for n in between if n in bodies and isinstance(bodies[n].shape, Particle)]
    others = [n for n in between if n in faces or (n in bodies and not isinstance(bodies[n].shape, Particle))]
    return names[0] if len(names) == len(others) == 1 else ""


def _lower(drawn: Drawn, joints: Sequence[Joint], between: Sequence[str]) -> str | None:
    """Which of two that come down together strikes a fixed surface; None: neither or both do."""
    fixed = {s.name for s in drawn.scene.problem.surfaces if s.body is None}
    met = [n for n in between if any({n} < {*getattr(j, "between", ())} <= {n, *fixed} for j in joints)]
    return met[0] if len(met) == 1 else None


def _beside(drawn: Drawn, between: Sequence[str], name: str) -> float:
    """How far it is drawn beside a body: two balls stand beside each other."""
    at = drawn.spot(drawn.scene.bodies[name].center)
    for other in (drawn.scene.bodies.get(n) for n in between if n != name):
        if other is not None and isinstance(other.shape, Particle):
            return 2 * DOT
        if other is not None and isinstance(other.shape, Composite):
            pieces = [p.shape.place for p in other.shape.pieces if isinstance(p.shape, Particle)]
            spots = [drawn.carried(other.name, p) for p in pieces if isinstance(p, str)]
            if at is not None and any(s is not None and math.dist(s, at) < CLOSE for s in spots):
                return 2 * DOT
    return EDGE


def _normal(drawn: Drawn, joint: Joint, between: tuple[str, ...]) -> float | None:
    """The direction across which bodies meet; None: nothing tells it."""
    normal = getattr(joint, "normal", None)
    if normal is not None:
        return drawn.length(normal)
    try:
        return drawn.angle(meeting_of(drawn.scene, between, None, joint.mark, getattr(joint, "at", "")).normal)
    except PlanarError:
        return None


def _closing(moving: Moving | None, between: Sequence[str], angle: float) -> float:
    """How fast the first of two comes to the other along a direction, as far as it is told."""
    first, second = (moving.vector("v", name) if moving is not None else None for name in between)
    coming = zip(first or (0.0, 0.0), second or (0.0, 0.0), (math.cos(angle), math.sin(angle)), strict=True)
    return sum((a - b) * n for a, b, n in coming)


def _meet(drawn: Drawn, between: tuple[str, ...]) -> bool:
    """Are both particles, in one place?"""
    bodies = [drawn.scene.bodies.get(name) for name in between]
    told = (drawn.spot(b.center) for b in bodies if b is not None and isinstance(b.shape, Particle))
    spots = [s for s in told if s is not None]
    return len(spots) == 2 and math.dist(spots[0], spots[1]) < CLOSE
