"""Curves y(x) and r(theta) as drawn in the axes of the body that carries them, wherever that body is now."""

from __future__ import annotations

from dataclasses import dataclass

from planar_cli.motion.carried import Carried
from planar_cli.motion.places import unit_vector
from planar_cli.motion.replacing import replaced
from planar_cli.motion.terms import Term
from planar_cli.problem.geometry import Vec
from planar_cli.problem.scene import GROUND, Curve, Surface


@dataclass(frozen=True, slots=True)
class Bend:
    """A curve at one of its points."""

    place: Vec
    """The point of the curve, m."""
    tangent: Vec
    """The unit tangent towards growing x or theta."""
    curvature: Term
    """1/m, positive where the curve bends to the left of the tangent."""


def curve_at(scene: Carried, surface: Surface, curve: Curve, point: Vec) -> Bend:
    """A curve where a point of it is now: what is drawn, carried along by its body."""
    graph, body = scene.graph, surface.body or GROUND
    origin = scene.carried_from(body, Vec(graph.number(0.0), graph.number(0.0)))
    axis = scene.turned_with(body, Vec(graph.number(1.0), graph.number(0.0)))
    seen = point - origin
    x, y = graph.of(seen.dot(axis)), graph.of(axis.cross(seen))
    if curve.kind == "y":
        f, first, second = _derivatives(scene, curve, "x", x)
        # y'' / (1 + y'²)^(3/2)
        speed = graph.call("sqrt", first * first + 1)
        place: Vec = origin + axis * x + axis.turned() * f
        return Bend(place, (axis + axis.turned() * first) / speed, second / (speed * speed * speed))
    theta = graph.turning(y, x, 0.0)
    f, first, second = _derivatives(scene, curve, "theta", theta)
    # (r² + 2 r'² - r r'') / (r² + r'²)^(3/2), in parts along and across r.
    part = unit_vector(graph, theta)
    radial = axis * part.x + axis.turned() * part.y
    speed = graph.call("sqrt", f * f + first * first)
    bend = f * f + first * first * 2 - f * second
    tangent = (radial * first + radial.turned() * f) / speed
    return Bend(origin + radial * f, tangent, bend / (speed * speed * speed))


def _derivatives(scene: Carried, curve: Curve, name: str, at: Term) -> tuple[Term, Term, Term]:
    """The formula of a curve and its first and second derivative, at a value of its variable."""
    graph = scene.graph
    one = graph.number(1.0)
    variable = graph.variable(scene.free_name(f"curve_{name}"), at.value, 1.0)
    formula = scene.sides.with_variables({name: variable}).value(curve.formula)
    first = graph.rate(formula, {variable: one})
    second = graph.rate(first, {variable: one})
    found = [replaced(t, {variable: at}) for t in (formula, first, second)]
    return found[0], found[1], found[2]
