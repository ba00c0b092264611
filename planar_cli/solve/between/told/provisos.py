"""What the letters of a file must be for its motion to take the course in which it was solved.

A contact slides one way until it stops, a cord stays taut, a state is reached after the one before: with the numbers
that were drawn for the letters it is so, with others it need not be. What must be positive is told at both ends of each
stretch.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise

import sympy as sp

from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import derivative, longer
from planar_cli.equation.values.exact import Valuation
from planar_cli.records import record
from planar_cli.solve.between.branches.solved_motion import SolvedMotion
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.told.answers import put_in
from planar_cli.solve.between.trace.derivation import Route
from planar_cli.solve.instant.conditions import LONGEST, Proviso
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.timeline import Stop

SLACK = 1e-9
"""What is smaller, in parts of its size, is at its limit."""
LOOKS = 16
"""In so many parts a stretch is looked at."""
ENOUGH = 8
"""So many draws at least show that a sign follows from others."""


@record
class Kept:
    """What holds in a stretch of the motion."""

    signs: tuple[sp.Expr, ...]
    """Any of these is positive then, and only then: in letters of states."""
    words: str
    over: tuple[sp.Expr, sp.Expr] | None = None
    """The times of both ends, for what is told at the second one."""
    acting: frozenset[sp.Symbol] = frozenset()
    """The letters of what acts in between: a time of which this rests is not only that of the end."""


def course_provisos(found: SolvedMotion, way: Callable[[list[sp.Symbol]], Route]) -> tuple[Proviso, ...]:
    """What must be positive, in letters of the file. `way`: to letters of states, asked for or not."""
    course = found.course
    if not course.symbolic:
        return ()
    told = [k for k in _told(course, found.value) if k.signs]
    wanted = {s for k in told for e in k.signs for s in e.free_symbols} & course.chain().unknowns
    if not wanted:
        return ()
    route = way(sorted(wanted, key=lambda s: s.name))
    letters = course.scene.ledger.known_letters()
    open_: dict[sp.Expr, str] = {}
    ways: list[tuple[str, list[sp.Expr]]] = []
    for kept in told:
        put = (put_in(e, route) for e in kept.signs)
        expr = next((e for e in put if e.free_symbols <= letters), sp.S.Zero)
        if expr.free_symbols:
            open_.setdefault(expr, kept.words)
            ways += [(kept.words, _inside(expr, [put_in(e, route) for e in kept.over], kept))] if kept.over else []
    draws = course.scene.everywhere() if open_ else ()
    made: dict[sp.Expr, str] = {}
    for expr, words in open_.items():
        if _negative(expr, draws):
            made |= {e: made.get(e, words) for e in _factors(expr, found.value, draws)}
    told_so = _least(list(made), draws)
    fit = [d for d in draws if all((d.known(e) or 0) > 0 for e in told_so)] if ways else []
    lost = dict.fromkeys(words for words, inside in ways if any(_negative(e, fit) for e in inside))
    return (*(Proviso(e, made[e]) for e in told_so), *(Proviso(sp.S.One, words) for words in lost))


def _told(course: MotionEquations, value: Valuation) -> Iterator[Kept]:
    """What holds at both ends of every stretch."""
    for i, (p, r) in enumerate(pairwise(course.stops[s.name] for s in course.states)):
        if course.is_impulsive(i):
            continue
        regime = course.regimes[i]
        laws = (*regime.rates.values(), *regime.accelerations.values(), *(e for e, _ in _kept(regime)))
        acting = frozenset(s for e in laws for s in e.free_symbols)
        yield Kept(tuple(_passed(regime, p, r, value)), f"{r.name} comes after {p.name}")
        for expr, words in _kept(regime):
            here = words + f" from {p.name} to {r.name}"
            begun = p.at(expr)
            if value.known(begun) is not None and not _positive(value, begun):
                begun = p.at(regime.derivative(expr))
            for e, over in ((r.at(expr), (p.t, r.t)), (begun, None)):
                yield Kept((e,) if _positive(value, e) else (), here, over, acting)


def _inside(expr: sp.Expr, times: Sequence[sp.Expr], kept: Kept) -> list[sp.Expr]:
    """What is told at the end of a stretch, at times before; nothing where it changes evenly, so that the ends tell it,
    and where the end is not told by its time.
    """
    since, until = times
    if not until.is_Symbol or until in kept.acting | since.free_symbols:
        return []
    if until not in derivative(expr, until).free_symbols:
        return []
    return [expr.xreplace({until: since + (until - since) * k / LOOKS}) for k in range(1, LOOKS)]


def _passed(regime: Regime, p: Stop, r: Stop, value: Valuation) -> Iterator[sp.Expr]:
    """What grows from one state to the next: the time, and coordinates that go one way at both ends."""
    yield r.t - p.t
    for q, rate in regime.rates.items():
        way = r.letters[q] - p.letters[q]
        for sense in (1, -1):
            ends = (p.at(rate), r.at(rate))
            speeds = [_positive(value, sense * e) for e in ends]
            if _positive(value, sense * way) and all(speeds):
                yield sense * way


def _kept(regime: Regime) -> Iterator[tuple[sp.Expr, str]]:
    """What stays positive in a regime."""
    yield from ((w.expr, w.test.words) for w in regime.watches)
    yield from ((e, "what slides does not stop") for e in regime.slips)
    yield from ((way * u, "what moves does not turn round") for u, way in regime.going().items())


def _positive(value: Valuation, expr: sp.Expr) -> bool:
    """Is it so with the numbers that were drawn, and not at its limit?"""
    number = value.known(expr)
    return number is not None and float(number) > SLACK * float(value.size(expr))


def _factors(expr: sp.Expr, value: Valuation, draws: Sequence[Valuation]) -> Iterator[sp.Expr]:
    """The factors of a formula, each as it is positive with these numbers, but for those that are so in all draws."""
    if longer(expr, LONGEST):
        yield expr
        return
    for factor in sp.Mul.make_args(factored(expr)):
        base = factor.base if factor.is_Pow and factor.exp.is_Integer else factor
        number = value.known(base)
        if base.is_number or number is None or (base is not factor and factor.exp % 2 == 0):
            continue
        for held in _in_branch(base, value) or [base if number > 0 else -base]:
            if _negative(held, draws):
                yield held


def _in_branch(factor: sp.Expr, value: Valuation) -> list[sp.Expr]:
    """Within what an angle stays where its sine, cosine or tangent keeps its sign all the way; none for anything else,
    and where that is not the first branch.
    """
    if not isinstance(factor, sp.sin | sp.cos | sp.tan):
        return []
    (angle,) = factor.args
    near = sp.pi if isinstance(factor, sp.sin) else sp.pi / 2
    low, high = (-near, near) if isinstance(factor, sp.cos) else (sp.S.Zero, near)
    if not isinstance(factor, sp.cos) and (value.known(angle) or 0) < 0:
        low, high = -near, sp.S.Zero
    bounds = [angle - low, high - angle]
    return bounds if all(_positive(value, e) for e in bounds) else []


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
