"""The diameter is put in for the radius, or half the radius."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

import sympy as sp

from planar_cli.homework.mistakes.base import Mistake, Model, inputs_at
from planar_cli.problem.scene import Problem
from planar_cli.replay.equations import Equations


@final
class DiameterForRadius(Mistake):
    """The diameter is taken for the radius, or the radius for the diameter."""

    kind: ClassVar[str] = "diameter-for-radius"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        for name, symbol in inputs_at(equations, problem, "radius", "hub", "radius_of_gyration").items():
            yield Model(f"the diameter stands where the radius {name} belongs", equations, {symbol: 2 * symbol})
            yield Model(f"{name} is a radius; it was halved", equations, {symbol: symbol * sp.Rational(1, 2)})
