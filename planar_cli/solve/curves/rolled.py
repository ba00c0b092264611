"""Wheels that roll without slipping on a straight surface because the file places them so: no joint says it."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from planar_cli.equation.plain import identically_zero, simplified
from planar_cli.equation.quantities import Quantities
from planar_cli.equation.scene import Scene
from planar_cli.problem.geometry import Vec
from planar_cli.problem.scene import Line, Polar, Round, with_article
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
    rim: tuple[tuple[str, str], ...] = ()
    """The points that the file measures from its centre at a direction that turns with it, and where each of them is
    while that coordinate is zero: straight below.
    """

    def told(self) -> str:
        """That it rolls, and how it turns."""
        body, surface = with_article(self.body), with_article(self.surface)
        rolls = f"{body[:1].upper()}{body[1:]} rolls on {surface} without slipping: "
        start = " from x = 0" if self.from_origin else ""
        advances = f"{self.centre} advances{start} by the arc that has come into contact with {surface}."
        if not self.angle:
            return rolls + advances
        sense = "clockwise" if self.clockwise else "counterclockwise"
        places = "".join(f" At `{self.angle}` = 0 {point} is {where}." for point, where in self.rim)
        return f"{rolls}{advances} `{self.angle}`: the angle by which {body} has turned, {sense}.{places}"


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
                rim = tuple(_rim(scene, shape.center, angle))
                yield Rolled(body.name, shape.center, surface.name, starts, angle, clockwise, rim)


def _rim(scene: Scene, centre: str, angle: str) -> Iterator[tuple[str, str]]:
    """Where points on the rim start that turn with it, if straight up, down or to a side."""
    zero = {q: 0 for q in scene.ledger.coordinates if q.name == angle}
    for point in scene.problem.points:
        place = point.place
        if isinstance(place, Polar) and place.origin == centre:
            direction = scene.value(place.angle)
            at = sp.Mod(simplified(direction.subs(zero) * 2 / sp.pi), 4)
            if zero and direction.free_symbols == zero.keys() and at in SIDES:
                yield point.name, SIDES[at].format(centre)


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
