"""Speeds handed over where what acts changes: a free speed of one regime, read in the motion of another."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.kinematics.motion import Edge, Motion, Tree
from planar_cli.equation.scene.scene import Scene
from planar_cli.problem.scene.geometry import Vec


def edges_of(tree: Tree) -> dict[sp.Symbol, Edge]:
    """The edges of a tree by each of their velocity unknowns."""
    found = {}
    for e in tree.edges:
        found.update({s: e for s in (e.slide, e.rise, e.spin) if s is not None})
    return found


def transferred_speed(
    speed: sp.Symbol, edge: Edge, motion: Motion, scene: Scene, after: bool = False
) -> sp.Expr | None:
    """A velocity unknown of some tree in another motion of the same bodies; None: it is none of the tree's own.

    `after`: read what stands where accelerations stand, the velocities after a blow.
    """
    twists = motion.accelerations if after else motion.velocities
    point_motion = motion.acceleration if after else motion.velocity
    if speed == edge.spin:
        return twists[edge.body].angular * edge.turn
    if edge.joining is None:
        v = point_motion(scene.center(edge.body), edge.body)
        return v.x * edge.rightward if speed == edge.slide else v.y * edge.upward
    joining, path = edge.joining, edge.joining.path
    if path is None:
        return None
    relative: Vec = point_motion(joining.point, joining.mover) - point_motion(joining.point, joining.base)
    if joining.drift is not None:
        relative = relative - joining.drift
    along: sp.Expr = relative.dot(path.tangent)
    return along
