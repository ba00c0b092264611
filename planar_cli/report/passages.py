"""Passages as blocks: places over time, their derivatives, and how the parameter of a curve was eliminated."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import sympy as sp

from planar_cli.report.blocks import Block, Equation, Line, Math, Name, Paragraph, Text, line
from planar_cli.report.notation import plain
from planar_cli.report.words import Phrases
from planar_cli.solve.passages import Passage, Row, Tale
from planar_cli.solve.solution import Found


def tale_blocks(tale: Tale, phrases: Phrases) -> Iterator[Block]:
    """All passages of a part."""
    for passage in tale.passages:
        yield Paragraph(line(passage.heading))
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


def curve_line(found: Found, phrases: Phrases) -> Line:
    """The name of a curve, its equation, and where that holds; lengths in metres where numbers stand in it."""
    curve = found.curve
    assert curve is not None
    parts: list[Any] = [Text(curve.told(plain))]
    if curve.equation is not None and isinstance(curve.equation, sp.Eq):
        parts += [Text(", "), phrases.math(curve.equation)]
        axes = [s.name for s in sorted(curve.equation.free_symbols, key=str) if s.name in ("x", "y", "v_x", "v_y")]
        if not phrases.letters and axes:
            unit = "m/s" if axes[0].startswith("v") else "m"
            parts += [Text(" (in "), Text(unit), Text(")")]
    if curve.holds:
        parts.append(Text(f", {curve.holds}"))
    return tuple(parts)
