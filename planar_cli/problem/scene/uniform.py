"""Uniform shapes: mass centre, moment of inertia about it, and the direction of the body's angle.

About the mass centre (An Introduction to Planar Dynamics, appendix on moments of inertia): slender rod m l²/12, disk
m r²/2, ring m r², sphere 2 m r²/5, plate m (w² + h²)/12, sector m r²/2 - m d² with its mass centre at
d = 4 r sin(span/2)/(3 span) from the apex. Written once for whatever numbers a scene is made of.
"""

from __future__ import annotations

from typing import Any, Protocol

from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import Outline, Particle, Plate, Rod, Round, Sector, Shape
from planar_cli.records import record

SHARES = {"disk": (1, 2), "ring": (1, 1), "sphere": (2, 5)}
"""I/(m r²), as a fraction."""


@record
class Uniform:
    """A uniform shape where the file draws it."""

    center: Vec
    """The mass centre, m."""
    center_name: str
    """Its name in print; "" where it has none."""
    gyration_squared: Any
    """Moment of inertia about the mass centre per unit of mass, m²."""
    theta: Any
    """The direction that the body's angle measures, rad."""


class Measures(Protocol):
    """What a shape is measured with."""

    def point(self, name: str) -> Vec: ...
    def value(self, side: Side) -> Any: ...
    def sine(self, angle: Any) -> Any: ...
    def unit_vector(self, angle: Any) -> Vec:
        """(cos, sin) of an angle."""

    def rod(self, shape: Rod, reach: Vec) -> tuple[Any, Any]:
        """The squared length of a rod from end to end, and its direction, as the file writes it if it does."""

    @property
    def zero(self) -> Any: ...


def uniform(shape: Shape, measures: Measures, body: str = "") -> Uniform:
    """The uniform properties of a simple shape; `body`: the name of a particle that is drawn by itself."""
    point, value, zero = measures.point, measures.value, measures.zero
    match shape:
        case Particle():
            name = shape.place if isinstance(shape.place, str) else body
            return Uniform(point(name), name, zero, zero)
        case Rod():
            return _rod(shape, measures)
        case Round():
            radius, (part, whole) = value(shape.radius), SHARES[shape.kind]
            return Uniform(point(shape.center), shape.center, radius * radius * part / whole, zero)
        case Plate():
            width, height = value(shape.width), value(shape.height)
            square = (width * width + height * height) / 12
            return Uniform(point(shape.center), shape.center, square, _or_zero(shape.angle, measures))
        case Sector():
            radius, span, angle = value(shape.radius), value(shape.span), _or_zero(shape.angle, measures)
            reach = 4 * radius * measures.sine(span / 2) / (3 * span)
            center = point(shape.apex) + measures.unit_vector(angle) * reach
            return Uniform(center, "", radius * radius / 2 - reach * reach, angle)
        case Outline():
            at = point(shape.center) if shape.center else Vec(zero, zero)
            return Uniform(at, shape.center or "", zero, zero)
    raise TypeError(type(shape).__name__)


def _rod(shape: Rod, measures: Measures) -> Uniform:
    start = measures.point(shape.start)
    if shape.end is not None:
        reach = measures.point(shape.end) - start
        length_squared, angle = measures.rod(shape, reach)
    else:
        angle, length = _or_zero(shape.angle, measures), _or_zero(shape.length, measures)
        reach, length_squared = measures.unit_vector(angle) * length, length * length
    return Uniform(start + reach / 2, "", length_squared / 12, angle)


def _or_zero(side: Side | None, measures: Measures) -> Any:
    return measures.zero if side is None else measures.value(side)
