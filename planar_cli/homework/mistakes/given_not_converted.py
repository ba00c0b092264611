"""A given value is put in with its number, though its unit is another one: 120 rev/min as 120 rad/s."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import ClassVar, final

import sympy as sp

from planar_cli.base_units import factor_to_base, in_base
from planar_cli.homework.mistakes.base import Mistake, Model, inputs_by_unit
from planar_cli.homework.sets.printed_names import printed
from planar_cli.problem.nodes.reading import listed
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations
from planar_cli.units import PURE, RATE, Unit, pretty_unit


@final
class GivenNotConverted(Mistake):
    """A given value is put in without conversion of its unit.

    In the equations
        Data in rev/min, km/h, inches and the like have their numbers as ones of rad/s, m/s or feet; all data of one
        such unit together. Units that are a power of ten apart, as mm, are not taken so. Of revolutions 2π is missing.
    """

    kind: ClassVar[str] = "given-not-converted"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        for unit, symbols in inputs_by_unit(equations, lambda unit: not _is_base(unit, problem.us)):
            told = listed([printed(s.name) for s in symbols], "and")
            verb = "was" if len(symbols) == 1 else "were"
            feedback = f"{told} {verb} put in with the number of {pretty_unit(unit.text)}, without conversion"
            yield Model(feedback, equations, {s: s / in_base(unit, problem.us) for s in symbols})
            if unit.dimension == RATE and unit.angle and unit.pi_power == 1:
                feedback = f"of {told} 2π is missing: a revolution is 2π rad"
                yield Model(feedback, equations, {s: s / (2 * sp.pi) for s in symbols})


def _is_base(unit: Unit, us: bool) -> bool:
    """Is nothing to be converted, or a power of ten? Of an angle in degrees another mistake tells."""
    if unit.dimension == PURE:
        return True
    factor = factor_to_base(unit, us)
    return not unit.pi_power and re.fullmatch("10*", str(factor.numerator * factor.denominator)) is not None
