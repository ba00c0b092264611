"""Extreme positions of a mechanism: two links lie in one line there, folded on each other or stretched.

sin(β - α) = 0:   β = α + n π;   a sin α + b sin β = e   ->   (a ± b) sin α = e,   and the distance along the guide is
√((a ± b)² - e²).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.solve.between.trace.trace import LinksInLine, MotionTrace, Relation, Result
from planar_cli.solve.regimes.equations import Equation


def line_of(relations: Sequence[Relation | Equation], results: Sequence[Result]) -> LinksInLine | None:
    """Of a step that tells two angles by sin(β - α) = 0 and one relation of lengths; None: it is no such step."""
    formulas = {r.unknown: r.formula for r in results if r.formula is not None}
    if len(relations) != 2 or len(formulas) != 2 or relations[0].kind != "given":
        return None
    wave = _wave(relations[0].residual)
    if wave is None or wave.free_symbols != set(formulas):
        return None
    for first, other in (tuple(formulas), tuple(formulas)[::-1]):
        half_turns = sp.expand(formulas[other] - first) / sp.pi
        asin = [f for f in formulas[first].atoms(sp.asin) if not f.is_number]
        if half_turns.is_Integer and len(asin) == 1 and turns_of(formulas[first], asin[0]) is not None:
            return LinksInLine(first, other, int(half_turns), formulas[first])
    return None


def _wave(residual: sp.Expr) -> sp.Expr | None:
    """The sine that vanishes."""
    waves = [f for f in sp.Mul.make_args(residual) if not f.is_number]
    return waves[0] if len(waves) == 1 and isinstance(waves[0], sp.sin) else None


def says_in_line(closed: sp.Expr, pairs: Iterable[tuple[sp.Symbol, sp.Symbol]]) -> bool:
    """Does a speed vanish where two of these angles differ by half turns?"""
    both = (pair for pair in pairs if closed.free_symbols.issuperset(pair))
    return any(simplified(closed.xreplace({b: a + n * sp.pi})) == 0 for a, b in both for n in (0, 1))


def turns_of(formula: sp.Expr, asin: sp.Expr) -> tuple[int, int] | None:
    """n and the sign of n π ± arcsin."""
    formula = sp.expand_mul(formula, deep=False)
    slope = formula.coeff(asin)
    rest = sp.expand(formula - slope * asin) / sp.pi
    return (int(rest), int(slope)) if slope in (1, -1) and rest.is_Integer else None


def by_lines(motion: MotionTrace) -> MotionTrace:
    """A motion in which places that are asked stand without the angles of such positions, where that is no longer."""
    waves: dict[sp.Expr, sp.Expr] = {}
    for step in motion.route.steps:
        if step.in_line is not None:
            waves.update(waves_of(step.in_line, motion.value))
    if not waves:
        return motion
    requests = tuple(replace(r, parts=tuple(_put(p, waves) for p in r.parts)) for r in motion.requests)
    return replace(motion, requests=requests)


def waves_of(found: LinksInLine, value: Valuation) -> dict[sp.Expr, sp.Expr]:
    """Sines and cosines of both angles in lengths: cos(n π ± arcsin(e/d)) = ± √(d² - e²)/d."""
    (asin,) = (f for f in found.formula.atoms(sp.asin) if not f.is_number)
    told = turns_of(found.formula, asin)
    assert told is not None
    turns, slope = told
    above, below = sp.fraction(sp.together(asin.args[0]))
    if value(below) < 0:
        above, below = -above, -below
    back = -1 if turns % 2 else 1
    cos, sin = back * sp.sqrt(below**2 - above**2) / below, back * slope * above / below
    over = -1 if found.folded else 1
    first, other = found.first, found.other
    return {sp.cos(first): cos, sp.sin(first): sin, sp.cos(other): over * cos, sp.sin(other): over * sin}


def _put(expr: sp.Expr, waves: Mapping[sp.Expr, sp.Expr]) -> sp.Expr:
    put = expr.xreplace(dict(waves))
    if put == expr:
        return expr
    roots = {f: sp.Dummy(positive=True) for f in put.atoms(sp.Pow) if f.exp == sp.Rational(1, 2)}
    lettered = put.xreplace(roots)
    slopes = {f: simplified(sp.diff(lettered, x)) for f, x in roots.items()}
    rest = simplified(lettered.xreplace(dict.fromkeys(roots.values(), sp.S.Zero)))
    if any(slope.free_symbols & set(roots.values()) for slope in slopes.values()):
        return expr
    found = sp.Add(rest, *(slope * f for f, slope in slopes.items()))
    return found if operations(found) <= operations(expr) + len(roots) else expr
