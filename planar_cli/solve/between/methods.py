"""Which laws between states a method allows, and whether they reach what is asked."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import sympy as sp

from planar_cli.problem.scene import Problem
from planar_cli.solve.between.derivation import Route
from planar_cli.solve.instant.finish import not_reached
from planar_cli.solve.regimes.equations import Equation


def by_method(equations: Sequence[Equation], method: str | None) -> tuple[Equation, ...]:
    """The equations that a method allows: its own, and data, geometry and blows, which are no method's; None: all."""
    return tuple(e for e in equations if method is None or not e.offered or method in e.offered)


def demand_reached(
    problem: Problem, follows: bool, route: Route, targets: Sequence[sp.Symbol], free: Callable[[], Route]
) -> None:
    """FileProblem: a method that was named does not lead to something that is asked. What no plan leads to, not even
    the one by all laws (`free`), comes from following the equations of motion in numbers, if the method `follows` them.
    """
    missing = _missing(route, targets)
    if missing and follows:
        missing = sorted(set(missing) - set(_missing(free(), targets)))
    if missing:
        raise not_reached(problem.method, missing, problem.find[0].mark)


def _missing(route: Route, targets: Sequence[sp.Symbol]) -> list[str]:
    """The names of what a route does not tell."""
    told = {r.unknown for step in route.steps for r in step.results} | set(route.plain)
    return sorted(s.name.replace("__", "_") for s in targets if s not in told)
