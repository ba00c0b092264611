"""A vane or a pipe: the way of a stream through a body."""

from __future__ import annotations

import math

from planar_cli.equation.scene.bodies import BodyModel
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.partners import sketch_of
from planar_cli.figures.rings import SMOOTH, Ring, moved_by
from planar_cli.problem.scene.sketches import Push


def led(rest: Drawn, body: BodyModel) -> Ring:
    """The way of a stream through a body, from where it enters to where it leaves: a vane, or a pipe."""
    scene = rest.scene
    flows = [
        s
        for load in scene.problem.loads
        if load.kind == "stream" and getattr(load, "body", "") == body.name
        for s in sketch_of(rest, load)
    ]
    ends = {f.inward: (rest.spot(f.at), rest.angle(f.direction)) for f in flows if isinstance(f, Push)}
    (a, way), (b, leaving) = ends.get(True, (None, None)), ends.get(False, (None, None))
    if a is None or b is None or way is None or leaving is None or math.dist(a, b) < 1e-9:
        return []
    # A curve that goes on as it comes in, and out as it leaves.
    reach = math.dist(a, b) * (0.55 if math.cos(leaving - way) > -0.2 else 0.9)
    c = moved_by(a, (reach * math.cos(way), reach * math.sin(way)))
    d = moved_by(b, (-reach * math.cos(leaving), -reach * math.sin(leaving)))
    found = []
    for i in range(SMOOTH + 1):
        t = i / SMOOTH
        parts = ((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t**3)
        found.append(
            (
                sum(p * q[0] for p, q in zip(parts, (a, c, d, b), strict=True)),
                sum(p * q[1] for p, q in zip(parts, (a, c, d, b), strict=True)),
            )
        )
    return found
