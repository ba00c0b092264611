"""Formulas that a student typed: read by the guarded parser of problem files, valued in machine numbers, compared."""

from __future__ import annotations

import math
import random
import re
from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import lru_cache
from typing import Any

from planar_cli.base_units import in_base
from planar_cli.errors import Mark
from planar_cli.homework.typed.unreadable import Unreadable
from planar_cli.problem.language.evaluation import ARITHMETIC, evaluated
from planar_cli.problem.language.expression import Binary, Function, Name, Number, Quantity, Scaled, Side
from planar_cli.problem.language.parser import ParseError, parse_side
from planar_cli.problem.language.walk import walk
from planar_cli.units import PURE, Dimension, parse_unit

DRAWS, NEEDED = 24, 6
"""So many places are drawn; at so many both formulas must have a value."""
ENOUGH, MOST = 12, 4000
"""A root may have a value at few places: more are drawn, up to `MOST`, until the right formula has one at `ENOUGH`."""
SAME = 1e-9
"""Two formulas that are identical differ by rounding alone, in parts of the larger."""
CLOSE = 1e-6
"""Exponents of a dimension that differ by more are not the same."""
MANY, RIGHT = 4096, 256
"""So many typed formulas, and right ones, are remembered."""
TURN = 6.3
"""Radians."""
DEEPEST = 30
"""Brackets in brackets."""
HERE = Mark("<answer>", 1, 1)

FUNCTIONS: Mapping[str, Callable[[float], float]] = {
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "asin": math.asin,
    "acos": math.acos,
    "atan": math.atan,
    "sqrt": math.sqrt,
    "exp": math.exp,
    "log": math.log,
    "abs": abs,
}


class _Numbers:
    """Machine numbers of a formula in which some names have values."""

    def __init__(self, values: Mapping[str, float]) -> None:
        self.values = values

    def number(self, number: Number) -> float:
        factor = 1.0 if number.unit is None else in_base(parse_unit(number.unit), us=False)
        return float(number.value) * factor * (number.sense or 1)

    def scaled(self, side: Scaled) -> float:
        found: float = evaluated(side.operand, self)
        return found * in_base(parse_unit(side.unit), us=False) * (side.sense or 1)

    def named(self, name: Name) -> float:
        if name.name == "pi":
            return math.pi
        if name.name not in self.values:
            raise Unreadable(f"'{name.name}' is none of the letters of the problem")
        return self.values[name.name]

    def combined(self, side: Binary) -> float:
        left, right = evaluated(side.left, self), evaluated(side.right, self)
        try:
            found = ARITHMETIC[side.operator](left, right)
        except (ZeroDivisionError, OverflowError, ValueError):
            return math.nan
        return math.nan if isinstance(found, complex) else float(found)

    def called(self, function: Function) -> float:
        try:
            return FUNCTIONS[function.name](evaluated(function.argument, self))
        except (ValueError, OverflowError):
            return math.nan

    def asked(self, quantity: Quantity) -> Any:
        raise Unreadable(f"`{quantity.word}(…)` is a quantity of the problem, not a part of an answer")

    def at(self, state: str, side: Side) -> Any:
        raise Unreadable("no `@` stands in an answer")


def parsed(text: str) -> Side:
    """A formula. Unreadable: it is none."""
    try:
        return parse_side(text.replace("**", "^").replace("°", " deg"), HERE)
    except ParseError as error:
        raise Unreadable(f"{error.diagnostic.message}, at character {error.diagnostic.mark.column}") from None
    except (RecursionError, MemoryError):
        raise Unreadable("it is too long") from None


def value_of(side: Side, values: Mapping[str, float]) -> float:
    """A side in which names have these values. Unreadable: it has others, or a quantity of the problem."""
    found: float = evaluated(side, _Numbers(values))
    return found


