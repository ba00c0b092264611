"""Sums of forces, each of which gives one unknown, body by body: ΣF_x and ΣF_y of one, then those of the next."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import groupby, pairwise

from planar_cli.solve.instant.algebra import SolvedBlock
from planar_cli.solve.instant.stages import Stage

SAVED = 2
"""The order is changed where so many names of bodies need not be told again."""


def body_by_body(stages: Iterable[Stage]) -> tuple[Stage, ...]:
    """The stages with the sums of forces on one body behind each other, where what one needs is known all the same."""
    return tuple(_ordered(stage) for stage in stages)


def _ordered(stage: Stage) -> Stage:
    blocks: list[SolvedBlock] = []
    for alone, run in groupby(stage.blocks, _is_sum_of_forces):
        own = list(run)
        blocks += _of_bodies(own, stage) if alone and len(own) > SAVED + 1 else own
    return stage if blocks == list(stage.blocks) else replace(stage, blocks=tuple(blocks))


def _is_sum_of_forces(block: SolvedBlock) -> bool:
    """Is it one sum of forces along an axis?"""
    return len(block.equations) == 1 and block.equations[0].law == "force" and bool(block.equations[0].lead)


def _of_bodies(run: list[SolvedBlock], stage: Stage) -> list[SolvedBlock]:
    bodies = list(dict.fromkeys(b.equations[0].bodies for b in run))
    ordered = sorted(run, key=lambda b: bodies.index(b.equations[0].bodies))
    saved = _changes(run) - _changes(ordered)
    return ordered if saved >= SAVED and _in_turn(ordered, stage) else run


def _changes(run: Sequence[SolvedBlock]) -> int:
    return sum(a.equations[0].bodies != b.equations[0].bodies for a, b in pairwise(run))


def _in_turn(run: Sequence[SolvedBlock], stage: Stage) -> bool:
    """Is all that each of them needs of the others found before it?"""
    left = {s for b in run for s in b.unknowns}
    for b in run:
        left -= set(b.unknowns)
        if b.equations[0].residual.xreplace(stage.algebra.explicit).free_symbols & left:
            return False
    return True
