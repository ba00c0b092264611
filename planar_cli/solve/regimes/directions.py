"""Which way things go where a stretch begins: signs of speeds that a resistance asks for, and what ceases at once."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import by_name, parts_of
from planar_cli.equation.values.scales import SLACK, Here
from planar_cli.solve.regimes.regime import Regime


def ways_at(regime: Regime, here: Here) -> dict[str, int]:
    """Signs of speeds that a law asks for, where they are not those of the regime; a speed that is zero takes that of
    its rate.
    """
    found = {}
    for u in by_name({*turning_speeds(regime), *regime.going()}):
        rests = abs(here.letters[u]) <= SLACK * here.sizes[u]
        way = here.at(regime.accelerations[u], {u: 0.0}) if rests else here.letters[u]
        sign = 1 if way >= 0 else -1
        if regime.ways.get(u.name) != sign:
            found[u.name] = sign
    return found | _other_sides(regime, here)


def _other_sides(regime: Regime, here: Here) -> dict[str, int]:
    """Places that are, or come at once, on the other side of that from which their distance is measured."""
    found = {}
    for key, (way, expr) in regime.sided.items():
        if not expr.free_symbols & set(regime.letters):
            continue
        side = here.sign(expr)
        if side < 0 or (side == 0 and becomes_negative(regime, expr, here)):
            found[key] = -way
    return found


def becomes_negative(regime: Regime, expr: sp.Expr, here: Here) -> bool:
    """Does a formula that is zero become negative at once?"""
    for _ in range(2):
        expr = regime.derivative(expr)
        sign = here.sign(expr)
        if sign:
            return sign < 0
    return False


def turning_speeds(regime: Regime) -> list[sp.Symbol]:
    """Free speeds whose size or sign stands in a law: the law reads otherwise when they turn round."""
    sided = [a for a in parts_of(regime.accelerations.values()) if isinstance(a, sp.Abs | sp.sign)]
    return [u for u in regime.free if any(u in a.free_symbols for a in sided)]
