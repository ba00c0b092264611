"""Exact units: what `N*m`, `km/h` or `rev/min` are in SI, and how a unit is written and printed.

The SI value of `number unit` is `number * factor * pi**pi_power`, with a rational factor, so that nothing is rounded
before the last step. Angles have dimension 1; that a quantity is an angle or a rate of angle is only remembered for
what is printed.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction
from functools import lru_cache
from types import MappingProxyType

from planar_cli.records import record
from planar_cli.unit_hints import HABITS, suggestion

MAX_UNIT_LENGTH = 40
MAX_UNIT_POWER = 12


@record
class Dimension:
    """Exponents of length, mass and time; angles are pure numbers."""

    length: Fraction = Fraction(0)
    mass: Fraction = Fraction(0)
    time: Fraction = Fraction(0)

    def __mul__(self, other: Dimension) -> Dimension:
        return Dimension(self.length + other.length, self.mass + other.mass, self.time + other.time)

    def __truediv__(self, other: Dimension) -> Dimension:
        return Dimension(self.length - other.length, self.mass - other.mass, self.time - other.time)

    def __pow__(self, power: Fraction | int) -> Dimension:
        exponent = Fraction(power)
        return Dimension(self.length * exponent, self.mass * exponent, self.time * exponent)


def _dimension(length: int, mass: int, time: int) -> Dimension:
    return Dimension(Fraction(length), Fraction(mass), Fraction(time))


PURE = Dimension()
LENGTH = _dimension(1, 0, 0)
MASS = _dimension(0, 1, 0)
TIME = _dimension(0, 0, 1)
AREA = _dimension(2, 0, 0)
VOLUME = _dimension(3, 0, 0)
RATE = _dimension(0, 0, -1)
RATE_OF_RATE = _dimension(0, 0, -2)
VELOCITY = _dimension(1, 0, -1)
ACCELERATION = _dimension(1, 0, -2)
JERK = _dimension(1, 0, -3)
FORCE = _dimension(1, 1, -2)
ENERGY = _dimension(2, 1, -2)
POWER = _dimension(2, 1, -3)
MOMENTUM = _dimension(1, 1, -1)
IMPULSE = MOMENTUM
ANGULAR_MOMENTUM = _dimension(2, 1, -1)
INERTIA = _dimension(2, 1, 0)
STIFFNESS = _dimension(0, 1, -2)
DAMPING = _dimension(0, 1, -1)
PRESSURE = _dimension(-1, 1, -2)
DENSITY = _dimension(-3, 1, 0)
LINE_DENSITY = _dimension(-1, 1, 0)


@record
class Unit:
    """A unit as written; SI value = number * factor * pi**pi_power. `angle`: an angle or a rate of angle."""

    text: str
    factor: Fraction
    pi_power: int
    dimension: Dimension
    angle: bool

    @property
    def turns(self) -> bool:
        """Is it of angles themselves, and not of their rates?"""
        return self.angle and self.dimension == PURE

    @property
    def places(self) -> bool:
        """Is it of lengths, or of angles?"""
        return self.turns or self.dimension == LENGTH


class UnitError(ValueError):
    """Not a unit of the list; `message` says what, `hint` what to write, `atom` is the part that is wrong."""

    def __init__(self, message: str, hint: str = "", atom: str = "") -> None:
        super().__init__(message)
        self.message = message
        self.hint = hint
        self.atom = atom


_POUND = Fraction(45359237, 100000000)
_FOOT = Fraction(3048, 10000)
_GRAVITY = Fraction(980665, 100000)
_POUND_FORCE = _POUND * _GRAVITY
_MILE = 5280 * _FOOT

# Each row: atoms with their factors to SI, pi power, dimension, angle.
_ROWS: tuple[tuple[dict[str, Fraction | int], int, Dimension, bool], ...] = (
    ({"m": 1, "mm": Fraction(1, 1000), "cm": Fraction(1, 100), "km": 1000}, 0, LENGTH, False),
    ({"in": _FOOT / 12, "ft": _FOOT, "yd": 3 * _FOOT, "mi": _MILE}, 0, LENGTH, False),
    ({"kg": 1, "g": Fraction(1, 1000), "mg": Fraction(1, 10**6), "tonne": 1000, "lb": _POUND}, 0, MASS, False),
    ({"slug": _POUND_FORCE / _FOOT}, 0, MASS, False),
    ({"s": 1, "ms": Fraction(1, 1000), "min": 60, "h": 3600}, 0, TIME, False),
    ({"1": 1}, 0, PURE, False),
    ({"rad": 1}, 0, PURE, True),
    ({"deg": Fraction(1, 180), "rev": 2}, 1, PURE, True),
    ({"rpm": Fraction(1, 30)}, 1, RATE, True),
    ({"Hz": 1, "kHz": 1000}, 0, RATE, False),
    ({"N": 1, "mN": Fraction(1, 1000), "kN": 1000, "MN": 10**6}, 0, FORCE, False),
    ({"lbf": _POUND_FORCE, "kip": 1000 * _POUND_FORCE}, 0, FORCE, False),
    ({"Pa": 1, "kPa": 1000, "MPa": 10**6, "GPa": 10**9}, 0, PRESSURE, False),
    ({"psi": _POUND_FORCE / (_FOOT / 12) ** 2}, 0, PRESSURE, False),
    ({"J": 1, "kJ": 1000, "MJ": 10**6}, 0, ENERGY, False),
    ({"W": 1, "kW": 1000, "MW": 10**6, "hp": 550 * _FOOT * _POUND_FORCE}, 0, POWER, False),
    ({"mph": _MILE / 3600}, 0, VELOCITY, False),
)

ATOMS: Mapping[str, Unit] = MappingProxyType(
    {
        text: Unit(text, Fraction(factor), pi_power, dimension, angle)
        for atoms, pi_power, dimension, angle in _ROWS
        for text, factor in atoms.items()
    }
)

# A broken power, `m^(1/2)`, is written `m^1|2` inside: no stroke, no bracket.
_BROKEN = re.compile(r"\^\((-?[0-9]{1,2})/([1-9][0-9]?)\)")
_TOKEN = re.compile(r"([A-Za-z]+|1)(?:\^(-?[0-9]{1,2})(?:\|([0-9]{1,2}))?)?")


def parse_unit(text: str) -> Unit:
    """The unit that `text` says, such as `N*m`, `m/s^2`, `1/s`, `1`; products and quotients are read left to right.

    A bracket may follow a stroke: `kg/(m*s)`; a broken power of an SI base unit stands in one: `m^(1/2)/s`. Raises
    UnitError.
    """
    return _parse_unit(text.strip())


@lru_cache(maxsize=1024)
def _parse_unit(text: str) -> Unit:
    _refuse_signs(text)
    factor, pi_power, dimension, angle = Fraction(1), 0, PURE, False
    for sign, part in _factors(text):
        unit, power = _atom(part)
        power *= sign
        # A broken power stands only where the factor is one.
        factor *= unit.factor**power.numerator
        pi_power += unit.pi_power * power.numerator
        dimension *= unit.dimension**power
        angle = angle or unit.angle
    only_turning = dimension.length == 0 and dimension.mass == 0
    return Unit(text, factor, pi_power, dimension, angle and only_turning)


def _refuse_signs(text: str) -> None:
    """Raise for what can never stand in a unit, with the repair of the frequent cases."""
    if not text:
        raise UnitError("a unit is missing", "write one such as `m/s`, or `1` for a pure number")
    if len(text) > MAX_UNIT_LENGTH:
        raise UnitError(f"a unit is at most {MAX_UNIT_LENGTH} characters long")
    if "°" in text:
        raise UnitError("the degree sign is not a unit", "write `" + text.replace("°", "deg").strip() + "`", text)
    if not text.isascii() and all(c in "²³·×µμ⁻¹⋅" or c.isascii() for c in text):
        plain = text.translate({ord(c): s for c, s in _PLAIN.items()}).replace("^-^", "^-")
        raise UnitError(f"the unit `{text}` has special characters", f"write `{plain}`", text)
    if "%" in text:
        raise UnitError("per cent is not a unit", "write a fraction, `0.05`", "%")
    if re.search(r"\s", text):
        raise UnitError(f"the unit `{text}` has a space inside", "join the parts with `*` or `/`: `N*m`", text)
    joined = re.fullmatch(r"([A-Za-z]+)[.-]([A-Za-z]+)(\^[0-9]|)", text)
    if joined:
        first, second = ("lbf" if part == "lb" and not joined[3] else part for part in joined.groups()[:2])
        raise UnitError(f"unknown unit `{text}`", f"write `{first}*{second}{joined[3]}`", text)
    if re.fullmatch(r"[A-Za-z]+\.", text):
        raise UnitError(f"unknown unit `{text}`", f"write it without the point: `{text[:-1]}`", text)
    if "**" in text:
        raise UnitError("a power is written with `^`", f"write `{text.replace('**', '^')}`", text)


_PLAIN = {"²": "^2", "³": "^3", "·": "*", "⋅": "*", "×": "*", "µ": "u", "μ": "u", "⁻": "^-", "¹": "^1"}


def _factors(text: str) -> list[tuple[int, str]]:
    """The atoms of a unit with +1 (above the stroke) or -1 (below); `kg/(m*s)` reads as `kg/m/s`."""
    whole = _BROKEN.sub(r"^\1|\2", text)
    flat = re.sub(r"/\(([^()/]+)\)(?=$|[*/])", lambda match: "/" + match[1].replace("*", "/"), whole)
    pieces = re.split(r"([*/])", flat)
    signs = (1, *(-1 if sign == "/" else 1 for sign in pieces[1::2]))
    return list(zip(signs, pieces[::2], strict=True))


def _atom(piece: str) -> tuple[Unit, Fraction]:
    """One atom with its power, `s^2`; raises UnitError with what to write instead."""
    match = _TOKEN.fullmatch(piece)
    if match is None:
        piece = piece.replace("|", "/")
        if not piece:
            raise UnitError("a unit ends or begins with `*` or `/`", "write it as in `N*m` or `1/s`", piece)
        if re.fullmatch(r"[A-Za-z]+[0-9]", piece) and piece[:-1] in ATOMS:
            raise UnitError(f"unknown unit `{piece}`", f"write the power with `^`: `{piece[:-1]}^{piece[-1]}`", piece)
        broken = re.fullmatch(r"([A-Za-z]+)\^-?([0-9]+\.[0-9]+)", piece)
        if broken:
            exponent = Fraction(broken[2]).limit_denominator(99)
            raise UnitError(f"unknown unit `{piece}`", f"write a broken power as in `{broken[1]}^({exponent})`", piece)
        raise UnitError(f"unknown unit `{piece}`", "units are joined by `*` and `/`, powers are whole numbers", piece)
    power = Fraction(int(match[2] or 1), int(match[3] or 1))
    if abs(power) > MAX_UNIT_POWER:
        raise UnitError(f"the power of a unit is at most {MAX_UNIT_POWER}", "", piece)
    name = match[1]
    if name not in ATOMS:
        raise UnitError(f"unknown unit `{name}`", suggestion(name, ATOMS), name)
    unit = ATOMS[name]
    if power.denominator != 1 and (unit.factor != 1 or unit.pi_power):
        raise UnitError(f"no broken power of `{name}`", "write it with `m`, `kg`, `s`", name)
    return unit, power


def is_habit(atom: str) -> bool:
    """Whether `atom` is a well-known misspelling of a unit (`sec`, `lbs`, `kph`), and no likely name of a file."""
    return len(atom) > 1 and atom in HABITS


# Display units and words of the dimensions that have a name: SI text, US text, words.
_KNOWN: Mapping[Dimension, tuple[str, str, str]] = MappingProxyType(
    {
        PURE: ("1", "1", "a pure number"),
        LENGTH: ("m", "ft", "a length"),
        MASS: ("kg", "lb", "a mass"),
        TIME: ("s", "s", "a time"),
        AREA: ("m^2", "ft^2", "an area"),
        VOLUME: ("m^3", "ft^3", "a volume"),
        RATE: ("1/s", "1/s", "a frequency"),
        RATE_OF_RATE: ("1/s^2", "1/s^2", "a rate of a frequency"),
        VELOCITY: ("m/s", "ft/s", "a velocity"),
        ACCELERATION: ("m/s^2", "ft/s^2", "an acceleration"),
        JERK: ("m/s^3", "ft/s^3", "a rate of acceleration"),
        FORCE: ("N", "lbf", "a force"),
        ENERGY: ("N*m", "lbf*ft", "a moment or an energy"),
        POWER: ("W", "ft*lbf/s", "a power"),
        MOMENTUM: ("N*s", "lbf*s", "an impulse or a momentum"),
        ANGULAR_MOMENTUM: ("kg*m^2/s", "lbf*ft*s", "an angular momentum"),
        INERTIA: ("kg*m^2", "lb*ft^2", "a moment of inertia"),
        STIFFNESS: ("N/m", "lbf/ft", "a stiffness"),
        DAMPING: ("N*s/m", "lbf*s/ft", "a damping coefficient or a mass flow"),
        PRESSURE: ("Pa", "psi", "a pressure"),
        DENSITY: ("kg/m^3", "lb/ft^3", "a density"),
        LINE_DENSITY: ("kg/m", "lb/ft", "a mass per length"),
    }
)
_ANGULAR: Mapping[Dimension, tuple[str, str]] = MappingProxyType(
    {
        PURE: ("rad", "an angle"),
        RATE: ("rad/s", "an angular velocity"),
        RATE_OF_RATE: ("rad/s^2", "an angular acceleration"),
    }
)


def default_unit(dimension: Dimension, angle: bool = False, us: bool = False) -> Unit:
    """The unit in which a value is printed when nobody asked for another: SI, or US customary.

    Energy and moment have one dimension and get `N*m`; the caller says `J` where energy is meant.
    """
    if angle and dimension in _ANGULAR:
        return parse_unit(_ANGULAR[dimension][0])
    if dimension in _KNOWN:
        return parse_unit(_KNOWN[dimension][1 if us else 0])
    return _generic_unit(dimension, us)


def _generic_unit(dimension: Dimension, us: bool) -> Unit:
    """A unit put together from powers of the base units; with broken powers it is always SI, where the factor is 1."""
    whole = all(power.denominator == 1 for power in (dimension.mass, dimension.length, dimension.time))
    mass, length = ("lb", "ft") if us and whole else ("kg", "m")
    powers = ((mass, dimension.mass), (length, dimension.length), ("s", dimension.time))
    above = [_power(base, power) for base, power in powers if power > 0]
    below = [_power(base, -power) for base, power in powers if power < 0]
    text = "*".join(above) or "1"
    if below:
        text += "/" + (below[0] if len(below) == 1 else f"({'*'.join(below)})")
    factor = Fraction(1)
    for base, power in powers:
        factor *= ATOMS[base].factor ** power.numerator
    return Unit(text, factor, 0, dimension, False)


def _power(base: str, power: Fraction) -> str:
    if power == 1:
        return base
    return f"{base}^{power}" if power.denominator == 1 else f"{base}^({power})"


def describe(dimension: Dimension, angle: bool = False) -> str:
    """Words for messages: `a force (N)`, `an angular velocity (rad/s)`, `a pure number`, `a quantity in kg*m`."""
    if angle and dimension in _ANGULAR:
        unit, words = _ANGULAR[dimension]
        return f"{words} ({unit})"
    if dimension in _KNOWN:
        unit, _, words = _KNOWN[dimension]
        return words if dimension == PURE else f"{words} ({unit})"
    return f"a quantity in {_generic_unit(dimension, us=False).text}"


_RAISED = str.maketrans("0123456789-/", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻ᐟ")


def pretty_unit(text: str) -> str:
    """How a unit is printed: `m/s^2` as `m/s²`, `N*m` as `N·m`, `deg` as `°`, `1` as nothing."""
    if text == "1":
        return ""
    text = re.sub(r"\^(-?[0-9]+|\([0-9/]+\))", lambda match: match[1].strip("()").translate(_RAISED), text)
    text = re.sub(r"\bdeg\b", "°", text)
    return text.replace("*", "·")
