"""Larger blocks of a motion's equations: unknowns that enter linearly are expressed one after the other, until one or
two equations are left in as many unknowns. So two paths that meet give the time and the direction of an interception.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Sequence

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded, wide
from planar_cli.equation.algebra.form import Nonlinear, linear_form
from planar_cli.equation.algebra.plain import letters, longer, tidy
from planar_cli.records import record
from planar_cli.solve.between.roots.substitution import STATE
from planar_cli.solve.regimes.equations import Equation

SQUARES = ("energy", "v(q)")
KERNEL = 2
"""So many equations in as many unknowns may be left when all else is expressed."""
LONG, ENDLESS = 120, 480
"""Nothing is expressed by an equation of more operations than the first; one of more than the second, or of very many
terms, is not multiplied out either.
"""
Block = tuple[tuple[Equation, ...], tuple[sp.Symbol, ...]]


@record
class Reduced:
    """One equation with others put in: its residual, and which equations it rests on."""

    residual: sp.Expr
    members: frozenset[int]


def linked_blocks(
    equations: Sequence[Equation], unknowns: frozenset[sp.Symbol], times: Sequence[sp.Symbol]
) -> Iterator[Block]:
    """Blocks that are left when unknowns are expressed by others, the smallest first. Equations in the squares of
    speeds come last: with the laws in time the letters go one after the other.
    """
    equations = sorted(equations, key=lambda e: (e.kind in SQUARES, e.cost))
    residuals = [e.residual if _endless(e.residual) else expanded(e.residual) for e in equations]
    pool = [Reduced(r, frozenset([i])) for i, r in enumerate(residuals)]
    left = set(unknowns)
    seen: set[tuple[int, ...]] = set()
    while True:
        for block in _kernels(pool, left, equations, unknowns):
            key = tuple(id(e) for e in block[0])
            if key not in seen:
                seen.add(key)
                yield block
        found = _next(pool, left, times) or _dated(pool, left, times)
        if found is None:
            return
        index, x, formula = found
        taken = pool.pop(index)
        left.discard(x)
        pool = [_put(p, x, formula, taken) for p in pool]
        pool = [p for p in pool if p.residual != 0 and independent(equations[i] for i in p.members)]


def _endless(residual: sp.Expr) -> bool:
    """Is it too long to be multiplied out?"""
    return longer(residual, ENDLESS) or wide(residual)


def _put(p: Reduced, x: sp.Symbol, formula: sp.Expr, by: Reduced) -> Reduced:
    if x not in letters(p.residual):
        return p
    put = p.residual.xreplace({x: formula})
    return Reduced(put if _endless(put) else tidy(expanded(put)), p.members | by.members)


def _next(
    pool: Sequence[Reduced], left: set[sp.Symbol], times: Sequence[sp.Symbol]
) -> tuple[int, sp.Symbol, sp.Expr] | None:
    """The equation with the fewest unknowns that gives one of them linearly; no time."""
    best: tuple[int, int, sp.Symbol, sp.Expr] | None = None
    for i, p in enumerate(pool):
        inside = letters(p.residual) & left
        if longer(p.residual, LONG) or (best is not None and len(inside) >= best[0]):
            continue
        # A constant that is sought is kept: all letters of the states rest on it.
        for x in sorted(inside, key=lambda s: (STATE not in s.name, s.name)):
            if x in times:
                continue
            try:
                form = linear_form(p.residual, {x})
            except Nonlinear:
                continue
            factor = form.terms.get(x, sp.S.Zero)
            if factor != 0 and not letters(factor) & left:
                best = (len(inside), i, x, tidy(-form.constant / factor))
                break
    return None if best is None else best[1:]


def _dated(
    pool: Sequence[Reduced], left: set[sp.Symbol], times: Sequence[sp.Symbol]
) -> tuple[int, sp.Symbol, sp.Expr] | None:
    """A time that is another one, as of a blow, or that one speed alone tells: d = v cos α t. Nothing that multiplies
    it can vanish, as the rest of the equation does not.
    """
    for i, p in enumerate(pool):
        if longer(p.residual, LONG):
            continue
        for x in (t for t in times if t in left and t in p.residual.free_symbols):
            try:
                form = linear_form(p.residual, {x})
            except Nonlinear:
                continue
            factor = form.terms.get(x, sp.S.Zero)
            if factor != 0 and _is_no_zero(factor, form.constant, left, times):
                return i, x, tidy(-form.constant / factor)
    return None


def _is_no_zero(factor: sp.Expr, constant: sp.Expr, left: set[sp.Symbol], times: Sequence[sp.Symbol]) -> bool:
    """Is what multiplies a time known, or a product without which something would be left?"""
    inside = letters(factor) & left
    if not inside:
        return letters(constant) & left <= set(times)
    rests = [constant.xreplace({s: sp.S.Zero}) for s in inside]
    return not factor.is_Add and all(r != 0 and not letters(r) & left for r in rests)


def _kernels(
    pool: Sequence[Reduced], left: set[sp.Symbol], equations: Sequence[Equation], unknowns: frozenset[sp.Symbol]
) -> Iterator[Block]:
    """Up to two of the equations that are left, in as many unknowns."""
    open_in = [letters(p.residual) & left for p in pool]
    for size in range(1, KERNEL + 1):
        small = [i for i, u in enumerate(open_in) if 0 < len(u) <= size]
        for group in itertools.combinations(small, size):
            inside = frozenset().union(*(open_in[i] for i in group))
            members = frozenset().union(*(pool[i].members for i in group))
            if len(inside) != size or not independent(equations[i] for i in members):
                continue
            block = tuple(equations[i] for i in sorted(members))
            every = frozenset().union(*(letters(e.residual) for e in block)) & unknowns
            if len(every) == len(block):
                yield block, tuple(sorted(every, key=lambda s: s.name))


def independent(equations: Iterable[Equation]) -> bool:
    """No family gives more equations than are independent."""
    count: dict[tuple[str, ...], int] = {}
    for e in equations:
        if e.family:
            count[e.family] = count.get(e.family, 0) + 1
            if count[e.family] > e.rank:
                return False
    return True
