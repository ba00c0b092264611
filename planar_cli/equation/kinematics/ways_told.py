"""Which way something goes, where the first state tells it: `v(P).x < 0` beside a speed that is given by its size."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import sympy as sp

from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.values.jets import Jet
from planar_cli.errors import FileProblem
from planar_cli.problem.language.expression import Relation, Side


def way_told(
    speed: sp.Symbol, read: Callable[[Side], Any], scene: Scene, led: Callable[[], Mapping[sp.Symbol, sp.Expr]]
) -> int:
    """+1 or -1, the sign of a speed that makes a relation of the first state true as drawn; 0: none tells it. `led`:
    the speeds that go with it, in parts of it.
    """
    first = next((s for s in scene.problem.states if not s.before), None)
    for relation in first.relations if first is not None else ():
        if isinstance(relation, Relation) and (way := _way(speed, relation, read, scene, led)):
            return way
    return 0


def _way(
    speed: sp.Symbol,
    relation: Relation,
    read: Callable[[Side], Any],
    scene: Scene,
    led: Callable[[], Mapping[sp.Symbol, sp.Expr]],
) -> int:
    """The same of one relation k v + c < 0, > 0 or = 0."""
    try:
        left, right = read(relation.left), read(relation.right)
    except FileProblem:
        # It speaks of other states, or of forces.
        return 0
    if not (isinstance(left, Jet) and isinstance(right, Jet)):
        return 0
    apart = sp.sympify(left.value - right.value)
    if _unknown(apart.xreplace({speed: sp.S.One}), scene):
        apart = apart.xreplace({x: factor * speed for x, factor in led().items()})
    slope = sp.diff(apart, speed)
    rest = apart.xreplace({speed: sp.S.Zero})
    if slope == 0 or slope.has(speed) or _unknown(slope, scene) or _unknown(rest, scene):
        return 0
    towards, offset = scene.sign(slope), scene.sign(rest)
    wanted = {"<": -1, "<=": -1, ">": 1, ">=": 1}.get(relation.operator, -offset)
    # What is already true at rest tells nothing.
    return towards * wanted if offset != wanted else 0


def _unknown(expr: sp.Expr, scene: Scene) -> bool:
    """Does it hold anything that has no sign before the motion is known?"""
    return any(value.known(expr) is None for value in scene.valuations)
