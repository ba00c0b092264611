"""A body that accelerates is taken to be in equilibrium: the tension at a hanging weight is m g."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

import sympy as sp

from planar_cli.homework.mistakes.base import Mistake, Model, terms_without, with_step_changed
from planar_cli.homework.sets.printed_names import printed
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations
from planar_cli.units import ACCELERATION


@final
class InertiaLeftOut(Mistake):
    """The forces on a body are put in equilibrium, though it accelerates.

    In the equations
        m a is zero in one equation of forces on one body, for each such equation.
    """

    kind: ClassVar[str] = "inertia-left-out"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        def accelerates(symbol: sp.Symbol) -> bool:
            unit = equations.units.get(symbol)
            return unit is not None and unit.dimension == ACCELERATION and symbol not in equations.inputs.values()

        def without(residual: sp.Expr) -> sp.Expr:
            return terms_without(residual, lambda term: any(map(accelerates, term.free_symbols)))

        for k, step in enumerate(equations.steps):
            for i, (kind, bodies) in enumerate(zip(step.kinds, step.bodies, strict=False)):
                if kind != "force" or len(bodies) != 1:
                    continue
                changed = with_step_changed(equations, k, i, without)
                if changed is not None:
                    yield Model(f"{printed(bodies[0])} is taken to be in equilibrium: m a is missing", changed)
