"""The outline of a body or surface at a point of contact: a corner, a straight edge or an arc, with its curvature.

Written once for whatever numbers a scene is made of: exact expressions, or terms of coordinates.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, Protocol

from planar_cli.errors import Mark, refuse
from planar_cli.problem.language.expression import Side
from planar_cli.problem.nodes.reading import listed
from planar_cli.problem.scene.facts import Outline
from planar_cli.problem.scene.gaps import as_first, gap, sought_in
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import (
    GROUND,
    Circle,
    Composite,
    Curve,
    Line,
    Plate,
    Rod,
    Round,
    Sector,
    State,
    Surface,
)
from planar_cli.problem.scene.scene import Outline as AnyShape
from planar_cli.problem.scene.setting import Setting
from planar_cli.records import record

Span = tuple[str, str] | None
LATER = "where they meet only later, let it begin there: `during: 2->3`, from the state in which they do"
"""The states between which a joint acts; None: always."""


@record
class Bend:
    """A curve at one of its points."""

    place: Vec
    """The point of the curve, m."""
    tangent: Vec
    """The unit tangent towards growing x or theta."""
    curvature: Any
    """1/m, positive where the curve bends to the left of the tangent."""
    sharpening: Any = 0
    """How the curvature changes along the tangent, 1/m²; where nobody differentiates it anew."""


class Outlined(Protocol):
    """What an outline asks of the scene: shapes and surfaces where they are now."""

    surfaces: dict[str, Surface]

    def shape(self, body: str) -> Any: ...
    def center(self, body: str) -> Vec: ...
    def carried(self, body: str, point: str) -> Vec:
        """A named point that goes with a body (or the ground)."""

    def surface_direction(self, surface: Surface) -> Vec: ...
    def direction(self, along: Side | str) -> Vec: ...
    def along_plate(self, body: str, shape: Plate) -> Vec:
        """The direction of a plate's width."""

    def bend(self, surface: Surface, shape: Curve, point: Vec) -> Bend:
        """A curve at the place nearest to a point of it."""

    def value(self, side: Side) -> Any: ...
    def length(self, v: Vec) -> Any: ...
    def sign(self, expr: Any) -> int: ...
    def is_zero(self, expr: Any) -> bool: ...
    def are_same(self, a: Any, b: Any) -> bool:
        """Are two squares of lengths the same, to the rounding of places?"""

    def as_drawn(self, expr: Any) -> Any:
        """An expression of a general position where the file draws it."""

    def vanishes(self, expr: Any) -> bool: ...


def outline_of(scene: Outlined, partner: str, point: Vec, mark: Mark) -> Outline:
    """The outline of `partner` (a body or a surface) at `point`. FileProblem where the point is not on it."""
    surface = scene.surfaces.get(partner)
    if surface is not None:
        return _surface(scene, surface, point, mark)
    match scene.shape(partner):
        case Composite() as shape:
            return _composite(scene, partner, shape, point)
        case Round() | Sector() as shape:
            return _round(scene, partner, shape, point, mark)
        case Plate() as shape:
            return _plate(scene, partner, shape, point, mark)
        case Rod() as shape:
            return _rod(scene, partner, shape, point)
        case AnyShape(rim=Round() as rim):
            return _round(scene, partner, rim, point, mark)
    return Outline("corner", partner)


def meeting_place(scene: Setting, between: Sequence[str], at: str) -> Vec:
    """Where two partners touch: a particle touches where it is, whatever else is drawn at that point."""
    particle = _particle(scene, between)
    return scene.point(at) if particle is None else scene.center(particle)


def demand_there(scene: Setting, between: Sequence[str], at: str, mark: Mark) -> None:
    """FileProblem: a particle is not drawn at the point where it is to touch."""
    particle = _particle(scene, between)
    if particle is None or at in (particle, scene.center_name(particle)):
        return
    reach = scene.center(particle) - scene.point(at)
    if scene.is_zero(reach.dot(reach)):
        return
    away = gap(scene, scene.length(reach))
    text = f"the particle {particle} is not drawn at {at}, where it is to touch" + (away and f", but {away} away")
    hint = f"a particle touches where it is: draw it at {at}, or leave `at` out; a body with a size is a `plate`"
    raise scene.refuse(mark, "PL521", text, hint)


