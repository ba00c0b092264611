"""A mass that is written as a number in the law of a force, and is that of the body on which the force acts, as the
mass of the body: (500 kg)*g*R^2/r^2 on a body of 500 kg is m g R²/r².

So the law keeps its dimension when it is written in letters, and the mass cancels where it must.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from planar_cli.loads.base import Load
from planar_cli.problem.language.expression import Binary, Name, Number, Quantity, Side
from planar_cli.problem.language.walk import changed, walk
from planar_cli.problem.scene.scene import Body, Problem
from planar_cli.units import MASS, parse_unit


def with_own_masses(problem: Problem) -> Problem:
    """The problem and its cases with the masses of such laws named; the same object where there are none."""
    cases = tuple(replace(case, problem=with_own_masses(case.problem)) for case in problem.cases)
    same = all(a.problem is b.problem for a, b in zip(cases, problem.cases, strict=True))
    loads = tuple(_named(load, problem) for load in problem.loads)
    if same and all(a is b for a, b in zip(loads, problem.loads, strict=True)):
        return problem
    return replace(problem, loads=loads, cases=cases)


def _named(load: Load, problem: Problem) -> Load:
    """The load with the mass of its body for each number that is this mass, in a law in which letters stand too."""
    law: Any = getattr(load, "magnitude", None)
    numbers = [n for n in walk(law) if isinstance(n, Number) and _is_mass(n)] if isinstance(law, Side) else []
    if not numbers or not any(isinstance(n, Name | Quantity) for n in walk(law)):
        return load
    body = next((b for b in problem.bodies if b.name == getattr(load, "body", None)), None)
    mass = None if body is None else _mass(body, problem)
    own = [] if mass is None else [n for n in numbers if _kilograms(n) == _kilograms(mass)]
    if body is None or not own or any(_is_twice(n, own) for n in walk(law)):
        return load

    def rule(side: Side) -> Side | None:
        return Quantity("mass", (body.name,), None, (), None, side.mark) if side in own else None

    changes: Any = {"magnitude": changed(law, rule)}
    return replace(load, **changes)


def _is_twice(side: Any, own: list[Number]) -> bool:
    """Is it a product of the number with itself? One of both is the mass of another body then, and none tells which."""
    if not isinstance(side, Binary) or side.operator not in ("*", "^"):
        return False
    first, second = (any(n in own for n in walk(s)) for s in (side.left, side.right))
    return first and (second or side.operator == "^")


def _mass(body: Body, problem: Problem) -> Number | None:
    """The mass of a body as a number, its own or that of a letter of `given`."""
    side = body.mass
    if isinstance(side, Name):
        side = next((s.value for s in problem.given if s.name == side.name and not s.varies), None)
    return side if isinstance(side, Number) and _is_mass(side) else None


def _is_mass(number: Number) -> bool:
    return number.unit is not None and parse_unit(number.unit).dimension == MASS


def _kilograms(number: Number) -> Any:
    assert number.unit is not None
    return number.sense * number.value * parse_unit(number.unit).factor
