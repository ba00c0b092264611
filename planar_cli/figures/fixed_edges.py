"""Particles that the file fixes to the ground so that something strikes them: edges and stops, which are no balls."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from planar_cli.figures.drawn import Drawn
from planar_cli.figures.given_motion import Told
from planar_cli.joints.base import Joint
from planar_cli.problem.scene.scene import GROUND, Particle
from planar_cli.report.document.marks import Spot, Symbol

NEAR = 1e-9
UPRIGHT = math.pi / 2


def fixed_edges(drawn: Drawn, joints: Sequence[Joint]) -> dict[str, Symbol]:
    """Their signs, by their names: each with its edge to the side from which it is struck."""
    bodies = drawn.scene.bodies
    welded = {n for j in joints if is_fixing(j) for n in getattr(j, "between", ()) if n in bodies}
    named = {n: s for n in welded if isinstance(bodies[n].shape, Particle) and (s := drawn.spot(bodies[n].center))}
    struck = {n: way for n, at in named.items() for way in _ways(drawn, joints, n, at)}
    return {n: Symbol("edge", named[n], way - UPRIGHT) for n, way in struck.items()}


def is_fixing(entry: object) -> bool:
    """Does a joint hold a body on the ground?"""
    return isinstance(entry, Joint) and entry.kind == "weld" and GROUND in getattr(entry, "between", ())


def holds_an_edge(drawn: Drawn, entry: object, joints: Sequence[Joint]) -> bool:
    """Is it the joint that fixes one, whose sign has its ground?"""
    return is_fixing(entry) and not fixed_edges(drawn, joints).keys().isdisjoint(getattr(entry, "between", ()))


def _ways(drawn: Drawn, joints: Sequence[Joint], name: str, at: Spot) -> Iterator[float]:
    """The direction in which what strikes it is: across the contact, where its mass centre is or whence it comes."""
    for joint in joints:
        others = [n for n in getattr(joint, "between", ()) if n != name]
        normal = drawn.length(n) if (n := getattr(joint, "normal", None)) is not None else None
        if not joint.strikes or len(others) != 1 or normal is None or name not in getattr(joint, "between", ()):
            continue
        center = drawn.center(others[0]) or at
        far = (center[0] - at[0]) * math.cos(normal) + (center[1] - at[1]) * math.sin(normal)
        if abs(far) < NEAR:
            vx, vy = Told(drawn).vector("v", others[0]) or (0.0, 0.0)
            far = -vx * math.cos(normal) - vy * math.sin(normal)
        yield normal + (math.pi if far < -NEAR else 0.0)
