"""Two equations in two angles, where one of them is the angle between two bodies: in a dead position of a linkage a
crank stands at right angles to an arm, or in line with a rod.

    cos(θ - φ) / (h sin θ + r cos(θ - φ)) = 0:  cos(θ - φ) = 0        tan φ cos θ - sin θ = 0:  sin(θ - φ) = 0
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import letters, longer, simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.waves import LONGEST, WAVES, one_wave, right_angle, vanishing, wave_put_in, wave_values
from planar_cli.solve.between.trace.trace import Result
from planar_cli.solve.regimes.equations import Equation

CONDITIONS = ("given", "extreme")
"""What is said of a state."""


def by_the_angle_between(equation: Equation, unknowns: frozenset[sp.Symbol], value: Valuation) -> Equation:
    """A condition on two angles that only holds for their sum or difference, as the sine or cosine of that."""
    residual = equation.residual
    if equation.kind not in CONDITIONS or not residual.has(*WAVES) or longer(residual, LONGEST):
        return equation
    inside = set().union(*(f.free_symbols for f in residual.atoms(*WAVES))) & unknowns
    if len(inside) != 2 or letters(residual) & unknowns != inside:
        return equation
    for factor in vanishing(residual, value):
        wave = one_wave(factor)
        if wave is not None and wave.args[0].free_symbols == inside:
            return replace(equation, residual=wave)
    return equation


def by_angles(
    pool: Sequence[sp.Expr], left: Sequence[sp.Symbol], value: Valuation, single: Callable[[sp.Expr, sp.Symbol], Result]
) -> list[Result]:
    """Two angles from two equations, of which one fixes the angle between them, or gives a sine or cosine that goes
    into the other; empty: they do not. `single`: what gives an unknown from one equation.
    """
    if not len(pool) == len(left) == 2:
        return []
    for first, second in (pool, pool[::-1]):
        known = wave_values(first, value)
        # What holds one angle beside their difference comes first: of r sin(θ - φ) = h cos θ that is r = h cos θ.
        for x in sorted(left, key=lambda s: s not in letters(second.xreplace(known)), reverse=True):
            formula = right_angle(first, x, value)
            if formula is not None:
                (y,) = (s for s in left if s != x)
                found = single(simplified(second.xreplace(known).xreplace({x: formula})), y)
                if found.formula is not None:
                    return [found, Result(x, formula, value(x))]
    for put, other in wave_put_in(pool, value):
        inside = [s for s in left if s in put.free_symbols]
        if len(inside) == 1:
            (x,) = (s for s in left if s not in inside)
            found = single(put, inside[0])
            if found.formula is not None:
                return [found, single(other, x)]
    return []
