"""A formula that was typed against the right one: its value in letters, its sign, and a unit or sense behind it.

sqrt(3*g/l)    √(3g/l) rad/s    5/2 m g down    0.3214*m*g*l
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from itertools import islice

from planar_cli.base_units import in_base
from planar_cli.homework.figures import too_few_in_formula
from planar_cli.homework.paper import RIGHT, WRONG, Expected
from planar_cli.homework.rules import Rules
from planar_cli.homework.typed_directions import without_direction
from planar_cli.homework.typed_formula import SAME, dimension, is_rounded, letters_in, same_equation, same_formula
from planar_cli.homework.typed_letters import readings
from planar_cli.homework.typed_units import unit_of
from planar_cli.homework.unreadable import Unreadable
from planar_cli.records import record
from planar_cli.units import PURE, Dimension, Unit, describe

NOT_RIGHT = "the formula is not right"
"""Where nothing else is to be said."""
DEEPEST = 30
"""Brackets in brackets."""
MOST_WORDS = 6
"""Of a unit."""
_UNIT_IN_BRACKETS = re.compile(r"(.*\S)\s*[\[(]\s*(?:in\s+)?([^\[\]()]+)[\])]")


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


@record
class _Behind:
    """A formula, and what stands behind it."""

    formula: str
    unit: Unit | None = None
    sense: int = 0
    axis: str = ""
    way: int = 0


def equation_is_right(text: str, expected: Expected) -> bool:
    """Is it the right curve? Unreadable: it is no equation of these letters."""
    names = [name for name, _ in (*expected.letters, *expected.others)]
    _check_depth(text)
    sides = " = ".join(_one_reading(side, names) for side in text.split("="))
    return any(same_equation(sides, expected.formula, _letters(expected), known) for known in _known(expected))


def formula_verdict(text: str, expected: Expected, rules: Rules) -> FormulaVerdict:
    """What is right of a formula. Unreadable: it is none of the letters of the problem."""
    names = [name for name, _ in _letters(expected)]
    _check_depth(text)
    behind = _taken_apart(text.rsplit("=", 1)[-1].strip(), names)
    found = _meant(readings(behind.formula, names), expected)
    _check_letters(found, names)
    turned = _turned(behind, expected, found)
    sign, notes = _direction(behind, expected)
    tolerance = expected.tolerance if rules.tolerance is None else rules.tolerance
    unit, why = _unit(behind.unit, expected)
    if _is_same(turned, expected, tolerance):
        return FormulaVerdict(RIGHT, unit, sign, turned, why, _coarse(turned, found, expected, rules), notes)
    if _is_same(f"-({turned})", expected, tolerance):
        coarse = _coarse(f"-({turned})", found, expected, rules)
        return FormulaVerdict(RIGHT, unit, WRONG, turned, why, coarse, notes)
    return FormulaVerdict(WRONG, unit, "", turned, _what_differs(found, expected, names), notes=notes)


def _coarse(right: str, typed: str, expected: Expected, rules: Rules) -> str:
    """What is said of a right formula in which a number was rounded to too few figures."""
    return "" if _is_same(right, expected, SAME) else too_few_in_formula(typed, rules.figures)


def _letters(expected: Expected) -> tuple[tuple[str, str], ...]:
    return (*expected.letters, *expected.others)


def _known(expected: Expected) -> tuple[tuple[tuple[str, float], ...], ...]:
    """The formula in letters, and with the numbers put in that the sheet gives for some."""
    return tuple(dict.fromkeys(((), expected.known)))


def _is_same(text: str, expected: Expected, tolerance: float) -> bool:
    allowed = tolerance if is_rounded(text) else SAME
    letters = _letters(expected)
    return any(same_formula(text, expected.formula, letters, known, allowed) for known in _known(expected))


def _check_depth(text: str) -> None:
    depth = 0
    for character in text:
        depth += (character in "([{") - (character in ")]}")
        if depth > DEEPEST:
            raise Unreadable("the brackets are nested too deeply")


# --- reading ---------------------------------------------------------------------------------------------------------


def _taken_apart(text: str, names: Collection[str]) -> _Behind:
    """The formula before a unit, a sense of rotation or a direction in words."""
    formula, sense, axis, way = without_direction(text)
    for before, unit in islice(_units(formula), MOST_WORDS):
        if not _unknown(unit, names) or (_unknown(before, names) and not _is_number(before)):
            continue
        try:
            return _Behind(before, unit_of(unit.strip("[]() ")), sense, axis, way)
        except Unreadable:
            continue
    return _Behind(formula, None, sense, axis, way)


def _units(text: str) -> Iterator[tuple[str, str]]:
    """Where a unit may begin: the formula before it, and it; the shortest first."""
    bracket = _UNIT_IN_BRACKETS.fullmatch(text)
    if bracket is not None and not bracket[1].endswith(("*", "/", "+", "-", "^")):
        yield bracket[1], bracket[2]
    for place in range(len(text) - 1, 0, -1):
        before = text[:place]
        if text[place] == " " and before.count("(") == before.count(")") and text[place + 1 : place + 2].isalnum():
            yield before.rstrip(), text[place + 1 :]


def _is_number(text: str) -> bool:
    return not letters_in(text)


def _unknown(text: str, names: Collection[str]) -> list[str]:
    """Words of a text that are no letters of the problem."""
    return [w for w in letters_in(readings(text, names)[0]) if w not in names]


def _one_reading(text: str, names: Collection[str]) -> str:
    found = readings(text, names)
    if len(found) > 1:
        raise _two_ways(found)
    return found[0]


def _two_ways(found: tuple[str, ...]) -> Unreadable:
    return Unreadable(f"it can be read in two ways; write {found[0]} or {found[1]}")


def _meant(found: tuple[str, ...], expected: Expected) -> str:
    """Of two readings the one that has the dimension of what is asked."""
    if len(found) == 1:
        return found[0]
    due = _due(expected)
    try:
        fit = [text for text in found if dimension(text, _letters(expected)) == due]
    except Unreadable:
        return found[0]
    if len(fit) > 1:
        raise _two_ways(found)
    return fit[0] if fit else found[0]


def _due(expected: Expected) -> Dimension | None:
    return dimension(expected.formula, _letters(expected))


def _check_letters(text: str, names: Collection[str]) -> None:
    """Unreadable where there are others: which the problem has is told."""
    unknown = [w for w in letters_in(text) if w not in names]
    if not unknown:
        return
    words = re.findall(r"[A-Za-z]+", text)
    if sum(len(w) > 2 for w in unknown) > 1 and not re.search(r"[0-9(/^+]", text) and len(words) > 1:
        raise Unreadable("this is not an answer that can be read: a formula is asked")
    there = sorted(names)
    listed = " and ".join(filter(None, (", ".join(there[:-1]), there[-1])))
    same = [n for n in there if n.lower() == unknown[0].lower()]
    hint = f"; did you mean '{same[0]}'?" if len(same) == 1 else ""
    raise Unreadable(f"'{unknown[0][:40]}' is none of the letters of the problem, which are {listed}{hint}")


# --- verdicts --------------------------------------------------------------------------------------------------------


def _turned(behind: _Behind, expected: Expected, text: str) -> str:
    """The formula with the sign that a sense or direction in words gives it; said twice it is said once."""
    way = behind.sense if expected.rotation else behind.way if behind.axis == expected.axis else 0
    return f"-({text})" if way < 0 and not text.startswith("-") else text


def _direction(behind: _Behind, expected: Expected) -> tuple[str, tuple[str, ...]]:
    """The verdict on a direction in words where the formula is right, and what is said of it."""
    if behind.sense and not expected.rotation:
        raise Unreadable("a sense of rotation stands behind what does not turn")
    if behind.way and expected.axis and behind.axis != expected.axis:
        return WRONG, ()
    if behind.way and not expected.axis:
        return RIGHT, ("the direction in words is not graded here",)
    return RIGHT, ()


def _unit(unit: Unit | None, expected: Expected) -> tuple[str, str]:
    """Letters have their units in them: one that stands behind has the right dimension, or is wrong."""
    due = _due(expected)
    if unit is None or due is None:
        return RIGHT, ""
    if unit.dimension != due:
        return WRONG, f"the unit is that of {describe(unit.dimension, unit.angle)}"
    if in_base(unit, us=False) != 1:
        raise Unreadable(f"a formula in letters has its unit by its letters; leave {unit.text} out")
    return RIGHT, ""


def _what_differs(text: str, expected: Expected, names: Collection[str]) -> str:
    """What can be said of a wrong formula without telling the right one."""
    if expected.letters and not letters_in(text):
        return f"a formula in letters is asked, of {', '.join(sorted(names))}"
    found, due = dimension(text, _letters(expected)), _due(expected)
    if found is None:
        return "the formula is not right: its terms do not have the same dimension"
    if due is not None and found != due:
        turns = expected.rotation and due != PURE
        mine, asked = describe(found, turns), describe(due, turns)
        return f"the formula is not right: it has the dimension of {mine}, and asked is {asked}"
    return NOT_RIGHT
