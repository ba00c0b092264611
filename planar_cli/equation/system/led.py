"""How a body is led by the joint with the ground on which it rests, in words: why its mass centre moves as it does."""

from __future__ import annotations

from planar_cli.equation.kinematics.motion import Edge
from planar_cli.equation.system.system import System
from planar_cli.problem.scene.scene import GROUND


def root_edge(system: System, body: str) -> Edge | None:
    """By which joint with the ground a body is led, itself or at the end of bodies on which it turns; None: it slides
    or rolls on another body, or nothing leads it.
    """
    edges = {e.body: e for e in system.tree.edges}
    edge = edges.get(body)
    while edge is not None and edge.parent != GROUND:
        if edge.joining is None or edge.joining.path is not None or edge.joining.rolling is not None:
            return None
        edge = edges.get(edge.parent)
    if edge is None or edge.joining is None or edge.joining.drift is not None:
        return None
    return edge


def rolls(system: System, body: str) -> bool:
    """Does it roll on the ground?"""
    joinings = (j for mode in system.modes.values() for j in mode.facts.joinings)
    return any({j.mover, j.base} == {body, GROUND} and j.rolling is not None and j.drift is None for j in joinings)


def led(system: System, body: str) -> str:
    """It rolls, or hangs on a wheel that does, or turns about a fixed point; "": neither."""
    edge = root_edge(system, body)
    if edge is None or edge.joining is None:
        return ""
    j = edge.joining
    if j.rolling is not None:
        return f"{body} {'rolls without slipping' if edge.body == body else f'moves with {edge.body}, which rolls'}"
    return f"{edge.body} turns about {j.place}" if turns_about_a_fixed_point(system, body) else ""


def turns_with_an_axis(system: System, body: str) -> bool:
    """Does a rigid body turn about a point of the ground, itself or fixed to one that does?"""
    edges = {e.body: e for e in system.tree.edges}
    edge = edges.get(body)
    while edge is not None and edge.joining is not None and edge.joining.only_turns and not edge.joining.turns:
        edge = edges.get(edge.parent)
    return edge is not None and system.scene.rigid(body) and turns_about_a_fixed_point(system, edge.body)


def turns_about_a_fixed_point(system: System, body: str) -> bool:
    """Does a rigid body itself turn about a point of the ground?"""
    edge = root_edge(system, body)
    j = None if edge is None or edge.body != body else edge.joining
    return j is not None and j.rolling is None and j.path is None and j.turns and system.scene.rigid(body)
