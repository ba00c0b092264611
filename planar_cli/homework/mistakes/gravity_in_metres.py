"""9.81 stands for g where lengths are in feet."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

import sympy as sp

from planar_cli.homework.mistakes.base import Mistake, Model
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations


@final
class GravityInMetres(Mistake):
    """g is taken as 9.81 where lengths are in feet.

    In the equations
        g is 9.81 ft/s^2, in a file in US customary units.
    """

    kind: ClassVar[str] = "gravity-in-metres"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        if problem.us and "g" in equations.inputs:
            said = "g was put in as 9.81, which it is in m/s²; in ft/s² it is 32.2"
            yield Model(said, equations, {equations.inputs["g"]: sp.Rational(981, 100)})
