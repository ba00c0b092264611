"""Which laws between states a method allows, and whether they reach what is asked."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import sympy as sp

from planar_cli.equation.evaluate import refuse
from planar_cli.problem.scene import Problem
from planar_cli.registry import members
from planar_cli.solve.course.derivation import Route
from planar_cli.solve.course.equations import Equation

FOLLOWED = frozenset(("v(t)",))
"""Laws of methods that work with the equations of motion."""


def laws_of_methods() -> frozenset[str]:
    """The kinds of law that belong to some method; all other equations are data, geometry or blows."""
    found: set[str] = set()
    for kind in members("principles"):
        found |= _laws(kind)
    return frozenset(found)


def _laws(kind: str) -> frozenset[str]:
    principle: Any = members("principles")[kind]
    laws: frozenset[str] = principle.laws
    return laws


def by_method(equations: Sequence[Equation], method: str | None) -> tuple[Equation, ...]:
    """The equations that a method allows; None: all of them."""
    if method is None:
        return tuple(equations)
    barred = laws_of_methods() - _laws(method)
    return tuple(e for e in equations if e.kind not in barred)


def follows(method: str | None) -> bool:
    """Does a method allow what follows the equations of motion in numbers?"""
    return method is None or bool(FOLLOWED & _laws(method))


def demand_reached(problem: Problem, route: Route, targets: Sequence[sp.Symbol], free: Callable[[], Route]) -> None:
    """FileProblem: a method that was named does not lead to something that is asked. What no plan leads to, not even
    the one by all laws (`free`), comes from following the equations of motion in numbers, which are Newton's.
    """
    missing = _missing(route, targets)
    if missing and follows(problem.method):
        missing = sorted(set(missing) - set(_missing(free(), targets)))
    if missing:
        text = f"method {problem.method} alone does not reach {', '.join(missing)}"
        hint = "leave `method` out: the plan then takes the laws that lead there; `--compare` lists what each reaches"
        raise refuse(problem.find[0].mark, "PL570", text, hint)


def _missing(route: Route, targets: Sequence[sp.Symbol]) -> list[str]:
    """The names of what a route does not tell."""
    told = {r.unknown for leg in route.legs for r in leg.results} | set(route.plain)
    return sorted(s.name.replace("__", "_") for s in targets if s not in told)
