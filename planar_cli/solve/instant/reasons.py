"""Why a mass centre has the acceleration that is written for it, in words."""

from __future__ import annotations

from planar_cli.equation.led import led, root_edge
from planar_cli.equation.system import System


def acceleration_words(system: System, body: str, centre: str, axis: str = "") -> str:
    """What a line says that gives the acceleration of a mass centre, or one component of it: why it is so, where that
    is short.
    """
    called = f"the mass centre of {body}" if "_" in centre else centre
    why = "" if axis else led(system, body) or _held(system, body)
    return why or f"acceleration of {called}{f' along {axis}' if axis else ''}"


def _held(system: System, body: str) -> str:
    """By a taut rope, or a link, that starts from rest."""
    edge, motion = root_edge(system, body), system.motion
    if edge is None or edge.joining is None or edge.body != body or motion is None:
        return ""
    j, v = edge.joining, motion.velocities[body].linear
    tied = any(push.kind == "tension" for push in system.modes[j.joint].facts.pushes)
    if not tied or v.x != 0 or v.y != 0:
        return ""
    return f"{j.place} has no acceleration along {system.scene.problem.called(j.joint)}"
