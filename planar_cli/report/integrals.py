"""Integrals of a motion as they are printed: over time or a coordinate, between the values at two states."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from planar_cli.solve.between.trace import Relation, RouteTrace

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
        inside = integral.function.xreplace({variable: plain}).xreplace(route.plain)
        return sp.Integral(inside, (plain, low.xreplace(route.plain), high.xreplace(route.plain)))

    return side.replace(lambda x: isinstance(x, sp.Integral), renamed)


def over_coordinates(formula: sp.Expr, general: General) -> sp.Expr:
    """Under an integral a coordinate runs, not its value at a state."""
    names = {own.name: placed.name for own, placed in general.items()}

    def renamed(integral: Any) -> Any:
        variable, low, high = integral.limits[0]
        running = sp.Symbol(names.get(variable.name, variable.name), real=True)
        return sp.Integral(integral.function.xreplace({variable: running}), (running, low, high))

    return formula.replace(lambda x: isinstance(x, sp.Integral), renamed)
