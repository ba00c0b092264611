"""Laws that are linear in their speed, a = F(t) - p(t) v, by an integrating factor."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from planar_cli.calculus.antiderivative import antiderivative, definite
from planar_cli.calculus.deciding import sign
from planar_cli.calculus.spans import Moment, Span, bound, integral, span
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import derivative, simplified
from planar_cli.equation.values.exact import Valuation

BY_PRODUCT = "a = dv/dt, as the derivative of a product"
"""The words of a relation of a law a = F - p v, told as d(μ v)/dt = μ F with its integrating factor μ."""


def linear_in_speed(
    a: sp.Expr, start: Moment, end: Moment, value: Valuation | None, where: tuple[sp.Expr, ...]
) -> tuple[Span, ...]:
    """a = F(t) - p(t) v with the integrating factor μ = exp(∫ p dt), for which d(μ v)/dt = μ F."""
    slope = derivative(a, end.v)
    if slope.has(end.v):
        return ()
    x = bound(end.t)
    power = antiderivative(-slope.xreplace({end.t: x}), x, value)
    if power is None:
        return ()
    factor = _grown(power, {x: start.t}, value)
    rest = simplified(expanded(a - slope * end.v)).xreplace({end.t: x})
    gained = definite(simplified(factor * rest), x, start.t, end.t, value)
    if gained is None:
        return ()
    ended = factor.xreplace({x: end.t})
    terms = sp.Add(start.v * factor.xreplace({x: start.t}) / ended, *(g / ended for g in sp.Add.make_args(gained)))
    speed = simplified(terms)
    told = span("v(t)", BY_PRODUCT, end.v - speed, None, speed, where)
    found = [replace(told, product=(ended, simplified(factor * rest).xreplace({x: end.t})))]
    change = definite(terms.xreplace({end.t: x}), x, start.t, end.t, value)
    if change is not None:
        sides = integral(1, start.q, end.q), integral(speed, start.t, end.t)
        found.append(span("q(t)", "dq = v dt", end.q - start.q - change, sides, start.q + change, where))
    return tuple(found)


def _grown(power: sp.Expr, beginning: dict[sp.Dummy, sp.Symbol], value: Valuation | None) -> sp.Expr:
    """e to a power, with |u|^c for e^(c ln u), where u keeps the sign that it has in the beginning."""
    found = sp.S.One
    for term in sp.Add.make_args(power):
        logs = [f for f in sp.Mul.make_args(term) if isinstance(f, sp.log)]
        if len(logs) != 1:
            found *= sp.exp(term)
            continue
        u = logs[0].args[0]
        found *= (-u if sign(u.xreplace(beginning), value) == -1 else u) ** expanded(term / logs[0])
    return found
