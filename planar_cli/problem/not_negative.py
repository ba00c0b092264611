"""Constants under `unknowns` that can not be negative: coefficients of friction, and limits of it."""

from __future__ import annotations

from planar_cli.problem.expression import Name
from planar_cli.problem.scene import Problem

FRICTION = ("mu", "mu_s", "mu_k", "friction", "friction_torque")
"""Keys of joints that say how much friction there is at most."""


def not_negative(problem: Problem) -> frozenset[str]:
    """The names of the unknowns that stand there alone."""
    sides = (getattr(j, key, None) for j in problem.joints for key in FRICTION)
    named = {side.name for side in sides if isinstance(side, Name)}
    return frozenset(named & {u.name for u in problem.unknowns})
