"""`a(B).y = -1.2 m/s^2`: a weight on a cord that is let go counts its motion downward, as the file states it goes."""

from __future__ import annotations

from planar_cli.problem.language.expression import AtRest, Negate, Number, Quantity, Relation, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.going import Going
from planar_cli.problem.scene.scene import Particle, Problem

DOWN = Going(0.0, -1.0, False)
PLACES = ("x", "y", "r", "v", "a")


def stated_downward(problem: Problem) -> dict[str, Going]:
    """The particles of one instant at rest that only cords hold, whose acceleration is stated as a number downward, and
    whose motion nobody asks; none in a scene with rigid bodies, which might turn against it.
    """
    stated = [s for s in problem.instant or () if isinstance(s, Relation)]
    rests = any(isinstance(s, AtRest) and s.body is None for s in problem.instant or ())
    bodies = [(b.name, b.shape) for b in problem.bodies]
    if not (stated and rests) or problem.coordinates or not all(isinstance(s, Particle) for _, s in bodies):
        return {}
    found = {}
    for name, shape in bodies:
        own = {name, getattr(shape, "place", name)}
        if any(_falls(s, own) for s in stated) and not _is_held(problem, own) and not _is_asked(problem, own):
            found[name] = DOWN
    return found


def _falls(relation: Relation, own: set[str]) -> bool:
    """Is its acceleration along y stated as a negative number?"""
    left = relation.left
    return (
        isinstance(left, Quantity)
        and left.word == "a"
        and len(left.things) == 1
        and left.things[0] in own
        and [p.kind for p in left.parts] == ["y"]
        and relation.operator == "="
        and _is_negative(relation.right)
    )


def _is_negative(side: Side) -> bool:
    negated = isinstance(side, Negate) and isinstance(side.operand, Number) and side.operand.value > 0
    return negated or (isinstance(side, Number) and side.value < 0)


def _is_held(problem: Problem, own: set[str]) -> bool:
    """Does anything but cords hold it?"""
    return any(
        j.kind != "rope" and own & {*getattr(j, "between", ()), getattr(j, "point", ""), getattr(j, "at", "")}
        for j in problem.joints
    )


def _is_asked(problem: Problem, own: set[str]) -> bool:
    nodes = (node for f in problem.find for node in walk(f.found.what))
    return any(isinstance(q, Quantity) and q.word in PLACES and own & set(q.things) for q in nodes)
