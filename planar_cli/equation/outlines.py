"""The outline of a body or surface at a point of contact: a corner, a straight edge or an arc, with its curvature."""

from __future__ import annotations

from typing import Protocol

import sympy as sp

from planar_cli.equation.bodies import BodyModel
from planar_cli.equation.curves import CurveSetting, bend_at, carrier_pose
from planar_cli.errors import Mark, refuse
from planar_cli.problem.facts import Outline
from planar_cli.problem.geometry import Vec
from planar_cli.problem.scene import Circle, Composite, Curve, Line, Plate, Rod, Round, Sector, Surface


class OutlineSetting(CurveSetting, Protocol):
    """What an outline asks of the scene: shapes and surfaces where they are now."""

    surfaces: dict[str, Surface]
    bodies: dict[str, BodyModel]

    def point(self, name: str) -> Vec: ...
    def turn(self, body: str) -> sp.Expr: ...
    def surface_angle(self, surface: Surface) -> Vec: ...
    def is_zero(self, expr: sp.Expr) -> bool: ...


def outline_of(scene: OutlineSetting, partner: str, point: Vec, mark: Mark) -> Outline:
    """The outline of `partner` (a body or a surface) at `point`. Refused when the point is not on it."""
    surface = scene.surfaces.get(partner)
    if surface is not None:
        return _surface(scene, surface, point, mark)
    shape = scene.bodies[partner].shape
    if isinstance(shape, Composite):
        return _composite(scene, partner, shape, point)
    if isinstance(shape, Round):
        return _round(scene, partner, shape, point, mark)
    if isinstance(shape, Plate):
        return _plate(scene, partner, shape, point, mark)
    if isinstance(shape, Rod):
        return _rod(scene, partner, shape, point)
    if isinstance(shape, Sector):
        center = scene.point(shape.apex)
        if not _same(scene, center, point):
            return arc(scene, partner, center, shape.apex, point)
    return Outline("corner", partner)


def arc(scene: OutlineSetting, body: str, center: Vec, name: str, point: Vec, drift: Vec | None = None) -> Outline:
    """An arc about `center`; its tangent is k × (outward normal), its curvature +1/R."""
    out = point - center
    radius = scene.length(out)
    normal = out / radius
    return Outline("arc", body, normal.turned(), 1 / radius, center, name, drift)


def _surface(scene: OutlineSetting, surface: Surface, point: Vec, mark: Mark) -> Outline:
    body = surface.body or "ground"
    shape = surface.shape
    if isinstance(shape, Line):
        tangent = scene.surface_angle(surface)
        off = (point - scene.point(shape.through)).cross(tangent)
        if not scene.is_zero(off):
            raise refuse(
                mark, "PL521", f"the point of contact is not on {surface.name}", "let the line go `through:` it"
            )
        return Outline("straight", body, tangent, drift=_drift(scene, surface, tangent))
    if isinstance(shape, Circle):
        center, radius = scene.point(shape.center), scene.value(shape.radius)
        if not scene.is_zero((point - center).dot(point - center) - radius**2):
            raise refuse(
                mark,
                "PL521",
                f"the point of contact is not on {surface.name}",
                "its distance from the centre is the radius",
            )
        if surface.speed is not None:
            raise refuse(
                mark,
                "PL543",
                f"{surface.name}: a belt runs along a line",
                "give `speed:` to a line; let a disk turn instead",
            )
        found = arc(scene, body, center, shape.center, point)
        return Outline(
            "arc", body, found.tangent, 1 / radius, center, shape.center, _drift(scene, surface, found.tangent)
        )
    return _curve(scene, surface, shape, point, mark)


def _drift(scene: OutlineSetting, surface: Surface, tangent: Vec | None) -> Vec | None:
    if surface.speed is None or tangent is None:
        return None
    found: Vec = tangent * scene.value(surface.speed)
    return found


def polar_angle(scene: OutlineSetting, point: Vec) -> sp.Expr:
    """The angle of a place; of one that is written as (ρ cos φ, ρ sin φ) just φ, with its turns."""
    for sine in sorted(point.y.atoms(sp.sin), key=str):
        phi = sine.args[0]
        along = point.x * sp.cos(phi) + point.y * sp.sin(phi)
        if scene.is_zero(point.x * sp.sin(phi) - point.y * sp.cos(phi)) and scene.sign(along) > 0:
            return sp.sympify(phi)
    return sp.sympify(sp.atan2(point.y, point.x))


