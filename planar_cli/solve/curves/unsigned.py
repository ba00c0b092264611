"""Sizes of which the file says that they are not negative: |e| is e where it writes a distance with it."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.common_factors import together
from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.scene.scene import Scene
from planar_cli.problem.language.expression import Quantity, Relation, Side
from planar_cli.problem.scene.scene import Polar, Problem

MOST_OPS = 60
"""Under a root of more operations no square is looked for in other angles."""


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


def divided(expr: sp.Expr) -> sp.Expr:
    """A fraction of sums of waves without the factors that both have: (11 + 2 cos 2 u - 12 cos u)/(3 - 2 cos u) is
    3 - 2 cos u.
    """
    above, below = sp.fraction(together(expr))
    if not any(f.is_Add and f.has(sp.sin, sp.cos) for f in sp.Mul.make_args(below)):
        return expr
    short = simplified(factored(_in_one_angle(above)) / factored(_in_one_angle(below)))
    return short if operations(short) < operations(expr) else expr


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
    """√(a²) as |a|, also where the square is written with double angles."""
    for base in (e.base, _in_one_angle(e.base)):
        root = sp.sqrt(factored(base))
        if not any(_is_root(p) for p in root.atoms(sp.Pow)):
            return root ** (2 * e.exp)
    return e


def _in_one_angle(base: sp.Expr) -> sp.Expr:
    """Sums of waves without double angles and squares of sines."""
    doubled = {f: sp.expand_trig(f) for f in base.atoms(sp.sin, sp.cos) if f.args[0].as_coeff_Mul()[0] == 2}
    if longer(base, MOST_OPS):
        return base
    whole = expanded(base.xreplace(doubled))
    sines = [p for p in whole.atoms(sp.Pow) if isinstance(p.base, sp.sin) and p.exp.is_Integer and p.exp % 2 == 0]
    return expanded(whole.xreplace({p: (1 - sp.cos(*p.base.args) ** 2) ** (p.exp / 2) for p in sines}))
