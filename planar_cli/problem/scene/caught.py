"""Pins and welds to the ground that take hold later: of which point of the body, its shape as drawn must tell."""

from __future__ import annotations

from typing import Any, Protocol

from planar_cli.errors import refuse
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.outlines import Outlined
from planar_cli.problem.scene.scene import GROUND, Outline, Plate, Problem, Rod, Round


class Catching(Outlined, Protocol):
    """A scene whose bodies are where the file draws them, or can be asked for it."""

    problem: Problem
    own_points: set[str]

    def point(self, name: str) -> Vec: ...


def demand_caught(scene: Catching) -> None:
    """A pin that takes hold of a body after the first state holds the point of it that is drawn there. FileProblem
    where the body, as drawn, has nothing there: then a fixed place was meant to which it comes, and which of its
    points is there by then the drawing does not tell.
    """
    problem = scene.problem
    for joint in problem.joints:
        partners, at = getattr(joint, "between", ()), getattr(joint, "at", "")
        if joint.touches or joint.strikes or GROUND not in partners or problem.holds_at_first(joint.during):
            continue
        if not at or at in scene.own_points:
            continue
        for body in (b.name for b in problem.bodies if b.name in partners):
            if _beside(scene, body, scene.point(at)):
                begins = joint.during[0] if joint.during is not None else ""
                text = f"{joint.name} takes hold of {body} at {begins}, and as drawn {body} has nothing at {at}"
                hint = (
                    f"begin with state {begins}, {body} drawn where it is then; or draw the point of {body} that is "
                    "caught and name it among its `points`"
                )
                raise refuse(joint.mark, "PL537", text, hint)


def _beside(scene: Catching, body: str, place: Vec) -> bool:
    """Is a place, as drawn, outside a disk, a rectangle or a rod? Of other shapes nothing is said."""
    match scene.shape(body):
        case Round(center=center, radius=radius) | Outline(rim=Round(center=center, radius=radius)):
            out, far = place - scene.carried(body, center), scene.value(radius)
            return _exceeds(scene, out.dot(out), far * far)
        case Plate(center=center, width=width, height=height) as shape:
            out, along = place - scene.carried(body, center), scene.along_plate(body, shape)
            reaches = (along.dot(out), scene.value(width) / 2), (along.cross(out), scene.value(height) / 2)
            return any(_exceeds(scene, reach * reach, half * half) for reach, half in reaches)
        case Rod(start=start, end=str(end)):
            first, last = scene.carried(body, start), scene.carried(body, end)
            along, out = last - first, place - first
            off, ahead = along.cross(out), along.dot(out)
            return not scene.is_zero(off) or scene.sign(ahead) < 0 or _exceeds(scene, ahead, along.dot(along))
    return False


def _exceeds(scene: Catching, one: Any, other: Any) -> bool:
    """Is it more, beyond the rounding of places?"""
    return not scene.are_same(one, other) and scene.sign(one - other) > 0
