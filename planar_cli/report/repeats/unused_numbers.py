"""In a case, a quantity whose formula stands in an earlier one, and whose new number nothing needs: a moment of inertia
where only the sign of a lever says whether an equilibrium is stable.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import sympy as sp

from planar_cli.report.document.blocks import Answer, Block, Equation, Math, Note, Paragraph, Result, Text, Value
from planar_cli.report.document.mentioned import names_in, pieces_of

MADE = (
    *("mass of ", "moment of inertia of ", "x of the mass centre", "y of the mass centre"),
    *("distance of the mass centre", "from "),
)
"""Begins the line of what a body is made up of."""


def without_unused_numbers(blocks: Sequence[Block], before: Sequence[Block]) -> list[Block]:
    """The blocks of a case without such lines. `before`: those of earlier cases. What stood there word for word stays,
    to be named again, where a numbered equation has its letter.
    """
    formulas = {(_letter(b), repr(b.sides[1])) for b in before if isinstance(b, Equation) and _is_made(b)}
    numbered = {x for b in blocks if isinstance(b, Equation) and b.number is not None for x in _letters(b)}
    wanted: set[str] = set()
    kept: list[Block] = []
    for block in reversed(blocks):
        made = isinstance(block, Equation) and _is_made(block) and _letter(block) not in wanted
        told = made and isinstance(block, Equation) and (_letter(block), repr(block.sides[1])) in formulas
        if told and isinstance(block, Equation) and (block not in before or _letter(block) not in numbered):
            continue
        if not isinstance(block, Equation) or any(map(_is_number, block.sides)):
            wanted |= set(_letters(block))
        kept.append(block)
    return kept[::-1]


def _is_made(equation: Equation) -> bool:
    """Has it the formula and the number of such a quantity?"""
    lead = equation.lead[0] if equation.lead and equation.number is None and len(equation.sides) > 2 else None
    return isinstance(lead, Text) and lead.text.startswith(MADE) and isinstance(equation.sides[-1], Value)


def _letter(equation: Equation) -> str:
    first = equation.sides[0]
    return first.expr.name if isinstance(first, Math) and isinstance(first.expr, sp.Symbol) else ""


def _is_number(side: Any) -> bool:
    return isinstance(side, Value) or any(isinstance(p, Value) for p in pieces_of(side))


def _letters(block: Block) -> Iterator[str]:
    """All letters of which a block speaks."""
    parts: Any = block.sides if isinstance(block, Equation) else getattr(block, "line", ())
    if isinstance(block, Answer | Note | Paragraph | Result | Equation):
        yield from names_in(parts)
