"""The normal force is taken to be the weight: cos β of a slope is forgotten, or that a pull lifts or presses too."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

import sympy as sp

from planar_cli.homework.mistakes.base import Mistake, Model, inputs_at, terms_without, with_changed
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations
from planar_cli.units import FORCE

NORMAL = "N"
"""The letter of a normal force."""


@final
class NormalForceIsWeight(Mistake):
    """The whole weight is taken for its component along the normal, or the weight alone for all that presses.

    In the equations
        In an equation with the normal force, m g stands in place of m g cos β or m g sin β; or other forces, as a pull
        at an angle, are missing in it, with the component of the weight as it is, or with m g.
    """

    kind: ClassVar[str] = "normal-force-is-weight"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        if "g" not in equations.inputs:
            return
        g = equations.inputs["g"]
        coefficients = set(inputs_at(equations, problem, "mu", "mu_s", "mu_k").values())
        pushes = {u for u in equations.unknowns if _is_force(equations, u)}
        weights = {g, *inputs_at(equations, problem, "weight").values()}
        normals = {u for u in pushes if u.name.partition("_")[0] == NORMAL}

        def whole(residual: sp.Expr, among: set[sp.Symbol] = pushes) -> sp.Expr:
            """N - m g cos β with the whole weight; an equation in which friction stands is the other one."""
            inside = residual.free_symbols
            if g not in inside or not inside & among or inside & coefficients:
                return residual
            terms = sp.Add.make_args(sp.expand(residual))
            return sp.Add(*(t.replace(_is_part, lambda _: sp.S.One) if t.has(g) else t for t in terms))

        def is_other(term: sp.Expr) -> bool:
            """A force other than the normal force and the weight."""
            inside = term.free_symbols
            return not inside & (normals | weights) and any(_is_force(equations, s) for s in inside)

        def alone(residual: sp.Expr) -> sp.Expr:
            """N - m g cos β, without the pull that is in it too."""
            inside = residual.free_symbols
            left = terms_without(residual, is_other) if inside & normals and not inside & coefficients else residual
            return left if left.free_symbols & weights else residual

        changed = with_changed(equations, whole, _has_normals)
        if changed is not None:
            yield Model("the whole weight stands where its component along the normal belongs", changed)
        without = with_changed(equations, alone, _has_normals)
        if without is not None:
            said = "the normal force is taken to be the weight: another force acts along the normal too"
            yield Model(said, without)
            both = with_changed(without, lambda residual: whole(residual, normals), _has_normals)
            if both is not None:
                yield Model(said, both)


def _has_normals(kind: str) -> bool:
    return kind == "force"


def _is_force(equations: Equations, symbol: sp.Symbol) -> bool:
    """Is a symbol a force, given or sought?"""
    unit = equations.units.get(symbol)
    return unit is not None and unit.dimension == FORCE


def _is_part(expr: sp.Basic) -> bool:
    return isinstance(expr, sp.sin | sp.cos)
