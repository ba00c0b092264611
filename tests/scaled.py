"""A problem in a world with another metre, kilogram and second: every number of the file changes by its dimension."""

from __future__ import annotations

from dataclasses import fields, is_dataclass, replace
from decimal import Decimal
from fractions import Fraction
from typing import Any

from planar_cli.errors import NOWHERE
from planar_cli.problem.language.expression import Binary, Number, Scaled
from planar_cli.problem.scene.scene import Problem, Symbol
from planar_cli.units import Dimension, parse_unit

GRAVITY = Number(Fraction(981, 100), "m/s^2", 1, NOWHERE)
World = tuple[int, int, int]
"""Powers of ten: of the metre, the kilogram and the second."""


def power_of(dimension: Dimension, world: World) -> int:
    """By which power of ten a quantity of this dimension grows."""
    metre, kilogram, second = world
    return int(dimension.length * metre + dimension.mass * kilogram + dimension.time * second)


def factor_of(dimension: Dimension, world: World) -> Decimal:
    return Decimal(10) ** power_of(dimension, world)


def scaled(problem: Problem, world: World) -> Problem:
    """The same problem with every number that has a unit multiplied; gravity, where the file leaves it out, as well."""
    found: Problem = _scaled(problem, world)
    told = any(s.name == "g" for s in (*problem.given, *problem.symbols))
    if not told and not problem.symbols:
        found = _with_gravity(found, Symbol("g", _scaled(GRAVITY, world), None, NOWHERE))
    return found


def _with_gravity(problem: Problem, g: Symbol) -> Problem:
    cases = tuple(replace(c, problem=_with_gravity(c.problem, g)) for c in problem.cases)
    return replace(problem, given=(*problem.given, g), cases=cases)


def _scaled(node: Any, world: World) -> Any:
    if isinstance(node, tuple):
        return tuple(_scaled(n, world) for n in node)
    if isinstance(node, Number):
        return replace(node, value=node.value * _factor(node.unit, world)) if node.unit is not None else node
    if isinstance(node, Scaled):
        factor = Number(_factor(node.unit, world), None, 1, node.mark)
        return replace(node, operand=Binary("*", _scaled(node.operand, world), factor, node.mark))
    if not is_dataclass(node) or isinstance(node, type):
        return node
    own = {f.name: _scaled(getattr(node, f.name), world) for f in fields(node) if f.init and f.name != "answers"}
    return replace(node, **own)


def _factor(unit: str, world: World) -> Fraction:
    return Fraction(10) ** power_of(parse_unit(unit).dimension, world)
