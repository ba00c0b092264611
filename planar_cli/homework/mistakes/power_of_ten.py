"""A prefix is lost: the number is off by a power of ten, or a given value was put in so."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import ClassVar, final

import sympy as sp

from planar_cli.base_units import factor_to_base, in_base
from planar_cli.equation.values.parts_of_accelerations import is_mark
from planar_cli.homework.mistakes.base import Mistake, Model, inputs_by_unit
from planar_cli.homework.sets.paper import Expected
from planar_cli.homework.sets.powers_of_ten import LOOK, OFF_BY_TEN, POWER_OF_TEN, POWERS
from planar_cli.homework.sets.printed_names import printed
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations
from planar_cli.units import LENGTH, PURE, Unit, pretty_unit

TEN = sp.Integer(10)
TIMES = {1: "ten", 2: "a hundred", 3: "a thousand"}


@final
class PowerOfTen(Mistake):
    """The number is off by a power of ten, or a given value was.

    In the equations
        A given value whose unit has a prefix, as kN/m or mm, has its number as one of N/m or m; one value at a time, or
        all of one unit. Or a given value is ten times as large, or as small; where it has a unit of SI, which may have
        a prefix, also a thousand times, and a length a hundred times. Or the right number is ten, a hundred or a
        thousand times as large, or as small.
    """

    kind: ClassVar[str] = POWER_OF_TEN

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        for unit, symbols in inputs_by_unit(equations, lambda unit: _has_prefix(unit, problem.us)):
            factor, told = in_base(unit, problem.us), pretty_unit(unit.text)
            for symbol in symbols:
                said = f"{printed(symbol.name)} was put in with the number of {told}, without its power of ten"
                yield Model(said, equations, {symbol: symbol / factor})
            if len(symbols) > 1:
                said = f"what is given in {told} was put in with its numbers, without the power of ten"
                yield Model(said, equations, {s: s / factor for s in symbols})
        for symbol in equations.inputs.values():
            given = equations.units.get(symbol)
            if given is None or given.angle or is_mark(symbol) or symbol == equations.inputs.get("g"):
                continue
            for power in _powers(given, problem.us):
                times = TIMES[abs(power)]
                said = f"{printed(symbol.name)} was put in {times} times too {'large' if power > 0 else 'small'}"
                yield Model(f"{said}: {LOOK}", equations, {symbol: symbol * TEN**power})

    def slips(self, expected: Expected) -> Iterable[tuple[str, tuple[float, ...]]]:
        for power in POWERS:
            yield OFF_BY_TEN, tuple(v * 10.0**power for v in expected.values)


def _has_prefix(unit: Unit, us: bool) -> bool:
    """Is it a power of ten of the unit in which it is put in?"""
    if unit.dimension == PURE or unit.pi_power:
        return False
    factor = factor_to_base(unit, us)
    return re.fullmatch("10+", str(factor.numerator * factor.denominator)) is not None


def _powers(unit: Unit, us: bool) -> Iterable[int]:
    """The powers of ten by which a value of this unit may be off, but for that of its prefix."""
    if unit.dimension == PURE or us:
        return (-1, 1)
    powers = (-3, -2, -1, 1, 2, 3) if unit.dimension == LENGTH else (-3, -1, 1, 3)
    factor = factor_to_base(unit, us)
    return (p for p in powers if TEN**p * factor != 1)
