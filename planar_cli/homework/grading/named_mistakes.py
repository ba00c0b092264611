"""A wrong number or formula that a typical mistake gives: the mistake is named, where just one gives it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from planar_cli.homework.sets.paper import Expected, Graded, Mistaken
from planar_cli.homework.sets.powers_of_ten import LOOK, OFF_BY_TEN, POWER_OF_TEN, POWERS, is_of_a_datum
from planar_cli.homework.typed.typed import Typed
from planar_cli.homework.typed.unreadable import Unreadable

FEWEST = 3
"""A number of fewer figures fits too many mistakes to tell of any, unless the sheet asks for no more."""
WIDEST = 2e-3
"""Relative: what rounded numbers in a formula change, and what is left of a zero beside another component."""
LAST_PLACE = 0.6
"""Of a unit in the last place: rounded once, and a little for what was rounded before."""

LARGEST_WHOLE = 1e15
"""Beyond it not all digits of a number are certain."""
AT_PLACES = 1e-7
"""Relative: what equations that are solved in numbers come to may be off by this."""


def named(one: Graded, expected: Expected, values: Sequence[float], answer: Typed, asked: int) -> Graded:
    """The verdict with the mistakes that give this number, as far as it was written out: one is told to the student,
    several are only listed. `asked`: significant figures that the sheet asks for.
    """
    told = [f for f, v in zip(answer.figures, values, strict=False) if v]
    if not told or min(told) < min(FEWEST, asked):
        return one
    places = _last_places(values, answer, asked)
    fits = [m for m in expected.mistakes if _same(m.values, values, places)]
    if not fits:
        # The number is not right: what is hardly further off tells of it too, but for a datum of little influence.
        near = (m for m in expected.nearly if not is_of_a_datum(m.feedback))
        fits = [m for m in near if _same(m.values, values, places)]
    return _told(one, fits)


def named_formula(one: Graded, expected: Expected, text: str) -> Graded:
    """The same of a wrong formula."""
    from planar_cli.homework.typed.typed_formula import SAME, is_rounded, same_formula, values_at

    letters = (*expected.letters, *expected.others)
    tolerance = WIDEST if is_rounded(text) else SAME

    def is_it(wrong: Mistaken) -> bool:
        try:
            if not wrong.formula:
                pairs = zip(values_at(text, expected.places), wrong.values, strict=True)
                return all(math.isclose(a, b, rel_tol=max(tolerance, AT_PLACES)) for a, b in pairs)
            return same_formula(text, wrong.formula, letters, expected.known, tolerance)
        except Unreadable:
            # Where the two have no values in common nothing is told of the mistake; the answer is wrong all the same.
            return False

    fits = [m for m in expected.mistakes if is_it(m)]
    if not fits and is_rounded(text):
        # As of a number: what is more to the point comes first.
        slips = (Mistaken(POWER_OF_TEN, OFF_BY_TEN, (), f"10^({p})*({expected.formula})") for p in POWERS)
        fits = [m for m in slips if is_it(m)]
    return _told(one, fits)


def _told(one: Graded, fits: Sequence[Mistaken]) -> Graded:
    # Mistakes that come to the same number by the same words are one.
    names = tuple(dict.fromkeys(m.name for m in fits))
    feedback = fits[0].feedback if len(names) == 1 else ""
    if is_of_a_datum(feedback) and len({m.feedback for m in fits}) > 1:
        # Ten times the mass, or a tenth of the stiffness.
        feedback = f"a given value was put in off by a power of ten: {LOOK}"
    return replace(one, mistakes=names, feedback=feedback)


def _last_places(values: Sequence[float], answer: Typed, asked: int) -> list[float]:
    """A unit in the last place that was typed of each number, in the unit of the find; 0 of a zero. Zeros at the end of
    a whole number may fill it up behind the figures that are `asked`: 4150 has three.
    """
    told = [max(f - _zeros_at_its_end(v), min(f, asked)) for f, v in zip(answer.figures, answer.values, strict=False)]
    as_typed = math.hypot(*answer.values)
    factor = 1.0 if answer.polar or not as_typed else math.hypot(*values) / as_typed
    return [
        factor * 10.0 ** (math.floor(math.log10(abs(v) / factor)) - f + 1) if v else 0.0
        for v, f in zip(values, told, strict=False)
    ]


def _zeros_at_its_end(value: float) -> int:
    """Of a whole number; 0 of any other."""
    digits = f"{abs(value):.0f}" if value == round(value) and abs(value) < LARGEST_WHOLE else ""
    return len(digits) - len(digits.rstrip("0"))


def _same(due: Sequence[float], values: Sequence[float], places: Sequence[float]) -> bool:
    if len(due) != len(values):
        return False
    if len(values) == 1:
        return abs(due[0] - values[0]) <= _least(values[0], places[0])
    size = math.hypot(*values)
    return bool(size) and all(_close(a, b, p, size) for a, b, p in zip(due, values, places, strict=False))


def _close(due: float, value: float, place: float, size: float) -> bool:
    """Is a number as typed that which is due? Beside another component a zero has no figures of its own."""
    if not math.isfinite(due):
        return False
    if not value:
        return abs(due) <= WIDEST * size
    return abs(due - value) <= _least(value, place)


def _least(value: float, place: float) -> float:
    """How far off a number that was typed may be that has this unit in its last place."""
    return max(LAST_PLACE * place, 1e-6 * abs(value))
