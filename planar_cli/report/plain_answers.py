"""Closed answers as a person would leave them: short in their angles, without bars round what is positive.

2 v² |cos(φ/2 + 45°)| |sin(φ/2 + 45°) - tan φ cos(φ/2 + 45°)|/(g |cos φ|)  =  v²/(g (1 + sin φ))
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

import sympy as sp

from planar_cli.equation.exact import Valuation
from planar_cli.report.shorter_angles import shorter
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution


def with_plain_answers(part: PartSolution) -> PartSolution:
    """A part whose answers in letters are in their plainest form."""
    if part.followed is not None or not part.instants:
        return part
    ledger = part.instants[-1].instant.scene.ledger
    value = part.instants[-1].value if part.motion is None else part.motion.value
    letters = set(ledger.letters) - set(ledger.coordinates)
    return replace(part, found=tuple(_plain(f, letters, value) for f in part.found))


def _plain(found: Found, letters: Collection[sp.Symbol], value: Valuation) -> Found:
    told = found.kind in ("number", "vector") and found.values is None and not found.word and found.curve is None
    if not told or not found.expressions:
        return found
    return replace(found, expressions=tuple(plainest(e, letters, value) for e in found.expressions))


def plainest(expr: sp.Expr, letters: Collection[sp.Symbol], value: Valuation) -> sp.Expr:
    """The formula without bars that say nothing, and short in its angles; itself where numbers do not bear it out.
    `letters`: what the file gives without a number.
    """
    expr = sp.sympify(expr)
    if not expr.free_symbols <= set(letters):
        return expr
    found = shorter(_without_bars(expr, letters))
    return found if found == expr or value.is_zero(found - expr) else expr


def _without_bars(expr: sp.Expr, letters: Collection[sp.Symbol]) -> sp.Expr:
    """Sizes that are factors of one another stand in one pair of bars, and what is positive in none."""
    bars = [f for f in sp.Mul.make_args(expr) if f.as_base_exp()[0].func == sp.Abs]
    if len(bars) > 1:
        inside = shorter(sp.Mul(*(f.as_base_exp()[0].args[0] ** f.as_base_exp()[1] for f in bars)))
        expr = sp.Mul(*(f for f in sp.Mul.make_args(expr) if f not in bars)) * sp.Abs(inside)
    positive = {a: a.args[0] for a in expr.atoms(sp.Abs) if is_positive(a.args[0], letters)}
    return sp.sympify(expr.xreplace(positive))


def is_positive(expr: sp.Expr, letters: Collection[sp.Symbol]) -> bool:
    """Is it positive for positive letters, angles among them acute?"""
    functions = {f for f in expr.atoms(sp.sin, sp.cos, sp.tan) if f.args[0] in letters}
    known = {f: sp.Dummy(positive=True) for f in functions}
    for f in (*expr.atoms(sp.sin, sp.cos),):
        # 1 - sin φ.
        expr = expr.xreplace({1 - f: sp.Dummy(nonnegative=True)})
    return bool(expr.xreplace(known).is_nonnegative)
