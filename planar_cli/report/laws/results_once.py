"""What equations of forces gave, and a state makes shorter, is told once.

(7):  A_y = 1/2 m g + 1/6 m l α_AB = 1/4 m g        instead of the first half above and all of it below
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.report.document.blocks import Block, Equation, Math, Name, Paragraph, Text


def results_once(before: Sequence[Block], moving: Sequence[Block]) -> tuple[list[Block], list[Block]]:
    """The blocks before a motion and those of it. What another solution before needs keeps its line; below it has its
    result alone.
    """
    told, kept = list(before), list(moving)
    for i, block in enumerate(kept):
        if not isinstance(block, Equation) or block.number is not None or block.lead or len(block.sides) < 3:
            continue
        name, formula, *rest = block.sides
        at = next((n for n, b in enumerate(told) if _tells(b, _name_of(name), formula)), None)
        if at is None:
            continue
        line_of = told[at]
        assert isinstance(line_of, Equation)
        needed = _is_put_into(told, at)
        kept[i] = replace(block, sides=(name, *rest) if needed else block.sides, lead=line_of.lead)
        if not needed:
            del told[at]
    return told, kept


def _tells(block: Block, name: str, formula: object) -> bool:
    """Is it the line by which an equation gives the letter of that name, with that formula alone?"""
    if not isinstance(block, Equation) or block.number is not None or not block.lead or len(block.sides) != 2:
        return False
    return bool(name) and _name_of(block.sides[0]) == name and block.sides[1] == formula


def _name_of(side: object) -> str:
    """The name of a side that is a letter; else nothing."""
    pieces = side if isinstance(side, tuple) else (side,)
    (piece, *more) = [p for p in pieces if not (isinstance(p, Text) and not p.text)] or (None,)
    if more:
        return ""
    if isinstance(piece, Name):
        return piece.name
    return piece.expr.name if isinstance(piece, Math) and isinstance(piece.expr, sp.Symbol) else ""


def _is_put_into(told: Sequence[Block], at: int) -> bool:
    """Does what follows tell a letter of it, so that it is carried into another equation?"""
    own = told[at]
    assert isinstance(own, Equation)
    formula = own.sides[1]
    letters = {s.name for s in formula.expr.free_symbols} if isinstance(formula, Math) else set[str]()
    for block in told[at + 1 :]:
        if not isinstance(block, Equation | Paragraph):
            return False
        if isinstance(block, Equation) and _name_of(block.sides[0]) in letters:
            return True
    return False
