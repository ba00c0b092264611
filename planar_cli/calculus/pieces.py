"""Antiderivatives of functions given in pieces: continuous where the pieces meet."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import sympy as sp

from planar_cli.calculus.deciding import sign
from planar_cli.equation.algebra.plain import MANY, longer
from planar_cli.equation.values.exact import Valuation

MOST_PIECES = 40


def pieces(
    f: sp.Expr, x: sp.Symbol, find: Callable[[sp.Expr], sp.Expr | None], value: Valuation | None = None
) -> sp.Expr | None:
    """∫ f dx for one function in pieces (x < c1), (x < c2), … with growing ends, times and plus anything else."""
    if longer(f, 10 * MANY):
        return None
    still = {p: sp.Dummy(real=True) for p in sorted(f.atoms(sp.Piecewise), key=sp.default_sort_key) if not p.has(x)}
    back = {d: p for p, d in still.items()}
    own = f.xreplace(still)
    together = own if isinstance(own, sp.Piecewise) else sp.piecewise_fold(own)
    if not own.has(sp.Piecewise):
        return _back(find(own), back)
    if not isinstance(together, sp.Piecewise) or len(together.args) > MOST_PIECES:
        return None
    ends = _ends(together, x, value)
    if ends is None:
        return None
    parts: list[sp.Expr] = []
    for i, (piece, _) in enumerate(together.args):
        found = find(piece)
        if found is None:
            return None
        if i:
            c = ends[i - 1]
            found += parts[-1].xreplace({x: c}) - found.xreplace({x: c})
        parts.append(found)
    return _back(sp.Piecewise(*((p, c) for p, (_, c) in zip(parts, together.args, strict=True))), back)


def _back(found: sp.Expr | None, back: dict[sp.Dummy, sp.Piecewise]) -> sp.Expr | None:
    return None if found is None else found.xreplace(back)


def _ends(together: sp.Piecewise, x: sp.Symbol, value: Valuation | None) -> list[sp.Expr] | None:
    """The right ends of the pieces; None: they do not grow, or the last piece does not reach on."""
    ends = []
    for _, condition in together.args[:-1]:
        if not isinstance(condition, sp.StrictLessThan | sp.LessThan) or condition.lhs != x or condition.rhs.has(x):
            return None
        ends.append(condition.rhs)
    growing = all(sign(b - a, value) == 1 for a, b in pairwise(ends))
    return ends if growing and together.args[-1][1] == sp.true else None
