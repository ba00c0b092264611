"""The one mistake that explains all wrong numbers of a problem: it says more than that one follows from another."""

from __future__ import annotations

import math
from collections.abc import Iterable

from planar_cli.homework.sets.paper import WRONG, Expected, Graded
from planar_cli.homework.sets.powers_of_ten import POWER_OF_TEN

ROUNDED = 6e-3
"""Relative: of the numbers of one mistake, told by the figures that were typed, that which is meant."""
Explanation = tuple[str, str]
"""The name of a mistake and what it says."""


def common_mistake(
    graded: Iterable[tuple[Expected, Graded, tuple[float, ...] | None]],
) -> Explanation | None:
    """The mistake that gives each wrong number, of two at least; None: there is none, or several do. A decimal point
    elsewhere is none of those that are meant.
    """
    found: dict[Explanation, None] | None = None
    count = 0
    for expected, one, values in graded:
        if one.verdict != WRONG or one.value != WRONG:
            continue
        count += 1
        here = _explanations(expected, one, values)
        found = dict.fromkeys(k for k in here if found is None or k in found)
    if count < 2 or not found or len({name for name, _ in found}) > 1:
        return None
    return next(iter(found))


def is_named(one: Graded) -> bool:
    """Does one mistake give the number, and not only a decimal point elsewhere?"""
    return bool(one.feedback) and POWER_OF_TEN not in one.mistakes


def _explanations(expected: Expected, one: Graded, values: tuple[float, ...] | None) -> list[Explanation]:
    if expected.kind not in ("number", "vector"):
        return [(one.mistakes[0], one.feedback)] if is_named(one) else []
    names = set(one.mistakes) - {POWER_OF_TEN}
    given = (m for m in (*expected.mistakes, *expected.nearly) if m.name in names)
    return [
        (m.name, m.feedback)
        for m in given
        if values is not None
        and len(m.values) == len(values)
        and math.dist(m.values, values) <= ROUNDED * math.hypot(*values)
    ]
