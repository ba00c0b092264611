"""Which loads act in a scene, and the kind of load behind a wrench."""

from __future__ import annotations

from collections.abc import Container

from planar_cli.loads.base import Load, mode_key
from planar_cli.problem.scene.facts import Wrench
from planar_cli.problem.scene.scene import Problem
from planar_cli.registry import member


def acting_loads(problem: Problem, idle: Container[str] = ()) -> list[Load]:
    """The weight of every body, then the loads of the file but those that are `idle`, by the keys of their modes."""
    weight = member("loads", "weight")
    weights: list[Load] = [weight(name=b.name, during=None, mark=b.mark) for b in problem.bodies]
    return [*weights, *(x for x in problem.loads if mode_key(x.name) not in idle)]


def kind_of(wrench: Wrench) -> type[Load] | None:
    """The class of the load that a wrench comes from; None: friction, or the momentum that a body brings."""
    try:
        found: type[Load] = member("loads", wrench.kind)
    except KeyError:
        return None
    return found
