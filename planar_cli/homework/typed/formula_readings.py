"""Formulas as they may be meant: what stands before a unit or a direction, and which words in it are units.

0.533 v_0 rad/m is a number with a unit times a letter, and so is 0.96 kg v_0; in 0.533/m*v_0 m can be the letter for a
mass, or the metre.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import replace
from itertools import islice

from planar_cli.homework.sets.paper import Expected
from planar_cli.homework.typed.typed_directions import without_direction
from planar_cli.homework.typed.typed_formula import dimension, letters_in
from planar_cli.homework.typed.typed_letters import readings
from planar_cli.homework.typed.typed_units import atom_of, unit_of
from planar_cli.homework.typed.unreadable import Unreadable
from planar_cli.problem.nodes.reading import listed
from planar_cli.records import record
from planar_cli.units import Dimension, Unit

MOST_WORDS = 6
"""Of a unit."""
_UNIT_IN_BRACKETS = re.compile(r"(.*\S)\s*[\[(]\s*(?:in\s+)?([^\[\]()]+)[\])]")
_ONE_OVER = re.compile(r"1\s*/\s*[A-Za-z(]")
_ONE_OVER_BEHIND = re.compile(r"(?<=[0-9)])\s+1\s*/\s*(?=[A-Za-z(])")
_WORD = re.compile(r"(?<![\w\\])[A-Za-z]+(?![\w(])")
Letters = tuple[tuple[str, str], ...]


@record
class Reading:
    """A formula with all signs written, and what stands behind it. `units`: words in it that are units, with these."""

    formula: str
    unit: Unit | None = None
    sense: int = 0
    axis: str = ""
    way: int = 0
    units: Letters = ()


def letters_of(expected: Expected) -> Letters:
    """The letters that may stand in an answer, with their units."""
    return (*expected.letters, *expected.others)


def _in_letters(text: str, expected: Expected) -> Reading:
    """The formula before a unit, a sense of rotation or a direction in words; in it are letters alone."""
    names = [name for name, _ in letters_of(expected)]
    return _with_signs(_taken_apart(text, names), names, expected)


def _with_unknown_units(text: str, expected: Expected) -> Reading | None:
    """Words that are no letters of the problem are units: 0.96 kg v_0. None: there are none."""
    names = {name for name, _ in letters_of(expected)}
    return _with_units(text, expected, {w: a for w, a in _atoms(text).items() if w not in names})


def _with_all_units(text: str, expected: Expected) -> Reading | None:
    """Also letters of the problem that are written as units are: the m of 0.533/m*v_0 is the metre. None: then no
    letter, or no number, is left.
    """
    names = [name for name, _ in letters_of(expected)]
    units = _atoms(text)
    left = [n for n in names if n not in units and re.search(rf"(?<![\w]){re.escape(n)}(?![\w])", text)]
    return _with_units(text, expected, units) if left and re.search("[0-9]", text) else None


READERS: tuple[Callable[[str, Expected], Reading | None], ...] = (_in_letters, _with_unknown_units, _with_all_units)


def _with_units(text: str, expected: Expected, units: Mapping[str, str]) -> Reading | None:
    """The formula in which some words are units, by the names of these."""
    if not units:
        return None
    names = [*dict.fromkeys((*(name for name, _ in letters_of(expected)), *units))]
    plain = _ONE_OVER_BEHIND.sub("/", text)
    formula, sense, axis, way = without_direction(plain)
    before = Reading(formula, None, sense, axis, way, tuple(units.items()))
    return _with_signs(before, names, expected)


def _atoms(text: str) -> dict[str, str]:
    """The words of a text that are units, with the names of these."""
    return {word: atom for word in _WORD.findall(text) if (atom := atom_of(word))}


def _with_signs(before: Reading, names: Collection[str], expected: Expected) -> Reading:
    found = _meant(readings(before.formula, names), with_units(letters_of(expected), before), expected)
    _check_letters(found, names)
    return replace(before, formula=found)


def with_units(letters: Letters, reading: Reading) -> Letters:
    """Letters, and units that stand in a formula as letters do."""
    return tuple((dict(letters) | dict(reading.units)).items())


def _taken_apart(text: str, names: Collection[str]) -> Reading:
    formula, sense, axis, way = without_direction(text)
    for before, unit in islice(_units(formula), MOST_WORDS):
        is_unit = _unknown(unit, names) or _ONE_OVER.match(unit)
        if not is_unit or (_unknown(before, names) and not _is_number(before)):
            continue
        try:
            return Reading(before, unit_of(unit.strip("[]() ")), sense, axis, way)
        except Unreadable:
            continue
    return Reading(formula, None, sense, axis, way)


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


def one_reading(text: str, names: Collection[str]) -> str:
    found = readings(text, names)
    if len(found) > 1:
        raise _two_ways(found)
    return found[0]


def _two_ways(found: tuple[str, ...]) -> Unreadable:
    return Unreadable(f"it can be read in two ways; write {found[0]} or {found[1]}")


def _meant(found: tuple[str, ...], letters: Letters, expected: Expected) -> str:
    """Of two readings the one that has the dimension of what is asked."""
    if len(found) == 1:
        return found[0]
    due = due_of(expected)
    try:
        fit = [text for text in found if dimension(text, letters) == due]
    except Unreadable:
        return found[0]
    if len(fit) > 1:
        raise _two_ways(found)
    return fit[0] if fit else found[0]


def due_of(expected: Expected) -> Dimension | None:
    """The dimension that is asked; None: it cannot be told."""
    return dimension(expected.formula, letters_of(expected))


def _check_letters(text: str, names: Collection[str]) -> None:
    """Unreadable where there are others: which the problem has is told."""
    unknown = [w for w in letters_in(text) if w not in names]
    if not unknown:
        return
    words = re.findall(r"[A-Za-z]+", text)
    if sum(len(w) > 2 for w in unknown) > 1 and not re.search(r"[0-9(/^+]", text) and len(words) > 1:
        raise Unreadable("this is not an answer that can be read: a formula is asked")
    there = sorted(names)
    same = [n for n in there if n.lower() == unknown[0].lower()]
    hint = f"; did you mean '{same[0]}'?" if len(same) == 1 else ""
    raise Unreadable(
        f"'{unknown[0][:40]}' is none of the letters of the problem, which are {listed(there, 'and')}{hint}"
    )
