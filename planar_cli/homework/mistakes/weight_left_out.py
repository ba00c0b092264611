"""The weight is forgotten in every equation of forces, moments or energies."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import ClassVar, final

import sympy as sp

from planar_cli.homework.mistakes.base import Mistake, Model, has_forces, with_put_in, with_step_changed
from planar_cli.homework.printed_names import printed
from planar_cli.problem.scene import Problem
from planar_cli.replay.equations import Equations


@final
class WeightLeftOut(Mistake):
    """The weight is left out.

    In the equations
        g is zero in the equations of forces, moments and energies, and in formulas by which a reaction is told; or in
        one equation of forces or moments alone, where it stands in several and others act there too.
    """

    kind: ClassVar[str] = "weight-left-out"
    effect: ClassVar[str] = "weight"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        if "g" in equations.inputs:
            without = {equations.inputs["g"]: sp.S.Zero}
            changed = with_put_in(equations, without, has_forces)
            if changed is not None:
                # A reaction that is asked may be told by a formula of its own, in which the weight stands too.
                asked = {
                    n: replace(a, parts=tuple(sp.sympify(e.xreplace(without)) for e in a.parts))
                    for n, a in changed.asked.items()
                }
                yield Model("this is the result without the weight", replace(changed, asked=asked))
            yield from _in_one(equations, without)


def _has_others(residual: sp.Expr) -> bool:
    """Is there more than one other term? Else what balances the weight would be zero, which nobody writes: N = 0."""
    return len(sp.Add.make_args(sp.expand(residual))) > 1


def _in_one(equations: Equations, without: dict[sp.Symbol, sp.Expr]) -> Iterable[Model]:
    """Without it in one equation, as without its component along a slope, with the normal force as it is."""
    (g,) = without
    places = [
        (k, i)
        for k, step in enumerate(equations.steps)
        for i, (kind, residual) in enumerate(zip(step.kinds, step.residuals, strict=False))
        if kind in ("force", "moment") and g in residual.free_symbols and _has_others(residual.xreplace(without))
    ]
    for k, i in places if len(places) > 1 else ():
        changed = with_step_changed(equations, k, i, lambda r: sp.sympify(r.xreplace(without)))
        bodies = " and ".join(map(printed, equations.steps[k].bodies[i]))
        if changed is not None and bodies:
            yield Model(f"this is the result without the weight in one equation of {bodies}", changed)
