"""Only what an answer rests on: the blocks and lines of a solution that lead to some symbols."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.solve.instant.algebra import SolvedBlock
from planar_cli.solve.instant.stages import Stage


def used_blocks(stages: tuple[Stage, ...], wanted: frozenset[str] | None) -> tuple[Stage, ...]:
    """The stages with just the blocks on which the wanted symbols rest (None: as they are)."""
    if wanted is None:
        return stages
    names = set(wanted)
    found: list[Stage] = []
    for stage in reversed(stages):
        kept = []
        lines = list(stage.lines)
        for block in reversed(stage.blocks):
            names |= {s.name for x in lines if x.symbol.name in names for s in x.expression.free_symbols}
            if any(u.name in names for u in block.unknowns):
                kept.append(block)
                names |= {s.name for w in block.equations for s in w.residual.free_symbols}
        kept += _drawn(stage, kept)
        used = tuple(x for x in lines if x.symbol.name in names)
        found.append(replace(stage, blocks=tuple(reversed(kept)), lines=used))
    return tuple(s for s in reversed(found) if s.blocks or s.lines)


def _drawn(stage: Stage, kept: Sequence[SolvedBlock]) -> list[SolvedBlock]:
    """Relations that say of an acceleration in a diagram that it is another one but for its sign, α_BC = -α_AB: the
    equations of forces have the other letter alone.
    """
    bodies = {body for block in kept for w in block.equations for body in w.bodies}
    drawn = {s for b in bodies for _, part in stage.accelerations.get(b, ()) for s in sp.sympify(part).free_symbols}
    lines = [(block, block.lines[0]) for block in stage.blocks if len(block.lines) == len(block.equations) == 1]
    alike = [(block, x) for block, x in lines if x.symbol in drawn and (x.formula.is_Symbol or (-x.formula).is_Symbol)]
    return [block for block, _ in alike if block.equations[0].law == "relation" and block not in kept]
