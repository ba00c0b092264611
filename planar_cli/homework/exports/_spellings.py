"""How students write a unit, and how many of it are one of the unit of the key."""

from __future__ import annotations

import math
from collections.abc import Iterator

from planar_cli.units import Unit, UnitError, parse_unit, pretty_unit

# Units that students take in place of another, by their first factor.
_OTHERS = {
    "m": ("mm", "cm", "km"),
    "mm": ("m", "cm"),
    "cm": ("m", "mm"),
    "km": ("m",),
    "ft": ("in",),
    "in": ("ft",),
    "kg": ("g",),
    "g": ("kg",),
    "s": ("ms",),
    "ms": ("s",),
    "N": ("kN",),
    "kN": ("N",),
    "J": ("kJ", "N*m"),
    "kJ": ("J",),
    "W": ("kW",),
    "kW": ("W",),
    "rad": ("deg",),
    "deg": ("rad",),
    "rev": ("rad", "deg"),
}


_WHOLE = {
    "m/s": ("km/h",),
    "km/h": ("m/s",),
    "ft/s": ("mph",),
    "mph": ("ft/s",),
    "rad/s": ("rpm",),
    "rpm": ("rad/s",),
    "N/m": ("N/mm",),
    "kN/m": ("N/mm",),
    "N/mm": ("N/m", "kN/m"),
    "N*m": ("N*mm",),
}
"""Whole units that students take in place of another."""


def spellings(unit: str) -> tuple[tuple[str, float], ...]:
    """A unit in its usual spellings, then others of its dimension in theirs; none for a pure number.

    Each comes with how many of it are one of `unit`, as in Moodle's multipliers; spaces are left out, as Moodle
    does in answers.
    """
    try:
        base = parse_unit(unit)
    except UnitError:
        return ()
    if unit == "1":
        return ()
    found: dict[str, float] = {}
    for other in (unit, *_WHOLE.get(unit, ()), *_others(unit)):
        for name in (n for spelt in _written(other) for n in _by_pounds(spelt)):
            found.setdefault(name, _ratio(base, parse_unit(other)))
    return tuple(found.items())


def smaller(unit: str) -> Iterator[str]:
    """Smaller units of the same dimension, the nearest first."""
    try:
        base = parse_unit(unit)
    except UnitError:
        return
    fitting = [(other, _ratio(base, parse_unit(other))) for other in _others(unit)]
    yield from (other for other, ratio in sorted(fitting, key=lambda pair: pair[1]) if ratio > 1)


def ratio(unit: str, other: str) -> float:
    """How many of the other are one of a unit."""
    return _ratio(parse_unit(unit), parse_unit(other))


def _ratio(unit: Unit, other: Unit) -> float:
    return float(unit.factor / other.factor) * math.pi ** (unit.pi_power - other.pi_power)


def _others(unit: str) -> Iterator[str]:
    """The unit with its first factor in another size; one with a power keeps it."""
    for size, others in _OTHERS.items():
        rest = unit.removeprefix(size)
        if rest != unit and (not rest or rest[0] in "/*^"):
            for other in others:
                # A product of two has no power of its own.
                if not rest.startswith("^") or "*" not in other:
                    yield other + rest


def _by_pounds(unit: str) -> Iterator[str]:
    """Where a force is due students write the pound of force as American books do: lb, lb·ft."""
    yield unit
    if "lbf" in unit:
        yield unit.replace("lbf", "lb")


def _written(unit: str) -> Iterator[str]:
    yield unit
    yield pretty_unit(unit)
    if "*" in unit:
        yield unit.replace("*", "")
        yield unit.replace("*", "-")
        yield pretty_unit(unit).replace("·", "")
    if unit.startswith("deg"):
        yield unit.replace("deg", "degrees", 1)
