"""A definite integral, and where its antiderivative is a logarithm or an inverse function, this between its limits.

∫[v_0 → 0] (-v_t² v/(g (v_t² + v²))) dv = ∫[0 → h] ds
h = [-v_t² ln(v_t² + v²)/(2 g)] from v = v_0 to 0
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.calculus.antiderivative import antiderivative, where_real
from planar_cli.equation.algebra.plain import identically_zero, longer, simplified
from planar_cli.report.document.blocks import Block, Equation, Text, line
from planar_cli.report.laws.laws import integral_note, running
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import Relation

LONGEST = 24
"""A longer antiderivative is not told."""
TOLD = (sp.log, sp.atan, sp.atanh, sp.asinh)
"""Functions that a reader does not see in the integrand."""
OPENS = "["


def is_between_limits(block: Block) -> bool:
    """Is it an antiderivative between its limits, whose value the next line tells?"""
    match block:
        case Equation(sides=(_, (Text(text), *_))):
            return text == OPENS
    return False


def integral_blocks(
    sides: Sequence[sp.Expr], varying: Collection[sp.Symbol], e: Relation, phrases: Phrases
) -> Iterator[Block]:
    """Both sides as integrals; then, where one of them alone needs it, with its antiderivative. `varying`: letters that
    run, or are not known yet.
    """
    shown = [running(s, varying, phrases, e.law) for s in sides]
    yield Equation(tuple(shown), None, (), integral_note(e.law, e.kind, shown, phrases))
    plain = [s for s in sides if isinstance(s, sp.Integral) and s.function == 1]
    (integral, *more) = [s for s in sides if s not in plain] or [None]
    if len(plain) != 1 or more or not isinstance(integral, sp.Integral) or any(m.values for m in shown):
        return
    x, low, high = integral.limits[0]
    found = _antiderivative(integral, phrases)
    if found is not None and found.has(*TOLD) and not longer(found, LONGEST):
        _, since, until = plain[0].limits[0]
        running_from = line("] from ", phrases.math(x), " = ", phrases.math(low), " to ", phrases.math(high))
        yield Equation((phrases.math(until - since), line(OPENS, phrases.math(found), running_from)))


def _antiderivative(integral: sp.Integral, phrases: Phrases) -> sp.Expr | None:
    """Real between the limits."""
    x, low, high = integral.limits[0]
    ends = [phrases.value.known(e) for e in (low, high)]
    if None in ends:
        return None
    between = phrases.value.extended({x: sum((e for e in ends if e is not None), Decimal(0)) / 2})
    found = antiderivative(integral.function, x, between)
    if found is None:
        return None
    raw = where_real(found, between)
    real = min((_by_artanh(_plain(e), x) for e in (simplified(raw), raw)), key=sp.count_ops)
    return real if identically_zero(sp.diff(real, x) - integral.function) else None


def _plain(found: sp.Expr) -> sp.Expr:
    """Without numbers by which a logarithm differs by a constant: ln(2 u) is ln(u)."""
    put = {}
    for log in found.atoms(sp.log):
        number, rest = log.args[0].as_coeff_Mul()
        put[log] = sp.log(rest) if number > 0 else log
    return found.xreplace(put)


def _by_artanh(found: sp.Expr, x: sp.Symbol) -> sp.Expr:
    """ln((a - x)/(a + x)) = -2 artanh(x/a)."""
    put = {}
    for log in found.atoms(sp.log):
        ratio = simplified((1 - log.args[0]) / (1 + log.args[0]))
        if (ratio / x).is_Pow and not (ratio / x).has(x):
            put[log] = -2 * sp.atanh(ratio)
    return found.xreplace(put)
