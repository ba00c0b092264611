"""The time at which a vibration has no velocity, or passes its middle, by the tangent of its phase.

v_0 cos(ω_n t_1) + x_eq ω_n sin(ω_n t_1) = 0:
  tan(ω_n t_1) = -v_0/(x_eq ω_n) = 4.946
  t_1 = arctan(4.946)/ω_n = 1.130 s
"""

from __future__ import annotations

import math
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import derivative, identically_zero, longer, simplified
from planar_cli.report.document.blocks import Math, Value
from planar_cli.report.in_numbers.angles_found import by_function, by_tangent
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.report.words.origins import sides_of
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import Result, RouteStep, RouteTrace
from planar_cli.units import PURE

LONGEST = 16
"""The tangent of more operations is not told."""
FLAT, STEEP = Decimal("1e-4"), Decimal("1e4")
"""Beyond these a tangent is zero or infinite but for rounding: the phase is a whole number of quarters."""


def function_first(leg: RouteStep, r: Result, route: RouteTrace, counted: bool, phrases: Phrases) -> tuple[Any, ...]:
    """The sine of an angle, from its equation in numbers where it stands so (`counted`), or the tangent of a phase,
    tan(ω t) = formula = numbers = value, from a sin(ω t) + b cos(ω t) = 0; empty of anything else.
    """
    (e, *more) = leg.relations
    sides = sides_of(e, route) if counted and not more and len(leg.unknowns) == 1 else None
    told = by_function(r, sides, leg.unknowns, phrases) or by_tangent(e.residual, r, phrases)
    found = None if told else _tangent(leg, r, route, phrases)
    if found is None:
        return told
    phase, ratio = found
    value = Value(phrases.value(ratio), "", phrases.figures)
    return phrases.math(sp.tan(phase)), phrases.math(ratio), *phrases.substituted(ratio, value), value


def by_the_tangent(leg: RouteStep, r: Result, route: RouteTrace, phrases: Phrases) -> list[Math]:
    """The time by that tangent, (π + arctan(4.946))/ω_n + t_0; empty: it is another equation."""
    found = _tangent(leg, r, route, phrases)
    if found is None:
        return []
    phase, ratio = found
    number, size = phrases.value(ratio), sp.Symbol(f"{NUMBER}tangent", positive=True)
    first = sp.atan(size) if number > 0 else -sp.atan(size)
    rate = derivative(phase, r.unknown)
    turns = round(float(phrases.value(phase - sp.atan(ratio))) / math.pi)
    begun = simplified(r.unknown - phase / rate)
    return [Math((turns * sp.pi + first) / rate + begun, {size: significant(abs(number), phrases.figures)})]


def _tangent(leg: RouteStep, r: Result, route: RouteTrace, phrases: Phrases) -> tuple[sp.Expr, sp.Expr] | None:
    """The phase, and its tangent."""
    if len(leg.relations) > 1:
        return None
    residual = leg.relations[0].residual.xreplace(dict(route.plain))
    waves = residual.atoms(sp.sin, sp.cos)
    inside = {f.args[0] for f in waves if r.unknown in f.free_symbols}
    inverse = [] if r.formula is None else list(r.formula.atoms(sp.atan))
    if phrases.symbolic or len(waves) != 2 or len(inside) != 1 or len(inverse) != 1 or residual.has(sp.exp):
        return None
    (phase,) = inside
    letters = {f(phase): sp.Dummy(real=True) for f in (sp.sin, sp.cos)}
    flat = residual.xreplace(letters)
    a, b = (derivative(flat, x) for x in letters.values())
    rest = flat - sp.Add(*(k * x for k, x in zip((a, b), letters.values(), strict=True)))
    if 0 in (a, b) or not identically_zero(rest) or r.unknown in (a + b).free_symbols:
        return None
    # Without one of the two waves it is a sine or a cosine alone.
    if any(map(phrases.value.is_zero, (a, b))):
        return None
    ratio = simplified(-b / a)
    number = phrases.value.known(ratio)
    if number is None or not number.is_finite() or not FLAT < abs(number) < STEEP:
        return None
    ours = any(identically_zero(inverse[0].args[0] - sign * ratio) for sign in (1, -1))
    plain = ours and not longer(ratio, LONGEST) and is_clean(phrases.ledger, ratio, dimension=PURE)
    return (phase, ratio) if plain and phrases.has_numbers(ratio) else None
