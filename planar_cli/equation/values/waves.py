"""Sines and cosines of the angle between two bodies, in equations that hold nothing else of it or give it away."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp
from sympy.simplify.fu import TR8

from planar_cli.equation.algebra.common_factors import together
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.exact import PI, Valuation

LONGEST = 60
"""Nothing longer is made plainer here."""
WAVES = (sp.sin, sp.cos, sp.tan)


def vanishing(residual: sp.Expr, value: Valuation) -> Iterator[sp.Expr]:
    """The factors of its numerator that are zero."""
    tangents = {f: sp.sin(f.args[0]) / sp.cos(f.args[0]) for f in residual.atoms(sp.tan)}
    above = factored(sp.fraction(together(residual.xreplace(tangents)))[0])
    yield from (f for f in sp.Mul.make_args(above) if f.free_symbols and value.is_zero(f))


def one_wave(factor: sp.Expr) -> sp.Expr | None:
    """c sin u or c cos u as that sine or cosine, products of sines and cosines being written as sums."""
    summed = sp.factor_terms(expanded(TR8(expanded(factor))))
    (wave, *more) = summed.atoms(sp.sin, sp.cos) or (None,)
    return wave if wave is not None and not more and not (summed / wave).has(wave) else None


def right_angle(residual: sp.Expr, x: sp.Symbol, value: Valuation) -> sp.Expr | None:
    """x from sin u = 0 or cos u = 0, with u = ±x + other angles; None: it is another equation."""
    if not isinstance(residual, (sp.sin, sp.cos)):
        return None
    argument = expanded(residual.args[0])
    rate = argument.coeff(x)
    if rate not in (1, -1):
        return None
    quarters = round(value(argument) / (PI / 2))
    return expanded((sp.pi / 2 * quarters - (argument - rate * x)) / rate)


def wave_values(residual: sp.Expr, value: Valuation) -> dict[sp.Expr, sp.Expr]:
    """What sine and cosine of u are where one of them vanishes."""
    if not isinstance(residual, (sp.sin, sp.cos)):
        return {}
    argument = residual.args[0]
    return {f: sp.Integer(round(value(f))) for f in (sp.sin(argument), sp.cos(argument))}


def wave_put_in(pool: Sequence[sp.Expr], value: Valuation) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """One of two equations with a sine or cosine put in that the other gives, and that other: with r sin u = h cos θ,
    cos² u is 1 - (h cos θ/r)².
    """
    for first, second in (pool, pool[::-1]):
        if longer(first, LONGEST) or longer(second, LONGEST):
            continue
        for wave in sorted(second.atoms(sp.sin, sp.cos), key=str):
            letter = sp.Dummy("wave", real=True)
            put = second.xreplace({wave: letter})
            slope = sp.diff(put, letter)
            if slope.has(letter) or wave.args[0] in (f.args[0] for f in put.atoms(*WAVES)) or value.is_zero(slope):
                continue
            other = (sp.cos if isinstance(wave, sp.sin) else sp.sin)(wave.args[0])
            squares = {
                p: (1 - wave**2) ** (p.exp / 2) for p in first.atoms(sp.Pow) if p.base == other and p.exp % 2 == 0
            }
            gone = first.xreplace(squares)
            if not squares or gone.has(other):
                continue
            formula = -put.xreplace({letter: sp.S.Zero}) / slope
            yield simplified(gone.xreplace({wave: formula})), second


def without_waves(expr: sp.Expr) -> sp.Expr:
    """An expression whose sines and cosines cancel, without them; another one as it is."""
    if not expr.has(*WAVES) or longer(expr, 2 * LONGEST):
        return expr
    found = simplified(expr)
    return expr if found.has(*WAVES) else found
