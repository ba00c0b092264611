"""A root that one case leaves out and another case asks for is that of the other case, not one that is dropped."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from decimal import Decimal

from planar_cli.problem.language.expression import Name as Letter
from planar_cli.report.document.blocks import Block, Equation, Math, Paragraph, Text, Value, line
from planar_cli.report.equations.results import BEFORE_REASON, OTHER_ROOTS
from planar_cli.report.given.as_stated import in_base
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution

NUMBERED = re.compile(r"\(\d+\):")
SAME = Decimal("1e-20")


def with_roots_of_cases(blocks: list[Block], part: PartSolution, parts: Sequence[PartSolution]) -> list[Block]:
    """The blocks of a case in which such a root is told so; the same list where there is none. Of a root that an
    earlier case has told, the line of this one is `(3), the other root:`.
    """
    others = [p for p in parts if p is not part and p.case]
    earlier = {p.case for p in parts[: parts.index(part)]}
    if not part.case or not others or not any(_told(b) for b in blocks):
        return blocks
    found: list[Block] = []
    for i, block in enumerate(blocks):
        letter = _letter(blocks[:i]) if (root := _told(block)) is not None else ""
        case = next((p.case for p in others if root is not None and _asks(p.found, letter, root)), "")
        if case in earlier and (last := _led_by_number(found[-1:])) is not None:
            found[-1] = replace(last, lead=line(_said(last).removesuffix(":"), ", the other root:"))
            continue
        told = line("the other root, ", root, f", is that of case {case.replace('_', ' ')}") if root and case else ()
        found.append(Paragraph(told) if told else block)
    return found


def _led_by_number(blocks: Sequence[Block]) -> Equation | None:
    """The last of the blocks, where it is a line `(3):   β = …`."""
    last = blocks[-1] if blocks else None
    return last if isinstance(last, Equation) and NUMBERED.fullmatch(_said(last)) else None


def _said(equation: Equation) -> str:
    """The words that lead to an equation without a number, where they are plain."""
    lead = equation.lead if equation.number is None else ()
    return lead[0].text if len(lead) == 1 and isinstance(lead[0], Text) else ""


def _told(block: Block) -> Value | None:
    """The one root that a line leaves out."""
    pieces = [p for p in block.line if p != Text("")] if isinstance(block, Paragraph) else []
    match pieces:
        case [Text(text), Value() as root, Text(reason), *_] if text == OTHER_ROOTS and reason == BEFORE_REASON:
            return root
    return None


def _letter(above: Sequence[Block]) -> str:
    """The letter that the last equation gives."""
    last = next((b for b in reversed(above) if isinstance(b, Equation)), None)
    first = None if last is None else last.sides[0]
    return first.expr.name if isinstance(first, Math) and first.expr.is_Symbol else ""


def _asks(found: Sequence[Found], letter: str, root: Value) -> bool:
    """Is this value of the letter an answer?"""
    value = in_base((root.number, root.unit), False)
    names = [(f, f.find.found.what) for f in found if f.find is not None]
    asked = [f for f, what in names if isinstance(what, Letter) and what.name == letter]
    sizes = [f.values[0] for f in asked if f.values is not None and len(f.values) == 1]
    return value is not None and any(abs(size - value) <= SAME * abs(value) for size in sizes)
