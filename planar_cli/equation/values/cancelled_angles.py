"""Angles on which a formula does not depend: the directions of a whole scene that cancel in it."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import by_name
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.sample import anywhere
from planar_cli.errors import NoValue

DRAWS = (0, 50)
"""Where the numbers begin that are drawn for letters: two independent draws."""


def without_cancelled_angles(expr: sp.Expr, value: Valuation) -> sp.Expr:
    """The same formula where angles whose sines and cosines cancel are zero. `value`: numbers of what has some."""
    angles = {a for f in expr.atoms(sp.sin, sp.cos) for a in f.args if a.is_Symbol and a not in value.values}
    if not angles:
        return expr
    drawn = [
        value.extended({s: anywhere(first + i) for i, s in enumerate(by_name(expr.free_symbols - value.values.keys()))})
        for first in DRAWS
    ]
    for angle in by_name(angles):
        level = expr.xreplace({angle: sp.S.Zero})
        try:
            if all(here.is_zero(expr - level) for here in drawn):
                expr = level
        except NoValue:
            continue
    return expr
