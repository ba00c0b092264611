"""When a page says that everything is at rest: where speeds would stand in its equations otherwise."""

from __future__ import annotations

from collections.abc import Collection

import sympy as sp

from planar_cli.equation.motion import Motion
from planar_cli.equation.system import System


def speeds_matter(system: System, still: Collection[sp.Symbol]) -> bool:
    """Does something begin to move so that speeds would bring terms into its acceleration: does a body turn, or a point
    run on a curve? `still`: accelerations that are zero.
    """
    if all(a in still for a in system.tree.acceleration_unknowns()):
        return False
    assert system.motion is not None
    moving = Motion(system.tree, system.motion.center, system.motion.arm, {})
    speeds = set(system.tree.velocity_unknowns()) - _held(system, still)
    if any(twist.angular.free_symbols & speeds for twist in moving.velocities.values()):
        return True
    return any((a.linear.x + a.linear.y).free_symbols & speeds for a in moving.accelerations.values())


def _held(system: System, still: Collection[sp.Symbol]) -> set[sp.Symbol | None]:
    """The angular velocities of bodies that what joins them keeps from turning: their angular acceleration is zero, and
    the file does not say so of this instant alone.
    """
    stated = [e for c in system.acceleration_conditions() if c.kind == "given" for e in c.rows()]
    said = set().union(*(e.free_symbols for e in stated))
    return {e.spin for e in system.tree.edges if e.spin_rate in still and e.spin_rate not in said}
