"""What a reader of a page does not need: a line that stands just above, the name of the only body that is drawn over
its sums of forces, the time of a state that a blow does not change, what nothing after it speaks of, and a line of its
own for the reason of a root.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TypeGuard

from planar_cli.report.blocks import Block, Equation, Forces, Math, Name, Paragraph, Text
from planar_cli.report.left_out import tells_the_root
from planar_cli.report.mentioned import pieces_of
from planar_cli.report.one_name import renamed

BLOW = "a blow takes no time"
"""The remark on the time of a state just after a blow."""
STILL = "nothing moves during a blow"
"""The remark on a place just after a blow."""


def without_idle_lines(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a part."""
    told = with_times_of_blows(list(said_above(blocks)))
    return with_roots_beside(list(without_unused_places(told)))


def said_above(blocks: Sequence[Block]) -> Iterator[Block]:
    """Blocks without a line that only repeats the one above, and without the name of the body whose diagram alone
    stands there.
    """
    for i, block in enumerate(blocks):
        last = blocks[i - 1] if i else None
        alone = isinstance(last, Forces) and (i < 2 or not isinstance(blocks[i - 2], Forces))
        if alone and isinstance(last, Forces) and _words(block) == f"{last.body}:":
            continue
        if block == last and isinstance(block, Equation) and block.number is None:
            continue
        yield block


def _words(block: Block) -> str:
    """A sentence of words alone."""
    if not isinstance(block, Paragraph) or not all(isinstance(p, Text) for p in block.line):
        return ""
    return "".join(p.text for p in block.line if isinstance(p, Text))


def with_times_of_blows(blocks: Sequence[Block]) -> list[Block]:
    """Blocks with one letter for the time of a blow: that of the state just before it."""
    same: dict[str, str] = {}
    kept: list[Block] = []
    for block in blocks:
        names = _carried(block, BLOW)
        if len(names) < 2:
            kept.append(block)
        else:
            same |= {name: same.get(names[-1], names[-1]) for name in names[:-1]}
    return renamed(kept, same) if same else kept


def _carried(block: Block, remark: str) -> list[str]:
    """The letters of states that are equal as nothing happens to them in a blow, t_3 = t_2."""
    if not isinstance(block, Equation) or block.note != (Text(remark),):
        return []
    return [s.expr.name for s in block.sides if isinstance(s, Math) and s.expr.is_Symbol]


def without_unused_places(blocks: Sequence[Block]) -> Iterator[Block]:
    """Blocks without a place that a blow does not change, where nothing else speaks of it."""
    spoken = Counter(name for block in blocks for name in _letters(block))
    for block in blocks:
        names = _carried(block, STILL)
        if len(names) != 2 or spoken[names[0]] > 1:
            yield block


def _letters(block: Block) -> set[str]:
    """The letters of which a block speaks."""
    found: set[str] = set()
    for piece in pieces_of(block):
        match piece:
            case Name(name):
                found.add(name)
            case Math(expr):
                found |= {s.name for s in expr.free_symbols}
    return found


def with_roots_beside(blocks: Sequence[Block]) -> list[Block]:
    """Blocks in which the reason of a root stands beside the equation that has it, before its solution; beside the
    solution, where something else stands there already.
    """
    found: list[Block] = []
    for block in blocks:
        if isinstance(block, Paragraph) and tells_the_root(block):
            last, before = [*found[:-3:-1], None, None][:2]
            if _is_bare(before) and before.number is not None:
                found[-2] = replace(before, note=block.line)
                continue
            if _is_bare(last):
                found[-1] = replace(last, note=block.line)
                continue
        found.append(block)
    return found


def _is_bare(block: Block | None) -> TypeGuard[Equation]:
    """Is it an equation with nothing beside it?"""
    return isinstance(block, Equation) and not block.note