def _particle(scene: Setting, between: Sequence[str]) -> str | None:
    carriers = ((p, scene.carrier(p)) for p in between)
    particles = (p for p, body in carriers if p == body and not scene.rigid(p))
    return next(particles, None)


def spot_of(scene: Outlined, states: Sequence[State], during: Span, partner: str, point: Vec) -> Vec:
    """Where a partner is touched at a point: there; a line or circle that is met later where it is nearest."""
    surface = scene.surfaces.get(partner)
    later = during is not None and bool(states) and during[0] != states[0].name
    if not later or surface is None:
        return point
    body = surface.body or GROUND
    if isinstance(surface.shape, Line):
        start, along = scene.carried(body, surface.shape.through), scene.surface_direction(surface)
        foot: Vec = start + along * (point - start).dot(along)
        return foot
    if isinstance(surface.shape, Circle):
        center = scene.carried(body, surface.shape.center)
        out = point - center
        nearest: Vec = center + out * (scene.value(surface.shape.radius) / scene.length(out))
        return nearest
    return point


def hub_of(scene: Outlined, body: str, point: Vec) -> Vec:
    """The centre of the rim through a point of a body, about which a cord there is wound; elsewhere its mass centre."""
    rims: list[Round] = []
    match scene.shape(body):
        case AnyShape(rim=Round() as rim):
            rims = [rim]
        case Composite(pieces):
            rims = [p.shape for p in pieces if isinstance(p.shape, Round)]
    found = (outline.center for rim in rims if (outline := _rim(scene, body, rim, point)) is not None)
    return next((center for center in found if center is not None), scene.center(body))


def edges_at(scene: Outlined, body: str, shape: Plate, point: Vec) -> list[Outline]:
    """The edges of a plate that pass through a point (two at a corner), with the distances to their ends."""
    along = scene.along_plate(body, shape)
    out = point - scene.carried(body, shape.center)
    width, height = scene.value(shape.width) / 2, scene.value(shape.height) / 2
    found = []
    for direction, half, depth in ((along, width, height), (along.turned(), height, width)):
        across, ahead = direction.cross(out), direction.dot(out)
        if scene.is_zero(across * across - depth * depth) and scene.sign(half * half - ahead * ahead) >= 0:
            found.append(Outline("straight", body, direction, extent=(half + ahead, half - ahead)))
    return found


def _surface(scene: Outlined, surface: Surface, point: Vec, mark: Mark) -> Outline:
    body, shape = surface.body or GROUND, surface.shape
    if isinstance(shape, Line):
        tangent = scene.surface_direction(surface)
        off = (point - scene.carried(body, shape.through)).cross(tangent)
        fits = scene.is_zero(as_first(scene, off))
        _demand_told(fits, scene, off, surface, mark)
        away = "" if fits else gap(scene, off)
        _demand_on(fits, surface, mark, f"let the line go `through:` it; {LATER}", away and f", but {away} off")
        drift, through = _drift(scene, surface, tangent), scene.carried(body, shape.through)
        return Outline("straight", body, tangent, drift=drift, floor=surface.inferred, on_line=through)
    if isinstance(shape, Circle):
        center, radius = scene.carried(body, shape.center), scene.value(shape.radius)
        out = point - center
        fits = scene.are_same(as_first(scene, out.dot(out)), radius * radius)
        _demand_told(fits, scene, out.dot(out) - radius * radius, surface, mark)
        away = "" if fits else gap(scene, scene.length(out) - radius)
        _demand_on(fits, surface, mark, "its distance from the centre is the radius", away and f", but {away} off")
        if surface.speed is not None:
            text, hint = f"{surface.name}: a belt runs along a line", "give `speed:` to a line; let a disk turn instead"
            raise refuse(mark, "PL543", text, hint)
        return Outline("arc", body, (out / scene.length(out)).turned(), 1 / radius, center, shape.center)
    bend = scene.bend(surface, shape, point)
    off = bend.place - point
    fits = scene.is_zero(off.x) and scene.is_zero(off.y)
    away = "" if fits else gap(scene, scene.length(off))
    _demand_on(fits, surface, mark, "write its place with the formula of the curve", away and f", but {away} off")
    kind, drift = "straight" if scene.vanishes(bend.curvature) else "arc", _drift(scene, surface, bend.tangent)
    curve = Outline(kind, body, bend.tangent, bend.curvature, drift=drift, curve=surface.name)
    return replace(curve, sharpening=bend.sharpening)


