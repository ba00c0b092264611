"""`X is largest` in a state whose time is fixed by something else: the freedom is a constant that is sought."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.common_factors import together
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.algebra.product_to_sum import as_sums
from planar_cli.errors import Undecided
from planar_cli.records import record
from planar_cli.solve.diagnosis.limits_of_modes import unbounded
from planar_cli.solve.instant.stationary_point import eliminated, proper, unchanged
from planar_cli.solve.regimes.costs import COSTS
from planar_cli.solve.regimes.equations import Equation

PLAIN = ("given", "drawn", "start", "turn", "motion", "link", "loop", "handed", "blow", "q(t)", "v(t)")


@record
class Aim:
    """What is largest or smallest, as a function of the constant that is sought."""

    quantity: sp.Expr
    """A letter of a state, or its square, or what has such a one."""
    formula: sp.Expr
    """It as a formula of constants."""
    law: Equation | None
    """The balance from which that follows; None: it follows from equations that hold a time."""
    timed: tuple[sp.Expr, ...] = ()
    """Those equations, by their residuals."""


def stationary(
    equations: Sequence[Equation],
    objective: sp.Expr,
    unknowns: frozenset[sp.Symbol],
    kept: frozenset[sp.Symbol],
    like: Equation,
    sought: frozenset[sp.Symbol],
) -> list[Equation]:
    """The equations left when all linear unknowns but `kept` (times and sought constants) are eliminated, and the
    condition that the objective is stationary; each as an equation of the motion. `sought`: constants of the file.
    """
    plain = [e.residual for e in equations if e.kind in PLAIN]
    try:
        related, aim, letters, condition = eliminated(plain, objective, unknowns, kept, sought)
    except Undecided:
        if by_balance := _by_a_balance(equations, objective, unknowns, kept, like, sought):
            return by_balance
        raise
    if not related and aim in (letters[0], letters[0] ** 2):
        if "__" in letters[0].name:
            return _by_a_balance(equations, objective, unknowns, kept, like, sought)
        raise unbounded(like.words, like.mark, bool(like.stop))
    if reduced := _without_time(related, aim, letters, objective, like, sought):
        return reduced
    found = [Equation(p, "link", "what is left when the others are put in", like.stop) for p in related]
    struck = not related and letters[0] in sought and any(e.kind == "blow" for e in equations)
    source = Aim(objective, aim, None) if struck else None
    return [*found, _condition(condition, [x for x in letters if x in kept], objective, like, source)]


def _without_time(
    related: Sequence[sp.Expr],
    aim: sp.Expr,
    letters: Sequence[sp.Symbol],
    objective: sp.Expr,
    like: Equation,
    sought: frozenset[sp.Symbol],
) -> list[Equation]:
    """The condition in one constant, where the time at which something happens can be eliminated: of a throw
    v_0² = g x²/(2 cos² β (x tan β - y)), of which the derivative for β is zero. Empty: it is not so.
    """
    times, free = [x for x in letters if x not in sought], [x for x in letters if x in sought and x != aim]
    if len(times) != 1 or len(free) != 1:
        return []
    told, links = _of_one(list(related), aim, times[0], free[0], objective) or (None, [])
    if told is None or not told[1].free_symbols & {free[0]} or told[1].free_symbols & {aim, times[0]}:
        return []
    above, below = sp.fraction(simplified(told[1]))
    if free[0] not in above.free_symbols or free[0] not in below.free_symbols:
        rate = simplified(sp.diff(as_sums(below if free[0] in below.free_symbols else above), free[0]))
    else:
        rate = simplified(sp.fraction(together(sp.diff(told[1], free[0])))[0])
    shown = above / below if told[0] != objective or aim == times[0] else expanded(told[1])
    source = Aim(told[0], shown, None, tuple(related))
    found = [_condition(proper(rate, frozenset(free)), free, objective, like, source)]
    if told[0] != objective or aim == times[0]:
        words = f"with {times[0].name} eliminated" if aim != times[0] else "by the laws of motion"
        found.append(Equation(told[0] - above / below, "link", words, like.stop))
    return [*found, *(Equation(p, "link", "by the laws of motion", like.stop) for p in links)]


def _of_one(
    related: list[sp.Expr], aim: sp.Expr, time: sp.Symbol, free: sp.Symbol, objective: sp.Expr
) -> tuple[tuple[sp.Expr, sp.Expr], list[sp.Expr]] | None:
    """The quantity, or its square, as a formula of one constant, and the equation that tells the time then."""
    if aim == time:
        told = _solved(expanded(sp.fraction(together(related[0]))[0]), aim) if len(related) == 1 else None
        return None if told is None else (told, [])
    first = next((p for p in related if sp.diff(p, time) != 0 and sp.diff(p, time, 2) == 0), None)
    if first is None:
        return None
    formula = -first.subs(time, 0) / sp.diff(first, time)
    rest = [p for p in related if p is not first]
    if aim.is_Symbol and len(rest) == 1:
        told = _solved(expanded(sp.fraction(together(rest[0].xreplace({time: formula})))[0]), aim)
        return None if told is None else (told, [first])
    if rest or aim.is_Symbol or not objective.is_Symbol:
        return None
    return (objective, simplified(aim.xreplace({time: formula}))), [first]


def with_aims(equations: Sequence[Equation]) -> list[Equation]:
    """The same equations; a balance by which something is largest is written anyway, and costs nothing."""
    aims = [e.source.law for e in equations if isinstance(e.source, Aim) and e.source.law is not None]
    return [replace(e, surcharge=0.0) if e in aims else e for e in equations]


def _by_a_balance(
    equations: Sequence[Equation],
    objective: sp.Expr,
    unknowns: frozenset[sp.Symbol],
    kept: frozenset[sp.Symbol],
    like: Equation,
    sought: frozenset[sp.Symbol],
) -> list[Equation]:
    """The condition of a speed that only a balance between states tells, as one formula of the constant; empty: none
    tells it so.
    """
    plain = [e.residual for e in equations if e.kind in PLAIN]
    for law in _balances(equations, like.stop):
        try:
            related, aim, letters, _ = eliminated([*plain, law.residual], objective, unknowns, kept, sought)
        except Undecided:
            continue
        free, own = [x for x in letters if x in sought], [x for x in letters if x not in sought]
        if len(related) != 1 or len(own) != 1 or len(free) != 1:
            continue
        told = _solved(related[0], own[0])
        # The square of a speed has its extremes in the same places.
        aim = told[0] if told is not None and aim == own[0] else aim
        formula = aim if told is None else simplified(expanded(aim).subs(*told))
        if own[0] in formula.free_symbols:
            continue
        rate = proper(simplified(sp.fraction(together(sp.diff(formula, free[0])))[0]), unknowns)
        return [_condition(rate, free, objective, like, Aim(aim, formula, law))]
    return []


def _balances(equations: Sequence[Equation], stop: str) -> Iterator[Equation]:
    """Balances between two states that end in this one: their kind is the word of their principle."""
    for e in equations:
        if e.stop == stop and e.kind not in COSTS and not e.residual.has(sp.Integral):
            yield e


def _solved(residual: sp.Expr, x: sp.Symbol) -> tuple[sp.Expr, sp.Expr] | None:
    """x² or x by a formula without it; None: the equation does not give it so."""
    if not residual.is_polynomial(x):
        return None
    parts = sp.Poly(residual, x).as_dict()
    powers = {power for (power,) in parts if power}
    if len(powers) != 1 or not powers <= {1, 2}:
        return None
    (power,) = powers
    return x**power, simplified(-parts.get((0,), sp.S.Zero) / parts[(power,)])


def _condition(
    residual: sp.Expr, free: Sequence[sp.Symbol], objective: sp.Expr, like: Equation, aim: Aim | None = None
) -> Equation:
    names = [x.name for x in free if "__" not in x.name]
    words = f"{like.words}, so {unchanged(names, objective)}"
    return Equation(residual, "extreme", words, like.stop, mark=like.mark, source=aim)
