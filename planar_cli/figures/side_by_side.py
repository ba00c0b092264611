"""Particles that meet are at one place: just before that they are drawn side by side, each where it comes from."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from planar_cli.figures.drawn import Drawn
from planar_cli.figures.given_motion import Moving
from planar_cli.joints.base import Joint
from planar_cli.problem.scene import Particle
from planar_cli.problem.sketches import Slide
from planar_cli.report.marks import Spot

DOT, BOX = 5.5, 13.0
"""Half of how far apart they are drawn, on paper; of those that slide in a guide."""
WIDE, POINT = 400.0, 300.0
"""A scene is about so wide on paper; of one that is a point a metre is so long."""
CLOSE = 1e-9


def side_by_side(drawn: Drawn, moving: Moving | None, joints: Sequence[Joint], size: float) -> Mapping[str, Spot]:
    """By so much particles are drawn beside the place at which they meet, m. `size`: that of the scene, m."""
    found: dict[str, Spot] = {}
    for joint in joints:
        normal, between = getattr(joint, "normal", None), tuple[str, ...](getattr(joint, "between", ()))
        angle = drawn.length(normal) if normal is not None and joint.strikes else None
        if angle is None or len(between) != 2 or not _meet(drawn, between) or found.keys() & set(between):
            continue
        guided = any(isinstance(s, Slide) for j in joints for s in j.sketch(drawn.scene))
        half = (BOX if guided else DOT) * (size / WIDE if size > CLOSE else 1 / POINT)
        along = (math.cos(angle), math.sin(angle))
        first, second = (moving.vector("v", name) if moving is not None else None for name in between)
        coming = (first or (0.0, 0.0)), (second or (0.0, 0.0))
        closing = sum((a - b) * n for a, b, n in zip(*coming, along, strict=True))
        way = -half if closing >= 0 else half
        found[between[0]] = (way * along[0], way * along[1])
        found[between[1]] = (-way * along[0], -way * along[1])
    return found


def _meet(drawn: Drawn, between: tuple[str, ...]) -> bool:
    """Are both particles, in one place?"""
    bodies = [drawn.scene.bodies.get(name) for name in between]
    told = (drawn.spot(b.center) for b in bodies if b is not None and isinstance(b.shape, Particle))
    spots = [s for s in told if s is not None]
    return len(spots) == 2 and math.dist(spots[0], spots[1]) < CLOSE
