"""Friction acts along the motion, not against it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

from planar_cli.homework.mistakes._one_equation import in_last_equation
from planar_cli.homework.mistakes.base import COEFFICIENTS, Mistake, Model, has_forces, inputs_at, with_put_in
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations


@final
class FrictionReversed(Mistake):
    """The friction acts in the wrong direction.

    In the equations
        All given coefficients of friction have the other sign in the equations of forces, moments and energies; or, of
        an unknown beside others that are right, in the equation by which it is told last.
    """

    kind: ClassVar[str] = "friction-reversed"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        found = inputs_at(equations, problem, *COEFFICIENTS)
        changed = with_put_in(equations, {s: -s for s in found.values()}, has_forces)
        if changed is not None:
            yield Model("the friction acts the other way", changed)
        for words, wrong in in_last_equation(equations, lambda t: not t.free_symbols.isdisjoint(found.values()), 2):
            yield Model(f"the friction acts the other way in {words}", wrong)
