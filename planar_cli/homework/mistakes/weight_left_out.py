"""The weight is forgotten in every equation of forces, moments or energies."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

import sympy as sp

from planar_cli.homework.mistakes.base import Mistake, Model, has_forces, with_put_in
from planar_cli.problem.scene import Problem
from planar_cli.replay.equations import Equations


@final
class WeightLeftOut(Mistake):
    """The weight is left out."""

    kind: ClassVar[str] = "weight-left-out"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        if "g" in equations.inputs:
            changed = with_put_in(equations, {equations.inputs["g"]: sp.S.Zero}, has_forces)
            if changed is not None:
                yield Model("this is the result without the weight", changed)
