"""Pin reactions in the components that say most: along and across the way their point can move.

The pin at the end of a crank can only move across the crank, a slider's pin only along its guide. An ideal joint's
reaction does its work through that one component; resolved so, the other one stays out of most equations.
"""

from __future__ import annotations

from dataclasses import replace

from planar_cli.equation.scene.scene import Scene
from planar_cli.problem.scene.facts import Action, Facts, Push
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND


def natural_pushes(scene: Scene, facts: list[Facts], plain: frozenset[str]) -> tuple[Push, ...]:
    """All pushes, pins turned along and across where that is known. `plain`: joints whose x and y are asked for."""
    joinings = [j for f in facts for j in f.joinings]
    pivots = {
        j.mover: j.point for j in joinings if j.base == GROUND and j.path is None and j.turns and j.rolling is None
    }
    tracks = {j.mover: j.path.tangent for j in joinings if j.base == GROUND and j.path is not None and not j.turns}
    found: list[Push] = []
    for push in (p for f in facts for p in f.pushes):
        along = None if push.kind != "component" or push.joint in plain else _along(scene, push, pivots, tracks)
        found.append(push if along is None else _turned(push, along))
    return tuple(found)


def _along(scene: Scene, push: Push, pivots: dict[str, Vec], tracks: dict[str, Vec]) -> Vec | None:
    """The direction of the link or across the guide; None where x and y are as good."""
    bodies = [a.body for a in push.actions]
    if GROUND in bodies:
        return None
    place = push.actions[0].point
    for body in bodies:
        along = None
        if body in pivots:
            arm = place - pivots[body]
            if not scene.is_zero(arm.dot(arm)):
                along = arm / scene.length(arm)
        elif body in tracks:
            along = -tracks[body].turned()
        if along is not None:
            return None if scene.is_zero(along.x) or scene.is_zero(along.y) else along
    return None


def _turned(push: Push, along: Vec) -> Push:
    acting = push.actions[0].force
    assert acting is not None
    first = acting.y == 0
    direction = along if first else along.turned()
    sign = {a.body: 1 if i == 0 else -1 for i, a in enumerate(push.actions)}
    actions = tuple(Action(a.body, a.point, direction * sign[a.body], a.couple) for a in push.actions)
    return replace(push, name=push.name[:-1] + ("n" if first else "t"), actions=actions)
