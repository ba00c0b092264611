"""Position residuals that several joints share: points that stay together, outlines that touch, outlines that roll.

How far something is off a curve y(x) or r(theta), and how far a rim has rolled on it, is asked of the poses.
"""

from __future__ import annotations

from typing import Any

from planar_cli.problem.scene.facts import Outline, center_of
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.outlines import Span
from planar_cli.problem.scene.residuals import Poses, Residual
from planar_cli.problem.scene.scene import GROUND
from planar_cli.problem.scene.setting import Setting


def together(title: str, a: str, b: str, place: Vec) -> Residual:
    """The material points of two bodies that are drawn at one place stay together."""
    return Residual(title, lambda poses: poses.point(a, place) - poses.point(b, place))


def joined(scene: Setting, title: str, during: Span, a: str, b: str, place: Vec, owner: str) -> Residual:
    """A point stays where two bodies have it. A joint that acts for some time may catch it elsewhere than where it is
    drawn: then the other body keeps it where it was when that began. `owner`: the body that the point belongs to.
    """
    other = a if owner == b else b
    if during is None or owner not in (a, b) or other == GROUND or not scene.rigid(other):
        return together(title, a, b, place)

    axis = scene.direction(other)

    def seen(poses: Poses) -> Vec:
        reach, along = poses.point(owner, place) - poses.point(other, place), poses.direction(other, axis)
        return Vec(poses.change(reach.dot(along)), poses.change(reach.dot(along.turned())))

    return Residual(title, seen)


def same_turn(title: str, a: str, b: str) -> Residual:
    """Two bodies turn by the same angle."""
    return Residual(title, lambda poses: poses.angle(a) - poses.angle(b), turns=True)


def touching(title: str, a: Outline, b: Outline, place: Vec) -> tuple[Residual, ...]:
    """The outlines neither part nor press into each other; two straight edges stay flush."""
    curve, rest = (a, b) if a.curve else (b, a)
    if curve.curve and rest.kind != "straight":
        return (Residual(f"{title}: stays on {curve.curve}", lambda poses: poses.off_curve(curve, rest, place)),)
    line, other = (a, b) if b.kind != "straight" else (b, a)
    if line.kind == "straight" and line.tangent is not None:
        tangent, point = line.tangent, center_of(other, place) or place

        def height(poses: Poses) -> Any:
            gap = poses.point(other.body, point) - poses.point(line.body, place)
            return poses.change(gap.cross(poses.direction(line.body, tangent)))

        return (Residual(f"{title}: distance from the edge", height),)
    first, second = center_of(a, place) or place, center_of(b, place) or place
    corner, arc = (a, b) if a.kind == "corner" else (b, a)
    if corner.kind == "corner" and arc.center is not None:
        center = arc.center

        def off(poses: Poses) -> Any:
            reach = poses.length(poses.point(corner.body, place) - poses.point(arc.body, center))
            return (reach * reach - poses.number(1 / arc.curvature**2)) * poses.number(arc.curvature)

        return (Residual(f"{title}: distance from the centre", off, anywhere=True),)

    def distance(poses: Poses) -> Any:
        return poses.change(poses.length(poses.point(a.body, first) - poses.point(b.body, second)))

    return (Residual(f"{title}: distance of the centres", distance),)


def flush(title: str, a: Outline, b: Outline, place: Vec) -> tuple[Residual, ...]:
    """Two outlines touch; straight edges on each other also keep their angle."""
    found = touching(title, a, b, place)
    if a.kind == b.kind == "straight":
        found += (same_turn(f"{title}: angle", a.body, b.body),)
    return found


def stuck(title: str, a: Outline, b: Outline, place: Vec) -> tuple[Residual, ...]:
    """No slip: rims roll, corners and faces stay where they are; a belt carries what lies on it."""
    kinds = {a.kind, b.kind}
    curve, rim = (a, b) if a.curve else (b, a)
    if curve.curve and rim.kind == "arc":
        return (*touching(title, a, b, place), _disk_on_curve(title, curve, rim, place))
    if "arc" in kinds and "corner" not in kinds:
        roll = _disk_on_disk(title, a, b, place) if kinds == {"arc"} else _disk_on_line(title, a, b, place)
        return (*touching(title, a, b, place), roll)
    carried = Residual(title, lambda poses: _carried(poses, a, place) - _carried(poses, b, place))
    if a.kind == b.kind == "straight":
        return (carried, same_turn(f"{title}: angle", a.body, b.body))
    return (carried,)