def constant(text: str) -> float:
    """A number that is written as arithmetic, `5*sqrt(2)`, `250*cos(25 deg)`. Unreadable: it is none."""
    side = parsed(text)
    if any(isinstance(n, Number | Scaled) and n.unit is not None and not _is_angle(n.unit) for n in walk(side)):
        raise Unreadable("one unit stands behind the number")
    name = next((n.name for n in walk(side) if isinstance(n, Name) and n.name != "pi"), None)
    if name is not None:
        raise _in_letters(name)
    for function in walk(side):
        if isinstance(function, Function) and function.name in ("sin", "cos", "tan"):
            _check_radians(function)
    found: float = evaluated(side, _Numbers({}))
    return found


def _check_radians(function: Function) -> None:
    """Nobody means more than a turn of radians: `sin(30)` is one of 30 degrees, and the unit is missing."""
    inside = function.argument
    if isinstance(inside, Number) and inside.unit is None and abs(inside.value) > TURN:
        told = f"{function.name}({float(inside.value):g})"
        degrees = f"{function.name}({float(inside.value):g} deg)"
        raise Unreadable(f"in {told} the angle would be in radians; write {degrees}")


def _in_letters(name: str) -> Unreadable:
    asked = "a number with its unit is asked, such as `12.5 N`"
    return Unreadable(f"{asked}, not a formula in letters: '{name[:20]}' is one")


def arithmetic(text: str) -> float:
    """The same as students write it, `√(2*9.81)`, `9.81 cos 25°`, where that can be read in one way."""
    found = _arithmetic(text)
    if isinstance(found, str):
        raise Unreadable(found)
    return found


@lru_cache(MANY)
def _arithmetic(text: str) -> float | str:
    """The number, or why there is none."""
    try:
        check_depth(text)
        return _read_as_arithmetic(text)
    except Unreadable as why:
        return str(why)


def check_depth(text: str) -> None:
    """Unreadable where there are many brackets in brackets."""
    depth = 0
    for character in text:
        depth += (character in "([{") - (character in ")]}")
        if depth > DEEPEST:
            raise Unreadable("the brackets are nested too deeply")


def _read_as_arithmetic(text: str) -> float:
    from planar_cli.homework.typed.typed_letters import plain, readings

    try:
        return constant(text)
    except Unreadable as why:
        try:
            first, *others = (constant(reading) for reading in readings(text, ()))
        except Unreadable:
            letter = next(iter(letters_in(plain(text))), "")
            raise (_in_letters(letter) if letter else why) from None
    if any(not math.isclose(first, other, rel_tol=SAME) for other in others):
        raise Unreadable("what stands below the stroke can be read in two ways; put it in brackets")
    return first


def is_rounded(text: str) -> bool:
    """Does a decimal number stand in a formula that need not be exact, as 1.732 for √3? Halves and quarters are."""
    return any(isinstance(n, Number) and (n.value * 4).denominator != 1 for n in walk(parsed(text)))


def letters_in(text: str) -> tuple[str, ...]:
    """The names in a text that are no functions, in their order."""
    words = dict.fromkeys(re.findall(r"[A-Za-z][A-Za-z0-9_]*", re.sub(r"[0-9.]+[eE][+-]?[0-9]+", "", text)))
    return tuple(w for w in words if w not in FUNCTIONS and w != "pi")


@lru_cache(MANY)
def dimension(text: str, letters: tuple[tuple[str, str], ...]) -> Dimension | None:
    """The dimension of a formula; None: its terms have several. It is measured: with units of half the size a formula
    of the dimension L^a has the 2^a-fold value, at whatever place.
    """
    side, rng = parsed(text), random.Random(2)
    places = [{name: _drawn(unit, rng) for name, unit in letters} for _ in range(DRAWS)]
    exponents: list[Fraction] = []
    for base in ("length", "mass", "time"):
        powers = {name: float(getattr(parse_unit(unit).dimension, base)) for name, unit in letters}
        found: list[float] = []
        for values in places:
            scaled = {name: value * 2.0 ** powers[name] for name, value in values.items()}
            one, other = evaluated(side, _Numbers(values)), evaluated(side, _Numbers(scaled))
            if math.isfinite(one) and math.isfinite(other) and one and other / one > 0:
                found.append(math.log2(other / one))
        if not found or max(found) - min(found) > CLOSE:
            return None
        exponents.append(Fraction(found[0]).limit_denominator(12))
    return Dimension(*exponents)


