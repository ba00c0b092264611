"""A component that the file gives as a letter is that letter from there on: with v_Ax = -v, v = r ω for v_Ax = -r ω, so
that v and r ω are the sizes that they look like.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.report.document.blocks import Block, Equation, Math

COMPONENT = re.compile(r"[va]_\w*[xy]")


def with_given_letters(blocks: Sequence[Block], data: Iterable[Equation]) -> list[Block]:
    """Blocks with what the data say of components in their place."""
    told: dict[sp.Symbol, sp.Expr] = {}
    for datum in data:
        match datum.sides:
            case (Math(x), Math(value)) if x.is_Symbol and COMPONENT.fullmatch(x.name):
                told |= {x: value} if value.is_Symbol or (-value).is_Symbol else {}
    return [_put(b, told) for b in blocks] if told else list(blocks)


def _put(block: Block, told: dict[sp.Symbol, sp.Expr]) -> Block:
    if not isinstance(block, Equation):
        return block
    sides = tuple(_side(s, told) for s in block.sides)
    if sides == block.sides:
        return block
    match sides:
        case (Math(one), Math(other)) if one.could_extract_minus_sign() and other.could_extract_minus_sign():
            sides = (Math(-one), Math(-other))
    return replace(block, sides=sides)


def _side(side: Any, told: dict[sp.Symbol, sp.Expr]) -> Any:
    if isinstance(side, tuple):
        return tuple(_side(piece, told) for piece in side)
    if not isinstance(side, Math) or not side.expr.free_symbols & told.keys():
        return side
    values = None if side.values is None else dict(side.values)
    for x, value in told.items():
        if values is not None and x in values:
            text = values.pop(x)
            opposite = text[1:] if text.startswith("-") else f"-{text}"
            values |= {value: text} if value.is_Symbol else {-value: opposite}
    return Math(side.expr.xreplace(told), values)
