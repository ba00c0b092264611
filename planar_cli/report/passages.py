"""Passages as blocks: places over time, their derivatives, and how the parameter of a curve was eliminated."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import sympy as sp

from planar_cli.report.blocks import Block, Equation, Name, Paragraph, line
from planar_cli.report.words import Phrases
from planar_cli.solve.passages import Row, Tale


def tale_blocks(tale: Tale, phrases: Phrases) -> Iterator[Block]:
    """All passages of a part."""
    for passage in tale.passages:
        yield Paragraph(line(*_named(passage.heading)))
        for row in passage.rows:
            yield _row(row, phrases)


def _row(row: Row, phrases: Phrases) -> Equation:
    lead = line(*_named(row.words), ":") if row.words else ()
    if isinstance(row.line, sp.Eq):
        return Equation((phrases.math(row.line.lhs), phrases.math(row.line.rhs)), None, lead)
    return Equation((phrases.math(row.line),), None, lead)


def _named(words: str) -> list[Any]:
    """Words in which names with an index are set as mathematics."""
    pieces = re.split(r"(\b[A-Za-z]+(?:_\w+)+\b)", words)
    return [Name(p) if i % 2 else p for i, p in enumerate(pieces) if p]
