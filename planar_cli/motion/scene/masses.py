"""Mass, mass centre, moment of inertia and direction of the bodies as drawn.

Composites by the parallel-axis theorem, I = Σ (I_i + m_i d_i²); of uniform shapes see problem/scene/uniform.py.
"""

from __future__ import annotations

from typing import Any

from planar_cli.errors import refuse
from planar_cli.motion.scene.places import Drawing, length_of, unit_vector
from planar_cli.motion.terms.replacing import replaced
from planar_cli.motion.terms.sides import Sides
from planar_cli.motion.terms.terms import Term, ordered
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.masses import placed
from planar_cli.problem.scene.scene import Body, Composite, Outline, Particle, Piece, Rod, Shape
from planar_cli.problem.scene.uniform import Uniform, uniform
from planar_cli.records import record

ANY_MASS = 1.0
"""The mass of a body whose mass must cancel, kg."""


@record
class Drawn:
    """One body where the file draws it."""

    shape: Shape
    rigid: bool
    """False: a particle, which has no angle."""
    mass: Term
    """kg; zero: massless; it may vary with the time. Of one that is written with places see `loaded`."""
    inertia: Term
    """About the mass centre, kg m²."""
    center: Vec
    """The mass centre, m."""
    center_name: str
    """Its name in print; "" where it has none."""
    theta: Term
    """The direction that its angle measures, rad."""
    centers: tuple[Vec, ...] = ()
    """The mass centres of the parts of a composite, m."""


@record
class _Measures:
    """Shapes in terms."""

    drawing: Drawing

    @property
    def zero(self) -> Term:
        return self.drawing.sides.graph.number(0.0)

    def point(self, name: str) -> Vec:
        return self.drawing.point(name)

    def value(self, side: Side) -> Term:
        return self.drawing.sides.value(side)

    def sine(self, angle: Term) -> Term:
        return self.drawing.sides.graph.call("sin", angle)

    def unit_vector(self, angle: Term) -> Vec:
        return unit_vector(self.drawing.sides.graph, angle)

    def rod(self, shape: Rod, reach: Vec) -> tuple[Term, Term]:
        graph = self.drawing.sides.graph
        length = length_of(graph, reach)
        angle = None if shape.end is None else self.drawing.written_direction(shape.start, shape.end, reach)
        if angle is None:
            angle = graph.call("atan2", graph.of(reach.y), graph.of(reach.x))
        return length * length, angle


def drawn_bodies(drawing: Drawing) -> dict[str, Drawn]:
    """All bodies of the file by name."""
    later = placed(drawing.problem)
    return {body.name: _drawn(drawing, body, body.name in later) for body in drawing.problem.bodies}


def loaded(drawing: Drawing, body: Body, sides: Sides) -> tuple[Term, Term]:
    """Mass and moment of inertia that are written with places, which `sides` know."""
    mass = _mass(sides, body)
    if mass.value <= 0:
        text = f"{body.name} has no mass where it is drawn"
        raise refuse(body.mark, "PL520", text, "let it begin with some: a short piece of the chain")
    if isinstance(body.shape, Particle):
        return mass, sides.graph.number(0.0)
    return mass, _inertia(drawing, sides, body, uniform(body.shape, _Measures(drawing), body.name), mass)


def _drawn(drawing: Drawing, body: Body, later: bool) -> Drawn:
    """`later`: mass and moment of inertia are told once the places are."""
    if isinstance(body.shape, Composite):
        return _composite(drawing, body, body.shape)
    shape = uniform(body.shape, _Measures(drawing), body.name)
    zero = drawing.sides.graph.number(0.0)
    mass = zero if later else _mass(drawing.sides, body)
    rigid = not isinstance(body.shape, Particle)
    inertia = _inertia(drawing, drawing.sides, body, shape, mass) if rigid and not later else zero
    return Drawn(body.shape, rigid, mass, inertia, shape.center, shape.center_name, shape.theta)


