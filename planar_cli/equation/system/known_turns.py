"""Which way a body turns, where that is known before anything is worked out: then that way counts as positive.

A body that is let go or pulled from rest, and that the ground alone holds at a point or lets roll, turns the way in
which its loads turn it about that point: all of them the same way.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.bounds import certain_sign
from planar_cli.equation.kinematics.motion import Motion, TreeBuilder
from planar_cli.equation.kinematics.moving import all_wrenches
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.system.system import Statements
from planar_cli.equation.system.told_turns import rolling_as_asked, rolling_as_given
from planar_cli.problem.implied.stated_clockwise import states_clockwise
from planar_cli.problem.language.expression import AtRest, Quantity, Relation
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.facts import Joining, Mode
from planar_cli.problem.scene.scene import GROUND, Round

STEADY = ("force", "torque", "weight")
"""Loads that do not wait for a motion."""
MOVING = ("v", "a", "omega", "alpha", "x", "y", "r", "theta", "dot", "ddot")
"""Quantities of places and motion: where one of them is stated, that tells the motion."""


def with_known_turns(
    builder: TreeBuilder, scene: Scene, statements: Statements, modes: Iterable[tuple[Any, tuple[Mode, ...]]]
) -> TreeBuilder:
    """The same builder, in which the only body of a scene counts clockwise where it is known to turn so; in a general
    position as its coordinates do. `modes`: of each joint or load.
    """
    if scene.displacement is not None:
        builder.clockwise = scene.displacement.clockwise
        return builder
    builder.clockwise = frozenset(scene.bodies) if states_clockwise(scene.problem) else frozenset()
    modes = tuple(modes)
    builder.clockwise |= rolling_as_given(scene, statements, modes) | frozenset(scene.problem.turning)
    asked = rolling_as_asked(scene, statements, modes)
    if asked:
        builder.clockwise = frozenset(wheel for wheel, sense in asked.items() if sense < 0)
        builder.known_senses = frozenset(scene.bodies)
    pivot = _pivot(scene, [found for _, found in modes]) if _starts(scene, statements) else None
    return builder if pivot is None else _as_loaded(builder, scene, pivot)


def turns_as_loaded(builder: TreeBuilder, scene: Scene, statements: Statements, modes: Iterable[Mode]) -> bool:
    """Is it known which way the only body of a scene begins to turn, now that of the modes of its contact that which
    holds is known: it rolls, or turns about the point where it sticks? Then the builder counts so.
    """
    if builder.clockwise or builder.known_senses or scene.displacement is not None or not _starts(scene, statements):
        return False
    pivot = _pivot(scene, [(mode,) for mode in modes])
    return pivot is not None and bool(_as_loaded(builder, scene, pivot).known_senses)


def _as_loaded(builder: TreeBuilder, scene: Scene, pivot: Joining) -> TreeBuilder:
    """The builder, in which the only body counts the way in which all loads turn it about the point that holds it."""
    (body,) = scene.bodies
    motion = Motion(builder.build((pivot,)), scene.center, scene.arms.between, {})
    still = dict.fromkeys(motion.tree.velocity_unknowns(), sp.S.Zero)
    motion = Motion(motion.tree, scene.center, scene.arms.between, still)
    turning = {
        _sign(scene, sp.sympify((w.point - pivot.point).cross(w.force) if w.force is not None else 0) + w.couple)
        for w in all_wrenches(scene, motion, scene.valuations[0])
    }
    # Where the sense rests on what is sought, it counts as it did in the part of the file that was told before.
    if turning - {0} == {-1} or (None in turning and body in scene.problem.clockwise):
        builder.clockwise = frozenset((body,))
    if turning - {0} in ({1}, {-1}):
        builder.known_senses = frozenset((body,))
    return builder


def _starts(scene: Scene, statements: Statements) -> bool:
    """Does one body alone start from rest, under loads that are there from the beginning? Over time only a round one
    counts so, whose angle is that by which it has turned.
    """
    problem, stated = scene.problem, (r for r, _ in statements.relations)
    if len(problem.bodies) != 1 or not all(load.kind in STEADY and load.during is None for load in problem.loads):
        return False
    if any(map(_tells_motion, stated)):
        return False
    if problem.states:
        first = problem.states[0].relations
        rests = any(isinstance(s, AtRest) and s.body is None for s in first)
        return rests and isinstance(problem.bodies[0].shape, Round) and not problem.coordinates
    return statements.rest == (None,) and not statements.equilibrium and not statements.extremes


def _tells_motion(relation: Relation) -> bool:
    nodes = (node for side in (relation.left, relation.right) for node in walk(side))
    return any(isinstance(node, Quantity) and node.word in MOVING for node in nodes)


def _pivot(scene: Scene, modes: list[tuple[Mode, ...]]) -> Joining | None:
    """The one joint with the ground, about which a body turns or over which it rolls; None: it is held otherwise."""
    if len(modes) != 1 or len(modes[0]) != 1:
        return None
    facts = modes[0][0].facts
    if len(facts.joinings) != 1 or facts.rows:
        return None
    (joining,) = facts.joinings
    turns = joining.turns and joining.path is None and joining.drift is None and joining.pace is None
    return joining if turns and {joining.mover, joining.base} == {GROUND, *scene.bodies} else None


def _sign(scene: Scene, moment: sp.Expr) -> int | None:
    """The sign of a moment, whatever its letters are; None: that is open."""
    if moment == 0:
        return 0
    if scene.problem.states:
        # From the start on.
        return certain_sign(moment.xreplace({scene.ledger.symbols["t"]: sp.Symbol("t", positive=True)})) or None
    if scene.ledger.letters or scene.ledger.sought:
        return certain_sign(moment) or None
    number = scene.valuations[0].known(moment)
    return None if number is None else (number > 0) - (number < 0)
