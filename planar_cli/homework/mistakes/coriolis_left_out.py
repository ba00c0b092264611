"""The Coriolis acceleration is forgotten: 2 ω × v_rel."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

import sympy as sp

from planar_cli.homework.mistakes.base import Mistake, Model, terms_without, with_changed
from planar_cli.homework.mistakes.centripetal_left_out import speeds
from planar_cli.problem.scene import Problem
from planar_cli.replay.equations import Equations


@final
class CoriolisLeftOut(Mistake):
    """The Coriolis acceleration is left out."""

    kind: ClassVar[str] = "coriolis-left-out"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        moving = speeds(equations)
        turning = {s for s in moving if equations.turns(s)}
        sliding = moving - turning

        def is_coriolis(term: sp.Expr) -> bool:
            return bool(term.free_symbols & turning and term.free_symbols & sliding)

        changed = with_changed(
            equations, lambda r: terms_without(r, is_coriolis), lambda kind: kind not in ("energy", "blow")
        )
        if changed is not None:
            yield Model("the Coriolis acceleration 2 ω v_rel is missing", changed)
