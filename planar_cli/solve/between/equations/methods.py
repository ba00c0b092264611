"""Which laws between states a method allows, and whether they reach what is asked."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import sympy as sp

from planar_cli.solve.between.trace.derivation import Route
from planar_cli.solve.regimes.equations import Equation


def by_method(equations: Sequence[Equation], method: str | None) -> tuple[Equation, ...]:
    """The equations that a method allows: its own, and data, geometry and blows, which are no method's; None: all."""
    return tuple(e for e in equations if method is None or not e.offered or method in e.offered)


def not_reached_by(
    follows: bool, route: Route, targets: Sequence[sp.Symbol], free: Callable[[], Route]
) -> list[sp.Symbol]:
    """What is asked and a method that was named does not lead to. What no plan leads to, not even the one by all laws
    (`free`), comes from following the equations of motion in numbers, if the method `follows` them.
    """
    missing = _missing(route, targets)
    if not (missing and follows):
        return missing
    never = _missing(free(), targets)
    return [s for s in missing if s not in never]


def _missing(route: Route, targets: Sequence[sp.Symbol]) -> list[sp.Symbol]:
    """What a route does not tell."""
    told = {r.unknown for step in route.steps for r in step.results} | set(route.plain)
    return sorted((s for s in targets if s not in told), key=lambda s: s.name)