def _demand_told(fits: bool, scene: Outlined, off: Any, surface: Surface, mark: Mark) -> None:
    """FileProblem: where the point is depends on what is sought, so that nobody can say that it is on the surface."""
    names = [] if fits else sought_in(scene, off)
    if names:
        text = f"the point of contact is on {surface.name} only for some {listed(names, 'and')}, still to be found"
        hint = f"give {names[0]} as a number, or write the place of the point so that it is always on {surface.name}"
        raise refuse(mark, "PL521", text, hint)


def _demand_on(fits: bool, surface: Surface, mark: Mark, hint: str, away: str = "") -> None:
    if not fits:
        raise refuse(mark, "PL521", f"the point of contact is not on {surface.name} as drawn{away}", hint)


def _drift(scene: Outlined, surface: Surface, tangent: Vec) -> Vec | None:
    """The velocity of a belt's surface."""
    return None if surface.speed is None else Vec(tangent.x, tangent.y) * scene.value(surface.speed)


def _round(scene: Outlined, body: str, shape: Round | Sector, point: Vec, mark: Mark) -> Outline:
    """The rim of a disk, its hub or the arc of a sector; or the centre."""
    rim = _rim(scene, body, shape, point)
    if rim is not None:
        return rim
    center = _center(shape)
    if _same(scene, scene.carried(body, center), point):
        return Outline("corner", body)
    if isinstance(shape, Sector):
        where, hint = "arc", f"its distance from {center} is the radius"
    else:
        where, hint = "rim", "its distance from the centre is the radius or the hub"
    out = point - scene.carried(body, center)
    away = gap(scene, scene.length(out) - scene.value(shape.radius))
    raise refuse(
        mark, "PL522", f"the point of contact is not on the {where} of {body}{away and f', but {away} off'}", hint
    )


def _rim(scene: Outlined, body: str, shape: Round | Sector, point: Vec) -> Outline | None:
    """The rim, the hub or the arc through a point; None: none is there."""
    center = scene.carried(body, _center(shape))
    out = point - center
    for side in (shape.radius, shape.hub if isinstance(shape, Round) else None):
        if side is not None:
            radius = scene.value(side)
            if scene.are_same(out.dot(out), radius * radius):
                # Places in numbers and a radius by name: their quotient is no unit vector to the eye.
                return Outline("arc", body, (out / scene.length(out)).turned(), 1 / radius, center, _center(shape))
    return None


def _center(shape: Round | Sector) -> str:
    return shape.apex if isinstance(shape, Sector) else shape.center


def _plate(scene: Outlined, body: str, shape: Plate, point: Vec, mark: Mark) -> Outline:
    """An edge of the rectangle through the point; both edges at a corner are offered by `edges_at`."""
    edges = edges_at(scene, body, shape, point)
    if not edges:
        hint = "let `at` be the corner that touches, or a point of the edge: half the height below the centre, say"
        out, along = point - scene.carried(body, shape.center), scene.along_plate(body, shape)
        ahead, across = gap(scene, along.dot(out)), gap(scene, along.cross(out))
        away = ahead and f", but {ahead} from its centre along the width and {across} along the height"
        raise refuse(mark, "PL522", f"the point of contact is not on an edge of {body}{away}", hint)
    return edges[0] if len(edges) == 1 else Outline("corner", body)


def _rod(scene: Outlined, body: str, shape: Rod, point: Vec) -> Outline:
    start = scene.carried(body, shape.start)
    if shape.end is None or _same(scene, start, point) or _same(scene, scene.carried(body, shape.end), point):
        return Outline("corner", body)
    along = scene.direction(body)
    return Outline("straight", body, along) if scene.is_zero(along.cross(point - start)) else Outline("corner", body)


def _composite(scene: Outlined, body: str, shape: Composite, point: Vec) -> Outline:
    """The first part on whose rim the point is; a corner when none."""
    for piece in shape.pieces:
        part = piece.shape
        if isinstance(part, Round | Sector) and (rim := _rim(scene, body, part, point)) is not None:
            return rim
        if isinstance(part, Plate):
            edges = edges_at(scene, body, part, point)
            if len(edges) == 1:
                return edges[0]
    return Outline("corner", body)


def _same(scene: Outlined, a: Vec, b: Vec) -> bool:
    return scene.is_zero(a.x - b.x) and scene.is_zero(a.y - b.y)
