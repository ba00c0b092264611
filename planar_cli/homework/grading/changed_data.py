"""Mistakes that change the data of a problem alone: an angle by its complement, degrees for radians, a diameter for the
radius, what was not converted. A motion that is followed in numbers has no equations to be changed, but has its data.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import sympy as sp

from planar_cli.base_units import in_base
from planar_cli.homework.mistakes.base import Mistake, Model
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.sections.variations import number_of
from planar_cli.registry import members
from planar_cli.replay.equations import Equations
from planar_cli.units import Unit


def changed_data(problem: Problem) -> Iterator[tuple[str, str, dict[str, str]]]:
    """By mistake: its name, what it says, and the given values with it, as a file writes them."""
    equations = _of_data(problem)
    for name, kind in members("homework.mistakes").items():
        mistake: Mistake = kind()
        for model in mistake.models(equations, problem):
            if model.inputs:
                yield name, model.feedback, dict(_written(equations, model, problem.us))


def _of_data(problem: Problem) -> Equations:
    """Equations of which nothing is known but the data."""
    numbers = {s.name: found for s in problem.given if s.value and (found := number_of(s.value)) is not None}
    inputs = {name: sp.Symbol(name, real=True) for name in numbers}
    value = {inputs[n]: float(v) * in_base(unit, problem.us) for n, (v, unit) in numbers.items()}
    units: Mapping[sp.Symbol, Unit] = {inputs[n]: unit for n, (_, unit) in numbers.items()}
    return Equations("", inputs, {}, (), {}, (), value, units=units)


def _written(equations: Equations, model: Model, us: bool) -> Iterator[tuple[str, str]]:
    for symbol, formula in model.inputs.items():
        unit = equations.units[symbol]
        number = float(formula.evalf(30, subs=dict(equations.value))) / in_base(unit, us)
        yield symbol.name, f"{number:.15f} {unit.text}"
