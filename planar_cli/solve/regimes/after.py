"""On which side of an instant a quantity is read, where what acts changes there.

Places and velocities are the same on both sides. Accelerations, forces and modes are those just after: of what begins.
What a state itself states (N = 0 is reached) is read in what arrives, and so is the force of a joint that ends there.
"""

from __future__ import annotations

from collections.abc import Set

from planar_cli.equation.system.system import mode_of
from planar_cli.problem.checks.formulas import formulas
from planar_cli.problem.language.expression import Quantity, Relation
from planar_cli.problem.language.walk import Tree, walk
from planar_cli.problem.scene.scene import Problem

CONTINUOUS = frozenset(("x", "y", "r", "v", "theta", "omega", "KE", "PE", "momentum", "H", "mass", "I"))


def changes_at_once(tree: Tree, lasting: Set[str] = frozenset()) -> bool:
    """Does it hold anything that may jump when what acts changes? Forces of loads that are `lasting` do not."""
    quantities = [n for n in walk(tree) if isinstance(n, Quantity) and n.word not in CONTINUOUS]
    return any(q.word != "force" or q.things[0] not in lasting for q in quantities)


def asked_after(problem: Problem, state: str, lasting: Set[str] = frozenset()) -> bool:
    """Is anything asked of a state that may jump there? `lasting`: loads that act on both sides of it."""
    for formula in formulas(problem):
        for node in walk(formula.tree):
            if getattr(node, "at", None) == state and changes_at_once(node, lasting):
                return True
            if isinstance(node, Relation) and mode_of(node) is not None:
                sides = (node.left, node.right)
                if any(getattr(s, "at", None) == state for s in sides):
                    return True
    return False
