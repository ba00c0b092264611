"""Answers as a key tells them: `12.74 N to the left`, `[3, -4] m/s`."""

from __future__ import annotations

import math
from collections.abc import Sequence
from decimal import ROUND_HALF_UP, Decimal

from planar_cli.solve.solution import Found
from planar_cli.units import pretty_unit

TRUTHS = {"true": "yes", "false": "no"}


def key_text(found: Found, unit_text: str, values: Sequence[float], sense: tuple[str, str]) -> str:
    """As a key tells it: four figures, the unit, the sense in words. `sense`: of plus and of minus; "" where the number
    has its sign.
    """
    if found.word:
        return TRUTHS.get(found.word, found.word)
    unit = pretty_unit(unit_text)
    behind = unit if unit == "°" else f" {unit}" if unit else ""
    if len(values) == 1 and sense[0] and values[0]:
        return f"{shown(abs(values[0]))}{behind} {sense[values[0] < 0]}"
    numbers = ", ".join(shown(v) for v in values)
    return f"[{numbers}]{behind}" if len(values) > 1 else f"{numbers}{behind}"


def shown(value: float, figures: int = 4) -> str:
    """A number with so many significant figures, without an exponent where it is of ordinary size."""
    if not value or not math.isfinite(value):
        return "0" if not value else str(value)
    if not 1e-4 <= abs(value) < 1e7:
        return f"{value:.{figures - 1}e}"
    places = max(figures - 1 - math.floor(math.log10(abs(value))), 0)
    # Half a unit is rounded up, as on the page: 14.715 is 14.72, whatever its last binary digit.
    text = str(Decimal(f"{value:.12g}").quantize(Decimal(1).scaleb(-places), ROUND_HALF_UP))
    exact = f"{value:.10g}"
    return exact if len(exact) < len(text) and "e" not in exact else text
