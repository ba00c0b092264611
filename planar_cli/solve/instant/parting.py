"""How fast what has lifted off leaves the path along which it slid."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.kinematics.motion import Motion
from planar_cli.problem.scene.facts import Joining, Path, Test


def parting(motion: Motion, test: Test) -> sp.Expr | None:
    """The acceleration with which what a test is about leaves its path; None: it is about something else."""
    if test.joining is None or test.joining.path is None:
        return None
    return test.sense * _parting(motion, test.joining, test.joining.path)


def _parting(motion: Motion, joining: Joining, path: Path) -> sp.Expr:
    """The acceleration with which the mover leaves the path, along its left normal."""
    point, mover, base = joining.point, joining.mover, joining.base
    gap = motion.velocity(point, mover) - motion.velocity(point, base)
    speed = (gap if joining.drift is None else gap - joining.drift).dot(path.tangent)
    bend = path.curvature * speed**2 + 2 * motion.velocities[base].angular * speed
    normal = path.tangent.turned()
    pace = 0 if joining.pace is None else joining.pace.dot(normal)
    apart = motion.acceleration(point, mover) - motion.acceleration(point, base)
    return sp.sympify(apart.dot(normal) - bend - pace)
