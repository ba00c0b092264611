"""An angle in degrees is put into sine and cosine as if it were in radians."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

import sympy as sp

from planar_cli.homework.mistakes.base import Mistake, Model
from planar_cli.homework.mistakes.sine_for_cosine import angles
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations


@final
class DegreesAsRadians(Mistake):
    """Degrees are taken for radians.

    In the equations
        Each angle that is given in degrees has its number of degrees as a number of radians.
    """

    kind: ClassVar[str] = "degrees-as-radians"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        found = {s: s * 180 / sp.pi for s in angles(equations).values() if equations.units[s].pi_power}
        if found:
            yield Model("degrees are taken for radians: set the calculator to degrees", equations, found)
