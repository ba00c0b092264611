"""The other root of a quadratic equation is taken."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

from planar_cli.homework.mistakes.base import Mistake, Model
from planar_cli.problem.scene import Problem
from planar_cli.replay.equations import Equations


@final
class OtherRoot(Mistake):
    """The other root of an equation is taken.

    In the equations
        An unknown whose equation has several roots has another one of them, and what follows goes on from there.
    """

    kind: ClassVar[str] = "other-root"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        for step in equations.steps:
            for unknown, roots in step.others.items():
                for root in roots[:2]:
                    yield Model("this follows from the other root of the equation", equations, {}, {unknown: root})
