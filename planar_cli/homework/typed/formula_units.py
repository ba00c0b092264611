"""The unit of a formula: by its letters, by a unit behind it, or of the number before its letters.

A number before letters that leaves a part of the dimension out has it in base units: 0.533 v_0 is 0.533 v_0 rad/m for
an angular velocity.
"""

from __future__ import annotations

import re

from planar_cli.base_units import in_base
from planar_cli.homework.sets.paper import RIGHT, WRONG, Expected
from planar_cli.homework.typed.formula_readings import Reading, due_of, letters_of, with_units
from planar_cli.homework.typed.meant_units import meant, told
from planar_cli.homework.typed.typed_formula import dimension
from planar_cli.homework.typed.unreadable import Unreadable
from planar_cli.units import ATOMS, PURE, Dimension, describe, parse_unit


def size_and_unit(reading: Reading, expected: Expected) -> tuple[float, str, str]:
    """What the formula is to be multiplied by to be in SI units where its letters are, the verdict on its unit, and
    what is said of a wrong one. Unreadable: a formula that has its unit by its letters has one behind it that would
    change its number.
    """
    due, mine = due_of(expected), dimension(reading.formula, with_units(letters_of(expected), reading))
    if due is None:
        return 1.0, RIGHT, ""
    unit = None if reading.unit is None else meant(reading.unit, due, expected.gravity)
    if unit is None:
        if reading.units and mine != due:
            return 1.0, WRONG, f"with its units it has the dimension of {_in_words(mine, expected)}"
        return _base(due, mine, expected), RIGHT, ""
    size = in_base(unit, us=False)
    if unit.dimension == due:
        if mine == due and size != 1:
            raise Unreadable(f"a formula in letters has its unit by its letters; leave {unit.text} out")
        return (1.0 if mine == due else size / _base(mine, PURE, expected)), RIGHT, ""
    if mine is not None and mine * unit.dimension == due:
        return size, RIGHT, ""
    return 1.0, WRONG, f"the unit is that of {told(unit)}"


def in_numbers(reading: Reading, size: float) -> str:
    """The formula in letters alone, with the sizes of its units in SI."""
    text = reading.formula
    for word, atom in reading.units:
        text = re.sub(rf"\b{word}\b", f"({in_base(parse_unit(atom), us=False)!r})", text)
    return text if size == 1 else f"{size!r}*({text})"


def _base(one: Dimension | None, other: Dimension | None, expected: Expected) -> float:
    """The base unit of a quotient of dimensions in SI units."""
    if one is None or other is None or not expected.us:
        return 1.0
    found = one / other
    foot, slug = float(ATOMS["ft"].factor), float(ATOMS["slug"].factor)
    return float(foot ** float(found.length) * slug ** float(found.mass))


def _in_words(mine: Dimension | None, expected: Expected) -> str:
    return "no single quantity" if mine is None else describe(mine, expected.rotation and mine != PURE)
