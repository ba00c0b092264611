"""A place on which a body will turn that it strikes with its lower edge, as a kerb or a sill: a step in the ground on
which it comes, and no pin.
"""

from __future__ import annotations

import math

from planar_cli.figures.drawn import Drawn
from planar_cli.figures.given_motion import Told
from planar_cli.figures.rings import extent_of
from planar_cli.figures.shapes import body_marks
from planar_cli.problem.scene.sketches import Hinge, Sketch
from planar_cli.report.document.marks import Hatched, spots_of

BEHIND, AHEAD = 0.8, 0.5
"""How far the ground goes on behind a step and ahead of it, in parts of the size of the body."""
SILL = 0.04
"""How high and how wide a sill is that holds a lower corner, in the same parts; and what is lower is no step."""
NEAR = 1e-9


def step_of(drawn: Drawn, entry: object, sketch: Sketch) -> Hatched | None:
    """The ground with the step; None: it is another joint. The body comes level, and is pinned from the blow on."""
    problem, during = drawn.scene.problem, getattr(entry, "during", None)
    begins = during is not None and bool(problem.states) and during[0] == problem.states[0].name
    if not isinstance(sketch, Hinge) or not sketch.grounded or not begins or problem.plane != "vertical":
        return None
    at, body = drawn.spot(sketch.at), next((b for n in sketch.bodies if (b := drawn.body(n)) is not None), None)
    center = drawn.spot(body.center) if body is not None else None
    if at is None or body is None or center is None:
        return None
    points = (p for p, place in drawn.scene.points.items() if place == body.center)
    told = (Told(drawn).vector("v", name) for name in (body.name, *points))
    vx, vy = next((v for v in told if v is not None), (0.0, 0.0))
    spots = [s for m in body_marks(drawn, body) for s in spots_of(m)]
    size, low = extent_of(spots), min(y for _, y in spots)
    if abs(vx) < NEAR or abs(vy) > NEAR or vx * (at[0] - center[0]) <= 0 or not low - NEAR <= at[1] < center[1]:
        return None
    ahead = math.copysign(size, vx)
    x, y = at
    behind, end = center[0] - BEHIND * ahead, x + AHEAD * ahead
    top, side = low + SILL * size, x + SILL * ahead
    beyond = ((x, y), (end, y)) if y > top else ((x, top), (side, top), (side, low), (end, low))
    places = ((behind, low), (x, low), *beyond)
    return Hatched(places if ahead > 0 else places[::-1])
