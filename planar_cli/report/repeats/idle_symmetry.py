"""Where one of two bodies that move alike is by the other, where nothing else on the page speaks of that: the sentence
that they do stays, without its equation and without the places that only it needs.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from planar_cli.report.document.blocks import Block, Equation, Heading, Math, Paragraph, Text
from planar_cli.report.document.mentioned import pieces_of

ALIKE = "by symmetry:"
MEANS = ": the way of "
NUMBER = re.compile(r"\((\d+)\)")


def without_idle_symmetry(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a part, numbered anew behind what was left out."""
    kept = list(blocks)
    for i in reversed(range(len(kept) - 1)):
        block, after = kept[i], kept[i + 1]
        if not isinstance(block, Paragraph) or not _ends(block, ALIKE) or not isinstance(after, Equation):
            continue
        letter, number = _letter(after), after.number
        if not letter or number is None or _spoken(kept)[letter] > 1:
            continue
        last = block.line[-1]
        assert isinstance(last, Text)
        sentence = replace(block, line=(*block.line[:-1], Text(f"{last.text.removesuffix(':')}.")))
        kept[i : i + 2] = [sentence]
        kept = _without_places([renumbered(b, number) for b in kept], after)
    return kept


def _without_places(blocks: Sequence[Block], gone: Equation) -> list[Block]:
    """Blocks without the places that only the equation spoke of, and without what their letters mean."""
    spoken, others = _spoken(blocks), _letters(gone)
    kept: list[Block] = []
    for block in blocks:
        letter = _letter(block) if isinstance(block, Equation) and block.number is None else ""
        if letter in others and spoken[letter] == 1 and isinstance(block, Equation) and kept:
            if not block.lead and _ends(kept[-1], ":"):
                kept.pop()
                continue
            if _ends(Paragraph(block.lead), ":"):
                continue
        kept.append(block)
    spoken = _spoken(kept)
    return [b for b in kept if not _is_unused_meaning(b, spoken)]


def _is_unused_meaning(block: Block, spoken: Counter[str]) -> bool:
    """Does it only say what ways are of which nothing speaks?"""
    if not isinstance(block, Paragraph) or not any(isinstance(p, Text) and MEANS in p.text for p in block.line):
        return False
    own = _letters(block)
    families = [n for n in spoken if any(n == s or n.startswith((f"{s}__", f"{s}_d")) for s in own)]
    return sum(spoken[n] for n in families) <= len(own)


def renumbered(block: Any, gone: int) -> Any:
    """A block with the number that its equations have when one before them is left out."""
    if isinstance(block, Equation):
        number = block.number - 1 if block.number is not None and block.number > gone else block.number
        return replace(block, number=number, lead=_line(block.lead, gone), note=_line(block.note, gone))
    if isinstance(block, Paragraph):
        return replace(block, line=_line(block.line, gone))
    if isinstance(block, Heading) and isinstance(block.aside, str):
        return replace(block, aside=_shifted(block.aside, gone))
    return replace(block, aside=_line(block.aside, gone)) if isinstance(block, Heading) else block


def _line(line: Any, gone: int) -> Any:
    return tuple(Text(_shifted(p.text, gone)) if isinstance(p, Text) else p for p in line)


def _shifted(text: str, gone: int) -> str:
    return NUMBER.sub(lambda m: f"({int(m[1]) - (int(m[1]) > gone)})", text)


def _ends(block: Block, words: str) -> bool:
    told = block.line if isinstance(block, Paragraph) else ()
    return "".join(p.text for p in told if isinstance(p, Text)).endswith(words) and isinstance(told[-1], Text)


def _letter(block: Equation) -> str:
    first = block.sides[0]
    return first.expr.name if isinstance(first, Math) and first.expr.is_Symbol else ""


def _letters(block: Block) -> set[str]:
    return {s.name for p in pieces_of(block) if isinstance(p, Math) for s in p.expr.free_symbols}


def _spoken(blocks: Sequence[Block]) -> Counter[str]:
    return Counter(name for block in blocks for name in _letters(block))
