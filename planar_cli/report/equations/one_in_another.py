"""Equations of a state that are put into one of them: 3/4 x + y = 0 with x = v t and y = u t - g t²/2 gives the time t,
and with it the places.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import by_name, longer, simplified
from planar_cli.equation.values.ledger import Kind
from planar_cli.equation.values.waves import vanishing, wave_put_in
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Math, line
from planar_cli.report.equations.put_into import by_shorter, put_into
from planar_cli.report.equations.results import numbered
from planar_cli.report.equations.since_a_state import Since, since_a_state, told_since
from planar_cli.report.equations.squared import squared
from planar_cli.report.words.origins import used_elsewhere
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, Result, RouteStep

LONGEST = 40
"""Longer equations are not put into each other."""
SAME = Decimal("1e-20")
Formulas = dict[sp.Symbol, tuple[int, sp.Expr]]


@record
class Inserted:
    """How the unknowns of several equations follow one after the other. `put`, `into`: which equations are put into
    which; `residual`: what they give; `divided`: is it divided by its unknown?
    """

    put: tuple[int, ...]
    into: int
    residual: sp.Expr
    divided: bool
    time: Result
    others: tuple[tuple[int, Result], ...]
    """With the equation that gives each."""
    sides: tuple[sp.Expr, sp.Expr] | None = None
    """What they give as it comes from putting them in, where the unknown stands on both sides."""


def one_in_another(
    leg: RouteStep, found: MotionTrace, plain: Mapping[sp.Symbol, sp.Expr]
) -> Inserted | Reduced | Since | None:
    """The time at which several equations hold, from the one into which all others are put; None: they are others."""
    roles = found.ledger.roles
    times = [x for x in leg.unknowns if x in found.general and roles[found.general[x]].kind is Kind.TIME]
    if len(leg.relations) != len(leg.unknowns) or len(leg.unknowns) < 2:
        return None
    if len(times) != 1:
        return _of_angles(leg, found, plain) if not times else None
    (time,) = times
    residuals = [e.residual.xreplace(dict(plain)) for e in leg.relations]
    if any(longer(e, LONGEST) or e.has(sp.Integral) for e in residuals):
        return None
    formulas, left = _explicit(residuals, set(leg.unknowns) & set(found.general) - {time}, time)
    if len(left) == 2 and formulas:
        return _of_two(leg, found, (residuals, formulas, left))
    if len(left) != 1:
        return None
    (into,) = left
    whole = residuals[into]
    for _ in formulas:
        whole = whole.xreplace({x: f for x, (_, f) in formulas.items()})
    solved = _solved(expanded(whole), time, found)
    if solved is None:
        return since_a_state(whole, time, formulas, into, found)
    values = {r.unknown: r.value for r in leg.results}
    asked = used_elsewhere(leg, found)
    rest = by_shorter(_told(formulas, asked, leg), into, residuals[into], set(leg.unknowns))
    put = tuple(sorted(i for _, (i, _) in formulas.items()))
    both = put_into(residuals[into], {x: f for x, (_, f) in formulas.items()}, time)
    return Inserted(put, into, whole, solved[1], Result(time, solved[0], values[time]), rest, both)


def told_inserted(
    found: Inserted | Reduced | Since,
    numbers: Sequence[int],
    phrases: Phrases,
    chain: Callable[[Result], tuple[Any, ...]],
) -> Iterator[Block]:
    """(8), (9) in (7): the equation in the time; the time; and all else by it. `numbers`: of the equations."""
    if isinstance(found, Since):
        yield from told_since(found, numbers, phrases)
        return
    if isinstance(found, Reduced):
        yield from _told_reduced(found, numbers, phrases, chain)
        return
    put = numbered([numbers[i] for i in found.put])
    sides = _sides(found.residual, phrases) if found.sides is None else tuple(map(phrases.math, found.sides))
    yield Equation(sides, None, line(f"{put} in ({numbers[found.into]}):"))
    lead = line("divided by ", Math(found.time.unknown), " ≠ 0:") if found.divided else ()
    yield Equation(chain(found.time), None, lead)
    for i, result in found.others:
        yield Equation(chain(result), None, line(f"({numbers[i]}):"))


def _of_angles(leg: RouteStep, found: MotionTrace, plain: Mapping[sp.Symbol, sp.Expr]) -> Inserted | None:
    """One of two equations in two angles, with the sine or cosine put in that the other gives; what is told is the
    factor that vanishes.
    """
    residuals = [e.residual.xreplace(dict(plain)) for e in leg.relations]
    if len(residuals) != 2 or any(r.formula is None for r in leg.results) or found.symbolic:
        return None
    for put, other in wave_put_in(residuals, found.value):
        inside = [r for r in leg.results if r.unknown in put.free_symbols]
        factor = next(vanishing(put, found.value), None)
        if len(inside) == 1 and factor is not None and inside[0].unknown in factor.free_symbols:
            by = residuals.index(other)
            rest = tuple((by, r) for r in leg.results if r not in inside)
            return Inserted((by,), 1 - by, factor, False, inside[0], rest)
    return None


@record
class Reduced:
    """Two equations that are left of more, in two unknowns."""

    put: tuple[int, ...]
    into: tuple[int, ...]
    residuals: tuple[sp.Expr, ...]
    results: tuple[Result, ...]
    """The unknowns that are left."""
    others: tuple[tuple[int, Result], ...]
    """What is used besides, with the equation that gives each."""
    settled: frozenset[sp.Symbol]
    """Unknowns that rest on no letter without a number."""
    known: Mapping[sp.Symbol, sp.Expr]
    """Formulas of what was found before."""
    cancelled: tuple[sp.Symbol, ...]
    """Letters of the file that stand in what is put in, and no longer in what is left."""


def _of_two(leg: RouteStep, found: MotionTrace, made: tuple[list[sp.Expr], Formulas, list[int]]) -> Reduced | None:
    """Two equations in two unknowns, with everything else put into them."""
    residuals, formulas, left = made
    whole = [residuals[i] for i in left]
    for _ in formulas:
        whole = [e.xreplace({x: f for x, (_, f) in formulas.items()}) for e in whole]
    whole = [expanded(e) for e in whole]
    unknowns = set(leg.unknowns) - formulas.keys()
    if any(longer(e, LONGEST) or not e.free_symbols & unknowns for e in whole):
        return None
    elsewhere = used_elsewhere(leg, found)
    settled = found.route.settled | {r.unknown for r in leg.results if _is_fixed(r, found)}
    asked = {e for r in found.requests for e in r.parts if e.is_Symbol}
    if found.symbolic and (unknowns - settled - asked or elsewhere - unknowns):
        return None
    results = [r for r in leg.results if r.unknown in unknowns]
    inside, kept = (set().union(*(e.free_symbols for e in group)) for group in (residuals, whole))
    gone = tuple(by_name((inside - kept) & {*found.ledger.letters, *found.ledger.values} - set(found.general)))
    known = {s: f for s, f in found.route.formulas.items() if s not in leg.unknowns}
    rest = _told(formulas, elsewhere, leg)
    put = tuple(sorted(i for i, _ in formulas.values()))
    order = sorted(range(2), key=lambda k: left[k])
    return Reduced(put, tuple(sorted(left)), tuple(whole[k] for k in order), tuple(results), rest, settled, known, gone)


def _is_fixed(r: Result, found: MotionTrace) -> bool:
    """Has it the same number whatever the letters of its formula are?"""
    formula = r.formula
    if formula is None or longer(formula, 2 * LONGEST):
        return False
    for _ in found.route.steps:
        formula = formula.xreplace(dict(found.route.formulas))
    own = by_name(formula.free_symbols)
    if any(x in found.general for x in own):
        return False
    tried = [sp.N(formula.xreplace({x: sp.Rational(k + 3 * n, k) for n, x in enumerate(own, 1)})) for k in (7, 5)]
    return all(e.is_real for e in tried) and bool(abs(tried[0] - tried[1]) < 1e-12)


def _told_reduced(
    found: Reduced, numbers: Sequence[int], phrases: Phrases, chain: Callable[[Result], tuple[Any, ...]]
) -> Iterator[Block]:
    """(3) to (8) in (9), (10): two equations, and what they give together."""
    put, into = (numbered([numbers[i] for i in group]) for group in (found.put, found.into))
    for k, residual in enumerate(found.residuals):
        gone = [piece for s in found.cancelled for piece in (", ", Math(s))][1:]
        note = line(*gone, " cancels" if len(found.cancelled) == 1 else " cancel") if gone and k == 0 else ()
        yield Equation(_sides(residual, phrases), None, line(f"{put} in {into}:") if k == 0 else (), note)
    if lines := squared(found.residuals, found.results, found.known, phrases):
        yield from lines
    for k, result in enumerate(found.results if not lines else ()):
        # What has letters gets its closed formula with the answers.
        open_yet = phrases.symbolic and result.unknown not in found.settled
        shown = () if open_yet else (phrases.shown(result.unknown, result.value),)
        sides = (phrases.math(result.unknown), *shown)
        yield Equation(sides, None, line("together:") if k == 0 else ())
    for i, result in found.others:
        yield Equation(chain(result), None, line(f"({numbers[i]}):"))


def _sides(residual: sp.Expr, phrases: Phrases) -> tuple[Math, Math]:
    """An equation without minus signs."""
    terms = sp.Add.make_args(expanded(residual))
    left = sp.Add(*(t for t in terms if not t.could_extract_minus_sign()))
    return phrases.math(left), phrases.math(left - sp.Add(*terms))


def _explicit(residuals: list[sp.Expr], letters: set[sp.Symbol], time: sp.Symbol) -> tuple[Formulas, list[int]]:
    """Letters with the equation that gives each and its formula; the equations that are left. Those in which the time
    stands come first.
    """
    found: Formulas = {}
    left = sorted(range(len(residuals)), key=lambda i: (time not in residuals[i].free_symbols, i))
    while True:
        fresh = next((new for i in left if (new := _one_letter(i, residuals[i], letters, found))), None)
        if fresh is None:
            return found, left
        letter, given = fresh
        found[letter] = given
        left.remove(given[0])


def _one_letter(
    i: int, residual: sp.Expr, letters: set[sp.Symbol], found: Formulas
) -> tuple[sp.Symbol, tuple[int, sp.Expr]] | None:
    """A letter that an equation gives by what is known and by those that were `found`."""
    for x in by_name(residual.free_symbols & (letters - found.keys())):
        slope = sp.diff(residual, x)
        formula = expanded(x - residual / slope) if slope in (1, -1) else x
        if not formula.free_symbols & letters - found.keys():
            return x, (i, formula)
    return None


def _told(formulas: Formulas, asked: set[sp.Symbol], leg: RouteStep) -> tuple[tuple[int, Result], ...]:
    """The letters that are asked, by letters that have lines."""
    values = {r.unknown: r.value for r in leg.results}
    silent = {x: f for x, (_, f) in formulas.items() if x not in asked}
    found = []
    for x, (i, formula) in sorted(formulas.items(), key=lambda item: item[1][0]):
        put = formula
        for _ in silent:
            put = put.xreplace(silent)
        if x in asked:
            found.append((i, Result(x, put, values[x])))
    return tuple(found)


def _solved(whole: sp.Expr, time: sp.Symbol, found: MotionTrace) -> tuple[sp.Expr, bool] | None:
    """The time as a formula, and whether the equation was divided by it; None: it is no such polynomial."""
    if not whole.is_polynomial(time):
        return None
    powers = sp.Poly(whole, time).all_coeffs()[::-1]
    divided = len(powers) > 2 and powers[0] == 0
    powers = powers[1:] if divided else powers
    if len(powers) == 2:
        roots = [-powers[0] / powers[1]]
    elif len(powers) == 3 and powers[1] == 0:
        roots = [sp.sqrt(simplified(-powers[0] / powers[2]))]
    else:
        return None
    value = found.value
    own = value.known(time)
    for root in roots:
        there = value.known(root)
        if own is not None and there is not None and abs(there - own) <= SAME * abs(own):
            return simplified(root), divided
    return None
