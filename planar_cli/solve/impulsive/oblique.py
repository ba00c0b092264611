"""Particles that strike a rough slope: a course resolves the blow along the tangent t and the normal n of the slope."""

from __future__ import annotations

from typing import Any

import sympy as sp

from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND


def oblique_strikes(scene: Any) -> dict[str, Vec]:
    """By the name of a particle that nothing holds, the tangent of the rough slope of the ground that it strikes, to
    the right; of one that strikes several things none.
    """
    found: dict[str, list[Vec]] = {}
    held: set[str] = set()
    for joint in scene.problem.joints:
        partners = [scene.carrier(p) for p in getattr(joint, "between", ())]
        if not joint.strikes:
            held |= set(scene.bodies)
            continue
        normal = scene.meeting(joint.between, joint.normal, joint.mark, joint.at, joint.during).normal
        rough = getattr(joint, "mu", None) is not None
        slant = rough and not any(scene.is_zero(part) for part in (normal.x, normal.y))
        for body in partners:
            if body != GROUND and GROUND in partners and not scene.rigid(body):
                found.setdefault(body, []).append(_tangent(scene, normal) if slant else Vec(sp.S.One, sp.S.Zero))
    slanting = {b: ways[0] for b, ways in found.items() if len(ways) == 1 and b not in held}
    return {b: way for b, way in slanting.items() if not scene.is_zero(way.y)}


def _tangent(scene: Any, normal: Vec) -> Vec:
    """To the right."""
    along: Vec = -normal.turned()
    return along if scene.sign(along.x) > 0 else -along
