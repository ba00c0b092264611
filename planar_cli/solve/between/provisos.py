"""What the letters of a file must be for its motion to take the course in which it was solved.

A contact slides one way until it stops, a cord stays taut, a state is reached after the one before: with the numbers
that were drawn for the letters it is so, with others it need not be. What must be positive is told at both ends of each
stretch.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise

import sympy as sp

from planar_cli.equation.common_factors import factor_terms
from planar_cli.equation.exact import Valuation
from planar_cli.equation.plain import longer
from planar_cli.solve.between.answers import put_in
from planar_cli.solve.between.derivation import Route
from planar_cli.solve.between.motion_equations import MotionEquations
from planar_cli.solve.between.solved_motion import SolvedMotion
from planar_cli.solve.instant.conditions import LONGEST, Proviso
from planar_cli.solve.regimes.regime import Regime

SLACK = 1e-9
"""What is smaller, in parts of its size, is at its limit."""
ENOUGH = 8
"""So many draws at least show that a sign follows from others."""


def course_provisos(found: SolvedMotion, way: Callable[[list[sp.Symbol]], Route]) -> tuple[Proviso, ...]:
    """What must be positive, in letters of the file. `way`: to letters of states, asked for or not."""
    course = found.course
    if not course.symbolic:
        return ()
    told = [p for p in _told(course) if _positive(found.value, p.positive)]
    wanted = {s for p in told for s in p.positive.free_symbols} & course.chain().unknowns
    if not wanted:
        return ()
    route = way(sorted(wanted, key=lambda s: s.name))
    letters = set(course.scene.ledger.letters)
    put = [(put_in(p.positive, route), p.words) for p in told]
    open_ = {e: words for e, words in reversed(put) if e.free_symbols and e.free_symbols <= letters}
    draws = course.scene.everywhere() if open_ else ()
    made: dict[sp.Expr, str] = {}
    for expr, words in reversed(open_.items()):
        if _negative(expr, draws):
            made.setdefault(expr if longer(expr, LONGEST) else _plainer(expr, draws), words)
    return tuple(Proviso(e, made[e]) for e in _least(list(made), draws))


def _told(course: MotionEquations) -> Iterator[Proviso]:
    """What is positive at both ends of every stretch, in letters of the states."""
    for i, (p, r) in enumerate(pairwise(course.stops[s.name] for s in course.states)):
        if course.is_impulsive(i):
            continue
        yield Proviso(r.t - p.t, f"{r.name} comes after {p.name}")
        for stop in (r, p):
            for expr, words in _kept(course.regimes[i]):
                yield Proviso(stop.at(expr), f"{words} from {p.name} to {r.name}")


def _kept(regime: Regime) -> Iterator[tuple[sp.Expr, str]]:
    """What stays positive in a regime."""
    yield from ((w.expr, w.test.words) for w in regime.watches)
    yield from ((e, "what slides does not stop") for e in regime.slips)
    yield from ((way * u, "what moves does not turn round") for u, way in regime.going().items())


def _positive(value: Valuation, expr: sp.Expr) -> bool:
    """Is it so with the numbers that were drawn, and not at its limit?"""
    number = value.known(expr)
    return number is not None and float(number) > SLACK * float(value.size(expr))


def _plainer(expr: sp.Expr, draws: Sequence[Valuation]) -> sp.Expr:
    """What has the sign of a formula, without fractions and factors that are positive in all draws.

    A tangent that is finite all the way keeps to its branch, so that its sign is that of its angle.
    """
    above, below = sp.fraction(sp.together(expr))
    factors = sp.Mul.make_args(factor_terms(sp.expand(above)) * below)
    signs = [sp.sign(f) for f in factors if f.is_number]
    plain = sp.Mul(*signs, *(_of_angle(f) for f in factors if not f.is_number and _negative(f, draws)))
    return sp.sympify(plain)


def _of_angle(factor: sp.Expr) -> sp.Expr:
    return factor.args[0] if isinstance(factor, sp.tan) and factor.has(sp.atan) else factor


def _negative(expr: sp.Expr, draws: Sequence[Valuation]) -> bool:
    """Is it negative in one of the draws?"""
    return any((d.known(expr) or 0) < 0 for d in draws)


def _least(doubtful: Sequence[sp.Expr], draws: Sequence[Valuation]) -> list[sp.Expr]:
    """Those that do not follow from the others, as far as enough draws tell."""
    left = list(doubtful)
    signs = {e: [(d.known(e) or 0) > 0 for d in draws] for e in left}
    for expr in doubtful:
        others = zip(*(signs[e] for e in left if e is not expr), strict=True)
        own = [sign for sign, rest in zip(signs[expr], others, strict=False) if all(rest)]
        if len(own) >= ENOUGH and all(own):
            left.remove(expr)
    return left
