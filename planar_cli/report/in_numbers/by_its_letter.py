"""The unknowns of several equations by the one letter in which they are told: O_x = 0.15 α_disk = -0.3182 α_rod."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from planar_cli.report.document.blocks import Math
from planar_cli.report.in_numbers.closed_letters import in_letters
from planar_cli.report.in_numbers.put_in import Writer, put_in
from planar_cli.report.notation.nested import in_storeys
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.algebra import Line as SolvedLine
from planar_cli.solve.instant.algebra import SolvedBlock
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.solution import InstantSolution

FEW = 4
"""A formula of more terms is told by its sum alone."""


def by_its_letter(block: SolvedBlock, stage: Stage) -> Iterator[tuple[SolvedLine, sp.Expr]]:
    """The formulas of the other unknowns of a block in its one letter."""
    explicit = {s: e for s, e in stage.algebra.explicit.items() if e.free_symbols & stage.algebra.unknowns}
    told = [x for x in block.lines if x.letters and x.symbol not in block.letters]
    formulas = {x.symbol: x.formula.xreplace(explicit) for x in told}
    for x in told:
        formula = x.formula.xreplace(explicit)
        for _ in told:
            formula = formula.xreplace(formulas)
        yield x, formula


def by_another(x: SolvedLine, block: SolvedBlock, stage: Stage, phrases: Phrases) -> list[Math]:
    """What an unknown is by the one other of which its own equation tells it, where that is not the letter; of several
    each term by the letter, -0.3182 α - 0.1061 α + 0.05303 α.
    """
    own = next((y.formula for y in block.lines if y.symbol == x.symbol and not y.letters), sp.S.Zero)
    own = own.xreplace(stage.algebra.explicit)
    others = own.free_symbols & set(block.unknowns)
    if len(others) > 1:
        return _by_terms(own, block, stage, phrases)
    found = put_in(x.symbol, own, {x.symbol, *others}, phrases) if len(others) == 1 else None
    return [] if found is None or others <= set(block.letters) else [found.right]


def put_in_before(x: SolvedLine, block: SolvedBlock, stage: Stage) -> list[int]:
    """The equations of what an unknown is told by beside the letter, which is put into its own one: (7), (8) in (9)."""
    own = next((y.formula for y in block.lines if y.symbol == x.symbol and not y.letters), sp.S.Zero)
    others = own.xreplace(stage.algebra.explicit).free_symbols & set(block.unknowns) - set(block.letters)
    return sorted({n for y in block.lines if y.letters and y.symbol in others for n in y.equations})


def _by_terms(own: sp.Expr, block: SolvedBlock, stage: Stage, phrases: Phrases) -> list[Math]:
    """The terms of a formula, each in the one letter of the block; none where one of them has other letters."""
    if not own.is_Add or len(own.args) > FEW or len(block.letters) != 1:
        return []
    (letter,) = block.letters
    formulas = {x.symbol: formula for x, formula in by_its_letter(block, stage)}
    terms = [t.xreplace(formulas) for t in own.args]
    if any(t.free_symbols & set(block.unknowns) != {letter} or t.is_Add for t in terms):
        return []
    writer = Writer((letter,), phrases)
    told = [writer.written(t) for t in terms]
    if any(t is None or t.is_Add or letter not in t.free_symbols for t in told):
        return []
    return [Math(sp.Add(*(t for t in told if t is not None), evaluate=False), writer.texts)]


def makes_storeys(block: SolvedBlock, instant: InstantSolution) -> bool:
    """Are formulas in the letter fractions of fractions, and is the result no short formula of the file's letters?"""
    results = [x for x in block.lines if x.symbol in block.letters]
    nested = any(in_storeys(x.formula) for x in block.lines if x.letters)
    return nested and all(in_letters(x.formula, instant) is None for x in results)
