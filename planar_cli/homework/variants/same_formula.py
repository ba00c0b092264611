"""A formula of a variant beside that of the file: its sign, and whether that of the file holds in the variant too."""

from __future__ import annotations

import math
from dataclasses import replace

from planar_cli.homework.sets.paper import Expected
from planar_cli.homework.typed.typed_formula import drawn_places, values_at
from planar_cli.homework.typed.unreadable import Unreadable
from planar_cli.homework.variants.told_formula import ToldFormula

SAME = 1e-9
"""Relative: two formulas come to the same number."""


def formula_changes_sign(before: Expected, now: Expected) -> bool:
    """Has the answer of a variant another sign than that of the file, for the same values of the letters that neither
    gives? Both have the numbers that their sheets give.
    """
    letters = _letters(before, now)
    try:
        pairs = [values_at(e.formula, drawn_places(letters, e.known, e.formula)) for e in (before, now)]
    except Unreadable:
        return False
    return any(one * other < 0 for one, other in zip(*pairs, strict=False))


def as_in_file(before: Expected, now: Expected, told: ToldFormula | None) -> Expected:
    """The answer of a variant with the formula of the file where that is right in the variant too: where the rod is hit
    at its end, b = l, the solution has only one of the two. Else with its own, as it is `told`.
    """
    if now.kind != "formula" or now.formula == before.formula:
        return now
    try:
        places = drawn_places(_letters(before, now), now.known, now.formula)
        pairs = list(zip(values_at(before.formula, places), values_at(now.formula, places), strict=True))
    except Unreadable:
        pairs = []
    if pairs and all(math.isclose(a, b, rel_tol=SAME) for a, b in pairs):
        now = replace(now, formula=before.formula, letters=before.letters, others=before.others)
        return replace(now, text=before.text, mistakes=before.mistakes)
    return now if told is None else replace(now, text=told.text)


def _letters(before: Expected, now: Expected) -> tuple[tuple[str, str], ...]:
    return tuple({**dict(before.letters), **dict(now.letters)}.items())
