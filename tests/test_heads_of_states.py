"""Headings of states that follow each other, each over one line, stand before these lines."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from planar_cli.report.blocks import Block, Equation, Math, Paragraph, line
from planar_cli.report.heads_of_states import with_states_headed_once

LINES = [Equation((Math(sp.Symbol(x)), Math(sp.Symbol("u")))) for x in "abc"]


def _leads(blocks: Sequence[Block]) -> list[str]:
    return ["".join(map(str, b.lead)) if isinstance(b, Equation) else "heading" for b in blocks]


def test_several_stand_before_their_lines() -> None:
    heads = [Paragraph(line(f"At {i}:")) for i in (3, 4, 5)]
    blocks = [b for pair in zip(heads, LINES, strict=True) for b in pair]
    assert _leads(with_states_headed_once(blocks)) == [str(*line(f"At {i}:")) for i in (3, 4, 5)]


def test_one_and_those_over_several_lines_stay() -> None:
    one, other = (Paragraph(line(f"At {i}:")) for i in (3, 4))
    for blocks in ([one, LINES[0]], [one, LINES[0], other, *LINES[1:]]):
        assert with_states_headed_once(blocks) == blocks
