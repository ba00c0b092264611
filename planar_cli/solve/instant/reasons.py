"""Why a mass centre has the acceleration that is written for it, in words."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.system.led import led, root_edge
from planar_cli.equation.system.system import System
from planar_cli.problem.scene.facts import Joining


def acceleration_words(system: System, body: str, centre: str, axis: str = "", component: sp.Expr = sp.S.Zero) -> str:
    """What a line says that gives the acceleration of a mass centre, or one component of it: why it is so, where that
    is short.
    """
    called = f"the mass centre of {body}" if "_" in centre else centre
    why = "" if axis else led(system, body) or _held(system, body, component)
    return why or f"acceleration of {called}{f' along {axis}' if axis else ''}"


def _held(system: System, body: str, component: sp.Expr) -> str:
    """By a taut rope, or a link, that starts from rest."""
    edge, motion = root_edge(system, body), system.motion
    if edge is None or edge.joining is None or edge.body != body or motion is None:
        return ""
    j, v = edge.joining, motion.velocities[body].linear
    tied = any(push.kind == "tension" for push in system.modes[j.joint].facts.pushes)
    if not tied or v.x != 0 or v.y != 0:
        return ""
    rope = system.scene.problem.called(j.joint)
    if edge.slide_rate not in component.free_symbols and _nothing_across(system, body, j):
        return f"no force acts across {rope}, and {j.place} has no acceleration along it"
    return f"{j.place} has no acceleration along {rope}"


def _nothing_across(system: System, body: str, rope: Joining) -> bool:
    """Has nothing that acts on a body a part along the way that a rope leaves free?"""
    if rope.path is None or system.reactions is None:
        return False
    forces = [w.force for w in system.wrenches if w.body == body and w.force is not None]
    pushes = (a for push, _ in system.reactions.pushes for a in push.actions)
    forces += [a.force for a in pushes if a.body == body and a.force is not None]
    return all(sp.sympify(f.dot(rope.path.tangent)).equals(0) for f in forces)
