"""Passages as blocks: places over time, their derivatives, and how the parameter of a curve was eliminated."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.calculus.curve_waves import SQUARED
from planar_cli.equation.algebra.plain import simplified
from planar_cli.report.document.blocks import Block, Equation, Math, Name, Paragraph, Value, line
from planar_cli.report.notation.enough_figures import DEGREE
from planar_cli.report.words.frames_apart import HODOGRAPH, PATH, SEEN
from planar_cli.report.words.swallowed import with_its_number, with_unit
from planar_cli.report.words.words import Phrases
from planar_cli.solve.passages import CURVE, PLACES, RATES, SECOND_RATES, Arm, Passage, Row, Tale, sides_of
from planar_cli.units import PURE

RESTS_ON = ((PATH, PLACES), (HODOGRAPH, RATES))
"""What the heading of a curve begins with, and the kind of the passage from which it follows."""
BEHIND = ("given", SQUARED)
AHEAD = "the velocity is a quarter turn ahead of the position"


def tale_blocks(tale: Tale, phrases: Phrases) -> Iterator[Block]:
    """All passages of a part."""
    places: tuple[Row, ...] = ()
    rates: list[Equation] = []
    for passage in in_order(tale.passages):
        yield Paragraph(line(*_named(passage.heading)))
        places = passage.rows if passage.kind == PLACES else places
        rows = [_row(row, phrases) for row in passage.rows]
        if passage.kind == SECOND_RATES:
            rows = [_constant(row, rate) for row, rate in zip(rows, rates, strict=True)] if rates else rows
        if passage.kind == RATES and len(rows) == _of_second(tale):
            rates = rows
        if passage.kind == RATES and is_quarter_turn(places, passage.rows) and not rows[-1].note:
            rows[-1] = replace(rows[-1], note=line(AHEAD))
        for row, told in zip(passage.rows, rows, strict=True):
            yield from () if row.arm is None else [_arm(row.arm, phrases)]
            yield told


def is_quarter_turn(places: Sequence[Row], rates: Sequence[Row]) -> bool:
    """Is the velocity the position vector, turned by a quarter the way in which the point goes, times a factor?"""
    if len(places) != 2 or len(rates) != 2:
        return False
    (x, y), (v_x, v_y) = ([sides_of(row)[-1] for row in rows] for rows in (places, rates))
    # x of one point and y of another are no vector.
    things = {str(sides_of(row)[0]).partition("_")[2] for row in places}
    if len(things) > 1 or 0 in (x, y, v_x, v_y):
        return False
    along, across = simplified(v_y / x), simplified(v_x / y)
    return bool(simplified(along + across) == 0)


def _of_second(tale: Tale) -> int:
    """How many lines there are of second derivatives."""
    return next((len(p.rows) for p in tale.passages if p.kind == SECOND_RATES), 0)


def _constant(row: Equation, rate: Equation) -> Equation:
    """ẍ_G = 0 with its reason beside it, where ẋ_G is not zero."""
    idle = row.note or len(row.sides) != 2 or row.sides[1] not in (Math(sp.S.Zero), line("0"))
    moves = rate.sides[-1] not in (Math(sp.S.Zero), line("0"))
    return row if idle or not moves else replace(row, note=line(rate.sides[0], " is constant"))


def in_order(passages: Sequence[Passage]) -> list[Passage]:
    """A path right after the places, and a hodograph right after the velocities, on which alone they rest."""
    found = list(passages)
    for passage in passages:
        after = next((kind for words, kind in RESTS_ON if passage.heading.startswith(words)), "")
        place = next((i for i, p in enumerate(found) if p.kind == after), None) if SEEN not in passage.heading else None
        if passage.kind == CURVE and after and place is not None and place < found.index(passage):
            found.remove(passage)
            later = (i for i in range(place + 1, len(found)) if found[i].kind != CURVE)
            found.insert(next(later, len(found)), passage)
    return found


def _row(row: Row, phrases: Phrases) -> Equation:
    # A word or a reason stands behind a line that has no other remark.
    behind = row.words in BEHIND and not row.note
    lead = line(*_named(row.words), ":") if row.words and not behind else ()
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
        sides.insert(1, line(*(piece for i, term in enumerate(row.way) for piece in _term(term, first=not i))))
    return Equation(tuple(sides), None, lead, line(*_named(row.words if behind else row.note)))


def _term(term: sp.Expr, first: bool) -> tuple[Any, ...]:
    """A term of a sum that is written as it stands."""
    less = not first and bool(term.could_extract_minus_sign())
    return (*(() if first else (" - " if less else " + ",)), Math(-term if less else term))


def _arm(arm: Arm, phrases: Phrases) -> Equation:
    """r_P/G = [r cos(270° - φ), r sin(270° - φ)] = [-r sin φ, -r cos φ]"""
    name = Name(f"r_{arm.point.replace('_', ',')}/{arm.origin.replace('_', ',')}")
    vectors = dict.fromkeys((arm.measured, arm.components))
    shown = [line("[", Math(x), ", ", Math(y), "]") for x, y in vectors]
    return Equation((name, *shown))


def _named(words: str) -> list[Any]:
    """Words in which names with an index, and those in backquotes, are set as mathematics."""
    pieces = re.split(r"(`\w+`|\b[A-Za-z]+(?:_\w+)+\b)", words)
    return [Name(p.strip("`")) if i % 2 else p for i, p in enumerate(pieces) if p]
