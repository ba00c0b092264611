"""A step of a later part of a motion beside the same of an earlier one: diagrams by the forces that change, and the
equations that stay by their numbers.

Diagrams as from 1 to 2, but on frame M_b ↻ in place of M_c ↺; on rear no M_c ↻.
Equations as from 1 to 2: (16), (17), there (7), (8).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import groupby

from planar_cli.report.document.as_printed import as_text
from planar_cli.report.document.blocks import Block, Equation, Forces, Inline, Line, Paragraph, line
from planar_cli.report.equations.results import numbered
from planar_cli.report.kinetics.entries import entries

SAVED = 3
"""So many rows of a page at least are saved; else it is plainer to see the step itself."""
ROW = 95
"""About how many characters fill a row."""
NUMBER = re.compile(r"\(\d+\)")


def as_there(blocks: Sequence[Block], before: Sequence[Block], where: str) -> tuple[Block, ...]:
    """The blocks of a step, short where it is like an earlier one. `where`: what that is called, from 1 to 2."""
    drawn = [b for b in blocks if isinstance(b, Forces)]
    changed = _changed(drawn, [b for b in before if isinstance(b, Forces)], where)
    if changed is not None:
        first = next(i for i, b in enumerate(blocks) if isinstance(b, Forces))
        kept = [b for b in blocks if not isinstance(b, Forces)]
        blocks = [*kept[:first], changed, *kept[first:]]
    return tuple(_by_number(_groups(blocks), _groups(before), where))


# --- diagrams --------------------------------------------------------------------------------------------------------


def _changed(drawn: Sequence[Forces], before: Sequence[Forces], where: str) -> Paragraph | None:
    """What changes in the diagrams of all bodies; None: too much, or too few rows are saved."""
    if [b.body for b in drawn] != [b.body for b in before]:
        return None
    told: list[Line] = []
    for now, then in zip(drawn, before, strict=True):
        if repr((now.right, now.heads)) != repr((then.right, then.heads)):
            return None
        gone, new = _without(then.left, now.left), _without(now.left, then.left)
        if len(gone) > 1 or len(new) > 1:
            return None
        if gone or new:
            told.append(line(f"on {now.body} ", *_difference(gone, new)))
    if not told:
        return None
    text = line(f"Diagrams as {where}, but ", *(p for i, t in enumerate(told) for p in ("; ", *t)[i == 0 :]), ".")
    saved = sum(map(_rows, drawn)) - _rows(Paragraph(text))
    return Paragraph(text) if saved >= SAVED else None


def _difference(gone: Sequence[Line], new: Sequence[Line]) -> Line:
    """`M_b ↻ in place of M_c ↺`, `no M_c ↻`, `also M_b ↺`."""
    if gone and new:
        return line(*new[0], " in place of ", *gone[0])
    return line("also ", *new[0]) if new else line("no ", *gone[0])


def _without(acting: Line, other: Line) -> list[Line]:
    """The forces of a diagram that another does not have."""
    there = [repr(e) for e in entries(other)]
    found = []
    for entry in entries(acting):
        # Two equal springs pull with two equal forces.
        if (own := repr(entry)) in there:
            there.remove(own)
        else:
            found.append(entry)
    return found


# --- equations -------------------------------------------------------------------------------------------------------


def _groups(blocks: Sequence[Block]) -> list[tuple[Block, ...]]:
    """Each sentence with the equations under it; every other block by itself."""
    found: list[list[Block]] = []
    for block in blocks:
        led = found and isinstance(found[-1][0], Paragraph) and all(isinstance(b, Equation) for b in found[-1][1:])
        if led and isinstance(block, Equation):
            found[-1].append(block)
        else:
            found.append([block])
    return [tuple(group) for group in found]


def _by_number(groups: Sequence[tuple[Block, ...]], before: Sequence[tuple[Block, ...]], where: str) -> Iterator[Block]:
    """Blocks in which equations that stood there, under the same sentence, are named by their numbers."""
    there = {_said(group): _numbers(group) for group in before if _is_numbered(group)}

    def is_known(group: tuple[Block, ...]) -> bool:
        return _is_numbered(group) and _said(group) in there

    for known, run in groupby(groups, is_known):
        same = list(run)
        old = [n for group in same for n in there.get(_said(group), ())] if known else []
        rows = sum(_rows(b) for group in same for b in group)
        if known and rows > SAVED and sorted(old) == old:
            own = [n for group in same for n in _numbers(group)]
            yield Paragraph(line(f"Equations as {where}: {numbered(own)}, there {numbered(old)}."))
        else:
            yield from (b for group in same for b in group)


def _is_numbered(group: Sequence[Block]) -> bool:
    """Is it a sentence with equations that all have numbers?"""
    first, *more = group
    return isinstance(first, Paragraph) and bool(more) and len(_numbers(group)) == len(more)


def _numbers(group: Sequence[Block]) -> list[int]:
    return [b.number for b in group if isinstance(b, Equation) and b.number is not None]


def _said(group: Sequence[Block]) -> str:
    """What a group says, whatever the numbers of its equations; of others it names none."""
    told = "".join(repr(replace(b, number=None) if isinstance(b, Equation) else b) for b in group)
    return f"{told}{_numbers(group)}" if NUMBER.search(told) else told


def _rows(block: Block) -> int:
    """About how many rows of a page it fills."""
    match block:
        case Forces(_, left, right):
            parts: tuple[Inline | Line, ...] = (left, right)
        case Equation(sides, _, lead, note):
            parts = (*sides, lead, note)
        case _:
            parts = (getattr(block, "line", ()),)
    return 1 + len("".join(map(as_text, parts))) // ROW
