"""The tangential acceleration is forgotten: α r."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

import sympy as sp

from planar_cli.homework.mistakes.base import Mistake, Model, terms_without, with_changed
from planar_cli.homework.mistakes.centripetal_left_out import speeds, squares_of
from planar_cli.problem.scene import Problem
from planar_cli.replay.equations import Equations


@final
class TangentialLeftOut(Mistake):
    """The tangential acceleration is left out."""

    kind: ClassVar[str] = "tangential-left-out"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        moving = speeds(equations)
        done = {u for u in equations.unknowns if equations.turns(u) and u not in moving}
        for unknown in done:

            def without(residual: sp.Expr, alpha: sp.Symbol = unknown) -> sp.Expr:
                # Only where it stands beside ω² r: there both components of one acceleration are summed.
                if not any(squares_of(t, moving) for t in sp.Add.make_args(sp.expand(residual))):
                    return residual
                return terms_without(residual, lambda t: alpha in t.free_symbols)

            own = {r for s in equations.steps if unknown in s.unknowns for r in s.residuals}
            changed = with_changed(
                equations,
                lambda r, own=own, without=without: r if r in own else without(r),  # type: ignore[misc]
                lambda kind: kind not in ("energy", "blow"),
            )
            if changed is not None:
                yield Model("the tangential acceleration α r is missing", changed)
