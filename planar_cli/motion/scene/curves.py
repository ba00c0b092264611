"""Curves y(x) and r(theta) as drawn in the axes of the body that carries them, wherever that body is now."""

from __future__ import annotations

import math
from typing import Any

from planar_cli.motion.scene.carried import Carried
from planar_cli.motion.scene.places import unit_vector
from planar_cli.motion.terms.functions import Integral
from planar_cli.motion.terms.replacing import replaced
from planar_cli.motion.terms.terms import Term, evaluate
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.outlines import Bend
from planar_cli.problem.scene.scene import GROUND, Curve, Surface
from planar_cli.records import record

TURNS = 6
"""So many turns of a spiral are tried for a drawn place."""


@record
class Formula:
    """A curve in the axes in which it is drawn: y(x), or r(theta)."""

    kind: str
    """y or r."""
    variable: Term
    """x in m, or theta in rad."""
    value: Term
    """m."""
    first: Term
    """Its derivative."""
    second: Term
    """Its second derivative."""

    def at(self, parameter: Term) -> tuple[Term, Term, Term]:
        """Value and derivatives at a value of the variable."""
        by = {self.variable: parameter}
        return replaced(self.value, by), replaced(self.first, by), replaced(self.second, by)

    def numbers(self, parameter: float) -> tuple[float, float, float]:
        """The same in plain numbers."""
        value, first, second = evaluate((self.value, self.first, self.second), {self.variable: parameter})
        return value, first, second


def formula_of(scene: Carried, curve: Curve) -> Formula:
    """The formula of a curve."""
    graph, name = scene.graph, "x" if curve.kind == "y" else "theta"
    variable = scene.curve_variables.get(name)
    if variable is None:
        variable = scene.curve_variables[name] = scene.variable(f"along_{name}", 0.3 * scene.extent, 1.0)
    value = scene.sides.with_variables({name: variable}).value(curve.formula)
    one = {variable: graph.number(1.0)}
    first = graph.rate(value, one)
    return Formula(curve.kind, variable, value, first, graph.rate(first, one))


def curve_at(scene: Carried, surface: Surface, curve: Curve, point: Vec) -> Bend:
    """A curve where a point of it is now: what is drawn, carried along by its body."""
    return bend_of(scene, surface, curve, parameter_of(scene, surface, curve, point))


def seen_from(scene: Carried, surface: Surface, point: Vec) -> tuple[Term, Term]:
    """A place in the axes in which a curve is drawn, m."""
    origin, axis = axes_of(scene, surface)
    seen = point - origin
    return scene.graph.of(seen.dot(axis)), scene.graph.of(axis.cross(seen))


def axes_of(scene: Carried, surface: Surface) -> tuple[Vec, Vec]:
    """Origin and x axis of a curve, carried along by its body."""
    graph, body = scene.graph, surface.body or GROUND
    zero, one = graph.number(0.0), graph.number(1.0)
    return scene.carried_from(body, Vec(zero, zero)), scene.turned_with(body, Vec(one, zero))


def parameter_of(scene: Carried, surface: Surface, curve: Curve, point: Vec) -> Term:
    """The x or theta of a place; theta counts its turns, from the turn of the curve on which the place is drawn."""
    x, y = seen_from(scene, surface, point)
    if curve.kind == "y":
        return x
    formula = formula_of(scene, curve)
    start, far = math.atan2(y.value, x.value), math.hypot(x.value, y.value)
    angles = [start + k * math.tau for k in range(-TURNS, TURNS + 1)]
    nearest = min(angles, key=lambda a: (round(abs(formula.numbers(a)[0] - far) / scene.extent, 9), abs(a)))
    return scene.graph.turning(y, x, start - nearest)


def bend_of(scene: Carried, surface: Surface, curve: Curve, parameter: Term) -> Bend:
    """A curve at a value of its x or theta."""
    graph = scene.graph
    origin, axis = axes_of(scene, surface)
    f, first, second = formula_of(scene, curve).at(parameter)
    if curve.kind == "y":
        # y'' / (1 + y'²)^(3/2)
        speed = graph.call("sqrt", first * first + 1)
        place: Vec = origin + axis * parameter + axis.turned() * f
        return Bend(place, (axis + axis.turned() * first) / speed, second / (speed * speed * speed))
    # (r² + 2 r'² - r r'') / (r² + r'²)^(3/2), in parts along and across r.
    part = unit_vector(graph, parameter)
    radial = axis * part.x + axis.turned() * part.y
    speed = graph.call("sqrt", f * f + first * first)
    bend = f * f + first * first * 2 - f * second
    tangent = (radial * first + radial.turned() * f) / speed
    return Bend(origin + radial * f, tangent, bend / (speed * speed * speed))


def arc_of(scene: Carried, curve: Curve, parameter: Term, panel: float) -> Term:
    """The arc of a curve from the reference value of a parameter to the present one; `panel`: of the quadrature."""
    graph, formula = scene.graph, formula_of(scene, curve)

    def speed(f: Any, first: Any) -> Any:
        return first * first + (1.0 if curve.kind == "y" else f * f)

    arc = Integral(lambda u: math.sqrt(speed(*formula.numbers(u)[:2])), parameter.value, panel)
    name = f"arc{len(graph.slopes)}"
    graph.others[name] = arc.at
    graph.slopes[name] = lambda u: graph.call("sqrt", speed(*formula.at(u)[:2]))
    return graph.call(name, parameter)


def off_curve(scene: Carried, surface: Surface, curve: Curve, point: Vec) -> Term:
    """What vanishes where a place is on the curve: y - y(x), or r - r(theta), m."""
    x, y = seen_from(scene, surface, point)
    value = formula_of(scene, curve).at(parameter_of(scene, surface, curve, point))[0]
    return y - value if curve.kind == "y" else scene.graph.call("sqrt", x * x + y * y) - value
