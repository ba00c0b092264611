"""What to say where a formula has no value, or a numerical method stops before its goal."""

from __future__ import annotations

from planar_cli.errors import NotReached, Undecided, undecided_at
from planar_cli.problem.scene.scene import Problem

COORDINATES = (
    "it may help to write places with `coordinates` that follow the motion (r and phi of an orbit), to give a rope "
    "`along: 90 deg` where its parts stay parallel, or to ask at one instant"
)
ZEROS = (
    "a length or a speed by which it divides may be zero there: points that coincide, what is at rest and has no "
    "direction or radius of curvature"
)


def without_value(problem: Problem, error: ArithmeticError) -> Undecided:
    """The find that is not decided, and what usually helps."""
    asked = ", ".join(f"`{f.name}`" for f in problem.find)
    if isinstance(error, NotReached):
        return undecided_at(problem.find[0].mark, f"{asked}: not decided, {error}; {COORDINATES}")
    return undecided_at(problem.find[0].mark, f"{asked}: not decided, a formula has no value in this position; {ZEROS}")
