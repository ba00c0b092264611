"""What a find asks: the quantities that stand in it; what a file is about."""

from __future__ import annotations

from planar_cli.equation.system.system import mode_of
from planar_cli.joints.base import Joint
from planar_cli.problem.checks.formulas import formulas
from planar_cli.problem.language.expression import Name, Quantity, Relation, Side
from planar_cli.problem.language.outermost import quantities_in
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Find, Line, Problem

FORCES = frozenset(("N", "friction", "reaction", "moment", "tension", "force", "power", "mode"))
"""Quantities that are about forces."""


def has_mass(problem: Problem) -> bool:
    """Does the file say of any body that it has mass?"""
    return any(b.mass is not None or b.weight is not None or b.any_mass for b in problem.bodies)


def is_pure_kinematics(problem: Problem) -> bool:
    """Is it all about places and motion, without masses, loads and forces?"""
    if problem.loads or has_mass(problem):
        return False
    words = (n.word for f in formulas(problem) for n in walk(f.tree) if isinstance(n, Quantity))
    return not FORCES & set(words)


def names_anywhere(side: Side) -> set[str]:
    """All bare names of a side, also inside quantities and directions."""
    return {node.name for node in walk(side) if isinstance(node, Name)}


def names_of_directions(problem: Problem) -> set[str]:
    """All names with which the directions of straight surfaces are written."""
    lines = [s.shape for s in problem.surfaces if isinstance(s.shape, Line)]
    return {name for line in lines for name in names_anywhere(line.angle)}


def asked_by_axis(problem: Problem, joints: tuple[Joint, ...]) -> frozenset[str]:
    """Joints of whose reaction just one of x and y is asked: those components stay."""
    names = set()
    for find in problem.find:
        for q in quantities_in(find.found.what):
            if q.word == "reaction" and q.parts and q.parts[0].kind in ("x", "y"):
                names.add(q.things[0])
    return frozenset(ours for ours, name in alias_of(problem.joints, joints).items() if name in names)


def alias_of(joints: tuple[Joint, ...], named: tuple[Joint, ...]) -> dict[str, str]:
    """Our own name of each joint to the file's."""
    return {ours.name: theirs.name for ours, theirs in zip(named, joints, strict=True)}


def asks_mode(find: Find) -> bool:
    """Is it asked in which mode a joint is: `mode(C)`, or `mode(C) = stick`?"""
    what = find.found.what
    if isinstance(what, Relation):
        return mode_of(what) is not None
    return isinstance(what, Quantity) and what.word == "mode"
