"""ṙ and r̈ for what slides along a rod through the pole, where a page says that they are its speed and acceleration:
v_P,rod = ṙ = b ω sin θ is ṙ = b ω sin θ; and in diagrams r for the distance OP that it is said to be.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from planar_cli.report.document.blocks import Block, Equation, Forces, Math, Name, Paragraph, Text
from planar_cli.report.words.one_name import renamed

RATES = ("r_dot", "r_ddot")
RADIUS = "r"


def with_polar_names(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a page in these names, where one thing alone has them."""
    rates = [found for b in blocks if (found := _rate(b)) is not None]
    alone = {name for name in RATES if len({letter for letter, own in rates if own == name}) == 1}
    names = {letter: name for letter, name in rates if name in alone}
    if not names:
        return list(blocks)
    told = (_without_letter(b) if (found := _rate(b)) is not None and found[0] in names else b for b in blocks)
    distances = {distance: RADIUS for b in blocks if (distance := _distance(b))}
    return [renamed([b], distances)[0] if isinstance(b, Forces) else b for b in renamed(list(told), names)]


def _rate(block: Block) -> tuple[str, str] | None:
    """The letter and the rate of `v_P,rod = ṙ = …`."""
    if not isinstance(block, Equation) or len(block.sides) < 3:
        return None
    first, second = block.sides[:2]
    pieces = [p for p in second if p != Text("")] if isinstance(second, tuple) else [second]
    if not isinstance(first, Math) or not first.expr.is_Symbol or len(pieces) != 1 or not isinstance(pieces[0], Name):
        return None
    return (first.expr.name, pieces[0].name) if pieces[0].name in RATES else None


def _without_letter(block: Block) -> Block:
    return replace(block, sides=block.sides[1:]) if isinstance(block, Equation) else block


def _distance(block: Block) -> str:
    """OP of `P slides along rod, … ; r = OP:`."""
    pieces = block.line if isinstance(block, Paragraph) else ()
    for one, other in pairwise(pieces):
        if one == Name(RADIUS) and isinstance(other, Text) and other.text[:3] == " = " and other.text[-1] == ":":
            return other.text[3:-1]
    return ""
