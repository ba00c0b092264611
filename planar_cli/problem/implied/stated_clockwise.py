"""`omega(wheel) = 3 rad/s cw`: the rotation of the only body of one instant counts as the file states it."""

from __future__ import annotations

from planar_cli.problem.language.expression import Number, Quantity, Relation, Scaled, Side
from planar_cli.problem.scene.scene import Problem

TURNS = ("omega", "alpha")


def states_clockwise(problem: Problem) -> bool:
    """Is all that is stated of the rotation of the only body stated `cw`?"""
    if len(problem.bodies) != 1 or problem.states:
        return False
    statements = (*(law.statement for law in problem.motion), *(problem.instant or ()))
    stated = [s for s in statements if isinstance(s, Relation) and _is_of_rotation(s)]
    return bool(stated) and all(is_clockwise(s.right) for s in stated)


def is_clockwise(side: Side) -> bool:
    """Is it a number that ends with `cw`?"""
    return isinstance(side, Number | Scaled) and side.sense < 0


def _is_of_rotation(relation: Relation) -> bool:
    left = relation.left
    return isinstance(left, Quantity) and left.word in TURNS and len(left.things) == 1
