"""Sizes of which the file says that they are not negative: |e| is e where it writes a distance with it."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.factoring import factored
from planar_cli.equation.plain import simplified
from planar_cli.equation.scene import Scene
from planar_cli.problem.expression import Quantity, Relation, Side
from planar_cli.problem.scene import Polar, Problem


def unsigned(expr: sp.Expr, scene: Scene) -> sp.Expr:
    """A formula without the bars of those sizes."""
    expr = expr.replace(_is_root, _square_rooted)
    if not expr.has(sp.Abs):
        return expr
    distances = [scene.value(p.place.distance) for p in scene.problem.points if isinstance(p.place, Polar)]
    distances += [scene.value(side) for side in _magnitudes(scene.problem)]

    def plain(size: sp.Expr) -> sp.Expr:
        inside = size.args[0]
        for sign in (1, -1):
            if any(d.free_symbols and simplified(sign * inside / d).is_positive for d in distances):
                return sign * inside
        return size

    return expr.replace(lambda e: isinstance(e, sp.Abs), plain)


def _magnitudes(problem: Problem) -> list[Side]:
    """What `motion` gives as the magnitude of a place."""
    relations = [law.statement for law in problem.motion if isinstance(law.statement, Relation)]
    return [
        r.right
        for r in relations
        if isinstance(r.left, Quantity) and r.left.word == "r" and [p.kind for p in r.left.parts] == ["mag"]
    ]


def _is_root(e: sp.Expr) -> bool:
    return bool(e.is_Pow and e.exp.is_Rational and e.exp.q == 2 and e.base.is_Add)


def _square_rooted(e: sp.Expr) -> sp.Expr:
    """√(a²) as |a|."""
    root = sp.sqrt(factored(e.base))
    return root ** (2 * e.exp) if not any(_is_root(p) for p in root.atoms(sp.Pow)) else e