def _mass(sides: Sides, body: Body) -> Term:
    if body.any_mass:
        return sides.graph.number(ANY_MASS)
    if body.weight is not None:
        return sides.value(body.weight) / sides.constants.gravity(sides)
    return sides.graph.number(0.0) if body.mass is None else sides.value(body.mass)


def _inertia(drawing: Drawing, sides: Sides, body: Body, shape: Uniform, mass: Term) -> Term:
    if body.inertia is not None:
        value = _with_mass(body, sides.value(body.inertia), mass)
        return value if body.about is None else value - mass * _shift(drawing, body, shape.center)
    if body.gyration is not None:
        radius = sides.value(body.gyration)
        value = mass * radius * radius
        return value if body.about is None else value - mass * _shift(drawing, body, shape.center)
    if body.any_inertia:
        return sides.graph.number(ANY_MASS)
    if isinstance(body.shape, Outline) and not (mass.constant and mass.value == 0):
        # Its moment of inertia is not told, so that it must cancel as a mass may.
        return mass * ANY_MASS
    found: Term = mass * shape.gyration_squared
    return found


def _with_mass(body: Body, inertia: Term, mass: Term) -> Term:
    """A moment of inertia that is one number is that at t = 0, of a mass that goes with places that where it is drawn;
    it grows and shrinks with the mass.
    """
    if mass.constant or not inertia.constant:
        return inertia
    graph = mass.graph
    variables = [t for t in ordered([mass]) if t.op == "variable"]
    begun = replaced(mass, {v: graph.number(0.0 if graph.names[v] == "t" else v.value) for v in variables})
    if begun.zero:
        text = f"{body.name} has no mass at t = 0, so that its moment of inertia then does not tell the later ones"
        raise refuse(body.mark, "PL520", text, "write `radius_of_gyration:`, or `inertia:` with `t`")
    return inertia * mass / begun


def _shift(drawing: Drawing, body: Body, center: Vec) -> Any:
    arm = center - drawing.point(body.about or "")
    return arm.dot(arm)


def _composite(drawing: Drawing, body: Body, shape: Composite) -> Drawn:
    """Mass centre and moment of inertia of the parts together."""
    parts = [(_piece(drawing, body, p), uniform(p.shape, _Measures(drawing), body.name)) for p in shape.pieces]
    mass = parts[0][0][0]
    for (m, _), _ in parts[1:]:
        mass = mass + m
    if mass.zero:
        raise refuse(body.mark, "PL520", f"{body.name}: its parts have no mass", "give each part its `mass:`")
    center = Vec(0, 0)
    for (m, _), u in parts:
        center = center + u.center * (m / mass)
    inertia = drawing.sides.graph.number(0.0)
    for (m, own), u in parts:
        arm = u.center - center
        inertia = inertia + own + m * arm.dot(arm)
    if body.inertia is not None or body.gyration is not None:
        inertia = _inertia(drawing, drawing.sides, body, Uniform(center, "", mass * 0, parts[0][1].theta), mass)
    centers = tuple(u.center for _, u in parts)
    return Drawn(shape, True, mass, inertia, center, "", parts[0][1].theta, centers)


def _piece(drawing: Drawing, body: Body, piece: Piece) -> tuple[Term, Term]:
    """Mass of a part and its moment of inertia about its own mass centre."""
    sides = drawing.sides
    mass = sides.graph.number(0.0)
    if piece.weight is not None:
        mass = sides.value(piece.weight) / sides.constants.gravity(sides)
    elif piece.mass is not None:
        mass = sides.value(piece.mass)
    if piece.inertia is not None:
        return mass, sides.value(piece.inertia)
    if piece.gyration is not None:
        radius = sides.value(piece.gyration)
        return mass, mass * radius * radius
    return mass, mass * uniform(piece.shape, _Measures(drawing), body.name).gyration_squared
