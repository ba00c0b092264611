"""What the energies of a balance are made of, in letters of its states: speeds, heights and stretches with names.

T = m v_G²/2 + I ω²/2        U = m g (y_1 - y_2)        U = k (s_1² - s_2²)/2
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from planar_cli.equation.exact import Valuation
from planar_cli.principles.base import EnergyParts, Moving, Storage, Stored
from planar_cli.solve.between.balances import StateBalance
from planar_cli.solve.regimes.regime_sequence import RegimeSequence


def energy_parts(course: RegimeSequence, b: StateBalance, value: Valuation) -> EnergyParts | None:
    """The parts of a balance of energies; None: of another amount. `value`: numbers of everything."""
    if not b.law.moving:
        return None
    names = [s.name for s in course.states]
    regime = course.regimes[names.index(b.stop.name) - 1]

    def closed(expr: sp.Expr) -> sp.Expr:
        return regime.closed(sp.sympify(expr))

    moving = tuple(_at(m, lambda e: b.stop.at(closed(e))) for m in b.law.moving)
    stored = {s.words: s.stored for s in b.law.sources if s.stored is not None}
    found = []
    for words, brought in b.brought:
        if words in stored:
            found += _storage(words, brought, stored[words], closed, b, value)
    return EnergyParts(moving, tuple(found))


def _at(m: Moving, place: Callable[[sp.Expr], sp.Expr]) -> Moving:
    return Moving(m.body, place(m.mass), place(m.inertia), place(m.vx), place(m.vy), place(m.omega), m.center)


def _storage(
    words: str, brought: sp.Expr, s: Stored, closed: Callable[[sp.Expr], sp.Expr], b: StateBalance, value: Valuation
) -> list[Storage]:
    """Where it gives what was brought: a spring that was free at the beginning counts from its end alone."""
    measure, factor = closed(s.measure), closed(s.factor)
    last = b.stop.at(measure)
    for first in (b.since.at(measure), sp.S.Zero):
        found = Storage(words, factor, first, last, s.power, s.letter)
        letters = found.brought.free_symbols - brought.free_symbols
        if all(value.known(x) is not None for x in letters) and value.is_zero(brought - found.brought):
            return [found]
    return []
