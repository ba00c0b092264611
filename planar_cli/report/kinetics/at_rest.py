"""When a page says that everything is at rest: where speeds would stand in its equations otherwise."""

from __future__ import annotations

from collections.abc import Collection

import sympy as sp

from planar_cli.equation.kinematics.motion import Motion
from planar_cli.equation.system.system import System
from planar_cli.problem.scene.turning_planes import goes_round
from planar_cli.report.equations.numeric import vanishing
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.solution import InstantSolution


def said_at_rest(instant: InstantSolution, last: Stage | None, system: System) -> str:
    """What is said beside the heading of a position of rest, where a velocity would matter."""
    trial, nothing = instant.trial, set(vanishing(last) if last is not None else ())
    for block in last.blocks if last is not None else ():
        nothing -= {u for u in block.unknowns if any(w.source == "closure" for w in block.equations)}
    moving = any(v for t in trial.velocities[:1] for v in t.values.values())
    rests = instant.instant.at_rest and not moving and bool(trial.velocities)
    if not rests or not speeds_matter(system, nothing):
        return ""
    round_ = goes_round(instant.instant.scene.problem)
    return "at rest in this plane, which goes round" if round_ else "at rest: all velocities are zero"


def balance(system: System, stage: Stage) -> str:
    """What is said beside the heading of sums of forces and moments of bodies that are all in equilibrium; "": they are
    not.
    """
    sums = [w for block in stage.blocks for w in block.equations if w.law in ("force", "moment")]
    if not sums or not all(system.balanced(body) for w in sums for body in w.bodies):
        return ""
    return f"free-body diagram; ΣF = 0{', ΣM = 0' if any(w.law == 'moment' for w in sums) else ''}"


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
