"""Units that have two meanings, taken as they are meant where a quantity is due: `g` and `lb`.

0.377 g is an acceleration where one is due, and 74.4 lb a force: American textbooks of dynamics write the pound of
force so. Where a mass is due both are units of mass.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from fractions import Fraction

from planar_cli.units import ACCELERATION, FORCE, MASS, PURE, Dimension, Unit, UnitError, describe, parse_unit

STANDARD, TAUGHT, ROUNDED = 9.80665, 9.81, 10.0
"""The acceleration of gravity, in m/s^2: by definition, as books have it, and as it is taken in the head."""
_POUND = re.compile(r"\blb\b")
_NAMED = re.compile(r"(.*) \([^()]+(?:\([^()]*\))?\)")


def meant(unit: Unit, due: Dimension, gravity: float) -> Unit:
    """A unit as it is meant where a quantity of the dimension `due` is asked. `gravity`: that of the problem in m/s^2;
    0 if it has none.
    """
    if unit.dimension == due:
        return unit
    if unit.text == "g" and due == ACCELERATION:
        return Unit("g", Fraction(str(gravity or STANDARD)), 0, ACCELERATION, False)
    force = _with_pounds_of_force(unit.text)
    return force if force is not None and force.dimension == due else unit


def _with_pounds_of_force(text: str) -> Unit | None:
    """lb*s^2/ft as lbf*s^2/ft; None: there are no pounds in it."""
    if not _POUND.search(text):
        return None
    try:
        return parse_unit(_POUND.sub("lbf", text))
    except UnitError:
        return None


def weights(unit: Unit, due: Dimension, gravity: float) -> Iterator[float]:
    """Where a mass was typed for a force: what one of its unit weighs in N, by each g that a student may have used."""
    if unit.dimension == MASS and due == FORCE:
        for g in dict.fromkeys((gravity or STANDARD, TAUGHT, ROUNDED)):
            yield float(unit.factor) * g


def told(unit: Unit) -> str:
    """Words for a unit with the unit as it was typed: `a mass (lb)`, `a quantity in 1/m`."""
    words = describe(unit.dimension, unit.angle)
    if unit.dimension == PURE and not unit.angle:
        return words
    named = _NAMED.fullmatch(words)
    return f"{named[1]} ({unit.text})" if named is not None else f"a quantity in {unit.text}"
