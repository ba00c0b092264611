"""An answer in letters in print."""

from __future__ import annotations

from planar_cli.records import record


@record
class ToldFormula:
    """As a page has it, and as a product: its number, and its letters; "" where it is a sum or has none."""

    text: str
    number: float
    letters: str
