"""A couple has the wrong sign in the equation of moments."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

from planar_cli.homework.mistakes.base import Mistake, Model, has_forces, inputs_at, with_put_in
from planar_cli.homework.sets.printed_names import printed
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations


@final
class CoupleReversed(Mistake):
    """A couple has the wrong sign.

    In the equations
        A given `moment` has the other sign in the equations of forces, moments and energies; one at a time.
    """

    kind: ClassVar[str] = "couple-reversed"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        for name, symbol in inputs_at(equations, problem, "moment").items():
            changed = with_put_in(equations, {symbol: -symbol}, has_forces)
            if changed is not None:
                yield Model(f"the couple {printed(name)} has the wrong sign", changed)
