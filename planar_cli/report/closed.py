"""Answers in letters: the line that gives one ends with its formula in the letters of the file."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from planar_cli.equation.plain import longer
from planar_cli.report.answer_letters import asked_symbol
from planar_cli.report.blocks import Block, Equation, Inline, Line, Math, Name, Text
from planar_cli.report.names import plain_name
from planar_cli.report.notation import plain
from planar_cli.report.swallowed import swallowed
from planar_cli.report.words import Phrases
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution

LONGEST = 40
"""A longer formula stands in the answer alone."""


def with_closed_forms(blocks: Sequence[Block], part: PartSolution, phrases: Phrases) -> list[Block]:
    """The blocks of a part, with the formulas of its answers behind the lines that give them in other letters."""
    found = list(blocks)
    if not phrases.letters:
        return found
    for answer in part.found:
        if (
            answer.values is not None
            or answer.word
            or answer.curve is not None
            or answer.kind not in ("number", "vector")
        ):
            continue
        names = _names(answer, part)
        closed = answer.expressions or ()
        for axis, expr in zip(("x", "y") if len(closed) > 1 else ("",), closed, strict=True):
            own = {f"{name}, {axis}" if axis else name for name in names}
            lines = [i for i, block in enumerate(found) if _left(block) in own]
            # A numbered line may be an equation that a letter stands in, rather than what gives it.
            given = [i for i in lines if not _is_numbered(found[i])] or lines
            shown = swallowed(expr, answer, phrases.ledger, phrases.figures) or Math(phrases.neat(expr))
            if given and not longer(expr, LONGEST):
                found[given[-1]] = _ended(found[given[-1]], shown)
    return found


def _names(answer: Found, part: PartSolution) -> Collection[str]:
    """What the left side of its line may be called: its own name, or the letter of the solution that it is."""
    symbol = asked_symbol(answer, part)
    return {plain_name(answer.name)} | ({plain_name(symbol.name)} if symbol is not None else set())


def _left(block: Block) -> str:
    """The name that an equation gives; empty where its first side is more than a name."""
    if not isinstance(block, Equation):
        return ""
    side: Inline | Line = block.sides[0]
    pieces = side if isinstance(side, tuple) else (side,)
    if not all(isinstance(p, Name | Text) or (isinstance(p, Math) and p.expr.is_Symbol) for p in pieces):
        return ""
    return "".join(_word(p) for p in pieces)


def _is_numbered(block: Block) -> bool:
    return isinstance(block, Equation) and block.number is not None


def _word(piece: Inline) -> str:
    if isinstance(piece, Math):
        return plain_name(piece.expr.name)
    return plain_name(piece.name) if isinstance(piece, Name) else piece.text if isinstance(piece, Text) else ""


def _ended(block: Block, closed: Math) -> Block:
    """An equation that ends with a formula, once."""
    assert isinstance(block, Equation)
    text = plain(closed.expr, closed.values)
    said = [plain(s.expr, s.values) for s in block.sides if isinstance(s, Math)]
    return block if text in said else replace(block, sides=(*block.sides, closed))
