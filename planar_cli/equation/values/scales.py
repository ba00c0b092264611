"""Sizes against which the numbers of a motion are measured: no number is small or large by itself.

Of a scene: its ordinary sizes (problem/scene/ordinary). Of a motion: the largest length and speeds that it has shown so
far. Of a formula: what it would be if its parts did not cancel.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.machine import compiled
from planar_cli.equation.algebra.plain import derivative
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import NoValue
from planar_cli.problem.scene.ordinary import Scales
from planar_cli.records import record
from planar_cli.units import LENGTH, PURE, RATE, VELOCITY, Unit

SLACK = 1e-9
"""A number of a followed motion counts as zero below this part of its size."""
PART = 1e-6
"""Parts of a formula are changed by this part of their size, to see how much of it each of them is."""


@record
class Sizes:
    """The largest length, speed and angular speed of a motion so far; for other quantities those of its scene."""

    scales: Scales
    """Of the scene."""
    length: float
    """In m."""
    fastest: float = 0.0
    """The largest speed, in m/s."""
    spin: float = 0.0
    """The largest angular speed, in rad/s."""

    def of(self, unit: Unit) -> float:
        """What a quantity of this unit is measured by: speeds of points and of turning are told from each other."""
        if unit.dimension == PURE:
            return 1.0
        if unit.dimension == LENGTH:
            return self.length
        if unit.dimension == VELOCITY:
            return max(self.fastest, self.spin * self.length)
        if unit.dimension == RATE:
            # Before anything has moved, no length is in sight.
            return max(self.spin, self.fastest / self.length) if self.length else self.scales.of(unit.dimension)
        return self.scales.of(unit.dimension)

    def by_letter(self, letters: Iterable[sp.Symbol], units: Mapping[sp.Symbol, Unit]) -> dict[sp.Symbol, float]:
        """What each of these letters is measured by."""
        return {s: self.of(units[s]) for s in letters}

    def passing(self, state: Mapping[sp.Symbol, float], units: Mapping[sp.Symbol, Unit], length: float) -> Sizes:
        """The same after a state of the motion, in which `length` is in sight."""
        fastest, spin = self.fastest, self.spin
        for letter, number in state.items():
            dimension = units[letter].dimension
            fastest = max(fastest, abs(number)) if dimension == VELOCITY else fastest
            spin = max(spin, abs(number)) if dimension == RATE else spin
        return Sizes(self.scales, max(self.length, length), fastest, spin)


@record
class Here:
    """One state of a motion that is followed: its letters in numbers, and what each of them is measured by."""

    letters: Mapping[sp.Symbol, float]
    """Time, coordinates and free speeds, in SI units."""
    sizes: Mapping[sp.Symbol, float]
    """By letter, in its SI unit."""
    value: Valuation
    """Numbers of everything that does not vary."""

    def at(self, expr: sp.Expr, other: Mapping[sp.Symbol, float]) -> float:
        """A formula in numbers, with `other` numbers for some letters."""
        return measured([expr], {**self.letters, **other}, self.sizes, self.value)[0][0]

    def sign(self, expr: sp.Expr) -> int:
        """The sign of a formula; 0 where it is nothing beside what it is made of."""
        return self.signs([expr])[0]

    def signs(self, exprs: Sequence[sp.Expr]) -> list[int]:
        """The same of several formulas."""
        pairs = measured(exprs, self.letters, self.sizes, self.value)
        return [0 if abs(x) <= SLACK * size else 1 if x > 0 else -1 for x, size in pairs]


# --- formulas --------------------------------------------------------------------------------------------------------


def measured(
    exprs: Sequence[sp.Expr], here: Mapping[sp.Symbol, float], sizes: Mapping[sp.Symbol, float], value: Valuation
) -> list[tuple[float, float]]:
    """Formulas in numbers, each with its size: how much all that stands in it makes of it, whatever cancels.

    `here`: the letters that vary, `sizes` what each is measured by; everything else takes its value and is measured by
    it. NoValue: a formula has no real value here.
    """
    exprs = [sp.sympify(e) for e in exprs]
    fixed = set().union(*(e.free_symbols for e in exprs)) - set(here) if exprs else set()
    point = {**here, **{s: float(value(s)) for s in fixed}}
    letters = list(point)
    made = compiled(exprs, letters)
    now = _called(made, list(point.values()))
    found = [abs(x) for x in now]
    parts = [0.0] * len(exprs)
    for i, s in enumerate(letters):
        inside = [k for k, e in enumerate(exprs) if s in e.free_symbols]
        step = PART * max(abs(point[s]), sizes.get(s, 0.0))
        if not inside or not step:
            continue
        moved = _moved(made, list(point.values()), i, step)
        for k in inside if moved is not None else ():
            parts[k] += abs(moved[k] - now[k]) / PART if moved is not None else 0.0
    return [(x, max(a, b)) for x, a, b in zip(now, found, parts, strict=True)]


def _called(made: Any, numbers: list[float]) -> list[float]:
    try:
        return [float(x) for x in made(*numbers)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise NoValue("a formula has no real value here") from error


def _moved(made: Any, numbers: list[float], i: int, step: float) -> list[float] | None:
    """The formulas with one letter changed, to whichever side they have values; None: to neither."""
    for way in (step, -step):
        try:
            return _called(made, [x + way if k == i else x for k, x in enumerate(numbers)])
        except NoValue:
            continue
    return None


def slack_of(
    residual: sp.Expr, letters: Sequence[sp.Symbol], natural: Mapping[sp.Symbol, Decimal], value: Valuation
) -> Decimal:
    """How much a formula would change if letters changed by their ordinary sizes."""
    total = Decimal(0)
    for s in letters:
        if s in residual.free_symbols:
            total += abs(value.known(derivative(residual, s)) or Decimal(0)) * natural[s]
    return total
