"""The equations between states that can be solved, where others leave letters open whatever their numbers are."""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import derivative, letters
from planar_cli.equation.values.sample import anywhere
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.multibody.linear import solve
from planar_cli.solve.regimes.equations import Equation

ZERO = Decimal(0)


def determined_part(course: MotionEquations) -> list[Equation]:
    """The equations without letters that all of them together leave open, where they tell everything else; otherwise
    all equations.

    What is open for numbers drawn anywhere is open for all others as well. To look for roots of what holds such letters
    takes long, as every block of them is tried, and finds none.
    """
    equations = list(course.equations)
    if any(e.residual.has(sp.Integral) for e in equations):
        return equations
    unknowns = sorted(course.chain().unknowns, key=lambda s: s.name)
    slopes = _slopes(course, equations, unknowns)
    if slopes is None:
        return equations
    loose = _loose(slopes, unknowns)
    kept = [i for i, e in enumerate(equations) if not letters(e.residual) & loose]
    if not loose or _loose([slopes[i] for i in kept], unknowns) != loose:
        return equations
    return [equations[i] for i in kept]


def _slopes(
    course: MotionEquations, equations: Sequence[Equation], unknowns: Sequence[sp.Symbol]
) -> list[list[Decimal]] | None:
    """How every equation changes with every unknown, for numbers drawn anywhere; None: not all have a value."""
    ordinary = course.natural(unknowns)
    value = course.base().extended({x: anywhere(i) * ordinary[x] for i, x in enumerate(unknowns)})
    found = []
    for e in equations:
        own = letters(e.residual)
        row = [value.known(derivative(e.residual, x)) if x in own else ZERO for x in unknowns]
        told = [slope for slope in row if slope is not None]
        if len(told) < len(row):
            return None
        found.append(told)
    return found


def _loose(slopes: Sequence[Sequence[Decimal]], unknowns: Sequence[sp.Symbol]) -> frozenset[sp.Symbol]:
    """The unknowns that these equations leave open."""
    if not slopes:
        return frozenset(unknowns)
    solved = solve([[*row, ZERO] for row in slopes], len(unknowns))
    return frozenset(x for j, x in enumerate(unknowns) if not solved.unique(j))
