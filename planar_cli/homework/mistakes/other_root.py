"""The other root of a quadratic equation is taken, or the other assembly of a linkage."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

from planar_cli.homework.mistakes.base import Mistake, Model
from planar_cli.problem.scene.scene import Problem, TwoFacts
from planar_cli.replay.equations import Equations
from planar_cli.replay.two_places import with_other_place

OTHER = {"above": "below", "below": "above", "left": "on the right", "right": "on the left"}
"""Where the other of two places lies."""


@final
class OtherRoot(Mistake):
    """The other root of an equation is taken, or a point of a linkage at the other of two places that fit.

    In the equations
        An unknown whose equation has several roots has another one of them, and what follows goes on from there. A
        point that is placed by its distance from others, and of which the file says `side: above`, lies below.
    """

    kind: ClassVar[str] = "other-root"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        for step in equations.steps:
            for unknown, roots in step.others.items():
                for root in roots[:2]:
                    yield Model("this follows from the other root of the equation", equations, {}, {unknown: root})
        for point in problem.points:
            if point.name in equations.squares and isinstance(point.place, TwoFacts) and point.place.side:
                changed = with_other_place(equations, point.name)
                if changed is not None:
                    there = OTHER[point.place.side]
                    yield Model(f"this is the result for the other assembly, with {point.name} {there}", changed)
