"""The acceleration has the wrong sign in one equation: T = m (g + a) for what goes down with a."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from functools import partial
from typing import ClassVar, final

import sympy as sp

from planar_cli.equation.values.parts_of_accelerations import CORIOLIS, NORMAL, TANGENTIAL
from planar_cli.homework.mistakes._one_equation import FORCES, told
from planar_cli.homework.mistakes.base import Mistake, Model, with_step_changed
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations
from planar_cli.units import ACCELERATION, RATE_OF_RATE

GRAVITY = "g"


@final
class AccelerationReversed(Mistake):
    """The acceleration has the wrong sign in one equation.

    In the equations
        m a, or I α, has the other sign in one equation of forces, or of moments, on one body, with all else right; or
        also in the equations of several bodies into which it goes. For each such equation.
    """

    kind: ClassVar[str] = "acceleration-reversed"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        for k, step in enumerate(equations.steps):
            for i, bodies in enumerate(step.bodies):
                where = told(step, i)
                if not where or len(bodies) != 1:
                    continue
                said = f"the acceleration has the wrong sign in {where}"
                own = {frozenset(t.free_symbols) for t in _inertial(equations, step.residuals[i])}
                alone = with_step_changed(equations, k, i, partial(_reversed, own))
                if alone is None:
                    continue
                yield Model(said, alone)
                whole = _also_in_sums(alone, bodies[0], own)
                if whole is not None:
                    yield Model(said, whole)


def _inertial(equations: Equations, residual: sp.Expr) -> Iterator[sp.Expr]:
    """The terms m a, I α, m ω² r of an equation."""
    g = equations.inputs.get(GRAVITY)

    def accelerates(symbol: sp.Symbol) -> bool:
        unit = equations.units.get(symbol)
        if symbol.name in (CORIOLIS, NORMAL, TANGENTIAL):
            return True
        return unit is not None and symbol != g and unit.dimension in (ACCELERATION, RATE_OF_RATE)

    yield from (t for t in sp.Add.make_args(sp.expand(residual)) if any(map(accelerates, t.free_symbols)))


def _reversed(own: Collection[frozenset[sp.Symbol]], residual: sp.Expr) -> sp.Expr:
    """With the other sign of each term that has all symbols of one of `own` in it."""
    terms = sp.Add.make_args(sp.expand(residual))
    return sp.Add(*(-t if any(symbols <= t.free_symbols for symbols in own) else t for t in terms))


def _also_in_sums(equations: Equations, body: str, own: Collection[frozenset[sp.Symbol]]) -> Equations | None:
    """The same also in equations of several bodies, into which that of this body goes; None: there are none."""
    found: Equations | None = None
    for k, step in enumerate(equations.steps):
        for i, bodies in enumerate(step.bodies):
            if len(bodies) > 1 and body in bodies and step.kinds[i] in FORCES:
                found = with_step_changed(found or equations, k, i, partial(_reversed, own)) or found
    return found
