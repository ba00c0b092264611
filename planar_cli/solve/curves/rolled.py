"""Wheels that roll without slipping on a straight surface because the file places them so: no joint says it."""

from __future__ import annotations

from collections.abc import Collection, Iterator

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero, simplified
from planar_cli.equation.kinematics.quantities import Quantities
from planar_cli.equation.scene.scene import Scene
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import Line, Polar, Round, with_article
from planar_cli.records import record

SIDES = {
    0: "to the right of {}",
    1: "straight above {} (90°)",
    2: "to the left of {} (180°)",
    3: "straight below {} (270°)",
}
"""Where a point is seen from another, by the quarter turns of its direction from the x axis."""


@record
class Rolled:
    """A wheel, its centre and what it rolls on."""

    body: str
    centre: str
    surface: str
    from_origin: bool
    """Does its centre start at x = 0, where the coordinates are zero?"""
    angle: str = ""
    """The coordinate by which it turns as that grows; "": it turns by no coordinate itself."""
    clockwise: bool = False
    """In which sense it does."""
    seen: tuple[tuple[str, str], ...] = ()
    """The points that the file measures from its centre at a direction that turns with it, and where each of them is
    while that coordinate is zero.
    """
    rim: tuple[str, ...] = ()
    """Those of them on the rim that touch the surface then."""
    radius: str = ""
    """The letter of its radius; "": it is no letter."""

    def told(self) -> str:
        """How it turns, and that its centre advances by the arc that has touched."""
        body, surface = with_article(self.body), with_article(self.surface)
        start = " from x = 0" if self.from_origin else ""
        long = f", `{self.radius}` `{self.angle}`" if self.radius and self.angle else ""
        arc = f"the arc from {self.rim[0]} to the point of contact" if self.rim else "the arc that has touched"
        rolls = (
            f"{body[:1].upper()}{body[1:]} rolls on {surface} without slipping: {arc} has met {surface} point by "
            f"point, so that {self.centre} has advanced{start} by its length{long}."
        )
        if not self.angle:
            return rolls
        sense = "clockwise" if self.clockwise else "counterclockwise"
        places = "".join(f" At `{self.angle}` = 0 {point} is {where}." for point, where in self.seen)
        return f"`{self.angle}`: the angle by which {body} has turned, {sense}.{places} {rolls}"

    def cycloid(self, points: Collection[str], level: int) -> str:
        """What curve the point of its rim among these describes (`level` 0), how its velocity compares with that of the
        centre (1); "" where there is no such point, or more is told.
        """
        rim, surface = [p for p in self.rim if p in points], with_article(self.surface)
        if len(rim) != 1 or level > 1:
            return ""
        lowest, top = f"`{self.angle}` = 0, 2 π, …", f"`{self.angle}` = π"
        if level == 1:
            twice = f"at the top ({top}) it is twice as fast as {self.centre}"
            return f"{rim[0]} is at rest where it touches {surface} ({lowest}); {twice}."
        high = f", 2 `{self.radius}` above {surface}" if self.radius else ""
        return (
            f"{rim[0]} describes a cycloid. At {lowest} it touches {surface} and is at rest for a moment; "
            f"at {top} it is highest{high}."
        )


def rolled(quantities: Quantities) -> Iterator[Rolled]:
    """The wheels that touch a surface at rest wherever they are, with a point that has no velocity there."""
    scene, motion = quantities.scene, quantities.motion
    surfaces = [s for s in scene.surfaces.values() if isinstance(s.shape, Line) and s.speed is None and not s.body]
    for body in scene.bodies.values() if surfaces else ():
        shape = body.shape
        if not isinstance(shape, Round) or shape.center not in scene.formulas or body.name not in motion.velocities:
            continue
        centre, radius = scene.point(shape.center), scene.value(shape.radius)
        for surface in surfaces:
            assert isinstance(surface.shape, Line)
            normal = scene.surface_direction(surface).turned()
            reach = (centre - scene.point(surface.shape.through)).dot(normal)
            contact = centre - normal * reach
            v = motion.velocity(contact, body.name)
            moves = motion.velocity(centre, body.name)
            touches = identically_zero(reach**2 - radius**2)
            if touches and identically_zero(v.x) and identically_zero(v.y) and (moves.x, moves.y) != (0, 0):
                zero = {s: 0 for s in centre.x.free_symbols if s.name in {c.name for c in scene.problem.coordinates}}
                starts = bool(zero) and normal.x == 0 and centre.x.subs(zero) == 0
                angle, clockwise = _turned_by(scene, centre, normal, reach)
                seen = tuple(_seen(scene, shape.center, angle))
                level = normal.x == 0 and identically_zero(centre.y - contact.y - radius)
                below = SIDES[3].format(shape.center)
                rim = tuple(p for p, where in seen if level and where == below and _on_rim(scene, p, radius))
                letter = radius.name if radius.is_Symbol else ""
                yield Rolled(body.name, shape.center, surface.name, starts, angle, clockwise, seen, rim, letter)


def _seen(scene: Scene, centre: str, angle: str) -> Iterator[tuple[str, str]]:
    """Where points start that turn with it, if straight up, down or to a side."""
    zero = {q: 0 for q in scene.ledger.coordinates if q.name == angle}
    for point in scene.problem.points:
        place = point.place
        if isinstance(place, Polar) and place.origin == centre:
            direction = scene.value(place.angle)
            at = sp.Mod(simplified(direction.subs(zero) * 2 / sp.pi), 4)
            if zero and direction.free_symbols == zero.keys() and at in SIDES:
                yield point.name, SIDES[at].format(centre)


def _on_rim(scene: Scene, point: str, radius: sp.Expr) -> bool:
    """Does the file measure a point by the radius?"""
    place = next(p.place for p in scene.problem.points if p.name == point)
    return isinstance(place, Polar) and identically_zero(scene.value(place.distance) - radius)


def _turned_by(scene: Scene, centre: Vec, normal: Vec, reach: sp.Expr) -> tuple[str, bool]:
    """The coordinate that grows by the angle by which a wheel turns, θ' = -(r_G' · t)/reach, and whether it turns
    clockwise then; "" for none.
    """
    for q in scene.ledger.coordinates:
        way = Vec(sp.diff(centre.x, q), sp.diff(centre.y, q))
        turning = simplified(way.dot(normal.turned()) / reach)
        if turning in (1, -1):
            return q.name, turning == -1
    return "", False
