"""Only what an answer rests on: the blocks and lines of a solution that lead to some symbols."""

from __future__ import annotations

from dataclasses import replace

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
        used = tuple(x for x in lines if x.symbol.name in names)
        found.append(replace(stage, blocks=tuple(reversed(kept)), lines=used))
    return tuple(s for s in reversed(found) if s.blocks or s.lines)
