"""Passages as blocks: places over time, their derivatives, and how the parameter of a curve was eliminated."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from planar_cli.report.blocks import Block, Equation, Math, Name, Paragraph, Value, line
from planar_cli.report.enough_figures import DEGREE
from planar_cli.report.swallowed import with_its_number, with_unit
from planar_cli.report.words import Phrases
from planar_cli.solve.passages import Row, Tale, sides_of
from planar_cli.units import PURE


def tale_blocks(tale: Tale, phrases: Phrases) -> Iterator[Block]:
    """All passages of a part."""
    for passage in tale.passages:
        yield Paragraph(line(*_named(passage.heading)))
        for row in passage.rows:
            yield _row(row, phrases)


def _row(row: Row, phrases: Phrases) -> Equation:
    lead = line(*_named(row.words), ":") if row.words else ()
    sides: list[Any] = [phrases.math(side) for side in sides_of(row)]
    formula = sides_of(row)[-1]
    whole = (
        None
        if row.angle or row.dimension == PURE
        else with_unit(formula, row.dimension, phrases.ledger, phrases.figures)
    )
    sides = sides if whole is None else [*sides[:-1], whole]
    if row.value is not None:
        counted, own = (formula, {}) if whole is None else with_its_number(formula)
        in_numbers = (
            phrases.numbers(counted, {**row.sizes, **own}, turns=False)
            if row.sizes and not sides_of(row)[-1].is_Symbol
            else None
        )
        last = sides_of(row)[-1]
        # Between its formula and its value a number says something only where it is no plain one: 15 π/4.
        bare = last.is_number and (len(sides) == 2 or last.is_Rational)
        sides = sides[:-1] if bare else [*sides, *([in_numbers] if in_numbers else [])]
        sides.append(phrases.of_dimension(row.value, row.dimension, row.angle) if row.value else line("0"))
        if row.angle and row.dimension == PURE and row.value and not last.is_Symbol:
            sides.append(Value(row.value / DEGREE, "deg", phrases.figures))
    if row.way:
        terms = (piece for i, term in enumerate(row.way) for piece in ((" + ", Math(term)) if i else (Math(term),)))
        sides.insert(1, line(*terms))
    return Equation(tuple(sides), None, lead, line(*_named(row.note)))


def _named(words: str) -> list[Any]:
    """Words in which names with an index, and those in backquotes, are set as mathematics."""
    pieces = re.split(r"(`\w+`|\b[A-Za-z]+(?:_\w+)+\b)", words)
    return [Name(p.strip("`")) if i % 2 else p for i, p in enumerate(pieces) if p]
