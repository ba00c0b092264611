"""The moment of inertia about the mass centre stands where that about the axis belongs: m d² is forgotten."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

import sympy as sp

from planar_cli.equation.parts_of_accelerations import AXIS
from planar_cli.homework.mistakes.base import Mistake, Model, terms_without, with_changed, without_part
from planar_cli.homework.mistakes.rotational_inertia_left_out import inertias
from planar_cli.problem.scene import Problem
from planar_cli.replay.equations import Equations

MISSING = "the term m d² of the parallel-axis theorem is missing"


@final
class ParallelAxisLeftOut(Mistake):
    """The term m d² of the parallel-axis theorem is left out.

    In the equations
        The term m d² α is missing in equations of moments; where a body turns about a fixed point, m v_G²/2 is missing
        in its energy and the moment of m v_G in its angular momentum.
    """

    kind: ClassVar[str] = "parallel-axis-left-out"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        masses = {s for s, u in equations.units.items() if u.dimension.mass == 1 and u.dimension.length == 0}
        named = {s for s, _ in inertias(equations)}
        turning = {s for s in equations.unknowns if equations.turns(s)}

        def is_transport(term: sp.Expr) -> bool:
            """m d² α in an equation of moments: a mass, an angular acceleration, and no moment of inertia."""
            inside = term.free_symbols
            return bool(inside & turning and inside & masses) and not inside & named

        changed = with_changed(
            equations,
            lambda r: terms_without(r, is_transport) if r.free_symbols & named else r,
            lambda kind: kind == "moment",
        )
        found = list(without_part(changed or equations, AXIS, MISSING))
        yield from found
        if changed is not None and not found:
            yield Model(MISSING, changed)
