"""A blow is taken to be without rebound, or the speed of separation has the wrong sign."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

import sympy as sp

from planar_cli.homework.mistakes.base import Mistake, Model, inputs_at
from planar_cli.homework.sets.printed_names import printed
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations

SIGN = "the law of restitution has the wrong sign: e times the speed of approach is the speed of separation"


@final
class RestitutionLeftOut(Mistake):
    """The rebound of a blow is left out, or goes the wrong way.

    In the equations
        A given coefficient of restitution is zero, or has the other sign; one at a time.
    """

    kind: ClassVar[str] = "restitution-left-out"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        for name, symbol in inputs_at(equations, problem, "restitution").items():
            yield Model(f"this is the result without rebound, with {printed(name)} = 0", equations, {symbol: sp.S.Zero})
            yield Model(SIGN, equations, {symbol: -symbol})
