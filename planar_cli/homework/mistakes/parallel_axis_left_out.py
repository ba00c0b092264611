"""The moment of inertia about the mass centre stands where that about the axis belongs: m d² is forgotten."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction
from typing import ClassVar, final

import sympy as sp

from planar_cli.equation.values.parts_of_accelerations import AXIS, TANGENTIAL
from planar_cli.homework.mistakes.base import Mistake, Model, terms_without, with_changed
from planar_cli.homework.mistakes.rotational_inertia_left_out import inertias
from planar_cli.homework.sets.printed_names import printed
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations, Step
from planar_cli.units import ANGULAR_MOMENTUM, MASS, PURE, RATE_OF_RATE, Dimension

MISSING = "the term m d² of the parallel-axis theorem is missing"


@final
class ParallelAxisLeftOut(Mistake):
    """The term m d² of the parallel-axis theorem is left out.

    In the equations
        The term m d² α is missing in equations of moments, and m d² in I_O = I + m d²; where a body turns about a
        fixed point, or is fixed to one that does, m v_G²/2 is missing in its energy and the moment of m v_G in its
        angular momentum, also in a blow; of all bodies, and of each by itself.
    """

    kind: ClassVar[str] = "parallel-axis-left-out"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        changed = _about_points(equations)
        changed = _in_moments(changed or equations) or changed
        changed = _in_blows(changed or equations) or changed
        base = changed or equations
        finds = base.rests_on(e for a in base.asked.values() for e in a.parts)
        axes = {name: s for name, s in base.inputs.items() if name.startswith(AXIS) and s in finds}
        if axes or changed is not None:
            yield Model(MISSING, base, dict.fromkeys(axes.values(), sp.S.Zero))
        for name, symbol in axes.items() if len(axes) > 1 else ():
            body = printed(name.removeprefix(f"{AXIS}_"))
            yield Model(f"{MISSING} for {body}", equations, {symbol: sp.S.Zero})


def _about_points(equations: Equations) -> Equations | None:
    """With I in place of I_O = I + m d²."""
    named = dict(inertias(equations))
    own = {}
    for symbol in named:
        formula = sp.sympify(equations.defined[symbol])
        inside = [t for t in sp.Add.make_args(formula) if t in named]
        if formula.is_Add and inside:
            own[symbol] = sp.Add(*inside)
    return replace(equations, defined={**equations.defined, **own}) if own else None


def _in_moments(equations: Equations) -> Equations | None:
    masses = {s for s, u in equations.units.items() if u.dimension == MASS}
    named = {s for s, _ in inertias(equations)}
    turning = {s for s, u in equations.units.items() if u.angle and u.dimension == RATE_OF_RATE}

    def is_transport(term: sp.Expr) -> bool:
        """m d² α in an equation of moments: a mass, an angular acceleration, and no moment of inertia."""
        inside = term.free_symbols
        return bool(inside & turning and inside & masses) and not inside & named

    return with_changed(
        equations,
        lambda r: terms_without(r, is_transport) if r.free_symbols & named else r,
        lambda kind: kind == "moment",
    )


def _in_blows(equations: Equations) -> Equations | None:
    """The angular momentum of a blow from which an angular velocity follows, without the moment of m v_G. Before the
    blow the body is at rest, else the two sides would not fit.
    """
    mark = equations.inputs.get(TANGENTIAL)
    steps = [_without_moments(equations, step, mark) if mark is not None else step for step in equations.steps]
    return None if tuple(steps) == equations.steps else equations.mapped(steps)


def _without_moments(equations: Equations, step: Step, mark: sp.Symbol) -> Step:
    residuals = list(step.residuals)
    for i, (kind, residual) in enumerate(zip(step.kinds, step.residuals, strict=False)):
        rates = {u for u in step.unknowns if equations.turns(u)} & residual.free_symbols
        before = {s for s in residual.free_symbols if equations.turns(s)} - set(step.unknowns)
        if kind != "blow" or not rates or any(equations.defined.get(s) != 0 for s in before):
            continue
        terms = sp.Add.make_args(sp.expand(residual))
        momenta = [t.free_symbols for t in terms if _dimension(equations, t) == ANGULAR_MOMENTUM]
        # Where there is no I ω the body is a particle.
        own = {r for r in rates if any(r in inside and mark not in inside for inside in momenta)}
        moments = [inside for inside in momenta if mark in inside and inside & own]
        residuals[i] = sp.Add(*(t for t in terms if t.free_symbols not in moments))
    return replace(step, residuals=tuple(residuals))


def _dimension(equations: Equations, term: sp.Expr) -> Dimension | None:
    """That of a product of names; None: it is no such product."""
    found = PURE
    for base, power in term.as_powers_dict().items():
        if base.is_Symbol and power.is_Rational:
            unit = equations.units.get(base)
            found *= (unit.dimension if unit is not None else PURE) ** Fraction(power.p, power.q)
        elif base.free_symbols and not isinstance(base, sp.sin | sp.cos):
            return None
    return found
