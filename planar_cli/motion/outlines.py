"""The outline of a body or surface at a point of contact: a corner, a straight edge or an arc, with its curvature."""

from __future__ import annotations

from planar_cli.errors import Mark, refuse
from planar_cli.motion.carried import Carried
from planar_cli.motion.curves import curve_at
from planar_cli.motion.places import unit_vector
from planar_cli.problem.facts import Outline
from planar_cli.problem.geometry import Vec
from planar_cli.problem.scene import GROUND, Circle, Composite, Line, Plate, Rod, Round, Sector, Surface


def outline_of(scene: Carried, partner: str, point: Vec, mark: Mark) -> Outline:
    """The outline of `partner` (a body or a surface) at `point`. Refused when the point is not on it."""
    surface = scene.surfaces.get(partner)
    if surface is not None:
        return _surface(scene, surface, point, mark)
    shape = scene.drawn[partner].shape
    match shape:
        case Composite():
            return _composite(scene, partner, shape, point)
        case Round():
            return _round(scene, partner, shape, point, mark)
        case Plate():
            return _plate(scene, partner, shape, point, mark)
        case Rod():
            return _rod(scene, partner, shape, point)
        case Sector():
            center = scene.carried(partner, shape.apex)
            if not _same(scene, center, point):
                return arc(scene, partner, center, shape.apex, point)
    return Outline("corner", partner)


def arc(scene: Carried, body: str, center: Vec, name: str, point: Vec) -> Outline:
    """An arc about `center`; its tangent is k × (outward normal), its curvature +1/R."""
    out = point - center
    radius = scene.length(out)
    return Outline("arc", body, (out / radius).turned(), 1 / radius, center, name)


def edges_at(scene: Carried, body: str, shape: Plate, point: Vec) -> list[Outline]:
    """The edges of a plate that pass through a point (two at a corner)."""
    drawn = scene.sides.value(shape.angle) if shape.angle is not None else scene.graph.number(0.0)
    along = scene.turned_with(body, unit_vector(scene.graph, scene.graph.number(drawn.value)))
    out = point - scene.carried(body, shape.center)
    width, height = scene.value(shape.width) / 2, scene.value(shape.height) / 2
    found = []
    for direction, half, depth in ((along, width, height), (along.turned(), height, width)):
        across, ahead = direction.cross(out), direction.dot(out)
        if scene.is_zero(across * across - depth * depth) and scene.sign(half * half - ahead * ahead) >= 0:
            found.append(Outline("straight", body, direction, extent=(half + ahead, half - ahead)))
    return found


def _surface(scene: Carried, surface: Surface, point: Vec, mark: Mark) -> Outline:
    body, shape = surface.body or GROUND, surface.shape
    if isinstance(shape, Line):
        tangent = scene.surface_direction(surface)
        off = (point - scene.carried(body, shape.through)).cross(tangent)
        _on_it(scene, surface, mark, scene.is_zero(off), "let the line go `through:` it")
        return Outline("straight", body, tangent, drift=_drift(scene, surface, tangent))
    if isinstance(shape, Circle):
        center, radius = scene.carried(body, shape.center), scene.value(shape.radius)
        out = point - center
        fits = scene.is_zero(out.dot(out) - radius * radius)
        _on_it(scene, surface, mark, fits, "its distance from the centre is the radius")
        if surface.speed is not None:
            text, hint = f"{surface.name}: a belt runs along a line", "give `speed:` to a line; let a disk turn instead"
            raise refuse(mark, "PL543", text, hint)
        normal = out / scene.length(out)
        return Outline("arc", body, normal.turned(), 1 / radius, center, shape.center)
    bend = curve_at(scene, surface, shape, point)
    off = bend.place - point
    _on_it(scene, surface, mark, scene.is_zero(off.x) and scene.is_zero(off.y), "")
    kind = "straight" if scene.is_zero(bend.curvature) and bend.curvature.constant else "arc"
    drift = _drift(scene, surface, bend.tangent)
    return Outline(kind, body, bend.tangent, bend.curvature, drift=drift, curve=surface.name)


def _on_it(scene: Carried, surface: Surface, mark: Mark, fits: bool, hint: str) -> None:
    if not fits:
        raise refuse(mark, "PL521", f"the point of contact is not on {surface.name}", hint)


def _drift(scene: Carried, surface: Surface, tangent: Vec) -> Vec | None:
    if surface.speed is None:
        return None
    found: Vec = tangent * scene.value(surface.speed)
    return found


def _round(scene: Carried, body: str, shape: Round, point: Vec, mark: Mark) -> Outline:
    center = scene.carried(body, shape.center)
    out = point - center
    for side in (shape.radius, shape.hub):
        if side is not None:
            radius = scene.value(side)
            if scene.is_zero(out.dot(out) - radius * radius):
                return Outline("arc", body, (out / radius).turned(), 1 / radius, center, shape.center)
    if _same(scene, center, point):
        return Outline("corner", body)
    hint = "its distance from the centre is the radius or the hub"
    raise refuse(mark, "PL522", f"the point of contact is not on the rim of {body}", hint)


def _plate(scene: Carried, body: str, shape: Plate, point: Vec, mark: Mark) -> Outline:
    """An edge of the rectangle through the point; both edges at a corner are offered by `edges_at`."""
    edges = edges_at(scene, body, shape, point)
    if not edges:
        hint = "half the height below the centre, say"
        raise refuse(mark, "PL522", f"the point of contact is not on an edge of {body}", hint)
    return edges[0] if len(edges) == 1 else Outline("corner", body)


def _rod(scene: Carried, body: str, shape: Rod, point: Vec) -> Outline:
    start = scene.carried(body, shape.start)
    if shape.end is None or _same(scene, start, point) or _same(scene, scene.carried(body, shape.end), point):
        return Outline("corner", body)
    along = scene.direction(body)
    return Outline("straight", body, along) if scene.is_zero(along.cross(point - start)) else Outline("corner", body)


def _composite(scene: Carried, body: str, shape: Composite, point: Vec) -> Outline:
    """The first part on whose rim the point is; a corner when none."""
    for piece in shape.pieces:
        part = piece.shape
        if isinstance(part, Round):
            center, radius = scene.carried(body, part.center), scene.value(part.radius)
            out = point - center
            if scene.is_zero(out.dot(out) - radius * radius):
                return Outline("arc", body, (out / radius).turned(), 1 / radius, center, part.center)
        if isinstance(part, Plate):
            edges = edges_at(scene, body, part, point)
            if len(edges) == 1:
                return edges[0]
    return Outline("corner", body)


def _same(scene: Carried, a: Vec, b: Vec) -> bool:
    return scene.is_zero(a.x - b.x) and scene.is_zero(a.y - b.y)
