"""What the file gives of a velocity or an acceleration, put into the relations that hold it in other letters: with
-r ω_disk = v_O the relation of a rod from O says v_O = l ω_rod cos 45°, without the way round by the disk.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import derivative, simplified
from planar_cli.solve.instant.written import Written

GIVEN = "given"
"""The source of what the file states."""
Known = tuple[sp.Symbol, sp.Expr, sp.Expr]
"""An unknown, its factor, which has letters, and what their product is."""


def through_given(blocks: Sequence[tuple[Written, ...]], unknowns: Collection[sp.Symbol]) -> list[tuple[Written, ...]]:
    """The equations, block by block, with what is given put in."""
    known = [k for block in blocks for w in block if w.source == GIVEN and (k := _known(w, unknowns)) is not None]
    return [
        tuple(w if w.source == GIVEN or w.law != "relation" else _put_in(w, known) for w in block) for block in blocks
    ]


def _known(w: Written, unknowns: Collection[sp.Symbol]) -> Known | None:
    """What a given relation tells; None: more than one unknown, an unknown by itself, or a number without a letter."""
    inside = w.residual.free_symbols & set(unknowns)
    if len(inside) != 1:
        return None
    (x,) = inside
    factor = derivative(w.residual, x)
    if factor.is_number or x in factor.free_symbols:
        return None
    told = simplified(factor * x - w.residual)
    return (x, factor, told) if told.is_Symbol or (-told).is_Symbol else None


def _put_in(w: Written, known: Sequence[Known]) -> Written:
    for x, factor, told in known:
        if x in w.residual.free_symbols:
            sides = [_without(side, x, factor, told) for side in (w.left, w.right)]
            if all(side is not None and x not in side.free_symbols for side in sides):
                w = replace(w, left=sides[0], right=sides[1])
    return w


def _without(side: sp.Expr, x: sp.Symbol, factor: sp.Expr, told: sp.Expr) -> sp.Expr | None:
    """A side with what is told for the product; None: it holds the unknown with another factor."""
    own = derivative(side, x)
    ratio = simplified(own / factor)
    return simplified(side - own * x) + ratio * told if ratio in (0, 1, -1) else None
