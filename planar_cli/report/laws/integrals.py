"""Integrals of a motion as they are printed: over time or a coordinate, between the values at two states."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.solve.between.trace.trace import MotionTrace, Relation, RouteTrace
from planar_cli.units import RATE, VELOCITY

LONGEST = 60
"""Of a longer integrand no common factor is looked for."""
General = Mapping[sp.Symbol, sp.Symbol]
"""By the symbol of a state, that of the general position."""


def plain_integral(side: sp.Expr, e: Relation, route: RouteTrace, general: General) -> sp.Expr:
    """Limits of this motion, the variable without the name of a state; a speed of turning is called ω."""
    names = {own.name: placed.name for own, placed in general.items()}
    if e.law is not None and e.law.coordinate.unit == "rad":
        names["v"] = "omega"

    def renamed(integral: Any) -> Any:
        variable, low, high = integral.limits[0]
        plain = sp.Symbol(names.get(variable.name, variable.name), real=True)
        inside = _one_fraction(integral.function.xreplace({variable: plain}).xreplace(route.plain))
        return sp.Integral(inside, (plain, low.xreplace(route.plain), high.xreplace(route.plain)))

    return side.replace(lambda x: isinstance(x, sp.Integral), renamed)


def _one_fraction(inside: sp.Expr) -> sp.Expr:
    """Terms over the same sum as one product: 6 m s t (t - T)/((M + m) T³)."""
    terms = sp.Add.make_args(inside)
    under = [{d for d in sp.Mul.make_args(sp.fraction(t)[1]) if d.as_base_exp()[0].is_Add} for t in terms]
    if len(terms) < 2 or longer(inside, LONGEST) or not set.intersection(*under):
        return inside
    found = factored(simplified(inside))
    return found if operations(found) < operations(inside) else inside


def over_coordinates(formula: sp.Expr, general: General) -> sp.Expr:
    """Under an integral a coordinate runs, not its value at a state."""
    names = {own.name: placed.name for own, placed in general.items()}

    def renamed(integral: Any) -> Any:
        variable, low, high = integral.limits[0]
        running = sp.Symbol(names.get(variable.name, variable.name), real=True)
        return sp.Integral(integral.function.xreplace({variable: running}), (running, low, high))

    return formula.replace(lambda x: isinstance(x, sp.Integral), renamed)


def in_times(formula: sp.Expr, found: MotionTrace) -> sp.Expr:
    """As the course writes what passes between two times: v t + 1/2 a t² for t (v + 1/2 a t), ω_2 + α (t_3 - t_2) for
    ω_2 - α (t_2 - t_3), and t_2 + (ω_3 - ω_2)/α for ω_3/α + t_2 - ω_2/α.
    """
    times = {own for own, placed in found.general.items() if placed.name == "t"}
    return _over_common(_later_first(_in_powers(formula, times, found), times, found))


def _in_powers(formula: sp.Expr, times: set[sp.Symbol], found: MotionTrace) -> sp.Expr:
    """A time multiplied out where a speed stands in the bracket."""
    brackets = [f for f in sp.Mul.make_args(formula) if f.is_Add]
    common = times & (formula / sp.Mul(*brackets)).free_symbols
    if len(brackets) != 1 or not common & brackets[0].free_symbols:
        return formula
    if formula.free_symbols <= times:
        return sp.expand(formula)
    terms = [term.as_coeff_Mul()[1] for term in brackets[0].args]
    units = [unit for s in terms if (unit := found.ledger.units.get(s)) is not None]
    return sp.expand(formula) if any(u.dimension in (VELOCITY, RATE) for u in units) else formula


def _later_first(formula: sp.Expr, times: set[sp.Symbol], found: MotionTrace) -> sp.Expr:
    """Differences of times counted so that they are positive."""

    def turned(product: Any) -> Any:
        for factor in product.args:
            span = factor.is_Add and len(factor.args) == 2 and factor.free_symbols <= times
            number = found.value.known(factor) if span else None
            if number is not None and number < 0:
                return sp.Mul(-(product / factor), -factor)
        return product

    return formula.replace(lambda x: isinstance(x, sp.Mul), turned)


def _over_common(formula: sp.Expr) -> sp.Expr:
    """Terms with the same denominator over it once."""
    if not formula.is_Add:
        return formula
    above: dict[sp.Expr, list[sp.Expr]] = {}
    for term in formula.args:
        numerator, below = sp.fraction(term)
        plain = not below.free_symbols
        above.setdefault(sp.S.One if plain else below, []).append(term if plain else numerator)
    return sp.Add(*(sp.Mul(sp.Add(*parts), 1 / below) for below, parts in above.items()))
