"""Where rims are nearest to curves: the x or theta of the foot on the curve is a variable of the state.

It is found from the place of the rim's centre M at all times, touching or not: (M - c(u)) · c'(u) = 0.
"""

from __future__ import annotations

import math

from planar_cli.motion.scene.boundaries import Rim, boundaries
from planar_cli.motion.scene.carried import Carried
from planar_cli.motion.scene.coordinates import Tie
from planar_cli.motion.scene.curves import Formula, arc_of, bend_of, formula_of, seen_from
from planar_cli.motion.terms.terms import Term
from planar_cli.problem.scene.outlines import Bend
from planar_cli.problem.scene.scene import Curve
from planar_cli.records import record

TRIED, STEPS = 400, 60
"""Points of the curve among which the nearest is sought, and steps of Newton's method from there."""
ARC = 0.05
"""So far x (in parts of the drawing) or theta (rad) goes in one panel of the quadrature of an arc."""


@record
class Foot:
    """The point of a curve that is nearest to the centre of a rim."""

    bend: Bend
    """The curve there."""
    height: Term
    """How far the centre is to the left of the curve's tangent, m."""
    arc: Term
    """The arc of the curve from where it is drawn, towards growing x or theta, m."""
    tie: Tie
    """What keeps the foot below the centre."""


def feet_of(scene: Carried) -> dict[tuple[str, str], Foot]:
    """One for every round body that may touch a curve, by surface and body."""
    found: dict[tuple[str, str], Foot] = {}
    for joint in scene.problem.joints:
        between = getattr(joint, "between", ())
        for name in between:
            surface = scene.surfaces.get(name)
            if surface is None or not isinstance(surface.shape, Curve):
                continue
            for other in (b for b in between if b != name):
                rims = [b for b in boundaries(scene, other) if isinstance(b, Rim)]
                if len(rims) == 1 and (name, rims[0].body) not in found:
                    found[name, rims[0].body] = _foot(scene, name, surface.shape, rims[0])
    return found


def _foot(scene: Carried, name: str, curve: Curve, rim: Rim) -> Foot:
    surface, graph = scene.surfaces[name], scene.graph
    x, y = seen_from(scene, surface, rim.center)
    start = _nearest(formula_of(scene, curve), x.value, y.value, scene.extent)
    stem = f"foot_{rim.body}"
    variable = scene.variable(stem, start, scene.extent if curve.kind == "y" else 1.0)
    scene.own_variables[f"foot of {rim.body} on {name}"] = (variable, scene.variable(f"v_{stem}", 0.0, 0.0))
    bend = bend_of(scene, surface, curve, variable)
    reach = rim.center - bend.place
    title = f"the foot of {rim.body} on {name}"
    tie = Tie(title, graph.of(reach.dot(bend.tangent)))
    arc = arc_of(scene, curve, variable, ARC * (scene.extent if curve.kind == "y" else 1.0))
    return Foot(bend, graph.of(bend.tangent.cross(reach)), arc, tie)


def _nearest(formula: Formula, x: float, y: float, size: float) -> float:
    """The x or theta of the nearest point of the curve: the best of many, then Newton's method."""
    middle, span = (x, size) if formula.kind == "y" else (math.atan2(y, x), math.tau)
    tried = [middle + span * (2 * k / TRIED - 1) for k in range(TRIED + 1)]
    best = min(tried, key=lambda u: math.dist(_place(formula, u), (x, y)))
    step = span / TRIED
    for _ in range(STEPS):
        slope, bend = _slope(formula, best, x, y)
        move = -slope / bend if bend > 0 else -math.copysign(step, slope)
        best += max(-step, min(step, move))
    return best


def _place(formula: Formula, u: float) -> tuple[float, float]:
    f = formula.numbers(u)[0]
    return (u, f) if formula.kind == "y" else (f * math.cos(u), f * math.sin(u))


def _slope(formula: Formula, u: float, x: float, y: float) -> tuple[float, float]:
    """First and second derivative of half the squared distance."""
    f, d, dd = formula.numbers(u)
    if formula.kind == "y":
        return (u - x) + (f - y) * d, 1 + d * d + (f - y) * dd
    along, across = x * math.cos(u) + y * math.sin(u), y * math.cos(u) - x * math.sin(u)
    return (f - along) * d - across * f, d * d + (f - along) * dd - 2 * across * d + along * f
