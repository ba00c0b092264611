"""Equations that are solved together and of which several unknowns would have to be carried: each as a row, and what
all of them give.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import sympy as sp

from planar_cli.report.document.blocks import Block, Equation, line
from planar_cli.report.equations.numeric import NumericTelling
from planar_cli.solve.instant.algebra import SolvedBlock
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Written
from planar_cli.solve.solution import InstantSolution


def small_system(
    block: SolvedBlock,
    stage: Stage,
    instant: InstantSolution,
    numeric: NumericTelling,
    number: Callable[[Stage, int], int],
) -> list[Block]:
    """The rows with what is known on the right, and the roots. Empty: a row can not be told. `number`: the printed
    number of an equation or line of a stage.
    """
    phrases = numeric.phrases
    order = [s for s in instant.trial.system.tree.acceleration_unknowns() if s in block.unknowns]
    order += [s for s in block.unknowns if s not in order]
    if phrases.symbolic:
        from planar_cli.report.equations.letter_system import letter_system

        inside = {**instant.instant.scene.ledger.definitions, **stage.algebra.explicit}
        own = {w.number: number(stage, w.number) for w in block.equations}
        cited = [number(stage, n) for n in named_in(stage, block.equations).values()]
        return letter_system(block, order, inside, own, cited, phrases)
    from planar_cli.report.in_numbers.linear_system import system

    values = {x.symbol: x.value for x in block.lines if not x.letters}
    found = {number(stage, w.number): numeric.row(w, stage, order) for w in block.equations}
    rows = [(n, *own) for n, own in sorted(found.items()) if own is not None]
    if len(rows) < len(found) or any(values.get(s) is None for s in order):
        return []
    roots = {s: value for s, value in values.items() if value is not None}
    told = system(rows, order, roots, phrases.figures)
    for i, symbol in enumerate(order):
        lead = () if i else line("together:")
        told.append(Equation((phrases.math(symbol), phrases.shown(symbol, values[symbol])), None, lead))
    return told


def named_in(stage: Stage, written: Sequence[Written]) -> dict[sp.Symbol, int]:
    """The accelerations that stand for others in these equations, with the numbers of the lines that say so."""
    held = {s for w in written for s in w.residual.free_symbols}
    return {x.symbol: x.number for x in stage.lines if x.symbol in held}
