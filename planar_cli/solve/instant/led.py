"""Points that are led along straight lines of the ground, and what joins two of them.

A rigid link or a taut cord between two such points keeps its length: with d = r_B - r_A

    d · d = l²,   d · (v_B - v_A) = 0,   d · (a_B - a_A) = -|v_B - v_A|²

(An Introduction to Planar Dynamics, 1.6: a constraint is written in coordinates and differentiated).
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from planar_cli.equation.algebra.plain import tidy
from planar_cli.equation.system.conditions import Condition
from planar_cli.equation.system.system import System
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.solve.instant.written import Written

OF_LENGTH = "the square of its length, differentiated"
"""The words of a relation whose sides are half the rate of a squared length: m²/s, of accelerations m²/s²."""


def led_by_ground(system: System, body: str) -> tuple[Vec, ...]:
    """The direction of the straight line of the ground along which a body is led that does not turn: across it nothing
    moves.
    """
    if system.scene.rigid(body):
        return ()
    joinings = (j for mode in system.modes.values() for j in mode.facts.joinings)
    paths = (j.path for j in joinings if j.mover == body and j.base == GROUND and j.drift is None)
    return tuple(path.tangent for path in paths if path is not None and path.curvature == 0)


def is_between_led(j: Joining, system: System) -> bool:
    """Does a link or a taut cord join two points that are led along straight lines which are not parallel?"""
    if j.path is None or GROUND in (j.base, j.mover) or not j.far or j.path.curvature == 0:
        return False
    if not any(push.kind == "tension" for push in system.modes[j.joint].facts.pushes):
        return False
    ways = [led_by_ground(system, body) for body in (j.base, j.mover)]
    return all(len(way) == 1 for way in ways) and tidy(ways[0][0].cross(ways[1][0])) != 0


def reach_of(j: Joining, system: System) -> Vec:
    """From the far end of a link or cord to the point of the joint."""
    far = system.scene.point(j.far)
    return Vec(tidy(j.point.x - far.x), tidy(j.point.y - far.y))


def of_length(condition: Condition, system: System, number: Callable[[], int]) -> Written | None:
    """d · (v_B - v_A) = 0 or d · (a_B - a_A) = -|v_B - v_A|² of what joins two led points; None: it is no
    such tie, or its place is one of numbers, which hide their unit.
    """
    if condition.kind != "closure" or system.motion is None:
        return None
    j = next((j for j in system.tree.closures if j.joint == condition.text), None)
    if j is None or not is_between_led(j, system):
        return None
    motion, reach, far = system.motion, reach_of(j, system), system.scene.point(j.far)
    if not all(part.free_symbols for part in (reach.x, reach.y) if part != 0):
        return None
    velocity = motion.velocity(j.point, j.mover) - motion.velocity(far, j.base)
    right = sp.S.Zero
    if condition.residual != motion.closure_velocity(j):
        right = -tidy(velocity.dot(velocity))
        velocity = motion.acceleration(j.point, j.mover) - motion.acceleration(far, j.base)
    left = sp.Add(*(tidy(one * other) for one, other in ((reach.x, velocity.x), (reach.y, velocity.y))))
    return Written(number(), "relation", (), condition.text, OF_LENGTH, left, right, "closure", place=condition.place)
