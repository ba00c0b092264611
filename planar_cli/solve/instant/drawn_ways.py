"""The directions along which a teacher would sum forces on a group of bodies, beside the axes.

along and across a contact that rubs, or a tie      the force as it is drawn, and its perpendicular
along a smooth guide                                 there the force of the guide has no part
along and across the line to a centre                of a particle in polar coordinates
"""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import CERTAIN
from planar_cli.problem.scene.facts import Joining, Push
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.solve.instant.led import led_by_ground
from planar_cli.solve.instant.numbers import Numbers

MOST = 12
DRAWN = ("normal", "friction", "tension")
"""Kinds of reactions that are drawn as one line."""

Way = tuple[Vec, str]


def named_ways(system: System, numbers: Numbers, bodies: tuple[str, ...]) -> list[Way]:
    """Along and across the paths and contacts of the group's bodies, with what they are called."""
    scene = system.scene
    placed = ((e.components, e.body) for e in system.tree.edges if (e.body,) == bodies)
    found = [w for s, b in placed if s is not None for w in s.ways(scene.center_name(b))]
    for push in system.pushes:
        for action in push.actions:
            force = action.force
            if push.kind not in DRAWN or action.body not in bodies or force is None or not _slants(numbers, force):
                continue
            if push.kind == "tension":
                if push.member and all(a.body in bodies for a in push.actions):
                    continue  # within a group it is not drawn
                tie = push.member or scene.problem.called(push.joint)
                found += [(force, f"along {tie}"), (force.turned(), f"perpendicular to {tie}")]
            elif _several_at(system, push):
                found += [(force, f"along {push.name}"), *_along_guide(system, push, bodies)]
            else:
                way = "normal" if push.kind == "normal" else "contact"
                found += [(force, f"along the {way} at {push.place}"), *_along_guide(system, push, bodies)]
    return found[:MOST]


def goes_round(system: System, bodies: tuple[str, ...]) -> bool:
    """Is it one particle, which no straight guide leads?"""
    return len(bodies) == 1 and not system.scene.rigid(bodies[0]) and not led_by_ground(system, bodies[0])


def _several_at(system: System, push: Push) -> bool:
    """Do other joints press at the same place? Then "the normal" there says nothing."""
    return any(p.place == push.place and p.joint != push.joint and p.kind in DRAWN[:2] for p in system.pushes)


def _slants(numbers: Numbers, way: Vec) -> bool:
    return all(abs(numbers.value(p)) > CERTAIN for p in (way.x, way.y))


def _along_guide(system: System, push: Push, bodies: tuple[str, ...]) -> Iterator[Way]:
    """Along the guide of a particle, in which nothing rubs: rubbing has its own direction."""
    if push.kind != "normal" or len(bodies) > 1 or system.scene.rigid(bodies[0]):
        return
    if any(p.kind == "friction" and p.joint == push.joint for p in system.pushes):
        return
    joining = guided(system, bodies[0])
    if joining is not None and joining.joint == push.joint and joining.path is not None:
        straight = joining.path.curvature == 0
        led = straight and joining.base != GROUND
        yield joining.path.tangent, f"along {joining.base}" if led else f"along the path at {push.place}"


def guided(system: System, body: str) -> Joining | None:
    """How a particle is led along a path, of a body or of the ground; None: it is not."""
    for edge in system.tree.edges:
        if edge.body == body and edge.particle and not edge.backward and edge.joining is not None:
            return edge.joining if edge.joining.path is not None else None
    return None