def _is_angle(unit: str) -> bool:
    known = parse_unit(unit)
    return known.angle and known.dimension == PURE


@lru_cache(MANY)
def same_formula(
    typed: str,
    right: str,
    letters: tuple[tuple[str, str], ...],
    known: tuple[tuple[str, float], ...] = (),
    tolerance: float = SAME,
) -> bool:
    """Are two formulas of some letters identical, where those that are `known` have these values? They are compared at
    places that are the same in every run, relatively within `tolerance`.

    Unreadable: what was typed is no formula of these letters. In a class the same few are typed again and again.
    """
    mine, places = parsed(typed), _values(right, letters, known)
    met = 0
    for values, b in places:
        a = evaluated(mine, _Numbers(values))
        if not math.isfinite(a):
            continue
        met += 1
        if abs(a - b) > tolerance * max(abs(a), abs(b)):
            return False
    if met < NEEDED and (met or not places):
        raise Unreadable("the formula has no value at most places")
    # One without any value where the right one has them is another one.
    return bool(met)


@lru_cache(MANY)
def values_at(typed: str, places: tuple[tuple[tuple[str, float], ...], ...]) -> tuple[float, ...]:
    """What a formula comes to at places; NaN where it has no value. Unreadable: it is none in their letters."""
    side = parsed(typed)
    return tuple(evaluated(side, _Numbers(dict(place))) for place in places)


Letters = tuple[tuple[str, str], ...]
Known = tuple[tuple[str, float], ...]


def drawn_places(letters: Letters, known: Known, right: str) -> tuple[tuple[tuple[str, float], ...], ...]:
    """Places at which formulas are compared with the right one: values of all letters, those that are `known` as they
    are. It has a value at each of them.
    """
    return tuple(tuple(values.items()) for values, _ in _values(right, letters, known))


@lru_cache(RIGHT)
def _values(right: str, letters: Letters, known: Known) -> tuple[tuple[dict[str, float], float], ...]:
    """Values of the letters, and what a formula comes to with them."""
    side, rng = parsed(right), random.Random(1)
    found: list[tuple[dict[str, float], float]] = []
    for tried in range(MOST):
        if tried >= DRAWS and len(found) >= ENOUGH:
            break
        values = {name: _drawn(unit, rng) for name, unit in letters} | dict(known)
        number = evaluated(side, _Numbers(values))
        if math.isfinite(number):
            found.append((values, number))
    return tuple(found)


@lru_cache(MANY)
def same_equation(
    typed: str, right: str, letters: tuple[tuple[str, str], ...], known: tuple[tuple[str, float], ...] = ()
) -> bool:
    """Is an equation of a curve the right one, but for a factor, where letters that are `known` have these values?
    Unreadable: it is no equation in these letters.
    """
    if typed.count("=") != 1:
        raise Unreadable("an equation is asked, such as `y = 2*x^2`")
    mine, theirs = (tuple(map(parsed, text.split("="))) for text in (typed, right))
    rng, ratios = random.Random(1), []
    for _ in range(DRAWS):
        values = {name: _drawn(unit, rng) for name, unit in letters} | dict(known)
        (a, b), (c, d) = ([evaluated(side, _Numbers(values)) for side in sides] for sides in (mine, theirs))
        if math.isfinite(a - b) and math.isfinite(c - d) and c != d:
            ratios.append((a - b) / (c - d))
    if len(ratios) < NEEDED:
        raise Unreadable("the equation has no value at most places")
    return bool(ratios[0]) and all(abs(r - ratios[0]) <= SAME * abs(ratios[0]) for r in ratios)


def _drawn(unit: str, rng: random.Random) -> float:
    """A value of a letter: of an angle a sharp one, of all else a positive number of size one."""
    made = parse_unit(unit)
    if made.angle and made.dimension == PURE:
        return math.pi * (0.08 + 0.36 * rng.random())
    return 0.5 + 1.5 * rng.random()
