"""The law of a coordinate that the equations of motion have given already is not told again: what it comes to in the
letters of the file stands behind their solution.

(3):   α = -μ N_C R/I_G = -5 μ g/(2 R)        instead of   For the angle of the ball: θ̈ = -5 μ g/(2 R)
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.report.document.blocks import Block, Equation, Math, Paragraph
from planar_cli.report.laws.laws import is_law_heading, is_rate_of
from planar_cli.report.laws.results_once import results_once

SAME = Decimal("1e-12")


def with_laws_solved(
    before: Sequence[Block], moving: Sequence[Block], value: Valuation, varying: Collection[sp.Symbol]
) -> tuple[list[Block], list[Block]]:
    """The blocks before a motion and those of it. `value`: numbers, or draws of letters; `varying`: letters that vary
    with the motion: a law that has some is an equation to be integrated, and stands by itself.
    """
    told, kept = list(before), list[Block]()
    for block in moving:
        heading = kept[-1] if kept else None
        if isinstance(heading, Paragraph) and is_law_heading(heading) and _is_constant(block, varying):
            assert isinstance(block, Equation)
            i = _solution(told, block, value)
            if i is not None:
                told[i] = _ended(told[i], block)
                kept.pop()
                continue
        kept.append(block)
    return results_once(told, kept)


def _is_constant(block: Block, varying: Collection[sp.Symbol]) -> bool:
    """Is it an equation whose right side does not vary?"""
    if not isinstance(block, Equation):
        return False
    return not any(isinstance(s, Math) and s.expr.free_symbols & set(varying) for s in block.sides[1:])


def _solution(told: Sequence[Block], law: Equation, value: Valuation) -> int | None:
    """Where the last line stands that solves for the acceleration of a law; None: nowhere, or it says another thing."""
    rate, *formulas = law.sides
    if law.number is not None or law.note or not isinstance(rate, Math) or not rate.expr.is_Symbol or not formulas:
        return None
    for i in reversed(range(len(told))):
        block = told[i]
        if not isinstance(block, Equation) or block.number is not None or not block.lead or block.note:
            continue
        letter = block.sides[0]
        if isinstance(letter, Math) and letter.expr.is_Symbol and is_rate_of(letter.expr.name, rate.expr.name):
            return i if _same(letter.expr, formulas[0], value) and not _varies(block, law) else None
    return None


def _varies(block: Equation, law: Equation) -> bool:
    """Does the solution end with a number, and the law with a formula that is not its letter?"""
    letter, first = block.sides[0], law.sides[1]
    return first != letter and not (isinstance(block.sides[-1], Math) and isinstance(law.sides[-1], Math))


def _same(letter: sp.Symbol, formula: object, value: Valuation) -> bool:
    """Is the letter what the law says?"""
    if not isinstance(formula, Math) or formula.values:
        return False
    one, other = value.known(letter), value.known(formula.expr)
    return formula.expr == letter or (one is not None and other is not None and abs(one - other) <= SAME * abs(one))


def _ended(block: Block, law: Equation) -> Block:
    """A solution that ends with the formula of a law."""
    assert isinstance(block, Equation)
    more = law.sides[1:] if law.sides[1] != block.sides[0] and law.sides[1] not in block.sides else ()
    return replace(block, sides=(*block.sides, *more))
