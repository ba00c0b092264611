"""Two coordinates of a state of which only the difference counts: it is then the unknown, as in x_B/A.

So two bodies that a spring joins, on which nothing else acts, have a law for their distance, but none for their places.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import combinations

import sympy as sp

from planar_cli.equation.algebra.plain import derivative, identically_zero, longer
from planar_cli.solve.between.equations.asked_finds import AskedFind
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.timeline import Stop

LONG = 200


def by_differences(
    course: MotionEquations, finds: tuple[AskedFind, ...], truth: Mapping[sp.Symbol, float]
) -> tuple[MotionEquations, dict[sp.Symbol, float]]:
    """Differences put for pairs of coordinates of which nothing else counts, in the equations and in what is asked; and
    the values of the differences.
    """
    found: dict[sp.Symbol, float] = {}
    asked = [p for a in finds for p in a.parts()]
    for state in course.states[1:]:
        stop = course.stops[state.name]
        letters = [s for s in stop.letters if s != stop.time and s not in stop.speeds and stop.letters[s] in truth]
        for pair in combinations(letters, 2):
            a, b = sorted(pair, key=lambda s: truth[stop.letters[s]])
            one, other = stop.letters[a], stop.letters[b]
            if course.ledger.units[one] != course.ledger.units[other]:
                continue
            if _counts_alone(course.equations, asked, one, other):
                name = course.ledger.fresh(_name(a, b, stop), course.ledger.units[one].text)
                equations = tuple(_put(e, one, other, name) for e in course.equations)
                course = replace(course, equations=equations, differences=(*course.differences, name))
                course.told[one] = other - name
                found[name] = truth[other] - truth[one]
    return course, found


def _name(a: sp.Symbol, b: sp.Symbol, stop: Stop) -> str:
    """x_B_A of x_A and x_B."""
    stem, _, own = a.name.partition("_")
    other, _, rest = b.name.partition("_")
    return f"{stem}_{rest}_{own}__{stop.name}" if stem == other and own and rest else f"d__{stop.name}"


def _counts_alone(equations: Sequence[Equation], asked: list[sp.Expr], a: sp.Symbol, b: sp.Symbol) -> bool:
    """Do two letters stand in equations, and in these and in what is asked only as b - a?"""
    both = [e.residual for e in equations if {a, b} & e.residual.free_symbols]
    if not any({a, b} <= r.free_symbols for r in both):
        return False
    return all(_only_difference(r, a, b) for r in (*both, *(p for p in asked if {a, b} & p.free_symbols)))


def _only_difference(expr: sp.Expr, a: sp.Symbol, b: sp.Symbol) -> bool:
    if not {a, b} <= expr.free_symbols or longer(expr, LONG) or expr.has(sp.Integral):
        return False
    d = sp.Dummy("d", real=True)
    return identically_zero(derivative(expr.xreplace({a: b - d}), b))


def _put(equation: Equation, a: sp.Symbol, b: sp.Symbol, d: sp.Symbol) -> Equation:
    if a not in equation.residual.free_symbols:
        return equation
    return replace(equation, residual=equation.residual.xreplace({a: b - d}).subs(b, 0))
