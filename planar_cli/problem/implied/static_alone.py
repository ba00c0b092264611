"""Contacts of which only the static coefficient is given: what depends on the kinetic one is not told."""

from __future__ import annotations

from typing import Any

from planar_cli.errors import Diagnostic, FileProblem
from planar_cli.problem.scene.scene import Problem


def static_alone(problem: Problem) -> list[Any]:
    """The joints with `mu_s` and no kinetic coefficient."""
    return [j for j in problem.joints if getattr(j, "mu_s", None) is not None and getattr(j, "mu_k", None) is None]


def kinetic_open(what: str, joints: list[Any]) -> Diagnostic:
    """What depends on coefficients that are not given."""
    names = " and ".join(j.name for j in joints)
    text = f"{what} depends on the kinetic friction at {names}, of which only `mu_s` is given"
    return Diagnostic(joints[0].mark, "PL636", text, "write `mu_k` too, or `mu` for both")


def demand_kinetic(problem: Problem) -> None:
    """FileProblem where a motion is to be followed and a kinetic coefficient is not given."""
    joints = static_alone(problem)
    if joints:
        raise FileProblem([kinetic_open("the motion", joints)])
