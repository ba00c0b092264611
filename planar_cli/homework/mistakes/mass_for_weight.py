"""The mass stands where the weight belongs: m in place of m g."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from typing import ClassVar, final

import sympy as sp

from planar_cli.homework.mistakes.base import Mistake, Model, has_forces, with_changed, with_put_in
from planar_cli.homework.sets.printed_names import printed
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations
from planar_cli.units import MASS


@final
class MassForWeight(Mistake):
    """The mass is taken for the weight, or the weight for the mass.

    In the equations
        g is 1 in the equations of forces, moments and energies. Where weights are given, W stands for W/g in m a, I α,
        m v²/2 and the like, while the weight is right; or wherever there is a mass, so that the weight is W g. Of
        several masses also with one of them alone.
    """

    kind: ClassVar[str] = "mass-for-weight"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        if "g" not in equations.inputs:
            return
        g = equations.inputs["g"]
        changed = with_put_in(equations, {g: sp.S.One}, has_forces)
        if changed is not None:
            yield Model("the mass stands where the weight m g belongs", changed)
        given = [s for s in equations.inputs.values() if _is_mass(equations, s)]
        for mass in given if len(given) > 1 else ():
            letter = printed(mass.name)
            changed = with_changed(equations, partial(_mass_for_weight, mass, g), has_forces)
            if changed is not None:
                yield Model(f"the mass {letter} stands where the weight {letter} g belongs", changed)
        # m = W/g, where weights are given.
        masses = {s: e for s, e in equations.defined.items() if e.has(g) and _is_mass(equations, s)}
        if masses:
            yield from _with_weights(equations, masses, g, "W/g")
        for mass in masses if len(masses) > 1 else ():
            yield from _with_weights(equations, {mass: masses[mass]}, g, f"{printed(mass.name)} = W/g")


def _mass_for_weight(mass: sp.Symbol, g: sp.Symbol, expr: sp.Expr) -> sp.Expr:
    """An expression in which g is 1 where it stands with one mass."""
    if not {mass, g} <= expr.free_symbols:
        return expr
    terms = sp.Add.make_args(sp.expand(expr))
    return sp.Add(*(sp.sympify(t.xreplace({g: sp.S.One})) if mass in t.free_symbols else t for t in terms))


def _with_weights(
    equations: Equations, masses: Mapping[sp.Symbol, sp.Expr], g: sp.Symbol, told: str
) -> Iterator[Model]:
    """With weights in place of masses, where the weight itself is right and where it is not."""
    weights = {s: sp.sympify(e.xreplace({g: sp.S.One})) for s, e in masses.items()}
    for one in (_with_right_weights(equations, masses, g), equations):
        changed = replace(one, defined={**one.defined, **weights})
        yield Model(f"the weight stands where the mass {told} belongs", changed)


def _with_right_weights(equations: Equations, masses: Mapping[sp.Symbol, sp.Expr], g: sp.Symbol) -> Equations:
    """The equations with W for m g, so that it stays whatever stands for m elsewhere."""

    def change(expr: sp.Expr) -> sp.Expr:
        if g not in expr.free_symbols or masses.keys().isdisjoint(expr.free_symbols):
            return expr
        terms = sp.Add.make_args(sp.expand(expr))
        return sp.Add(*(sp.sympify(t.xreplace(dict(masses))) if t.as_powers_dict().get(g, 0) > 0 else t for t in terms))

    return replace(
        equations,
        steps=tuple(replace(s, residuals=tuple(map(change, s.residuals))) for s in equations.steps),
        defined={s: change(sp.sympify(e)) for s, e in equations.defined.items()},
        asked={n: replace(a, parts=tuple(map(change, a.parts))) for n, a in equations.asked.items()},
    )


def _is_mass(equations: Equations, symbol: sp.Symbol) -> bool:
    unit = equations.units.get(symbol)
    return unit is not None and unit.dimension == MASS
