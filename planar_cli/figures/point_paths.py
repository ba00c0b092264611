"""The whole path of a point, where the file or the page tells it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

import sympy as sp

from planar_cli.equation.scene.curves import curve_place
from planar_cli.figures.asked_curves import whole_paths
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.orbits import orbit
from planar_cli.figures.paths import course_of, curve_of, path_of
from planar_cli.figures.smooth import smooth
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND, Circle, Curve
from planar_cli.report.document.marks import Spot
from planar_cli.solve.solved_problem import PartSolution

ROUND, STEPS = 96, 48
"""Places of a whole circle, and of a curve."""
ON = 1e-6
BEYOND = 0.3
"""A curve goes on beyond its origin and the point by this part of what lies between them."""


def way_of_point(part: PartSolution, drawn: Drawn, name: str, state: str) -> tuple[Spot, ...]:
    """Places along it; none: nothing tells it. `state`: the one in which it is there."""
    at = drawn.spot(drawn.scene.bodies[name].center if name in drawn.scene.bodies else drawn.scene.points[name])
    led = whole_paths(part).get(name) or (next(_led(drawn, name, at), ()) if at is not None else ())
    led = led or orbit(part, name if name in drawn.scene.bodies else drawn.scene.owner(name), state)
    found = led or course_of(drawn, name) or (curve_of(drawn, name) if name in drawn.scene.bodies else ())
    if found or part.motion is None:
        return found
    ways = [path_of(part.motion, part.run, name, a, b) for a, b in pairwise(part.motion.states)]
    return tuple(s for way in ways for s in way)


def _led(drawn: Drawn, name: str, at: Spot) -> Iterator[tuple[Spot, ...]]:
    """Round the pivot of its body, or along a surface at rest on which it is."""
    scene = drawn.scene
    owner = name if name in scene.bodies else scene.owner(name)
    for joint in scene.problem.joints:
        pivot = drawn.named(getattr(joint, "at", "") or "") if joint.kind == "pin" else None
        if pivot is not None and {GROUND, owner} <= set(getattr(joint, "between", ())):
            yield circle(pivot, math.dist(pivot, at))
    for surface in scene.problem.surfaces:
        shape = surface.shape
        if surface.body is None and isinstance(shape, Circle):
            center, radius = drawn.named(shape.center), drawn.length(shape.radius)
            if center is not None and radius and abs(math.dist(center, at) - radius) < ON * radius:
                yield circle(center, radius)
        elif surface.body is None and isinstance(shape, Curve) and shape.kind == "y":
            yield from _graph(drawn, shape, at)


def _graph(drawn: Drawn, shape: Curve, at: Spot) -> Iterator[tuple[Spot, ...]]:
    """A curve y(x) on which a place is, from its origin to there and beyond."""
    x, place = curve_place(drawn.scene, shape)

    def there(across: float) -> Spot | None:
        here = {x: sp.Rational(f"{across:.9g}")}
        return drawn.spot(Vec(place.x.subs(here), place.y.subs(here)))

    own = there(at[0])
    if own is None or math.dist(own, at) > ON * math.hypot(*at):
        return
    low, high = min(0.0, at[0]), max(0.0, at[0])
    more = BEYOND * (high - low)
    yield smooth(lambda share: there(low - more + (high - low + 2 * more) * share), STEPS)


def circle(center: Spot, radius: float) -> tuple[Spot, ...]:
    """All of it."""
    steps = (2 * math.pi * i / ROUND for i in range(ROUND + 1))
    return tuple((center[0] + radius * math.cos(w), center[1] + radius * math.sin(w)) for w in steps)
