"""Mass, mass centre, moment of inertia and direction of the bodies as drawn.

Uniform shapes, about their mass centre (An Introduction to Planar Dynamics, appendix on moments of inertia): slender
rod m l²/12, disk m r²/2, ring m r², sphere 2 m r²/5, plate m (w² + h²)/12, sector m r²/2 - m d² with its mass centre at
d = 4 r sin(span/2)/(3 span) from the apex; composites by the parallel-axis theorem, I = Σ (I_i + m_i d_i²).
"""

from __future__ import annotations

from typing import Any

from planar_cli.errors import refuse
from planar_cli.motion.places import Drawing, length_of, unit_vector
from planar_cli.motion.replacing import replaced
from planar_cli.motion.terms import Term, ordered
from planar_cli.problem.expression import Side
from planar_cli.problem.geometry import Vec
from planar_cli.problem.scene import Body, Composite, Outline, Particle, Piece, Plate, Rod, Round, Sector, Shape
from planar_cli.records import record

ANY_MASS = 1.0
"""The mass of a body whose mass must cancel, kg."""
SHARES = {"disk": 0.5, "ring": 1.0, "sphere": 0.4}


@record
class Drawn:
    """One body where the file draws it."""

    shape: Shape
    rigid: bool
    """False: a particle, which has no angle."""
    mass: Term
    """kg; zero: massless; it may vary with the time."""
    inertia: Term
    """About the mass centre, kg m²."""
    center: Vec
    """The mass centre, m."""
    center_name: str
    """Its name in print; "" where it has none."""
    theta: Term
    """The direction that its angle measures, rad."""


@record
class _Uniform:
    """Mass centre of a uniform shape, moment of inertia about it per unit of mass, direction of its angle."""

    center: Vec
    name: str
    gyration_squared: Term
    theta: Term


def drawn_bodies(drawing: Drawing) -> dict[str, Drawn]:
    """All bodies of the file by name."""
    return {body.name: _drawn(drawing, body) for body in drawing.problem.bodies}


def _drawn(drawing: Drawing, body: Body) -> Drawn:
    if isinstance(body.shape, Composite):
        return _composite(drawing, body, body.shape)
    shape = _uniform(drawing, body.shape, body.name)
    mass, zero = _mass(drawing, body), drawing.sides.graph.number(0.0)
    rigid = not isinstance(body.shape, Particle)
    inertia = _inertia(drawing, body, shape, mass) if rigid else zero
    return Drawn(body.shape, rigid, mass, inertia, shape.center, shape.name, shape.theta)


def _uniform(drawing: Drawing, shape: Shape, body: str) -> _Uniform:
    """The uniform properties of a simple shape."""
    sides, zero = drawing.sides, drawing.sides.graph.number(0.0)
    match shape:
        case Particle():
            name = shape.place if isinstance(shape.place, str) else body
            return _Uniform(drawing.point(name), name, zero, zero)
        case Rod():
            return _rod(drawing, shape)
        case Round():
            radius = sides.value(shape.radius)
            return _Uniform(drawing.point(shape.center), shape.center, radius * radius * SHARES[shape.kind], zero)
        case Plate():
            width, height = sides.value(shape.width), sides.value(shape.height)
            square = (width * width + height * height) / 12
            return _Uniform(drawing.point(shape.center), shape.center, square, _angle(drawing, shape.angle))
        case Sector():
            radius, span, angle = sides.value(shape.radius), sides.value(shape.span), _angle(drawing, shape.angle)
            reach = radius * sides.graph.call("sin", span / 2) * 4 / (span * 3)
            center = drawing.point(shape.apex) + unit_vector(sides.graph, angle) * reach
            return _Uniform(center, "", radius * radius / 2 - reach * reach, angle)
        case Outline():
            at = drawing.point(shape.center) if shape.center else Vec(zero, zero)
            return _Uniform(at, shape.center or "", zero, zero)
    raise TypeError(type(shape).__name__)


def _angle(drawing: Drawing, side: Side | None) -> Term:
    return drawing.sides.graph.number(0.0) if side is None else drawing.sides.value(side)


def _rod(drawing: Drawing, shape: Rod) -> _Uniform:
    graph, start = drawing.sides.graph, drawing.point(shape.start)
    if shape.end is not None:
        reach = drawing.point(shape.end) - start
        length = length_of(graph, reach)
        angle = graph.call("atan2", graph.of(reach.y), graph.of(reach.x))
    else:
        angle = _angle(drawing, shape.angle)
        length = _angle(drawing, shape.length)
        reach = unit_vector(graph, angle) * length
    return _Uniform(start + reach * 0.5, "", length * length / 12, angle)


def _mass(drawing: Drawing, body: Body) -> Term:
    sides = drawing.sides
    if body.any_mass:
        return sides.graph.number(ANY_MASS)
    if body.weight is not None:
        return sides.value(body.weight) / sides.constants.gravity(sides)
    return sides.graph.number(0.0) if body.mass is None else sides.value(body.mass)


def _inertia(drawing: Drawing, body: Body, shape: _Uniform, mass: Term) -> Term:
    if body.inertia is not None:
        value = _with_mass(drawing, body, drawing.sides.value(body.inertia), mass)
        return value if body.about is None else value - mass * _shift(drawing, body, shape.center)
    if body.gyration is not None:
        radius = drawing.sides.value(body.gyration)
        value = mass * radius * radius
        return value if body.about is None else value - mass * _shift(drawing, body, shape.center)
    if isinstance(body.shape, Outline) and not (mass.constant and mass.value == 0):
        # Its moment of inertia is not told, so that it must cancel as a mass may.
        return mass * ANY_MASS
    return mass * shape.gyration_squared


def _with_mass(drawing: Drawing, body: Body, inertia: Term, mass: Term) -> Term:
    """A moment of inertia written without `t` is that at t = 0, and grows and shrinks with the mass."""
    if mass.constant or not inertia.constant:
        return inertia
    graph = drawing.sides.graph
    begun = replaced(mass, {t: graph.number(0.0) for t in ordered([mass]) if t.op == "variable"})
    if begun.zero:
        text = f"{body.name} has no mass at t = 0, so that its moment of inertia then does not tell the later ones"
        raise refuse(body.mark, "PL520", text, "write `radius_of_gyration:`, or `inertia:` with `t`")
    return inertia * mass / begun


def _shift(drawing: Drawing, body: Body, center: Vec) -> Any:
    arm = center - drawing.point(body.about or "")
    return arm.dot(arm)


def _composite(drawing: Drawing, body: Body, shape: Composite) -> Drawn:
    """Mass centre and moment of inertia of the parts together."""
    parts = [(_piece(drawing, body, p), _uniform(drawing, p.shape, body.name)) for p in shape.pieces]
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
        inertia = _inertia(drawing, body, _Uniform(center, "", mass * 0, parts[0][1].theta), mass)
    return Drawn(shape, True, mass, inertia, center, "", parts[0][1].theta)


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
    return mass, mass * _uniform(drawing, piece.shape, body.name).gyration_squared