def _curve(scene: OutlineSetting, surface: Surface, shape: Curve, point: Vec, mark: Mark) -> Outline:
    """Tangent and signed curvature of y(x) or r(theta) at the point; the arc of the osculating circle. They are those
    as drawn, carried along by the body of the curve.
    """
    bend = bend_at(scene, shape, carrier_pose(scene, surface), point)
    off = bend.place - point
    if not (scene.is_zero(off.x) and scene.is_zero(off.y)):
        raise refuse(mark, "PL521", f"the point of contact is not on {surface.name}")
    tangent, curvature = bend.tangent, bend.curvature
    return Outline(
        "arc" if curvature != 0 else "straight",
        surface.body or "ground",
        tangent,
        curvature,
        drift=_drift(scene, surface, tangent),
        curve=surface.name,
    )


def _round(scene: OutlineSetting, body: str, shape: Round, point: Vec, mark: Mark) -> Outline:
    center = scene.point(shape.center)
    out = point - center
    radii = [scene.value(shape.radius), *([scene.value(shape.hub)] if shape.hub is not None else [])]
    for radius in radii:
        if scene.is_zero(out.dot(out) - radius**2):
            normal = out / radius
            return Outline("arc", body, normal.turned(), 1 / radius, center, shape.center)
    if _same(scene, center, point):
        return Outline("corner", body)
    raise refuse(
        mark,
        "PL522",
        f"the point of contact is not on the rim of {body}",
        "its distance from the centre is the radius or the hub",
    )


def _plate(scene: OutlineSetting, body: str, shape: Plate, point: Vec, mark: Mark) -> Outline:
    """An edge of the rectangle through the point, with the distances to its corners behind and ahead; both edges at a
    corner are offered by `edges_at`.
    """
    edges = edges_at(scene, body, shape, point)
    if not edges:
        raise refuse(
            mark, "PL522", f"the point of contact is not on an edge of {body}", "half the height below the centre, say"
        )
    return edges[0] if len(edges) == 1 else Outline("corner", body)


def edges_at(scene: OutlineSetting, body: str, shape: Plate, point: Vec) -> list[Outline]:
    """The edges of a plate that pass through a point (two at a corner)."""
    angle = (scene.value(shape.angle) if shape.angle is not None else sp.S.Zero) + scene.turn(body)
    along = Vec(sp.cos(angle), sp.sin(angle))
    out = point - scene.point(shape.center)
    found = []
    for direction, half, depth in (
        (along, scene.value(shape.width) / 2, scene.value(shape.height) / 2),
        (along.turned(), scene.value(shape.height) / 2, scene.value(shape.width) / 2),
    ):
        across, ahead = direction.cross(out), direction.dot(out)
        on_edge = scene.is_zero(across**2 - depth**2) and scene.sign(half**2 - ahead**2) >= 0
        if on_edge:
            found.append(Outline("straight", body, direction, extent=(half + ahead, half - ahead)))
    return found


def _rod(scene: OutlineSetting, body: str, shape: Rod, point: Vec) -> Outline:
    start = scene.point(shape.start)
    if shape.end is None or _same(scene, start, point) or _same(scene, scene.point(shape.end), point):
        return Outline("corner", body)
    reach = scene.point(shape.end) - start
    if not scene.is_zero(reach.cross(point - start)):
        return Outline("corner", body)
    return Outline("straight", body, reach / scene.length(reach))


def _composite(scene: OutlineSetting, body: str, shape: Composite, point: Vec) -> Outline:
    """The first part on whose rim the point is; a corner when none."""
    for piece in shape.pieces:
        part = piece.shape
        if isinstance(part, Round):
            out = point - scene.point(part.center)
            radius = scene.value(part.radius)
            if scene.is_zero(out.dot(out) - radius**2):
                return Outline("arc", body, (out / radius).turned(), 1 / radius, scene.point(part.center), part.center)
        if isinstance(part, Plate):
            edges = edges_at(scene, body, part, point)
            if len(edges) == 1:
                return edges[0]
    return Outline("corner", body)


def _same(scene: OutlineSetting, a: Vec, b: Vec) -> bool:
    return scene.is_zero(a.x - b.x) and scene.is_zero(a.y - b.y)
