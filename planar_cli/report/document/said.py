"""What an equation says, however its sides are put together: the same side twice, and a letter equal to itself."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from planar_cli.report.document.blocks import Answer, Block, Equation, Inline, Line, Math, Name, Text
from planar_cli.report.notation.names import plain_name


def says_nothing(block: Block) -> bool:
    """Is it an equation of a letter with itself?"""
    if not isinstance(block, Equation) or len(block.sides) != 2:
        return False
    one, other = (letter_of(side) for side in block.sides)
    return one != "" and one == other


def said_once(block: Block) -> Block:
    """An equation without a side that only repeats the one before it; an answer without its own name before it."""
    if isinstance(block, Answer):
        first, *rest = block.line or (Text(""),)
        again = letter_of(first) == plain_name(block.name) and rest[:1] == [Text(" = ")]
        return replace(block, line=tuple(rest[1:])) if again else block
    if not isinstance(block, Equation):
        return block
    told = said(block)
    return replace(block, sides=tuple(s for i, s in enumerate(block.sides) if i == 0 or told[i] != told[i - 1]))


def said(equation: Equation) -> list[Any]:
    """The sides of an equation, however they are put together."""
    pieces = ([p for p in side if p != Text("")] if isinstance(side, tuple) else [side] for side in equation.sides)
    return [letter_of(side[0]) or side if len(side) == 1 else side for side in pieces]


def letter_of(side: Inline | Line) -> str:
    """The one letter that a side is."""
    piece = side[0] if isinstance(side, tuple) and len(side) == 1 else side
    if isinstance(piece, Name):
        return plain_name(piece.name)
    return plain_name(piece.expr.name) if isinstance(piece, Math) and piece.expr.is_Symbol else ""
