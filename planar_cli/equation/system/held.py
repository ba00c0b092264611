"""Whether joints that stick keep everything where it is, so that all of it is in equilibrium."""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from planar_cli.equation.kinematics.motion import Motion
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.system.conditions import ACCELERATION, VELOCITY, joint_conditions
from planar_cli.equation.values.determined import told_by
from planar_cli.problem.scene.facts import Mode


def is_held(scene: Scene, motion: Motion, modes: Iterable[Mode]) -> bool:
    """Do the joints leave no velocity but zero, and with it no acceleration? The conditions on the accelerations have
    the coefficients of those on the velocities, and nothing beside them where nothing moves. What is driven, and what
    the file places by coordinates, is not held; nor is what is displaced over time. `motion`: with all velocities as
    unknowns.
    """
    tree = motion.tree
    if scene.displacement is not None and scene.displacement.coordinates:
        return False
    if any(e.components is not None for e in tree.edges) or any(b.varies for b in scene.bodies.values()):
        return False
    rows = [row for mode in modes for row in mode.facts.rows]
    speeds = tree.velocity_unknowns()
    found = [e for c in joint_conditions(tree, rows, motion, VELOCITY, scene.rigid) for e in c.rows()]
    if len(found) < len(speeds):
        return False
    second = [e for c in joint_conditions(tree, rows, motion, ACCELERATION, scene.rigid) for e in c.rows()]
    nothing = dict.fromkeys((*speeds, *tree.acceleration_unknowns()), sp.S.Zero)
    if any(sp.sympify(e).xreplace(nothing) != 0 for e in (*found, *second)):
        return False
    return not speeds or set(speeds) <= told_by(found, speeds, scene.valuations[0])
