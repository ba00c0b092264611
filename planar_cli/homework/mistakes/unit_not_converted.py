"""A number was not converted: km/h for m/s, rev/min for rad/s, inches for feet, degrees for radians."""

from __future__ import annotations

import math
from collections.abc import Iterable
from functools import lru_cache
from typing import ClassVar, final

from planar_cli.homework.mistakes.base import Mistake
from planar_cli.homework.sets.paper import Expected
from planar_cli.units import Unit, parse_unit

PAIRS: tuple[tuple[str, str], ...] = (
    ("km/h", "m/s"),
    ("mi/h", "ft/s"),
    ("in", "ft"),
    ("rev/min", "rad/s"),
    ("rev/s", "rad/s"),
    ("deg", "rad"),
)
"""Units that are taken for each other; no find is told of a unit that is none of its own pairs."""
WORDS = {"in": "inches", "ft": "feet", "deg": "degrees", "rad": "radians"}


@final
class UnitNotConverted(Mistake):
    """The number stands for another unit than the one that is asked, or was converted where it had the asked one.

    In the equations
        Nothing: the right number is multiplied or divided by the factor between two units, such as rpm and rad/s.
    """

    kind: ClassVar[str] = "unit-not-converted"

    def slips(self, expected: Expected) -> Iterable[tuple[str, tuple[float, ...]]]:
        for other, factor in _taken_for(expected.unit):
            told, due = WORDS.get(other, other), WORDS.get(expected.unit, expected.unit)
            yield f"the number is one in {told}, not in {due}", tuple(v * factor for v in expected.values)
            said = f"the number was converted from {told} to {due}, but it was in {due} already"
            yield said, tuple(v / factor for v in expected.values)


@lru_cache(maxsize=256)
def _taken_for(unit: str) -> tuple[tuple[str, float], ...]:
    """The other unit of each pair, with how many of it the unit is."""
    asked = parse_unit(unit)
    others = (b if _same(parse_unit(a), asked) else a for a, b in PAIRS if _is_one_of(asked, a, b))
    return tuple((other, _size(asked) / _size(parse_unit(other))) for other in others)


def _is_one_of(asked: Unit, *units: str) -> bool:
    return any(_same(parse_unit(u), asked) for u in units)


def _same(one: Unit, other: Unit) -> bool:
    """Are two units the same, however they are written?"""
    return (one.factor, one.pi_power, one.dimension, one.angle) == (
        other.factor,
        other.pi_power,
        other.dimension,
        other.angle,
    )


def _size(unit: Unit) -> float:
    return float(unit.factor) * math.pi**unit.pi_power
