"""Particles that ropes alone hold to others, and that are pressed across the straight line on which they move.

The arms of their weight and of what presses them are those of the place where they happen to be: in moments with other
bodies they stand for nothing, and go out by the balance across the line. A load that hangs is pulled along its line.
"""

from __future__ import annotations

from planar_cli.equation.system.system import System
from planar_cli.problem.scene.scene import GROUND


def pressed_across_lines(system: System) -> frozenset[str]:
    """The names of such particles on lines at rest."""
    scene = system.scene
    found = set()
    for edge in system.tree.edges:
        path = edge.joining.path if edge.joining is not None else None
        if path is None or edge.parent != GROUND or scene.rigid(edge.body) or not scene.is_zero(path.curvature):
            continue
        own = [p for p in system.pushes if any(a.body == edge.body for a in p.actions)]
        if any(p.kind != "tension" and {a.body for a in p.actions} - {edge.body, GROUND} for p in own):
            continue
        forces = [a.force for p in own for a in p.actions if a.body == edge.body and a.force is not None]
        if any(not scene.is_zero(path.tangent.cross(force)) for force in forces):
            found.add(edge.body)
    return frozenset(found)
