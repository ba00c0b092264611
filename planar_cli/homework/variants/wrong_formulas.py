"""What typical mistakes make of an answer in letters: the right formula is one equation, and goes through the shelf of
mistakes as the equations of numbers do. √(2 g L (sin β - μ cos β)) without friction is √(2 g L sin β).
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.common_factors import factor_terms
from planar_cli.equation.values.ledger import Ledger
from planar_cli.homework.mistakes.base import Mistake, Model
from planar_cli.homework.sets.paper import Mistaken
from planar_cli.homework.typed.typed_formula import same_formula
from planar_cli.homework.typed.unreadable import Unreadable
from planar_cli.problem.scene.scene import Problem
from planar_cli.registry import members
from planar_cli.replay.equations import Asked, Equations, Step

Letters = tuple[tuple[str, str], ...]
ANSWER = sp.Symbol("answer", real=True)
UNKNOWN = "answer"
"""The kind of the equation: forces and lengths stand in it together."""


def wrong_formulas(expr: sp.Expr, letters: Letters, problem: Problem, ledger: Ledger) -> tuple[Mistaken, ...]:
    """The formulas that mistakes give, as a problem file writes them. `letters`: those of the formula, with units."""
    found: dict[tuple[str, str], Mistaken] = {}
    right = as_written(expr)
    for name, model in _models(_equation(expr, ledger), problem):
        wrong = _carried_out(model)
        if wrong is None or not wrong.free_symbols <= expr.free_symbols:
            continue
        text = as_written(wrong)
        if not _is_same(text, right, letters):
            found.setdefault((name, text), Mistaken(name, model.feedback, (), text))
    return tuple(found.values())


def as_written(expr: Any) -> str:
    """A formula as a problem file writes it, by the functions that it has there; |√x| is √x."""
    expr = sp.sympify(expr).replace(_is_size_of_root, lambda size: size.args[0])
    for function in (sp.sinh, sp.cosh, sp.tanh, sp.asinh, sp.acosh, sp.atanh):
        expr = expr.rewrite(function, sp.log if function in (sp.asinh, sp.acosh, sp.atanh) else sp.exp)
    expr = expr.replace(sp.sign, lambda x: x / sp.Abs(x)).replace(sp.atan2, _half_way)
    return str(factor_terms(expr).replace(sp.Abs, sp.Function("abs"))).replace("**", "^")


def _is_size_of_root(expr: sp.Expr) -> bool:
    return isinstance(expr, sp.Abs) and expr.args[0].is_Pow and expr.args[0].exp == sp.S.Half


def _half_way(y: sp.Expr, x: sp.Expr) -> sp.Expr:
    """The direction of (x, y) by a plain arctangent: half the angle has the tangent y/(r + x)."""
    return 2 * sp.atan(y / (sp.sqrt(x**2 + y**2) + x))


def _equation(expr: sp.Expr, ledger: Ledger) -> Equations:
    """answer - formula = 0, where every letter has a value."""
    inputs = {s.name: s for s in sorted(expr.free_symbols, key=lambda s: s.name)}
    step = Step((ANSWER,), (ANSWER - expr,), (UNKNOWN,), ((),))
    units = {s: ledger.units[s] for s in inputs.values() if s in ledger.units}
    ones = dict.fromkeys((*inputs.values(), ANSWER), 1.0)
    return Equations("", inputs, {}, (step,), {ANSWER.name: Asked((ANSWER,))}, (), ones, units=units)


def _models(equations: Equations, problem: Problem) -> Iterator[tuple[str, Model]]:
    for name, kind in members("homework.mistakes").items():
        mistake: Mistake = kind()
        for model in mistake.models(equations, problem):
            yield name, model


def _carried_out(model: Model) -> sp.Expr | None:
    """The formula with the mistake; None: it has no value, or nothing is left of it."""
    ((residual,),) = (s.residuals for s in model.equations.steps)
    wrong = (ANSWER - residual).xreplace(dict(model.inputs))
    return None if wrong == 0 or wrong.has(sp.zoo, sp.oo, sp.nan, sp.I, ANSWER) else wrong


def _is_same(one: str, other: str, letters: Letters) -> bool:
    """Also where it cannot be told: then it says nothing."""
    try:
        return same_formula(one, other, letters)
    except Unreadable:
        return True
