"""Friction is forgotten."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

import sympy as sp

from planar_cli.homework.mistakes._one_equation import in_last_equation
from planar_cli.homework.mistakes.base import COEFFICIENTS, Mistake, Model, inputs_at, with_put_in
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations


@final
class FrictionLeftOut(Mistake):
    """The friction is left out.

    In the equations
        All given coefficients of friction are zero; or, of an unknown beside others that are right, those in the
        equation by which it is told last.
    """

    kind: ClassVar[str] = "friction-left-out"
    effect: ClassVar[str] = "friction"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        found = inputs_at(equations, problem, *COEFFICIENTS)
        changed = with_put_in(equations, dict.fromkeys(found.values(), sp.S.Zero))
        if changed is not None:
            yield Model("this is the result without friction", changed)
        for words, wrong in in_last_equation(equations, lambda t: not t.free_symbols.isdisjoint(found.values())):
            yield Model(f"this is the result without friction in {words}", wrong)
