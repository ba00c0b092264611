"""Why a mass centre has the acceleration that is written for it: how its body is led, in words."""

from __future__ import annotations

from planar_cli.equation.motion import Edge
from planar_cli.equation.system import System
from planar_cli.problem.scene import GROUND


def acceleration_words(system: System, body: str, centre: str, axis: str = "") -> str:
    """What a line says that gives the acceleration of a mass centre, or one component of it: why it is so, where that
    is short.
    """
    called = f"the mass centre of {body}" if "_" in centre else centre
    why = "" if axis else _why(system, body)
    return why or f"acceleration of {called}{f' along {axis}' if axis else ''}"


def _why(system: System, body: str) -> str:
    """By the joint with the ground on which the body rests, directly or by others."""
    edges = {e.body: e for e in system.tree.edges}
    edge = edges.get(body)
    while edge is not None and edge.parent != GROUND:
        if edge.joining is None or edge.joining.path is not None or edge.joining.rolling is not None:
            return ""
        edge = edges.get(edge.parent)
    if edge is None or edge.joining is None or edge.joining.drift is not None:
        return ""
    j = edge.joining
    if j.rolling is not None:
        return f"{edge.body} rolls without slipping"
    if j.path is None:
        return f"{edge.body} turns about {j.place}" if j.turns and system.scene.rigid(edge.body) else ""
    return _held(system, edge) if edge.body == body else ""


def _held(system: System, edge: Edge) -> str:
    """By a taut rope, or a link, that starts from rest."""
    j, motion = edge.joining, system.motion
    assert j is not None
    tied = any(push.kind == "tension" for push in system.modes[j.joint].facts.pushes)
    if not tied or motion is None or motion.velocities[edge.body].linear.x != 0:
        return ""
    called = system.scene.problem.called(j.joint)
    return f"{j.place} has no acceleration along {called}"
