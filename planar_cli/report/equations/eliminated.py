"""Equations that give several unknowns together: one of them with the others put in, so that one unknown is left.

(1)  v_B,2 - v_A,2 = e (v_A,1 - v_B,1)
(2)  m_A v_A,1 + m_B v_B,1 = m_A v_A,2 + m_B v_B,2
(1) in (2):  m_A v_A,1 + m_B v_B,1 = m_A (v_B,2 - e (v_A,1 - v_B,1)) + m_B v_B,2
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import permutations

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.records import record
from planar_cli.report.document.blocks import Equation, Line, line
from planar_cli.report.equations.results import numbered
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.notation import plain
from planar_cli.report.notation.reciprocals import with_reciprocals
from planar_cli.report.words.counted import counts_the_other_way, opposite
from planar_cli.report.words.origins import sides_of
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import BalanceTrace, ImpactEquation, Relation, Result, RouteStep, RouteTrace

MOST, LONGEST, WIDE, FAR = 3, 40, 96, 12
"""More equations are not put into each other so, nor longer ones; characters of the line that results; what it counts
in operations that a balance is put into another equation.
"""
ANGLES = (sp.asin, sp.acos, sp.atan)
"""An angle is told by its sine or cosine."""
Sides = tuple[sp.Expr, sp.Expr]


@record
class Put:
    """Which equations are put into which, and its sides then."""

    used: tuple[int, ...]
    into: int
    sides: Sides
    divided: int
    """How many of those were divided by more than a number."""


def lead_of(numbers: Sequence[int], put: Sequence[Equation]) -> Line:
    """What stands before a result: the equations from which it follows, or that it follows from the line before."""
    return line("hence:") if put else line(numbered(numbers) + (" together:" if len(numbers) > 1 else ":"))


def with_others_put_in(
    leg: RouteStep, route: RouteTrace, numbers: Sequence[int], phrases: Phrases, told: Callable[[Result], bool]
) -> tuple[Equation, ...]:
    """The line from which the first result of a step follows; empty where it is no such step, where only numbers give
    the result, or where the line is long. `told`: has a result a formula on the page?
    """
    count, result = len(leg.relations), leg.results[0]
    if not 1 < count <= MOST or len(leg.unknowns) != count or len(numbers) != count:
        return ()
    if not told(result) and not (result.formula is not None and result.formula.has(*ANGLES)):
        return ()
    written = [sides_of(e, route) for e in leg.relations]
    if any(longer(left - right, LONGEST) or (left - right).has(sp.Integral) for left, right in written):
        return ()
    first = result.unknown
    others = [x for x in leg.unknowns if x != first]
    ranks = [_rank(e) for e in leg.relations]
    found = min(_ways(written, first, others), key=lambda p: _effort(p, ranks), default=None)
    if found is None or any(longer(side, LONGEST) for side in found.sides):
        return ()
    sides = tuple(map(opposite, found.sides)) if _is_turned(leg.relations[found.into], route) else found.sides
    left, right = (phrases.math(with_reciprocals(side)) for side in sides)
    known = phrases.value.vanishes(found.sides[0] - found.sides[1])
    if not known or len(plain(left.expr) + plain(right.expr)) > WIDE or not is_clean(phrases.ledger, *found.sides):
        return ()
    put = numbered([numbers[i] for i in found.used])
    return (Equation((left, right), None, line(f"{put} in ({numbers[found.into]}):")),)


def _is_turned(e: Relation, route: RouteTrace) -> bool:
    """Is it an angular momentum that the page counts the other way round?"""
    moment = isinstance(e.source, ImpactEquation) and e.source.law == "moment"
    return moment and counts_the_other_way(*sides_of(e, route))


def _rank(e: Relation) -> int:
    """Balances are what others are put into: of energies first, of momenta, then conditions of forces or motions."""
    if isinstance(e.source, BalanceTrace):
        return 0 if e.source.law.letter else 1
    return 1 if isinstance(e.source, ImpactEquation) and e.source.law != "relation" else 2


def _effort(put: Put, ranks: Sequence[int]) -> int:
    return sum(map(operations, put.sides)) + 4 * put.divided + FAR * (ranks[put.into] - min(ranks))


def _ways(written: Sequence[Sides], first: sp.Symbol, others: Sequence[sp.Symbol]) -> Iterator[Put]:
    """Each order in which the other unknowns can be told by an equation of their own."""
    for into in range(len(written)):
        rest = [i for i in range(len(written)) if i != into]
        for order in permutations(rest):
            if (put := _put_in(written, first, list(zip(others, order, strict=True)), into)) is not None:
                yield put


def _put_in(
    written: Sequence[Sides], first: sp.Symbol, order: Sequence[tuple[sp.Symbol, int]], into: int
) -> Put | None:
    """`order`: which unknown each of the other equations tells."""
    formulas: dict[sp.Expr, sp.Expr] = {}
    divided = 0
    for unknown, i in order:
        residual = sp.sympify(written[i][0] - written[i][1])
        told = _told_by(residual, unknown)
        if told is None:
            return None
        formulas[told[0]] = told[1]
        divided += bool(sp.diff(residual, unknown).free_symbols - {unknown})
    left, right = written[into]
    for _ in order:
        left, right = left.xreplace(formulas), right.xreplace(formulas)
    unknowns = {u for u, _ in order}
    inside = left.free_symbols | right.free_symbols
    if inside & unknowns or first not in inside or left == right:
        return None
    return Put(tuple(sorted(i for _, i in order)), into, (left, right), divided)


def _told_by(residual: sp.Expr, unknown: sp.Symbol) -> tuple[sp.Expr, sp.Expr] | None:
    """The unknown, or its square, and what an equation says it is; None: it is more than these in it."""
    once = sp.diff(residual, unknown)
    if once == 0:
        return None
    if unknown not in once.free_symbols:
        return unknown, simplified(-residual.xreplace({unknown: sp.S.Zero}) / once)
    twice = sp.diff(once, unknown)
    if unknown in twice.free_symbols or simplified(once - twice * unknown) != 0:
        return None
    return unknown**2, simplified(-2 * residual.xreplace({unknown: sp.S.Zero}) / twice)
