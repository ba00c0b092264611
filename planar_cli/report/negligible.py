"""Which finite forces of a problem have no impulse to speak of in a blow."""

from __future__ import annotations

from planar_cli.loads.base import Load
from planar_cli.problem.acting import acting_loads
from planar_cli.problem.scene import Problem

UNCOUNTED = ("drag",)
"""Kinds of loads that have no plural."""


def negligible(problem: Problem) -> str:
    """` (the impulse of the weights and the spring is negligible)`; "" where no finite force acts."""
    counts: dict[str, int] = {}
    for load in acting_loads(problem):
        if type(load).impulses is Load.impulses and _acts(load, problem):
            counts[load.kind] = counts.get(load.kind, 0) + 1
    named = [f"the {kind}{'s' if count > 1 and kind not in UNCOUNTED else ''}" for kind, count in counts.items()]
    if not named:
        return ""
    listed = ", ".join(named[:-1]) + " and " * bool(named[:-1]) + named[-1]
    return f" (the impulse of {listed} is negligible)"


def _acts(load: Load, problem: Problem) -> bool:
    """Is there such a force at all: weights act on what has mass, in a vertical plane?"""
    if load.kind != "weight":
        return True
    return problem.plane == "vertical" and not next(b for b in problem.bodies if b.name == load.name).is_massless
