"""Sine and cosine of a given angle are exchanged."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

import sympy as sp

from planar_cli.homework.mistakes.base import Mistake, Model
from planar_cli.homework.printed_names import printed
from planar_cli.problem.scene import Problem
from planar_cli.replay.equations import Equations
from planar_cli.units import PURE


def angles(equations: Equations) -> dict[str, sp.Symbol]:
    """The given angles."""
    found = {}
    for name, symbol in equations.inputs.items():
        unit = equations.units.get(symbol)
        if unit is not None and unit.angle and unit.dimension == PURE:
            found[name] = symbol
    return found


@final
class SineForCosine(Mistake):
    """Sine and cosine are exchanged.

    In the equations
        A given angle is 90° less itself, so that its sine and cosine change places; one at a time.
    """

    kind: ClassVar[str] = "sine-for-cosine"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        for name, symbol in angles(equations).items():
            yield Model(f"sine and cosine of {printed(name)} are exchanged", equations, {symbol: sp.pi / 2 - symbol})
