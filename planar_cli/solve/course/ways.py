"""Which way things go where a stretch begins: signs of speeds that a resistance asks for, and what ceases at once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from planar_cli.equation.exact import Valuation
from planar_cli.solve.course.regime import Regime, number_function

SLACK = 1e-9
AT_REST = 1e-9
"""A speed that counts as zero, in m/s or rad/s."""


def ways_at(regime: Regime, state: Mapping[sp.Symbol, float], value: Valuation) -> dict[str, int]:
    """Signs of speeds that a law asks for, where they are not those of the regime; a speed that is zero takes that of
    its rate.
    """
    found = {}
    for u in {*turning_speeds(regime), *regime.going()}:
        here = {**state, u: 0.0} if abs(state[u]) <= AT_REST else state
        numbers = [here[s] for s in regime.letters]
        way = here[u] or number_function([regime.accelerations[u]], regime.letters, value)(*numbers)[0]
        sign = 1 if way >= 0 else -1
        if regime.ways.get(u.name) != sign:
            found[u.name] = sign
    return found | _other_sides(regime, state, value)


def _other_sides(regime: Regime, state: Mapping[sp.Symbol, float], value: Valuation) -> dict[str, int]:
    """Places that are, or come at once, on the other side of that from which their distance is measured."""
    found = {}
    here = [state[s] for s in regime.letters]
    for key, (way, expr) in regime.sided.items():
        if not expr.free_symbols & set(regime.letters):
            continue
        number = number_function([expr], regime.letters, value)(*here)[0]
        if number < -SLACK or (abs(number) <= SLACK and becomes_negative(regime, expr, here, value)):
            found[key] = -way
    return found


def becomes_negative(regime: Regime, expr: sp.Expr, here: Sequence[float], value: Valuation) -> bool:
    """Does a formula that is zero become negative at once? `here`: the letters of the regime in numbers."""
    for _ in range(2):
        expr = regime.derivative(expr)
        rate = number_function([expr], regime.letters, value)(*here)[0]
        if abs(rate) > SLACK:
            return rate < 0
    return False


def turning_speeds(regime: Regime) -> list[sp.Symbol]:
    """Free speeds whose size or sign stands in a law: the law reads otherwise when they turn round."""
    found = []
    for u in regime.free:
        atoms = [a for f in regime.accelerations.values() for a in f.atoms(sp.Abs, sp.sign)]
        if any(u in a.free_symbols for a in atoms):
            found.append(u)
    return found
