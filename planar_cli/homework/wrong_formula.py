"""What can be seen of a formula that is not the right one, and what it comes to at the places of its find."""

from __future__ import annotations

import math
from collections.abc import Sequence

from planar_cli.homework.named_mistakes import WIDEST
from planar_cli.homework.paper import Expected
from planar_cli.homework.typed_formula import drawn_places, values_at
from planar_cli.homework.unreadable import Unreadable
from planar_cli.problem.reading import listed

ALIKE = 1e-6
NUDGED, FEWEST = 0.99, 4
"""A letter is changed to this part of it to see whether a formula rests on it; so many places must have values."""


def values_of(expected: Expected, text: str) -> tuple[float, ...] | None:
    """What a typed formula comes to at the places of the find; None: it has no value there."""
    values = values_at(text, expected.places)
    return values if values and all(map(math.isfinite, values)) else None


def same_at_places(one: Sequence[float], other: Sequence[float]) -> bool:
    """Do two formulas come to the same?"""
    return len(one) == len(other) and all(math.isclose(a, b, rel_tol=WIDEST) for a, b in zip(one, other, strict=True))


def fits_at_places(expected: Expected, values: Sequence[float]) -> bool:
    """Is it what the right formula comes to?"""
    return same_at_places(values_at(expected.formula, expected.places), values)


def seen(expected: Expected, text: str) -> str:
    """That a number before the letters is wrong, or which letters are; "" where there is nothing to be seen."""
    try:
        return _of_factor(expected, text) or _of_letters(expected, text)
    except (Unreadable, ValueError):
        # It has no value at the places where the right one has one.
        return ""


def _of_factor(expected: Expected, text: str) -> str:
    free = [n for n, _ in expected.letters if n not in dict(expected.known)]
    same = _are_equal(_ratios(_values(expected, text), _values(expected, expected.formula)))
    if not (free and same):
        return ""
    stand, it = ("stands as it should", "it") if len(free) == 1 else ("stand as they should", "them")
    return f"{listed(free, 'and')} {stand}, but not the number before {it}"


def _of_letters(expected: Expected, text: str) -> str:
    mine, right = _letters_in(expected, text), _letters_in(expected, expected.formula)
    more, less = [n for n in mine if n not in right], [n for n in right if n not in mine]
    said = ((more, "should not stand in it"), (less, "should stand in it"))
    return "; ".join(f"{listed(names, 'and')} {words}" for names, words in said if names)


def _letters_in(expected: Expected, text: str) -> list[str]:
    """The letters on which its value rests, but for those that are given as numbers."""
    before = _values(expected, text)
    free = [n for n, _ in (*expected.letters, *expected.others) if n not in dict(expected.known)]
    return [n for n in free if any(abs(r - 1) > ALIKE for r in _ratios(_values(expected, text, n), before))]


def _values(expected: Expected, text: str, nudged: str = "") -> tuple[float, ...]:
    """Of a formula at places of all letters, where one may be `nudged`; NaN where it has none."""
    drawn = drawn_places((*expected.letters, *expected.others), expected.known, expected.formula)
    return values_at(text, tuple(tuple((n, v * NUDGED if n == nudged else v) for n, v in place) for place in drawn))


def _ratios(one: Sequence[float], other: Sequence[float]) -> list[float]:
    """Of values where both have one. ValueError: at too few places."""
    found = [a / b for a, b in zip(one, other, strict=True) if math.isfinite(a) and math.isfinite(b) and b]
    if len(found) < FEWEST:
        raise ValueError("no value at most places")
    return found


def _are_equal(numbers: Sequence[float]) -> bool:
    return all(math.isclose(n, numbers[0], rel_tol=ALIKE) for n in numbers)
