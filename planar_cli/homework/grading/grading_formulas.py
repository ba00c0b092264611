"""A formula that was typed against the right one: its value in letters, its sign, and a unit or sense behind it.

sqrt(3*g/l)    √(3g/l) rad/s    5/2 m g down    0.3214*m*g*l    0.533 v_0 rad/m
"""

from __future__ import annotations

from planar_cli.homework.grading.wrong_formula import NOT_RIGHT, what_differs
from planar_cli.homework.sets.paper import RIGHT, WRONG, Expected
from planar_cli.homework.sets.rules import Rules
from planar_cli.homework.typed.figures import too_few_in_formula
from planar_cli.homework.typed.formula_readings import READERS, Reading, letters_of, one_reading
from planar_cli.homework.typed.formula_units import in_numbers, size_and_unit
from planar_cli.homework.typed.typed_formula import SAME, check_depth, is_rounded, same_equation, same_formula
from planar_cli.homework.typed.unreadable import Unreadable
from planar_cli.records import record


@record
class FormulaVerdict:
    """value, unit and sign: right or wrong; `why`: what is said of a wrong one; `text`: the formula as it was read."""

    value: str
    unit: str
    sign: str
    text: str
    why: str = ""
    coarse: str = ""
    """What is said of too few figures in it; "" where they are enough."""
    notes: tuple[str, ...] = ()


def equation_is_right(text: str, expected: Expected) -> bool:
    """Is it the right curve? Unreadable: it is no equation of these letters."""
    names = [name for name, _ in letters_of(expected)]
    check_depth(text)
    sides = " = ".join(one_reading(side, names) for side in text.split("="))
    return any(same_equation(sides, expected.formula, letters_of(expected), known) for known in _known(expected))


def formula_verdict(text: str, expected: Expected, rules: Rules) -> FormulaVerdict:
    """What is right of a formula. Unreadable: it is none of the letters of the problem."""
    check_depth(text)
    plain = text.rsplit("=", 1)[-1].strip()
    best: FormulaVerdict | None = None
    why_not: Unreadable | None = None
    # Most are read in the first way; of the others the words tell which letters are units.
    for reading_of in READERS:
        try:
            reading = reading_of(plain, expected)
        except Unreadable as why:
            why_not = why_not or why
            continue
        if reading is None:
            continue
        found = _tried(reading, expected, rules, best)
        if found.value == found.unit == RIGHT:
            return found
        if best is None or found.value == RIGHT != best.value:
            best = found
    if best is None:
        raise why_not or Unreadable(NOT_RIGHT)
    return best


def _tried(reading: Reading, expected: Expected, rules: Rules, before: FormulaVerdict | None) -> FormulaVerdict:
    """The verdict on one reading; where it cannot be graded that on the one `before`. Unreadable: there is none."""
    try:
        return _verdict(reading, expected, rules)
    except Unreadable:
        if before is None:
            raise
        return before


def _verdict(reading: Reading, expected: Expected, rules: Rules) -> FormulaVerdict:
    size, unit, why = size_and_unit(reading, expected)
    text = in_numbers(reading, size)
    turned = _turned(reading, expected, text)
    sign, notes = _direction(reading, expected)
    tolerance = expected.tolerance if rules.tolerance is None else rules.tolerance
    allowed = tolerance if is_rounded(reading.formula) else SAME
    if _is_same(turned, expected, allowed):
        return FormulaVerdict(RIGHT, unit, sign, turned, why, _coarse(turned, reading, expected, rules), notes)
    if _is_same(f"-({turned})", expected, allowed):
        coarse = _coarse(f"-({turned})", reading, expected, rules)
        return FormulaVerdict(RIGHT, unit, WRONG, turned, why, coarse, notes)
    return FormulaVerdict(WRONG, unit, "", turned, what_differs(expected, text), notes=notes)


def _coarse(right: str, reading: Reading, expected: Expected, rules: Rules) -> str:
    """What is said of a right formula in which a number was rounded to too few figures."""
    return "" if _is_same(right, expected, SAME) else too_few_in_formula(reading.formula, rules.figures)


def _known(expected: Expected) -> tuple[tuple[tuple[str, float], ...], ...]:
    """The formula in letters, and with the numbers put in that the sheet gives for some."""
    return tuple(dict.fromkeys(((), expected.known)))


def _is_same(text: str, expected: Expected, allowed: float) -> bool:
    letters = letters_of(expected)
    return any(same_formula(text, expected.formula, letters, known, allowed) for known in _known(expected))


def _turned(reading: Reading, expected: Expected, text: str) -> str:
    """The formula with the sign that a sense or direction in words gives it; said twice it is said once."""
    way = reading.sense if expected.rotation else reading.way if reading.axis == expected.axis else 0
    return f"-({text})" if way < 0 and not reading.formula.startswith("-") else text


def _direction(reading: Reading, expected: Expected) -> tuple[str, tuple[str, ...]]:
    """The verdict on a direction in words where the formula is right, and what is said of it."""
    if reading.sense and not expected.rotation:
        raise Unreadable("a sense of rotation stands behind what does not turn")
    if reading.way and expected.axis and reading.axis != expected.axis:
        return WRONG, ()
    if reading.way and not expected.axis:
        return RIGHT, ("the direction in words is not graded here",)
    return RIGHT, ()
