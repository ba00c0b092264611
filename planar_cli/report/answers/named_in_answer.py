"""What is asked and is only a letter of the solution is told by the answer: θ = θ_2 = 1 rad. No line before it says the
same.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.report.document.blocks import Answer, Block, Equation, Math, Name, Paragraph, Text, Value, line
from planar_cli.report.document.mentioned import pieces_of


def named_in_answer(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a part with its answers."""
    found = list(blocks)
    for i in range(len(blocks) - 1, -1, -1):
        block = found[i]
        if not isinstance(block, Equation) or (name := _name_alone(block)) is None:
            continue
        letter = block.sides[1]
        own = [k for k, b in enumerate(found) if isinstance(b, Answer) and b.name == name and b.relation == "="]
        if len(own) != 1 or not isinstance(letter, Math) or not _has_its_line(letter, found[:i]):
            continue
        answer = found[own[0]]
        used = any(_mentions(b, name) for b in (*found[:i], *found[i + 1 : own[0]]))
        if not isinstance(answer, Answer) or used:
            continue
        if not any(isinstance(p, Math) for p in answer.line):
            found[own[0]] = replace(answer, line=line(letter, " = ", *answer.line))
        del found[i]
        if _leads(found[i - 1]) and not isinstance(found[i], Equation):
            del found[i - 1]
    return found


def _name_alone(equation: Equation) -> str | None:
    """The name in `name = letter = value`."""
    match equation.sides:
        case ((Name() as name, *rest), Math() as letter, Value()) if _letter(letter) is not None and not letter.values:
            if any(not isinstance(p, Text) or p.text for p in rest):
                return None
            bare = equation.number is None and not equation.lead and not equation.note and equation.relation == "="
            return name.name if bare else None
    return None


def _letter(side: Math) -> sp.Symbol | None:
    """x of x and of -x."""
    return next((e for e in (side.expr, -side.expr) if e.is_Symbol), None)


def _has_its_line(letter: Math, before: Sequence[Block]) -> bool:
    """Does a line before give the letter?"""
    heads = (b.sides[0] for b in before if isinstance(b, Equation) and len(b.sides) > 1)
    return any(isinstance(h, Math) and h.expr == _letter(letter) for h in heads)


def _mentions(block: Block, name: str) -> bool:
    """Does a line speak of what is asked by its name?"""
    own = list(pieces_of(block))
    names = {p.name for p in own if isinstance(p, Name)}
    return name in names | {s.name for p in own if isinstance(p, Math) for s in p.expr.free_symbols}


def _leads(block: Block) -> bool:
    """Is it `Hence:` or `At 2:`?"""
    last = block.line[-1] if isinstance(block, Paragraph) and block.line else None
    return isinstance(last, Text) and last.text.endswith(":")
