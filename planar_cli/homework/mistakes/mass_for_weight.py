"""The mass stands where the weight belongs: m in place of m g."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import ClassVar, final

import sympy as sp

from planar_cli.homework.mistakes.base import Mistake, Model, has_forces, with_put_in
from planar_cli.problem.scene import Problem
from planar_cli.replay.equations import Equations


@final
class MassForWeight(Mistake):
    """The mass is taken for the weight, or the weight for the mass.

    In the equations
        g is 1 in the equations of forces, moments and energies; where weights are given, g is 1 in m = W/g.
    """

    kind: ClassVar[str] = "mass-for-weight"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        if "g" not in equations.inputs:
            return
        g = equations.inputs["g"]
        changed = with_put_in(equations, {g: sp.S.One}, has_forces)
        if changed is not None:
            yield Model("the mass stands where the weight m g belongs", changed)
        masses = {s: e for s, e in equations.defined.items() if e.has(g) and _is_mass(equations, s)}
        if masses:
            # m = W/g, where weights are given.
            weights = {s: sp.sympify(e.xreplace({g: sp.S.One})) for s, e in masses.items()}
            changed = replace(equations, defined={**equations.defined, **weights})
            yield Model("the weight stands where the mass W/g belongs", changed)


def _is_mass(equations: Equations, symbol: sp.Symbol) -> bool:
    unit = equations.units.get(symbol)
    return unit is not None and unit.dimension.mass == 1 and unit.dimension.length == unit.dimension.time == 0
