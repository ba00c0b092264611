"""Which inequality tells values apart that fit alike."""

from __future__ import annotations

from collections.abc import Sequence

from planar_cli.units import Unit

MOST_FIGURES = 8
IN_GENERAL = "say which is meant, with an inequality of it under `assume`"


def hint_between(name: str, unit: Unit, values: Sequence[float]) -> str:
    """What to write of a constant that has several values, in its unit."""
    relation = relation_between(name, unit, values)
    return f"say which is meant: `assume: [{relation}]`, or with `>`" if relation else IN_GENERAL


def relation_between(name: str, unit: Unit, values: Sequence[float]) -> str:
    """An inequality with a round number between the lowest two of several values; "": they are the same."""
    low, high, *_ = [*sorted(set(values)), 0.0, 0.0]
    middle = (low + high) / 2
    rounded = [0.0, *(float(f"{middle:.{figures}g}") for figures in range(1, MOST_FIGURES))]
    between = next((number for number in rounded if low < number < high), None)
    if between is None:
        return ""
    limit = f"{between:g}" if unit.text == "1" or not between else f"{between:g} {unit.text}"
    return f"{name} < {limit}"
