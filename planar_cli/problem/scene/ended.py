"""Forces of joints that end at a state: they have none just after it, so that the last one is meant."""

from __future__ import annotations

from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.language.walk import Tree, walk
from planar_cli.problem.scene.scene import Problem

FORCES = frozenset(("N", "friction", "reaction", "moment", "tension"))


def told_before(tree: Tree, problem: Problem, state: str) -> bool:
    """Does it hold the force of a joint or load that acts up to this state only?"""
    members = (*problem.joints, *problem.loads)
    until = {m.name for m in members if m.during is not None and m.during[1] == state}
    ended = until - {m.name for m in members if m.during is None or m.during[1] != state}
    return bool(ended) and any(
        isinstance(n, Quantity) and n.word in FORCES and n.things[0] in ended for n in walk(tree)
    )
