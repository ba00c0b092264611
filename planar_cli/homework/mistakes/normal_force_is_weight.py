"""The normal force on a slope is taken to be the whole weight: cos β is forgotten."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

import sympy as sp

from planar_cli.homework.mistakes.base import Mistake, Model, inputs_at, with_changed
from planar_cli.problem.scene import Problem
from planar_cli.replay.equations import Equations
from planar_cli.units import FORCE


@final
class NormalForceIsWeight(Mistake):
    """The whole weight is taken for its component along the normal.

    In the equations
        In an equation with the normal force, m g stands in place of m g cos β or m g sin β.
    """

    kind: ClassVar[str] = "normal-force-is-weight"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        if "g" not in equations.inputs:
            return
        g = equations.inputs["g"]
        coefficients = set(inputs_at(equations, problem, "mu", "mu_s", "mu_k").values())
        pushes = {u for u in equations.unknowns if (unit := equations.units.get(u)) and unit.dimension == FORCE}

        def whole(residual: sp.Expr) -> sp.Expr:
            """N - m g cos β with the whole weight; an equation in which friction stands is the other one."""
            inside = residual.free_symbols
            if g not in inside or not inside & pushes or inside & coefficients:
                return residual
            terms = sp.Add.make_args(sp.expand(residual))
            return sp.Add(*(t.replace(_is_part, lambda _: sp.S.One) if t.has(g) else t for t in terms))

        changed = with_changed(equations, whole, lambda kind: kind == "force")
        if changed is not None:
            yield Model("the whole weight stands where its component along the normal belongs", changed)


def _is_part(expr: sp.Basic) -> bool:
    return isinstance(expr, sp.sin | sp.cos)
