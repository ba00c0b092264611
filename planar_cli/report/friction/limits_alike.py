"""Contacts that reach the limit of friction together are told once, and so is the assumption that a body does not slip
at several points.

At the largest F: friction at A and B reaches its limit, it is about to slip:
  (1)  F_B = μ N_B
  (2)  F_A = μ N_A
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from planar_cli.report.document.blocks import Block, Equation, Inline, Line, Name, Paragraph, Text

AT_LIMIT = re.compile(r".*friction at \S+ reaches its limit, .*")
HOLDS = re.compile(r"(?P<before>.*) at (?P<place>\S+)(?P<after> does not slip| slips)")


def with_limits_alike(blocks: Iterable[Block]) -> list[Block]:
    """Equations of limits, those that stand below each other with one sentence over them."""
    kept: list[Block] = []
    head: int | None = None
    for block in blocks:
        if isinstance(block, Paragraph):
            above = kept[head] if head is not None else None
            if isinstance(above, Paragraph) and head is not None and (both := _joined(above.line, block.line)):
                kept[head] = Paragraph(both)
                continue
            head = len(kept) if AT_LIMIT.fullmatch("".join(map(_word, block.line))) else None
        elif not isinstance(block, Equation):
            head = None
        kept.append(block)
    return kept


def _joined(one: Line, other: Line) -> Line:
    """Both sentences as one; empty where they differ in more than the place."""
    if len(one) != len(other) or not AT_LIMIT.fullmatch("".join(map(_word, other))):
        return ()
    differ = [i for i, pair in enumerate(zip(one, other, strict=True)) if pair[0] != pair[1]]
    if len(differ) != 1:
        return ()
    (i,) = differ
    first, second = sorted((one[i], other[i]), key=_word)
    return (*one[:i], first, Text(" and "), second, *one[i + 1 :])


def _word(piece: Inline) -> str:
    match piece:
        case Text(text):
            return text
        case Name(name):
            return name
    return "…"


def assumed_alike(words: Iterable[str]) -> list[str]:
    """What is assumed, of a body that does not slip at two points told once: crate does not slip at A or B."""
    kept: list[str] = []
    for one in words:
        places = next(((i, found) for i, w in enumerate(kept) if (found := _places(w, one))), None)
        match = HOLDS.fullmatch(one)
        if places is None or match is None:
            kept.append(one)
        else:
            word = "or" if " not " in match["after"] else "and"
            kept[places[0]] = f"{match['before']}{match['after']} at {f' {word} '.join(places[1])}"
    return kept


def _places(one: str, other: str) -> list[str]:
    """The places of both, where the words are the same; empty where they are not."""
    here, there = HOLDS.fullmatch(one), HOLDS.fullmatch(other)
    if here is None or there is None or here.group("before", "after") != there.group("before", "after"):
        return []
    return sorted((here["place"], there["place"]))
