"""The arm of the middle of a rod is half the one of its end: r_G/A = 1/2 r_B/A = [0.2219, -0.0375] m."""

from __future__ import annotations

from collections.abc import Mapping

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.document.blocks import Line, Name, line


def half_of(own: str, arm: Vec, told: Mapping[str, Vec]) -> Line:
    """`1/2 r_B/A = ` for half of an arm from the same point that was told, by its name; empty: it is half of none.
    `own`: its own name.
    """
    for name, whole in told.items():
        same = name.partition("/")[2] == own.partition("/")[2]
        if same and all(expanded(2 * one - other) == 0 for one, other in ((arm.x, whole.x), (arm.y, whole.y))):
            return line("1/2 ", Name(name), " = ")
    return ()
