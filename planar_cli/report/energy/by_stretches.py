"""A balance in numbers that is wider than a row goes on in the letter of a stretch that stands above it by what is
unknown, and so does the work that has its square.

s_4 = 0.65 - 0.45 cos θ,  U = 4.156 - 200 s_4²     for     U = 4.156 - 200 (0.45 cos θ - 0.65)²
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.report.document.blocks import Block, Equation, Inline, Line, Math
from planar_cli.report.energy.few_lines import breaks, ended


def by_stretches(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a balance, the last of which is the balance."""
    last = blocks[-1] if blocks else None
    if not isinstance(last, Equation) or not breaks(last):
        return list(blocks)
    told: dict[sp.Expr, sp.Symbol] = {}
    found: list[Block] = []
    for block in blocks:
        shown = _shorter(block, told) if isinstance(block, Equation) and told else block
        found.append(shown)
        end = block.sides[-1] if isinstance(block, Equation) and ended(block) else None
        if isinstance(end, Math) and end.values and end.expr.is_Add:
            told[_spelled(end.expr, end.values)] = sp.Symbol(ended(block), real=True)
    whole = found[-1]
    return found if isinstance(whole, Equation) and whole != last and not breaks(whole) else list(blocks)


def _shorter(block: Equation, told: Mapping[sp.Expr, sp.Symbol]) -> Equation:
    return replace(block, sides=tuple(_by_letter(side, told) for side in block.sides))


def _by_letter(side: Inline | Line, told: Mapping[sp.Expr, sp.Symbol]) -> Inline | Line:
    """A side with the squares of letters for those of what they are."""
    if not isinstance(side, Math) or not side.values:
        return side
    put = {}
    for square in side.expr.atoms(sp.Pow):
        own = _spelled(square.base, side.values)
        letter = told.get(own) or told.get(-own)
        if square.exp == 2 and letter is not None:
            put[square] = letter**2
    return Math(side.expr.xreplace(put), side.values) if put else side


def _spelled(expr: sp.Expr, values: Mapping[sp.Symbol, str]) -> sp.Expr:
    """A formula by the texts of its numbers, which have other symbols in each line."""
    return expr.xreplace({s: sp.Symbol(values[s], positive=True) for s in expr.free_symbols if s in values})
