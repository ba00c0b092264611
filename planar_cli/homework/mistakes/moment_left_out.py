"""The moment of one force is forgotten in an equation of moments."""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from typing import ClassVar, final

import sympy as sp

from planar_cli.homework.mistakes.base import Mistake, Model, terms_without, with_changed
from planar_cli.homework.sets.printed_names import printed
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations
from planar_cli.units import FORCE


@final
class MomentLeftOut(Mistake):
    """The moment of a force is left out.

    In the equations
        In the equations of moments the terms of one force are missing; one force at a time.
    """

    kind: ClassVar[str] = "moment-left-out"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        inside: dict[sp.Symbol, None] = {}
        for step in equations.steps:
            for residual, kind in zip(step.residuals, step.kinds, strict=False):
                if kind == "moment":
                    inside.update(dict.fromkeys(sorted(residual.free_symbols, key=lambda s: s.name)))
        for symbol in inside:
            unit = equations.units.get(symbol)
            if unit is None or unit.dimension != FORCE:
                continue
            changed = with_changed(
                equations,
                partial(_without, symbol),
                lambda kind: kind == "moment",
            )
            if changed is not None:
                yield Model(f"the moment of {printed(symbol.name)} is missing", changed)


def _without(force: sp.Symbol, residual: sp.Expr) -> sp.Expr:
    """An equation of moments without that of one force."""
    return terms_without(residual, lambda term: force in term.free_symbols)
