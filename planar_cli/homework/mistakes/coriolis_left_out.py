"""The Coriolis acceleration is forgotten: 2 ω × v_rel."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

from planar_cli.equation.values.parts_of_accelerations import CORIOLIS
from planar_cli.homework.mistakes.base import Mistake, Model, without_part
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations


@final
class CoriolisLeftOut(Mistake):
    """The Coriolis acceleration is left out.

    In the equations
        2 ω × v_rel is zero in every acceleration, also in those that are asked.
    """

    kind: ClassVar[str] = "coriolis-left-out"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        yield from without_part(
            equations,
            CORIOLIS,
            "the Coriolis acceleration 2 ω v_rel is missing",
            lambda rate, turns: f"the Coriolis acceleration 2 {f'{rate} v_rel' if turns else f'ω {rate}'} is missing",
        )
