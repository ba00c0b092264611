"""The tangential acceleration is forgotten: α r."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

from planar_cli.equation.values.parts_of_accelerations import TANGENTIAL
from planar_cli.homework.mistakes.base import Mistake, Model, without_part
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations


@final
class TangentialLeftOut(Mistake):
    """The tangential acceleration is left out.

    In the equations
        α r is zero in every acceleration, also in those that are asked; velocities after a blow stay as they are.
    """

    kind: ClassVar[str] = "tangential-left-out"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        yield from without_part(
            equations,
            TANGENTIAL,
            "the tangential acceleration α r is missing",
            lambda rate, turns: f"the tangential acceleration {f'{rate} r' if turns else rate} is missing",
        )
