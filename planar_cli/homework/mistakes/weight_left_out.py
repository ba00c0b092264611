"""The weight is forgotten: in every equation of forces, moments or energies, in one of them, or of one body."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from typing import ClassVar, final

import sympy as sp

from planar_cli.homework.mistakes._one_equation import FORCES, in_last_equation, told
from planar_cli.homework.mistakes.base import (
    Mistake,
    Model,
    has_forces,
    inputs_at,
    terms_without,
    with_changed,
    with_step_changed,
)
from planar_cli.homework.sets.printed_names import printed
from planar_cli.problem.language.expression import Name
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations

GRAVITY = "g"


@final
class WeightLeftOut(Mistake):
    """The weight is left out.

    In the equations
        The terms with m g, or a given weight, are missing in the equations of forces, moments and energies and in
        formulas by which a reaction is told; in these formulas alone; in one equation of forces or moments alone, where
        others act there too; or those of one body.
    """

    kind: ClassVar[str] = "weight-left-out"
    effect: ClassVar[str] = "weight"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        weights = set(inputs_at(equations, problem, "weight").values())
        if not weights and GRAVITY not in equations.inputs:
            return
        is_weight = _is_weight(equations, weights)

        def without(expr: sp.Expr) -> sp.Expr:
            """Without weights; g may stand inside a root."""
            left = terms_without(expr, is_weight)
            g = equations.inputs.get(GRAVITY)
            return left if weights or g is None else sp.sympify(left.xreplace({g: sp.S.Zero}))

        asked = {n: replace(a, parts=tuple(map(without, a.parts))) for n, a in equations.asked.items()}
        everywhere = with_changed(equations, without, has_forces)
        if everywhere is not None:
            # A reaction that is asked may be told by a formula of its own, in which the weight stands too.
            yield Model("this is the result without the weight", replace(everywhere, asked=asked))
        if asked != equations.asked:
            yield Model("the weight is missing in the forces", replace(equations, asked=asked))
        yield from _in_one(equations, without)
        for words, wrong in in_last_equation(equations, is_weight):
            yield Model(f"this is the result without the weight in {words}", wrong)
        yield from _of_one_body(equations, problem, is_weight)


def _is_weight(equations: Equations, weights: set[sp.Symbol]) -> Callable[[sp.Expr], bool]:
    """Is a term one of weights: with g as a factor, or with a given weight that is not divided by g?"""
    g = equations.inputs.get(GRAVITY)

    def of(term: sp.Expr) -> bool:
        power = term.as_powers_dict().get(g, 0) if g is not None else 0
        return bool(power > 0 or (weights & term.free_symbols and (g is None or g not in term.free_symbols)))

    return of


def _has_others(residual: sp.Expr) -> bool:
    """Is there more than one other term? Else what balances the weight would be zero, which nobody writes: N = 0."""
    return len(sp.Add.make_args(sp.expand(residual))) > 1


def _in_one(equations: Equations, without: Callable[[sp.Expr], sp.Expr]) -> Iterator[Model]:
    """Without it in one equation, as without its component along a slope, with the normal force as it is."""
    places = [
        (k, i)
        for k, step in enumerate(equations.steps)
        for i, (kind, residual) in enumerate(zip(step.kinds, step.residuals, strict=False))
        if kind in FORCES and (left := without(residual)) != sp.expand(residual) and _has_others(left)
    ]
    for k, i in places if len(places) > 1 else ():
        words = told(equations.steps[k], i)
        changed = with_step_changed(equations, k, i, without)
        if changed is not None and words:
            yield Model(f"this is the result without the weight in {words}", changed)


def _of_one_body(equations: Equations, problem: Problem, is_weight: Callable[[sp.Expr], bool]) -> Iterator[Model]:
    """Without that of one body of several, where its mass or weight is a name of its own."""
    named: dict[str, list[str]] = {}
    for body in problem.bodies:
        sides = (getattr(body, "mass", None), getattr(body, "weight", None))
        for name in (s.name for s in sides if isinstance(s, Name) and s.name in equations.inputs):
            named.setdefault(name, []).append(body.name)
    for name, bodies in named.items() if len(named) > 1 else ():
        symbol = equations.inputs[name]

        def without(expr: sp.Expr, symbol: sp.Symbol = symbol) -> sp.Expr:
            return terms_without(expr, lambda term: symbol in term.free_symbols and is_weight(term))

        changed = with_changed(equations, without, has_forces) if len(bodies) == 1 else None
        if changed is not None:
            asked = {n: replace(a, parts=tuple(map(without, a.parts))) for n, a in equations.asked.items()}
            yield Model(f"this is the result without the weight of {printed(bodies[0])}", replace(changed, asked=asked))
