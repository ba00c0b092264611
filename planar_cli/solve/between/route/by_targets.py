"""A time by the velocity at the same state that is asked, or told before: t = (v_0 - v)/g, not the root of a quadratic
equation, and t = ∫ dv/a, not the place over time solved for t. A place at a time by which another place is told anyway,
as of a throw x = v_x t: y = v_y t - 1/2 g t², not v² = v_0² - 2 g y.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

import sympy as sp

from planar_cli.equation.algebra.plain import derivative
from planar_cli.solve.between.roots.substitution import TIME
from planar_cli.solve.between.trace.derivation import Derivation, Edge

Best = Mapping[sp.Symbol, Derivation]


def by_targets(
    best: Best, edges: Sequence[Edge], targets: Collection[sp.Symbol], plain: Mapping[sp.Symbol, sp.Expr]
) -> dict[sp.Symbol, Derivation]:
    """The derivations, where a target that is a root of a place over time follows from a velocity that is a target.
    `plain`: data that need no line.
    """
    found = dict(best)
    for x in targets:
        own = found.get(x)
        if own is None or len(own.equations) != 1 or own.equations[0].kind != "q(t)" or _is_plain(own, x):
            continue
        for equations, unknowns, needs, cost in edges:
            (e, *more) = equations
            if more or e.kind not in ("v(t)", "t(v)") or tuple(unknowns) != (x,) or not needs & set(targets):
                continue
            if e.residual.is_polynomial(x) and all(n in found for n in needs) and not _rests(needs, x, found):
                found[x] = Derivation(equations, unknowns, needs, cost)
                break
    return _by_the_clock(_by_told_velocities(found, edges, targets, plain), edges, targets)


def _by_told_velocities(
    found: dict[sp.Symbol, Derivation],
    edges: Sequence[Edge],
    targets: Collection[sp.Symbol],
    plain: Mapping[sp.Symbol, sp.Expr],
) -> dict[sp.Symbol, Derivation]:
    """The derivations, where a time on the way to a target that is a root of a full quadratic equation follows from a
    velocity on which something else rests, as the next bounce. √(2 h/g) after a start from rest is as plain.
    """
    dated = [x for x, own in found.items() if len(own.equations) == 1 and own.equations[0].kind == "q(t)"]
    roots = [x for x in dated if not _is_plain(found[x], x) and _has_linear_term(x, found[x], plain)]
    told = _on_the_way(targets, found) if roots else set()
    used = set[sp.Symbol]().union(*(found[s].needs for s in told if s in found))
    for x in roots:
        for equations, unknowns, needs, cost in edges if x in told else ():
            (e, *more) = equations
            if more or e.kind != "v(t)" or tuple(unknowns) != (x,) or not needs <= used - {x}:
                continue
            if e.law is not None and e.law.steady and not _rests(needs, x, found):
                found[x] = Derivation(equations, unknowns, needs, cost)
                break
    return found


def _has_linear_term(x: sp.Symbol, own: Derivation, plain: Mapping[sp.Symbol, sp.Expr]) -> bool:
    """Is a place over time more than a square of the time x since the state from which it counts: is it no rest?"""
    e = own.equations[0]
    start = next((s for s in e.residual.free_symbols if s.name == f"{TIME}{e.since}"), sp.S.Zero)
    return bool(sp.expand(derivative(e.residual, x).xreplace({x: start}).xreplace(dict(plain))) != 0)


def _on_the_way(targets: Collection[sp.Symbol], found: Best) -> set[sp.Symbol]:
    """The targets with all from which they follow."""
    seen, waiting = set[sp.Symbol](), list(targets)
    while waiting:
        s = waiting.pop()
        if s not in seen:
            seen.add(s)
            waiting += [*found[s].needs, *found[s].unknowns] if s in found else []
    return seen


def _by_the_clock(
    found: dict[sp.Symbol, Derivation], edges: Sequence[Edge], targets: Collection[sp.Symbol]
) -> dict[sp.Symbol, Derivation]:
    """The derivations, where the place of a target that follows from squares of velocities has a time at hand."""
    dated = {n for x in targets if x in found and found[x].equations[0].kind == "q(t)" for n in found[x].needs}
    for x in targets:
        own = found.get(x)
        if own is None or len(own.equations) != 1 or own.equations[0].kind != "v(q)":
            continue
        for equations, unknowns, needs, cost in edges:
            (e, *more) = equations
            times = (needs - own.needs) & dated & set(targets)
            if more or e.kind != "q(t)" or tuple(unknowns) != (x,) or not times or e.law is None or not e.law.steady:
                continue
            if all(n in found for n in needs) and not _rests(needs, x, found) and derivative(e.residual, x).is_number:
                found[x] = Derivation(equations, unknowns, needs, cost)
                break
    return found


def _is_plain(own: Derivation, x: sp.Symbol) -> bool:
    """Does x follow as it stands, or not by a formula at all?"""
    residual = own.equations[0].residual
    if residual.has(sp.Integral):
        return True
    return bool(residual.is_polynomial(x)) and sp.degree(residual, x) != 2


def _rests(needs: Collection[sp.Symbol], x: sp.Symbol, found: Best) -> bool:
    """Does anything that is needed rest on x?"""
    seen: set[sp.Symbol] = set()
    waiting = list(needs)
    while waiting:
        s = waiting.pop()
        if s == x:
            return True
        if s not in seen and s in found:
            seen.add(s)
            waiting += [*found[s].needs, *(u for u in found[s].unknowns if u != s)]
    return False
