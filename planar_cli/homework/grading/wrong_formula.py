"""What can be seen of a formula that is not the right one, and what it comes to at the places of its find."""

from __future__ import annotations

import math
from collections.abc import Sequence

from planar_cli.homework.grading.named_mistakes import WIDEST
from planar_cli.homework.sets.paper import Expected
from planar_cli.homework.typed.formula_readings import due_of, letters_of
from planar_cli.homework.typed.typed_formula import (
    Known,
    dimension,
    drawn_places,
    is_rounded,
    letters_in,
    parsed,
    values_at,
)
from planar_cli.homework.typed.unreadable import Unreadable
from planar_cli.problem.language.expression import Number
from planar_cli.problem.language.walk import walk
from planar_cli.problem.nodes.reading import listed
from planar_cli.units import PURE, describe, parse_unit

NOT_RIGHT = "the formula is not right"
"""Where nothing else is to be said."""
ALIKE = 1e-6
NUDGED, FEWEST = 0.99, 4
"""A letter is changed to this part of it to see whether a formula rests on it; so many places must have values."""


def values_of(expected: Expected, text: str) -> tuple[float, ...] | None:
    """What a typed formula comes to at the places of the find, NaN where it has no value, as the root of a negative
    number; None: it has one at too few of them.
    """
    values = values_at(text, expected.places)
    return values if values and sum(map(math.isfinite, values)) >= min(FEWEST, len(values)) else None


def same_at_places(one: Sequence[float], other: Sequence[float]) -> bool:
    """Do two formulas come to the same, and have no value at the same places?"""
    if len(one) != len(other) or not any(map(math.isfinite, one)):
        return False
    pairs = zip(one, other, strict=True)
    return all(math.isclose(a, b, rel_tol=WIDEST) or (math.isnan(a) and math.isnan(b)) for a, b in pairs)


def fits_at_places(expected: Expected, values: Sequence[float]) -> bool:
    """Is it what the right formula comes to?"""
    return same_at_places(values_at(expected.formula, expected.places), values)


def what_differs(expected: Expected, text: str) -> str:
    """What can be said of a wrong formula, read as one in letters alone, without telling the right one."""
    letters = letters_of(expected)
    if expected.letters and not letters_in(text):
        return f"a formula in letters is asked, of {', '.join(sorted(n for n, _ in letters))}"
    if (said := _of_dimension(expected, text)) and not _has_numbers_for_letters(expected, text):
        return f"{NOT_RIGHT}: {said}"
    return f"{NOT_RIGHT}: {said}" if (said := _seen(expected, text)) else NOT_RIGHT


def _of_dimension(expected: Expected, text: str) -> str:
    found, due = dimension(text, letters_of(expected)), due_of(expected)
    if found is None:
        return "its terms do not have the same dimension"
    if due is None or found == due:
        return ""
    turns = expected.rotation and due != PURE
    return f"it has the dimension of {describe(found, turns)}, and asked is {describe(due, turns)}"


def _has_numbers_for_letters(expected: Expected, text: str) -> bool:
    """May numbers stand in it for letters that the sheet gives as numbers, so that its dimension says nothing?"""
    known, right = dict(expected.known), set(letters_in(expected.formula))
    if not (right & known.keys()) - {*letters_in(text)}:
        return False
    return not known.keys() & {*letters_in(text)} or is_rounded(text) or _written_for(expected, text) != ()


def _written_for(expected: Expected, text: str) -> tuple[str, ...]:
    """The letters given as numbers that are not in a formula while their number is."""
    written = {float(n.value) for n in walk(parsed(text)) if isinstance(n, Number)}
    return tuple(n for n, v in expected.known if n not in letters_in(text) and any(math.isclose(v, w) for w in written))


def _seen(expected: Expected, text: str) -> str:
    """That a number before the letters is wrong, or which letters are; "" where there is nothing to be seen."""
    try:
        return _of_factor(expected, text) or _of_letters(expected, text)
    except (Unreadable, ValueError):
        # It has no value at the places where the right one has one.
        return ""


def _of_factor(expected: Expected, text: str) -> str:
    """Only a number before the letters is wrong. Where the letters that are given stand in it too they all count."""
    known = dict(expected.known)
    literal = any(n in known for n in letters_in(text))
    free = [n for n, _ in expected.letters if literal or n not in known]
    at = () if literal else expected.known
    same = _are_equal(_ratios(_values(expected, text, at), _values(expected, expected.formula, at)))
    if not (free and same):
        return ""
    stand, it = ("stands as it should", "it") if len(free) == 1 else ("stand as they should", "them")
    return f"{listed(free, 'and')} {stand}, but not the number before {it}"


def _of_letters(expected: Expected, text: str) -> str:
    mine, right = _letters_in(expected, text), _letters_in(expected, expected.formula)
    more = [n for n in mine if n not in right]
    less = [n for n in right if n not in mine and _is_needed(expected, text, n)]
    said = ((more, "should not stand in it"), (less, "should stand in it"))
    return "; ".join(f"{listed(names, 'and')} {words}" for names, words in said if names)


def _is_needed(expected: Expected, text: str, letter: str) -> bool:
    """Can a letter not be missing because its number stands there, or cancels that of another such letter?"""
    known = dict(expected.known)
    if letter not in known:
        return True
    if _has_numbers_for_letters(expected, text):
        return False
    units = dict(letters_of(expected))
    alike = (n for n, v in known.items() if n != letter and v == known[letter] and n in units)
    return not any(parse_unit(units[n]).dimension == parse_unit(units[letter]).dimension for n in alike)


def _letters_in(expected: Expected, text: str) -> list[str]:
    """The letters on which its value rests."""
    before = _values(expected, text, ())
    names = [n for n, _ in letters_of(expected)]
    return [n for n in names if any(abs(r - 1) > ALIKE for r in _ratios(_values(expected, text, (), n), before))]


def _values(expected: Expected, text: str, known: Known, nudged: str = "") -> tuple[float, ...]:
    """Of a formula at places of all letters, where one may be `nudged`; NaN where it has none."""
    drawn = drawn_places(letters_of(expected), known, expected.formula)
    return values_at(text, tuple(tuple((n, v * NUDGED if n == nudged else v) for n, v in place) for place in drawn))


def _ratios(one: Sequence[float], other: Sequence[float]) -> list[float]:
    """Of values where both have one. ValueError: at too few places."""
    found = [a / b for a, b in zip(one, other, strict=True) if math.isfinite(a) and math.isfinite(b) and b]
    if len(found) < FEWEST:
        raise ValueError("no value at most places")
    return found


def _are_equal(numbers: Sequence[float]) -> bool:
    return all(math.isclose(n, numbers[0], rel_tol=ALIKE) for n in numbers)
