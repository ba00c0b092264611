"""A constant acceleration that the way needs anyway: v² = v_0² + 2 a s is then shorter than a balance of energies, and
v = v_0 + a t than one of momentum, which would begin anew.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

import sympy as sp

from planar_cli.solve.between.derivation import Derivation, Edge
from planar_cli.solve.regimes.effort import AT_HAND
from planar_cli.solve.regimes.equations import Equation

Known = tuple[sp.Symbol, sp.Expr]
"""A coordinate and its acceleration."""


def at_hand(
    best: Mapping[sp.Symbol, Derivation], edges: Sequence[Edge], targets: Collection[sp.Symbol]
) -> list[Edge] | None:
    """The same edges; what a law says that the derivations of the targets rest on costs no equation of kinetics again.
    None: they rest on no such law.
    """
    laws = _used(best, targets)
    if not laws:
        return None
    return [
        (equations, unknowns, needs, cost + sum(_saved(e) for e in equations if _law(e) in laws))
        for equations, unknowns, needs, cost in edges
    ]


def _used(best: Mapping[sp.Symbol, Derivation], targets: Collection[sp.Symbol]) -> set[Known]:
    """The laws of constant acceleration on which the targets rest."""
    seen: set[sp.Symbol] = set()
    found: set[Known] = set()
    waiting = list(targets)
    while waiting:
        own = best.get(x := waiting.pop())
        if x in seen or own is None:
            continue
        seen.add(x)
        found |= {law for e in own.equations if (law := _law(e)) is not None}
        waiting += own.needs
    return found


def _law(e: Equation) -> Known | None:
    """None also of an acceleration that is zero: no equation of it stands on the page, where energies or momentum tell
    why a velocity stays.
    """
    if e.law is None or not e.law.steady or e.law.f == 0:
        return None
    return e.law.coordinate.symbol, e.law.f if e.law.constant is None else e.law.constant[1]


def _saved(e: Equation) -> float:
    assert e.law is not None
    return min(AT_HAND - e.law.effort, 0.0)
