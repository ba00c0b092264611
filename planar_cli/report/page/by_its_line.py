"""A formula in the letters of the file names the equation from which it follows, as the line above that found it did.

(2):          T = m_1 (g + a_0) - m_1 q̈
(2) in (3):   q̈ = (m_1 - m_2) (g + a_0) / (m_1 + m_2)
(2):          T = 2 m_1 m_2 (g + a_0) / (m_1 + m_2)
(4):        N_A = m_1 q̈ = m_1 (m_1 - m_2) (g + a_0) / (m_1 + m_2)
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace

import sympy as sp

from planar_cli.report.document.blocks import Block, Equation, Heading, Line, Math, Text

ONE = re.compile(r"\(\d+\):")


def by_its_line(blocks: Iterable[Block]) -> list[Block]:
    """The blocks of a part, each second formula of an unknown with the number that its first one has; at the end of the
    first one, where that holds nothing which was found later.
    """
    first: dict[sp.Expr, int] = {}
    told: list[Block] = []
    for block in blocks:
        if isinstance(block, Heading):
            first = {}
        found = _found(block)
        if found is None:
            told.append(block)
            continue
        equation, unknown, formula = found
        at = first.get(unknown)
        if at is None or equation.lead:
            if _is_number(equation.lead):
                first.setdefault(unknown, len(told))
            told.append(equation)
            continue
        own = told[at]
        assert isinstance(own, Equation)
        if _holds_later(own, told[at + 1 :]):
            told.append(replace(equation, lead=own.lead))
        else:
            told[at] = replace(own, sides=(*own.sides, formula))
    return told


def _holds_later(own: Equation, later: Iterable[Block]) -> bool:
    """Does the formula hold an unknown that only a line below it finds?"""
    held = {s for side in own.sides[1:] if isinstance(side, Math) for s in side.expr.free_symbols}
    return any(isinstance(b, Equation) and isinstance(b.sides[0], Math) and b.sides[0].expr in held for b in later)


def _found(block: Block) -> tuple[Equation, sp.Expr, Math] | None:
    """An equation `unknown = formula` with both; None: it is another one, or goes on to a number."""
    match block:
        case Equation(sides=(Math() as own, Math() as formula), number=None, note=(), relation="="):
            if own.expr.is_Symbol and not formula.values and formula.expr.free_symbols:
                return block, own.expr, formula
    return None


def _is_number(lead: Line) -> bool:
    match lead:
        case (Text(text),):
            return ONE.fullmatch(text) is not None
    return False
