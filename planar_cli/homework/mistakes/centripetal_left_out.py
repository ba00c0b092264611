"""The normal acceleration is forgotten: ω² r, or v²/ρ."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

import sympy as sp

from planar_cli.equation.ledger import Kind
from planar_cli.homework.mistakes.base import Mistake, Model, terms_without, with_changed
from planar_cli.problem.scene import Problem
from planar_cli.replay.equations import Equations


def speeds(equations: Equations) -> set[sp.Symbol]:
    """The velocity unknowns, and given angular velocities."""
    return {s for s, kind in equations.roles.items() if kind is Kind.SPEED}


def squares_of(term: sp.Expr, symbols: set[sp.Symbol]) -> bool:
    """Is a term of second degree in one of some symbols?"""
    return any(isinstance(p, sp.Pow) and p.base in symbols and p.exp == 2 for p in sp.preorder_traversal(term))


@final
class CentripetalLeftOut(Mistake):
    """The normal (centripetal) acceleration is left out."""

    kind: ClassVar[str] = "centripetal-left-out"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        moving = speeds(equations)
        rates = {s for s, kind in equations.roles.items() if kind is Kind.ACCELERATION}
        level = rates | {u for u in equations.unknowns if u not in moving}

        def without(residual: sp.Expr) -> sp.Expr:
            if not residual.free_symbols & level:
                return residual
            return terms_without(residual, lambda t: squares_of(t, moving))

        changed = with_changed(equations, without, lambda kind: kind not in ("energy", "blow"))
        if changed is not None:
            yield Model("the normal acceleration (ω² r or v²/ρ) is missing", changed)
