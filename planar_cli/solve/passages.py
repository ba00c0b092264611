"""Passages of a solution that are told beside its equations: places as functions, curves and how they were found."""

from __future__ import annotations

from typing import Any

import sympy as sp

from planar_cli.records import record


@record
class Row:
    """Words before a line, and the line: an equation, its sides one after the other, or a formula."""

    words: str
    line: Any


def sides_of(row: Row) -> tuple[Any, ...]:
    """All sides of the line of a row."""
    if isinstance(row.line, sp.Eq):
        return row.line.lhs, row.line.rhs
    return row.line if isinstance(row.line, tuple) else (row.line,)


@record
class Passage:
    """A sentence, and the lines that it introduces."""

    heading: str
    rows: tuple[Row, ...]


@record
class Tale:
    """What a part tells by itself. `whole`: its instants need no telling of their own, but for their checks."""

    passages: tuple[Passage, ...]
    whole: bool = True


def told_function(function: Any) -> Row:
    """A coordinate as a function, with the words from where it comes."""
    return Row(function.words, sp.Eq(function.symbol, function.expr, evaluate=False))
