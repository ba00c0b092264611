"""Closed answers as a person would leave them: short in their angles, without bars round what is positive.

2 v² |cos(φ/2 + 45°)| |sin(φ/2 + 45°) - tan φ cos(φ/2 + 45°)|/(g |cos φ|)  =  v²/(g (1 + sin φ))
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.cancelling import cancelled
from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.values.exact import Valuation
from planar_cli.report.notation.ordering import factor_key
from planar_cli.report.notation.shorter_angles import MOST, of_two_angles, shorter
from planar_cli.report.words.counted import as_counted
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution


def with_plain_answers(part: PartSolution) -> PartSolution:
    """A part whose answers in letters are in their plainest form, and rotations in the sense in which they count."""
    if part.followed is not None or not part.instants:
        return part
    part = as_counted(part)
    ledger = part.instants[-1].instant.scene.ledger
    value = part.instants[-1].value if part.motion is None else part.motion.value
    letters = set(ledger.letters) - set(ledger.coordinates)
    return replace(part, found=tuple(_plain(f, letters, value, ledger.above_zero) for f in part.found))


def _plain(found: Found, letters: Collection[sp.Symbol], value: Valuation, above_zero: Collection[sp.Expr]) -> Found:
    told = found.kind in ("number", "vector") and found.values is None and not found.word and found.curve is None
    if not told or not found.expressions:
        return found
    return replace(found, expressions=tuple(plainest(e, letters, value, above_zero) for e in found.expressions))


def plainest(
    expr: sp.Expr, letters: Collection[sp.Symbol], value: Valuation, above_zero: Collection[sp.Expr] = ()
) -> sp.Expr:
    """The formula without bars that say nothing, and short in its angles; itself where numbers do not bear it out.
    `letters`: what the file gives without a number; `above_zero`: differences of these that it says are positive.
    """
    expr = sp.sympify(expr)
    if not expr.free_symbols <= set(letters):
        return expr
    found = _over_one_bar(shorter(_without_bars(expr, letters, above_zero)))
    return _turned(found if found == expr or value.is_zero(found - expr) else expr, above_zero)


def _over_one_bar(expr: sp.Expr) -> sp.Expr:
    """A sum of fractions as one fraction, where that is shorter: (m g + 2 m a - M g)/(m + M) - a is
    (m - M) (g + a)/(m + M).
    """
    if not expr.is_Add or operations(expr) > MOST or not expr.is_rational_function(*expr.free_symbols):
        return expr
    if not any(p.exp.is_negative and p.base.is_Add for p in expr.atoms(sp.Pow)):
        return expr
    return min((expr, factored(cancelled(expr))), key=operations)


def _without_bars(expr: sp.Expr, letters: Collection[sp.Symbol], above_zero: Collection[sp.Expr]) -> sp.Expr:
    """Sizes that are factors of one another stand in one pair of bars, and what is positive in none."""
    bars = [f for f in sp.Mul.make_args(expr) if f.as_base_exp()[0].func == sp.Abs]
    if len(bars) > 1:
        inside = shorter(sp.Mul(*(f.as_base_exp()[0].args[0] ** f.as_base_exp()[1] for f in bars)))
        expr = sp.Mul(*(f for f in sp.Mul.make_args(expr) if f not in bars)) * sp.Abs(inside)
    insides = ((a, way * of_two_angles(a.args[0])) for a in expr.atoms(sp.Abs) for way in (1, -1))
    return sp.sympify(expr.xreplace({a: e for a, e in insides if is_positive(e, letters, above_zero)}))


def is_positive(expr: sp.Expr, letters: Collection[sp.Symbol], above_zero: Collection[sp.Expr] = ()) -> bool:
    """Is it positive for positive letters, angles among them acute? `above_zero`: differences of letters that are."""
    signs = {f: _sign(f, letters, above_zero) for f in expr.atoms(sp.sin, sp.cos, sp.tan)}
    known = {f: sign * sp.Dummy(positive=True) for f, sign in signs.items() if sign}
    for f in (*expr.atoms(sp.sin, sp.cos),):
        # 1 - sin φ.
        expr = expr.xreplace({1 - f: sp.Dummy(nonnegative=True)})
    return bool(expr.xreplace(known).is_nonnegative)


def _sign(f: sp.Expr, letters: Collection[sp.Symbol], above_zero: Collection[sp.Expr]) -> int:
    """The sign of a function of an acute angle, or of the difference of two; 0: it is not known."""
    angle = f.args[0]
    if angle in letters:
        return 1
    parts = {t: t.could_extract_minus_sign() for t in angle.args} if angle.is_Add else {}
    if sorted(parts.values()) != [False, True] or not all((-t if m else t) in letters for t, m in parts.items()):
        return 0
    return 1 if isinstance(f, sp.cos) or angle in above_zero else -1 if -angle in above_zero else 0


def _turned(expr: sp.Expr, above_zero: Collection[sp.Expr]) -> sp.Expr:
    """A product with the sine of a positive difference: 2 v sin(θ - β)/g for -2 v sin(β - θ)/g, as SymPy orders it."""
    sines = [f for f in sp.Mul.make_args(expr) if isinstance(f, sp.sin) and -f.args[0] in above_zero]
    if len(sines) != 1 or not expr.could_extract_minus_sign():
        return expr
    (sine,) = sines
    factors = (*sp.Mul.make_args(-expr / sine), sp.sin(-sine.args[0], evaluate=False))
    return sp.Mul(*sorted(factors, key=factor_key), evaluate=False)
