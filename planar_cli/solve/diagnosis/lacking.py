"""Why no motion passes through the states with the modes that are assumed."""

from __future__ import annotations

from collections.abc import Sequence

from planar_cli.errors import NoSolution
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.roots.chain import Branch
from planar_cli.solve.diagnosis.motions import clash, missing
from planar_cli.solve.diagnosis.undated import undated


def lacking(course: MotionEquations, branches: Sequence[Branch]) -> NoSolution | None:
    """What stands in the way of a motion, or is not told; None: neither is found. `branches`: solutions of the
    equations, of which none can be followed.
    """
    # To find statements that stand in each other's way the motion is solved without each of them.
    open_first = None if course.sought() else missing(course)
    clashing = None if branches or open_first is not None else clash(course, course.equations)
    return open_first or clashing or (missing(course) if course.sought() else None) or undated(course, branches)
