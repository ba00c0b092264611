"""The spring is forgotten: its force, or the energy that it stores."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

import sympy as sp

from planar_cli.homework.mistakes.base import Mistake, Model, inputs_at, with_put_in
from planar_cli.homework.sets.printed_names import printed
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations


@final
class SpringLeftOut(Mistake):
    """The force or the energy of a spring is left out.

    In the equations
        A given stiffness is zero; one spring at a time.
    """

    kind: ClassVar[str] = "spring-left-out"
    effect: ClassVar[str] = "spring"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        for name, symbol in inputs_at(equations, problem, "stiffness").items():
            changed = with_put_in(equations, {symbol: sp.S.Zero})
            if changed is not None:
                yield Model(f"this is the result without the spring {printed(name)}", changed)
