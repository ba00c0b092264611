"""The diameter is put in for the radius, or half the radius."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

import sympy as sp

from planar_cli.homework.mistakes.base import Mistake, Model, inputs_at
from planar_cli.homework.sets.printed_names import printed
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations

KEYS = "radius", "hub", "radius_of_gyration"


@final
class DiameterForRadius(Mistake):
    """The diameter is taken for the radius, or the radius for the diameter.

    In the equations
        A given length that stands at `radius` is twice or half as large; one at a time.
    """

    kind: ClassVar[str] = "diameter-for-radius"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        radii = set(inputs_at(equations, problem, *KEYS, alone=True))
        for name, symbol in inputs_at(equations, problem, *KEYS).items():
            twice, half = _told(printed(name), name in radii)
            yield Model(twice, equations, {symbol: 2 * symbol})
            yield Model(half, equations, {symbol: symbol * sp.Rational(1, 2)})


def _told(name: str, is_radius: bool) -> tuple[str, str]:
    """What is said of twice the length and of half of it. A file may give the diameter, and half of that as radius."""
    if is_radius:
        return f"the diameter stands where the radius {name} belongs", f"{name} is a radius; it was halved"
    return (
        f"the radius is twice too large: {name} where {name}/2 belongs",
        f"the radius is half of what it is: look at {name}",
    )
