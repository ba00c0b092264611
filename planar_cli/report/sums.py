"""Sums of numbers in a line: 98.1 - 40 + 7.2 = 65.3 N."""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal

from planar_cli.equation.ledger import display
from planar_cli.report.blocks import Inline, Text, Value
from planar_cli.report.words import Phrases
from planar_cli.units import Unit

ROUNDING = Decimal("1e-9")
"""In parts of the largest term: what is smaller is the rounding of zero."""


def agree(one: Sequence[Decimal], other: Sequence[Decimal]) -> bool:
    """Do two sums agree to all digits that are certain?"""
    largest = max((abs(t) for t in (*one, *other)), default=Decimal(0))
    return abs(sum(one, Decimal(0)) - sum(other, Decimal(0))) <= largest * ROUNDING


def counting(terms: Sequence[Decimal]) -> list[Decimal]:
    """The terms that are not zero."""
    largest = max((abs(t) for t in terms), default=Decimal(0))
    return [t for t in terms if abs(t) > largest * ROUNDING]


def added(terms: Sequence[Decimal], unit: Unit, phrases: Phrases) -> list[Inline]:
    """Terms in base units, with their signs, without the unit."""
    shown = [display(t, unit, phrases.ledger.us) for t in terms]
    found: list[Inline] = [Value(shown[0], "1", phrases.figures)]
    for number in shown[1:]:
        found += [Text(" - " if number < 0 else " + "), Value(abs(number), "1", phrases.figures)]
    return found


def chain(terms: Sequence[Decimal], unit: Unit, phrases: Phrases, told: str = "") -> list[Inline]:
    """Terms in base units and what they come to, with its unit. `told`: another text of that, as J is of N m."""
    result = sum(terms, Decimal(0))
    number = display(Decimal(0) if agree(terms, []) else result, unit, phrases.ledger.us)
    text = told or unit.text
    value = Value(number, text.replace("J", unit.text) if phrases.ledger.us else text, phrases.figures)
    return [*added(terms, unit, phrases), Text(" = "), value] if len(terms) > 1 else [value]
