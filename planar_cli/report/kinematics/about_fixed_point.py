"""The acceleration of the mass centre of a body, also of one that turns about a point at rest."""

from __future__ import annotations

import sympy as sp

from planar_cli.problem.scene.geometry import Vec
from planar_cli.solve.solution import InstantSolution


def about_fixed_point(instant: InstantSolution, body: str) -> list[tuple[Vec, sp.Expr]]:
    """α × r and -ω² r of the mass centre of a body of which a point rests, where no equation of the plan has them."""
    scene, motion = instant.instant.scene, instant.trial.system.motion
    model = scene.bodies[body]
    if motion is None or not scene.rigid(body):
        return []
    for name, point in scene.points.items():
        if body not in scene.owners.get(name, ()) or motion.acceleration(point, body) != Vec(sp.S.Zero, sp.S.Zero):
            continue
        arm = model.center - point
        twist = motion.accelerations[body].angular, motion.velocities[body].angular
        parts = [(Vec(-arm.y, arm.x), sp.sympify(twist[0])), (Vec(-arm.x, -arm.y), sp.sympify(twist[1]) ** 2)]
        rests = all(instant.value.known(p) == 0 for p in (arm.x, arm.y))
        return [] if rests else [(way, part) for way, part in parts if instant.value.known(part) != 0]
    return []


def acceleration_of_centre(instant: InstantSolution, body: str, reversed_sense: bool) -> Vec | None:
    """That of the mass centre of a body, or its opposite; None: none is known."""
    motion = instant.trial.system.motion
    if motion is None:
        return None
    a = motion.acceleration(instant.instant.scene.bodies[body].center, body)
    return -a if reversed_sense else a
