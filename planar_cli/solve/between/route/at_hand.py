"""A constant acceleration that the way needs anyway: v² = v_0² + 2 a s is then shorter than a balance of energies, and
v = v_0 + a t than one of momentum, which would begin anew. So too a simple harmonic motion: once its place and velocity
over time are written for one question, they tell what it reaches a quarter or half a period later.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.solve.between.roots.quarters import is_harmonic, quarters
from planar_cli.solve.between.trace.derivation import Derivation, Edge, each_once
from planar_cli.solve.regimes.costs import HIDDEN
from planar_cli.solve.regimes.effort import AT_HAND
from planar_cli.solve.regimes.equations import Equation

WRITTEN = 0.7
"""What the place or the velocity of a simple harmonic motion costs less, once both are written as functions of time."""

Known = tuple[sp.Symbol, sp.Expr]
"""A coordinate and its acceleration."""


def at_hand(
    best: Mapping[sp.Symbol, Derivation],
    edges: Sequence[Edge],
    targets: Collection[sp.Symbol],
    plain: Mapping[sp.Symbol, sp.Expr],
    value: Valuation,
    kinetics: Collection[str] = (),
) -> list[Edge] | None:
    """The same edges; what a law says that the derivations of the targets rest on costs no equation of kinetics again.
    So too a law up to one of the states `kinetics`, before which finds need an acceleration. None: they rest on no
    such law. `plain`: data that are put in at once; `value`: numbers of everything.
    """
    laws = _used(best, targets) | _asked(edges, kinetics)
    if not laws:
        return None
    found: list[Edge] = []
    for equations, unknowns, needs, cost in edges:
        own = [e for e in equations if _law(e) in laws]
        saved = sum(_saved(e, unknowns, e.residual.xreplace(dict(plain)), value) for e in own)
        found.append((equations, unknowns, needs, cost - saved))
    return found


def _used(best: Mapping[sp.Symbol, Derivation], targets: Collection[sp.Symbol]) -> set[Known]:
    """The laws of constant acceleration on which the targets rest. One that is zero is at hand where a place over time
    rests on it, of what is accelerated along another axis or at another time, as in a throw; else no equation of it
    stands on the page, where energies or momentum tell why a velocity stays.
    """
    found: dict[Known, tuple[str, bool]] = {}
    # What two equations tell together needs no law of its own.
    kept = {x: d for d in each_once(_on_the_way(best, targets)) for x in d.unknowns}
    for e in (e for d in _on_the_way(kept, targets) for e in d.equations):
        if (law := _law(e)) is not None and e.law is not None:
            told = found.get(law, ("", False))[1]
            found[law] = (e.law.coordinate.words.partition(" of ")[2], told or e.kind == "q(t)")
    thrown = {thing for law, (thing, _) in found.items() if law[1] != 0 and thing}
    return {law for law, (thing, told) in found.items() if law[1] != 0 or (told and thing in thrown)}


def _on_the_way(best: Mapping[sp.Symbol, Derivation], targets: Collection[sp.Symbol]) -> list[Derivation]:
    """The derivations of the targets and of all that they need."""
    found: list[Derivation] = []
    waiting = list(targets)
    while waiting:
        own = best.get(waiting.pop())
        if own is not None and own not in found:
            found.append(own)
            waiting += own.needs
    return found


def _asked(edges: Sequence[Edge], kinetics: Collection[str]) -> set[Known]:
    """The laws of constant acceleration up to these states."""
    found = {_law(e) for equations, _, _, _ in edges for e in equations if e.stop in kinetics and _steady(e)}
    return {law for law in found if law is not None and law[1] != 0}


def _steady(e: Equation) -> bool:
    return e.law is not None and e.law.steady and e.law.order == 2


def _law(e: Equation) -> Known | None:
    """None of a law without a constant acceleration."""
    if e.law is None or not (e.law.steady or is_harmonic(e)):
        return None
    return e.law.coordinate.symbol, e.law.f if e.law.constant is None else e.law.constant[1]


def _saved(e: Equation, unknowns: Sequence[sp.Symbol], residual: sp.Expr, value: Valuation) -> float:
    """What an equation of a law that is at hand costs less."""
    assert e.law is not None
    if not is_harmonic(e):
        return max(e.law.effort - AT_HAND, 0.0)
    if (found := quarters(residual, value)) is None:
        return 0.0
    return e.law.effort + WRITTEN + (HIDDEN if found[0].free_symbols & set(unknowns) else 0.0)
