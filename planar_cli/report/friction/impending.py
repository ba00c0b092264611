"""Reactions at their limit: their sense is known, so that nothing has to be assumed of it."""

from __future__ import annotations

import sympy as sp

from planar_cli.solve.instant.stages import Stage


def impending(stage: Stage) -> set[sp.Expr]:
    """The reactions that an equation says are at their limit, as where something is about to slip, and that act the way
    in which they count.
    """
    limits = (w for block in stage.blocks for w in block.equations if w.law == "relation" and w.source == "limit")
    inside = {s for w in limits for s in w.residual.free_symbols}
    found = {x.symbol: x.value for block in stage.blocks for x in block.lines}
    return {s for s in inside if (value := found.get(s)) is not None and value > 0}