def _carried(poses: Poses, outline: Outline, place: Vec) -> Vec:
    """Where the spot of a surface is that was drawn at `place`; on a belt it runs on, straight or round an arc."""
    at: Vec = poses.point(outline.body, place)
    if outline.drift is None:
        return at
    drift = poses.vector(outline.drift)
    at += poses.direction(outline.body, drift) * poses.time
    center = center_of(outline, place)
    if center is None or outline.kind == "corner":
        return at
    inward = poses.vector(center) - poses.vector(place)
    bend = drift.dot(drift) / inward.dot(inward)
    at += poses.direction(outline.body, inward * bend) * (poses.time * poses.time / 2)
    return at


def _speed(poses: Poses, outline: Outline, tangent: Vec) -> Any:
    """The speed of a belt's surface along a unit tangent, seen from the body that carries the belt."""
    return poses.vector(outline.drift).dot(tangent) if outline.drift is not None else 0


def _disk_on_line(title: str, a: Outline, b: Outline, place: Vec) -> Residual:
    """The way of the centre along the line and the arc unrolled cancel: s + h φ = (u_line - u_rim) t.

    h is the height of the centre over the line, to the left of its tangent; φ the turning of the disk against the line.
    """
    line, disk = (a, b) if a.kind == "straight" else (b, a)
    center = center_of(disk, place) or place

    def slip(poses: Poses) -> Any:
        tangent = poses.vector(line.tangent or Vec(1, 0))
        height = tangent.cross(poses.vector(center) - poses.vector(place))
        belt = _speed(poses, line, tangent) - _speed(poses, disk, tangent)
        reach = poses.point(disk.body, center) - poses.point(line.body, place)
        way = poses.change(reach.dot(poses.direction(line.body, tangent)))
        turn = poses.angle(disk.body) - poses.angle(line.body)
        return way + turn * height - poses.time * belt

    return Residual(f"{title}: arc rolled on the line", slip)


def _disk_on_curve(title: str, curve: Outline, rim: Outline, place: Vec) -> Residual:
    """The arc on the curve and the one unrolled cancel: s + h (θ - ψ) = (u_curve - u_rim) t.

    s: the arc from the drawn point to the foot of the rim's centre. ψ: the angle by which the tangent there has turned
    from the drawn one. h: the height of the centre, to the left of the tangent.
    """
    center = center_of(rim, place) or place

    def slip(poses: Poses) -> Any:
        tangent = poses.vector(curve.tangent or Vec(1, 0))
        height = tangent.cross(poses.vector(center) - poses.vector(place))
        belt = _speed(poses, curve, tangent) - _speed(poses, rim, tangent)
        way, turn = poses.foot(curve, rim, place)
        return way + (poses.angle(rim.body) - turn) * height - poses.time * belt

    return Residual(f"{title}: arc rolled on {curve.curve}", slip)


def _disk_on_disk(title: str, a: Outline, b: Outline, place: Vec) -> Residual:
    """The same arc is travelled on both rims: ρ_b (ψ - θ_b) - u_b t = ρ_a (ψ - θ_a) - u_a t.

    ψ: direction of the line of centres. ρ: from each centre to the point of contact, along the direction from b's
    centre to that point; so ρ_a < 0 for rims outside each other.
    """
    first, second = center_of(a, place) or place, center_of(b, place) or place

    def slip(poses: Poses) -> Any:
        at, c_a, c_b = (poses.vector(p) for p in (place, first, second))
        rho_b = poses.root((at - c_b).dot(at - c_b))
        out = (at - c_b) / rho_b
        rho_a = (at - c_a).dot(out)
        psi = poses.turned(poses.point(a.body, first) - poses.point(b.body, second))
        belt = _speed(poses, b, out.turned()) - _speed(poses, a, out.turned())
        return (psi - poses.angle(b.body)) * rho_b - (psi - poses.angle(a.body)) * rho_a - poses.time * belt

    return Residual(f"{title}: arcs rolled on each other", slip)
