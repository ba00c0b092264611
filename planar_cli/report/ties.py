"""What a link or a taut cord between two points says of their velocities and accelerations."""

from __future__ import annotations

from planar_cli.equation.plain import identically_zero
from planar_cli.equation.system import System
from planar_cli.problem.facts import Joining
from planar_cli.problem.scene import GROUND
from planar_cli.report.blocks import Line, Name, line


def tie_words(j: Joining, level: str, named: str, own: Name, system: System) -> Line:
    """`named`: what the tie is called; `level`: velocity or acceleration; `own`: that of its mover's end."""
    keeps = f"{named} keeps its length"
    if j.base == GROUND and level == "velocity":
        return line(f"{keeps}, so that along it ", own, " has no component")
    if j.base == GROUND:
        return line(f"{keeps}; along it ", own, f" is the normal acceleration of {j.place}")
    if level == "velocity":
        return line(f"{keeps}, so that along it the velocities of both ends agree")
    if not _swings(j, system):
        return line(f"{keeps}, so that along it the accelerations of both ends agree")
    return line(f"{keeps}; along it the accelerations of its ends differ by v²/l of their relative motion")


def _swings(j: Joining, system: System) -> bool:
    """May one end move across the tie, seen from the other?"""
    assert system.motion is not None
    assert j.path is not None
    far = system.scene.point(j.far) if j.far else j.point
    relative = system.motion.velocity(j.point, j.mover) - system.motion.velocity(far, j.base)
    return not identically_zero(j.path.tangent.dot(relative))
