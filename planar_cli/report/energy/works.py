"""The work of a force that changes on its way, as the integral that it is before its formula:

U of the drag rubbing = ∫[0 → x_P,1] (-m g (μ_0 + q x_P)) dx_P = -m g x_P,1 (μ_0 + 1/2 q x_P,1)
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from planar_cli.equation.algebra.plain import by_name, longer, simplified
from planar_cli.report.document.blocks import Math
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import BalanceTrace
from planar_cli.units import LENGTH, PURE

LONGEST = 20
"""A force of more operations is not written out."""
STATE = "__"


def work_integral(
    b: BalanceTrace, words: str, plain: Mapping[sp.Symbol, sp.Expr], phrases: Phrases
) -> tuple[Math, ...]:
    """Force or couple over its way; empty where it does not change, or the work is no function of one coordinate, so
    that nothing is integrated. `plain`: letters of states that are data, with what they are.
    """
    work = next((e for own, e in b.brought if own == words), sp.S.Zero)
    ends = [s for s in by_name(work.free_symbols) if s.name.endswith(f"{STATE}{b.stop}") and _is_way(s, phrases)]
    if len(ends) != 1 or work.has(sp.Integral) or longer(work, 2 * LONGEST):
        return ()
    (last,) = ends
    name = last.name.removesuffix(f"{STATE}{b.stop}")
    running = sp.Symbol(name, real=True)
    force = simplified(sp.diff(work, last).xreplace({last: running}))
    own = {s.name: s for s in (*(s for s in plain if s.is_Symbol), *work.free_symbols)}.get(f"{name}{STATE}{b.since}")
    start = sp.S.Zero if own is None else sp.sympify(plain.get(own, own))
    begun = work.xreplace({last: start}).xreplace(dict(plain))
    if running not in force.free_symbols or longer(force, LONGEST) or not phrases.value.vanishes(begun):
        return ()
    return (phrases.math(sp.Integral(force.xreplace(dict(plain)), (running, start, last.xreplace(dict(plain))))),)


def _is_way(symbol: sp.Symbol, phrases: Phrases) -> bool:
    """Is it a length or an angle?"""
    unit = phrases.ledger.units.get(symbol)
    return unit is not None and unit.dimension in (LENGTH, PURE)
