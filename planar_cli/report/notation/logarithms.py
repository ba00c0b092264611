"""Logarithms of ratios: ln(1 + c v²/(m g)) for ln(c v²/m + g) - ln(g), as no quantity with a unit has a logarithm."""

from __future__ import annotations

from typing import Any

import sympy as sp

from planar_cli.equation.values.ledger import Ledger
from planar_cli.report.notation.clean import Mixed, dimension_of
from planar_cli.units import PURE

LARGEST = 10_000
"""A ratio of larger numbers is not easier to read than the logarithms that it joins."""


def of_ratios(expr: sp.Expr, ledger: Ledger) -> sp.Expr:
    """A formula in which logarithms of quantities with units, with the same factor up to its sign, stand as one."""
    if not expr.has(sp.log):
        return expr

    def joined(total: Any) -> Any:
        if (one := _of_two(total, ledger)) is not None:
            return one
        found: dict[sp.Expr, list[tuple[int, sp.Expr]]] = {}
        rest = []
        for term in total.args:
            logs = [f for f in sp.Mul.make_args(term) if isinstance(f, sp.log)]
            if len(logs) != 1:
                rest.append(term)
                continue
            factor = term / logs[0]
            sign = -1 if factor.could_extract_minus_sign() else 1
            found.setdefault(sign * factor, []).append((sign, logs[0].args[0]))
        return sp.Add(*rest, *(_together(factor, parts, ledger) for factor, parts in found.items()))

    found = expr.replace(lambda x: x.is_Add and any(a.has(sp.log) for a in x.args), _of_numbers)
    found = found.replace(lambda x: x.is_Add and any(a.has(sp.log) for a in x.args), joined)
    return found.replace(lambda x: x.is_Mul and any(isinstance(a, sp.log) for a in x.args), _turned)


def _of_numbers(total: Any) -> Any:
    """2 a ln(8/5) for 6 a ln(2) - 2 a ln(5): logarithms of numbers with multiples of one factor as one."""
    multiples: dict[sp.Expr, dict[sp.Rational, sp.Rational]] = {}
    rest = []
    for term in total.args:
        logs = [f for f in sp.Mul.make_args(term) if isinstance(f, sp.log)]
        if len(logs) != 1 or not logs[0].args[0].is_Rational:
            rest.append(term)
            continue
        count, factor = (term / logs[0]).as_coeff_Mul(rational=True)
        multiples.setdefault(factor, {})[logs[0].args[0]] = count
    if not any(len(counts) > 1 for counts in multiples.values()):
        return total
    for factor, counts in multiples.items():
        unit = sp.gcd_list(list(counts.values()))
        ratio = sp.prod(number ** (count / unit) for number, count in counts.items())
        short = max(ratio.p, ratio.q) <= LARGEST
        if not short:
            rest += [factor * count * sp.log(number) for number, count in counts.items()]
        else:
            rest.append(factor * unit * sp.log(ratio) if ratio > 1 else -factor * unit * sp.log(1 / ratio))
    return sp.Add(*rest)


def _of_two(total: sp.Expr, ledger: Ledger) -> sp.Expr | None:
    """a ln x - a ln y as a ln(x/y), where a sum has these two logarithms alone, in whatever number of terms."""
    coefficients: dict[sp.Expr, sp.Expr] = {}
    rest = []
    for term in total.args:
        logs = [f for f in sp.Mul.make_args(term) if isinstance(f, sp.log)]
        if len(logs) > 1 or (term.has(sp.log) and not logs):
            return None
        if logs:
            coefficients[logs[0]] = coefficients.get(logs[0], sp.S.Zero) + term / logs[0]
        else:
            rest.append(term)
    if len(coefficients) != 2 or all(len(sp.Add.make_args(c)) < 2 for c in coefficients.values()):
        return None
    (one, a), (other, b) = coefficients.items()
    if sp.expand(a + b) != 0 or not _is_pure(one.args[0] / other.args[0], ledger):
        return None
    if one.args[0].is_Add:
        one, other, a = other, one, b
    return sp.Add(*rest, sp.factor(a) * sp.log(one.args[0] / other.args[0]))


def _turned(term: Any) -> Any:
    """a ln(x/y) for -a ln(y/x) and -a ln(1 - z/x), and for ln(-(y - x)/x) what it is without two signs."""
    (log, *more) = [f for f in term.args if isinstance(f, sp.log)]
    above, below = sp.fraction(log.args[0])
    if below == 1 and above.is_Add and (term / log).could_extract_minus_sign():
        above, below = sp.fraction(sp.together(above))
    if more or below == 1 or not any(f.is_Add for f in sp.Mul.make_args(above)):
        return term
    above, factor = sp.expand(above), term / log
    if above.is_Add and not below.is_Add and factor.could_extract_minus_sign():
        return -factor * sp.log(below / above)
    return factor * sp.log(above / below)


def _together(factor: sp.Expr, parts: list[tuple[int, sp.Expr]], ledger: Ledger) -> sp.Expr:
    """factor · Σ ± ln(argument) as one logarithm, where that alone is one of a pure number."""
    apart = sp.Add(*(sign * factor * sp.log(argument) for sign, argument in parts))
    if len(parts) > 1 and all(argument.is_Rational for _, argument in parts):
        return factor * sp.log(sp.Mul(*(argument**sign for sign, argument in parts)))
    if len(parts) == 1 or all(_is_pure(argument, ledger) for _, argument in parts):
        return apart
    sign = parts[0][0] if parts[0][1].is_Add else 1
    ratio = sp.Mul(*(argument ** (sign * own) for own, argument in parts))
    if not _is_pure(ratio, ledger):
        return apart
    above, below = sp.fraction(sp.together(ratio))
    if above.could_extract_minus_sign():
        above, below = -above, -below
    whole = (
        sp.Add(*(sp.cancel(a / below) for a in sp.expand(above).args)) if above.is_Add and not below.is_Add else None
    )
    return sign * factor * sp.log(above / below if whole is None else whole)


def _is_pure(expr: sp.Expr, ledger: Ledger) -> bool:
    try:
        return dimension_of(expr, ledger) == PURE
    except Mixed:
        return False
