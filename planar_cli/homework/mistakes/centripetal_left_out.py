"""The normal acceleration is forgotten: ω² r, or v²/ρ."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

from planar_cli.equation.values.parts_of_accelerations import NORMAL
from planar_cli.homework.mistakes.base import Mistake, Model, without_part
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations


@final
class CentripetalLeftOut(Mistake):
    """The normal (centripetal) acceleration is left out.

    In the equations
        ω² r and v²/ρ are zero in every acceleration, also in those that are asked.
    """

    kind: ClassVar[str] = "centripetal-left-out"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        yield from without_part(
            equations,
            NORMAL,
            "the normal acceleration (ω² r or v²/ρ) is missing",
            lambda rate, turns: f"the normal acceleration {f'{rate}² r' if turns else f'{rate}²/ρ'} is missing",
        )
