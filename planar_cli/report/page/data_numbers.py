"""Data are no equations of the solution: what the file gives has a number only where a later line calls it by that, and
what stands under Given word for word is not said again.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import fields, replace
from itertools import pairwise
from typing import Any

from planar_cli.report.document.blocks import (
    Block,
    Equation,
    Heading,
    Line,
    Math,
    Name,
    Note,
    Paragraph,
    Text,
    Value,
    line,
)
from planar_cli.report.document.mentioned import pieces_of
from planar_cli.report.equations.steps import without_ritual
from planar_cli.report.given.data import DIFFERENTIATED, GIVEN
from planar_cli.report.given.given_letters import with_given_letters
from planar_cli.report.given.given_speeds import SPEEDS
from planar_cli.report.given.restated import GROUPS
from planar_cli.report.kinetics.free_flight import WEIGHT
from planar_cli.report.notation.names import plain_name
from planar_cli.report.notation.notation import plain
from planar_cli.report.notation.numbers import quantity

CALLED = re.compile(r"\((\d+)\)")
RANGE = re.compile(r"\((\d+)\) to \((\d+)\)")
CONSTANT = Text(" constant:")
STATE = "STATE"
LAST = Paragraph(GROUPS[-1])


def without_numbered_data(blocks: Sequence[Block], throughout: bool) -> list[Block]:
    """The blocks of a part; the numbers behind a datum move up. `throughout`: are they counted through all of it, and
    not anew in each of its states?
    """
    starts = [i for i, b in enumerate(blocks) if isinstance(b, Heading) and b.label == STATE and i and not throughout]
    return [b for start, stop in pairwise([0, *starts, len(blocks)]) for b in _unnumbered(blocks[start:stop])]


def _unnumbered(blocks: Sequence[Block]) -> Sequence[Block]:
    data = [b.number for b in blocks if isinstance(b, Equation) and b.number is not None and is_datum(b)]
    if not data:
        return blocks
    called = set(_called(blocks))
    gone = sorted(n for n in data if n not in called)
    return [_moved(b, gone) for b in blocks] if gone else blocks


def is_datum(equation: Equation) -> bool:
    """Does it only say what the file gives, that what it gives stays constant, or that a body falls?"""
    return equation.lead in (GIVEN, DIFFERENTIATED, WEIGHT, *SPEEDS) or equation.lead[-1:] in (GIVEN, (CONSTANT,))


def _called(blocks: Sequence[Block]) -> Iterator[int]:
    """The numbers by which equations are called."""
    for block in blocks:
        for text in _texts(block):
            yield from map(int, CALLED.findall(text))
            for first, last in RANGE.findall(text):
                yield from range(int(first), int(last) + 1)


def _texts(block: Block) -> Iterator[str]:
    if isinstance(block, Heading) and isinstance(block.aside, str):
        yield block.aside
    yield from (p.text for p in pieces_of(block) if isinstance(p, Text))


def _moved(block: Block, gone: Sequence[int]) -> Block:
    """A block with the numbers that are left when some are gone."""

    def left(number: int) -> int:
        return number - sum(n < number for n in gone)

    def said(text: str) -> str:
        return CALLED.sub(lambda found: f"({left(int(found[1]))})", text)

    def of(value: Any) -> Any:
        match value:
            case Text(text):
                return replace(value, text=said(text)) if "(" in text else value
            case tuple():
                return tuple(of(part) for part in value)
            case Name() | Math() | Value():
                return value
        if not hasattr(value, "__slots__") or isinstance(value, str | int):
            return value
        return replace(value, **{f.name: of(getattr(value, f.name)) for f in fields(value) if f.init})

    if isinstance(block, Heading) and isinstance(block.aside, str):
        return replace(block, aside=said(block.aside))
    moved: Block = of(block)
    if isinstance(moved, Equation) and moved.number is not None:
        return replace(moved, number=None if moved.number in gone else left(moved.number))
    return moved


def without_restated_data(page: Sequence[Block]) -> list[Block]:
    """The blocks of a page without the data that stand under Given word for word, but for the name of the body behind
    the letter, where it has one value there; a heading of velocities or accelerations, or a step, goes with them, where
    nothing else stands under it.
    """
    told = "".join(_read(b.line) for b in page if isinstance(b, Note) and b.kind == "Given")
    given = [piece.rpartition(": ")[2].partition(" = ") for piece in re.split(r"[,;] ", told)]
    again = [_restates(b, [(letter, value) for letter, _, value in given]) for b in page]
    kept = [_beside(b) for b, told_above in zip(page, again, strict=True) if not told_above]
    data = (b for b, told_above in zip(page, again, strict=True) if told_above and isinstance(b, Equation))
    kept = with_given_letters(kept, data)
    follows = (*kept[1:], None)
    kept = [b for b, after in zip(kept, follows, strict=True) if not _is_group(b) or _stands_under(after)]
    # Accelerations alone need no heading below that of their step.
    kept = [b for b, above in zip(kept, (None, *kept), strict=False) if b != LAST or not isinstance(above, Heading)]
    return list(without_ritual(kept))


def _is_group(block: Block | None) -> bool:
    """Is it a heading of velocities or accelerations?"""
    return isinstance(block, Paragraph) and block.line in GROUPS


def _stands_under(block: Block | None) -> bool:
    """Is it a line of a group?"""
    return isinstance(block, Equation | Paragraph) and not _is_group(block)


def _beside(block: Block) -> Block:
    """A datum with its reason behind it, as nothing calls it: ω = 240 rpm = 25.13 rad/s, given."""
    if not isinstance(block, Equation) or block.number is not None or not is_datum(block):
        return block
    last = block.lead[-1]
    assert isinstance(last, Text)
    own = (*block.lead[:-1], replace(last, text=last.text.removesuffix(":")))
    # A function of the time has its units there.
    return replace(block, lead=(), note=line(*own, ", ", *block.note) if block.note else own)


def _restates(block: Block, given: Sequence[tuple[str, str]]) -> bool:
    if not isinstance(block, Equation) or block.number is not None or block.lead != GIVEN:
        return False
    letter, *values = (_read(side if isinstance(side, tuple) else (side,)) for side in block.sides)
    stated = [value for own, value in given if own == letter or own.startswith(f"{letter}_")]
    return not block.note and stated == values


def _read(told: Line) -> str:
    """A line as it is printed."""
    return "".join(_piece(p) for p in pieces_of(told))


def _piece(piece: Any) -> str:
    match piece:
        case Text(text):
            return text
        case Name(name):
            return plain_name(name)
        case Math(expr):
            return plain(expr, piece.values)
        case Value():
            return quantity(piece.number, piece.unit, piece.figures)
    raise TypeError(piece)
