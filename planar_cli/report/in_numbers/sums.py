"""Sums of numbers in a line: 98.1 - 40 + 7.2 = 65.3 N."""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal

from planar_cli.equation.values.ledger import display
from planar_cli.report.document.blocks import Inline, Text, Value
from planar_cli.report.notation.enough_figures import figures_of
from planar_cli.report.words.words import Phrases
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


def added(terms: Sequence[Decimal], unit: Unit, phrases: Phrases, figures: int = 0) -> list[Inline]:
    """Terms in base units, with their signs, without the unit. `figures`: where the page's are not enough of them."""
    shown, figures = [display(t, unit, phrases.ledger.us) for t in terms], figures or phrases.figures
    found: list[Inline] = [Value(shown[0], "1", figures)]
    for number in shown[1:]:
        found += [Text(" - " if number < 0 else " + "), Value(abs(number), "1", figures)]
    return found


def chain(terms: Sequence[Decimal], unit: Unit, phrases: Phrases, told: str = "") -> list[Inline]:
    """Terms in base units and what they come to, with its unit. `told`: another text of that, as J is of N m."""
    result = sum_of(terms)
    number = display(Decimal(0) if agree(terms, []) else result, unit, phrases.ledger.us)
    text = told or unit.text
    value = Value(number, text.replace("J", unit.text) if phrases.ledger.us else text, phrases.figures)
    if len(terms) < 2:
        return [value]
    shown = [display(t, unit, phrases.ledger.us) for t in terms]
    figures = phrases.figures if agree(terms, []) else figures_of(shown, sum_of, phrases.figures)
    return [*added(terms, unit, phrases, figures), Text(" = "), value]


def sum_of(terms: Sequence[Decimal]) -> Decimal:
    """What terms come to."""
    return sum(terms, Decimal(0))
