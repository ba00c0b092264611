"""The equations of one body: what acts on it, less its inertia.

    Σ F - m a_G = 0        Σ M_O - (r_G × m a_G + I_G α) = 0

In a blow impulses stand for forces, the velocities after it for accelerations, and the momenta before it are among what
acts. (An Introduction to Planar Dynamics, equations 4.11, 4.33, 4.75.)
"""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.system.system import System
from planar_cli.problem.scene.geometry import Vec


def body_residuals(system: System, body: str) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Force and moment residuals of one body about the origin: Σ F - m a, Σ M - (r × m a + I α)."""
    assert system.motion is not None
    assert system.reactions is not None
    model = system.scene.bodies[body]
    x: list[sp.Expr] = []
    y: list[sp.Expr] = []
    moment: list[sp.Expr] = []

    def act(point: Vec, force: Vec | None, couple: sp.Expr, factor: sp.Expr) -> None:
        if force is not None:
            x.append(factor * force.x)
            y.append(factor * force.y)
            moment.append(factor * point.cross(force))
        if couple != 0:
            moment.append(factor * couple)

    for push, expr in system.reactions.pushes:
        for action in push.actions:
            if action.body == body:
                act(action.point, action.force, action.couple, expr)
    for wrench in system.wrenches:
        if wrench.body == body:
            act(wrench.point, wrench.force, wrench.couple, sp.S.One)
    if model.mass != 0:
        a = system.motion.acceleration(model.center, body)
        act(model.center, a, sp.S.Zero, -model.mass)
    if model.inertia != 0:
        moment.append(-model.inertia * system.motion.accelerations[body].angular)
    return sp.Add(*x), sp.Add(*y), sp.Add(*moment)
