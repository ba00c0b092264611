"""A coordinate over the time from the laws by which a motion was solved: from state to state each law is summed up in
numbers, and what it comes to in the next state is what the closed form gives there. If it is not, nothing is drawn.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import pairwise

import sympy as sp

from planar_cli.equation.values.exact import FUNCTIONS
from planar_cli.integrators.base import OUTSIDE
from planar_cli.problem.language.walk import is_endless
from planar_cli.records import record
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.law import Law

AGREES = 1e-6
"""How closely it comes to what is known of a state, in parts of the largest value."""
STEPS, MOST = 96, 24576
"""A stretch has so many steps at least and at most: four times as many until it comes to the next state."""
SMOOTH = 24
"""So many steps has each half swing of a vibration at least."""
KEPT = 12000
"""So many places of a stretch are kept at most."""
LATER, RESTING = 3.0, 0.2
"""A motion that only approaches its end is drawn so many times as long again as it took up to there, rest shorter."""
Rates = Callable[[float, float, float], tuple[float, float]]
"""The velocity and acceleration of a coordinate in t, q and its own speed."""


@record
class Instant:
    """A coordinate at a moment: s, then m or rad, m/s or rad/s, and so on."""

    t: float
    q: float
    v: float
    a: float


@record
class Traced:
    """A coordinate over the time. `pieces`: from state to state; `states`: the states on the way, with their places."""

    law: Law
    """The first of its laws."""
    pieces: tuple[tuple[Instant, ...], ...]
    states: tuple[tuple[str, Instant], ...]


def traced(motion: MotionTrace, q: sp.Symbol) -> Traced | None:
    """A coordinate over all states; None: laws in numbers do not tell it, or do not come to what was found."""
    pieces, states = list[tuple[Instant, ...]](), list[tuple[str, Instant]]()
    own = _in_order(motion, q)
    for since, until, law in own:
        begun = _known(motion, law, since)
        if begun is None:
            # Nothing tells when it comes there.
            break
        if pieces and not _follows(pieces[-1][-1], begun):
            return None
        found = _stretch(motion, law, begun, until, begun.t - pieces[0][0].t if pieces else 0.0)
        if found is None:
            return None
        if found:
            states += [] if states else [(since, found[0])]
            pieces.append(found)
            states += [(until, found[-1])] if _number(motion, _time(motion), until) is not None else []
        elif states and _number(motion, _time(motion), until) is not None:
            # It takes no time.
            states.append((until, states[-1][1]))
    return Traced(own[0][2], tuple(pieces), tuple(states)) if pieces else None


def _in_order(motion: MotionTrace, q: sp.Symbol) -> list[tuple[str, str, Law]]:
    """The stretches of a coordinate with their laws; under one law in the order in which its states come."""
    own = [(a, b, law) for a, b, laws in motion.stretches for law in laws if law.coordinate.symbol == q]
    names = list(dict.fromkeys(name for a, b, _ in own for name in (a, b)))
    times = {name: t for name in names if (t := _number(motion, _time(motion), name)) is not None}
    same = {(law.order, law.f.xreplace({law.v: own[0][2].v})) for _, _, law in own}
    if len(same) != 1 or len(times) < 2:
        return own
    kept = [*sorted(times, key=lambda n: times[n]), *(n for n in names[-1:] if n not in times)]
    return [(a, b, own[0][2]) for a, b in pairwise(kept)]


def _follows(before: Instant, after: Instant) -> bool:
    """Does one stretch begin where and when another ends?"""
    near = AGREES * max(abs(before.t), abs(before.q), 1e-3)
    return abs(before.t - after.t) <= near and abs(before.q - after.q) <= near


def _stretch(motion: MotionTrace, law: Law, begun: Instant, until: str, before: float) -> tuple[Instant, ...] | None:
    """From a state to the next; () for one that takes no time. `before`: how long the motion has gone on, s."""
    rates, end = _rates(motion, law), _number(motion, _time(motion), until)
    if rates is None:
        return None
    ends = _known(motion, law, until) if end is not None else None
    if end is None:
        relations = next((s.relations for s in motion.problem.states if s.name == until), ())
        more = LATER if law.order == 2 else RESTING
        end = begun.t + (more * before if is_endless(relations) else 0.0)
    if end <= begun.t:
        return () if end == begun.t else None
    breaks = [t for t in _breaks(motion, law) if begun.t < t < end]
    steps = STEPS
    try:
        while steps <= MOST:
            found = _summed(rates, begun, (*breaks, end), steps)
            again = _summed(rates, begun, (*breaks, end), 2 * steps)
            same = _agree(found[-1], again[-1], again) and (ends is None or _agree(again[-1], ends, again))
            if same and sum(a.v * b.v < 0 for a, b in pairwise(again)) * SMOOTH <= steps:
                return tuple(_shown(again))
            steps *= 4
    except (*OUTSIDE, TypeError):
        # A power of a negative number is complex.
        pass
    return None


def _agree(a: Instant, b: Instant, way: Sequence[Instant]) -> bool:
    span = way[-1].t - way[0].t
    speed = max(abs(i.v) for i in way) or max(abs(i.a) for i in way) * span
    place = max(abs(i.q) for i in way) or speed * span
    return abs(a.q - b.q) <= AGREES * place and abs(a.v - b.v) <= AGREES * speed


def _shown(way: Sequence[Instant]) -> list[Instant]:
    each = max(1, len(way) // KEPT)
    return [*way[:-1:each], way[-1]]


def _summed(rates: Rates, begun: Instant, ends: Sequence[float], steps: int) -> list[Instant]:
    """By the method of Runge and Kutta, in equal steps up to each place where the law changes."""
    found, q, v, since = list[Instant](), begun.q, begun.v, begun.t
    for end in ends:
        h, inner = (end - since) / steps, 1e-9 * (end - since)

        def slope(t: float, q: float, v: float, low: float = since + inner, high: float = end - inner) -> Instant:
            # Where the law changes it is that of this side.
            return Instant(t, q, *rates(min(max(t, low), high), q, v))

        for k in range(steps + 1):
            t = since + k * h
            one = slope(t, q, v)
            found.append(Instant(t, q, one.v, one.a))
            if k == steps:
                break
            two = slope(t + h / 2, q + h / 2 * one.v, v + h / 2 * one.a)
            three = slope(t + h / 2, q + h / 2 * two.v, v + h / 2 * two.a)
            four = slope(t + h, q + h * three.v, v + h * three.a)
            q += h / 6 * (one.v + 2 * two.v + 2 * three.v + four.v)
            v += h / 6 * (one.a + 2 * two.a + 2 * three.a + four.a)
        since = end
    return found


# --- what is known ----------------------------------------------------------------------------------------------------


def _rates(motion: MotionTrace, law: Law) -> Rates | None:
    """The rates of a law; None: something else in it varies, or has no number."""
    f = law.f if law.constant is None else law.f.xreplace({law.constant[0]: law.constant[1]})
    clock, q = _time(motion) or sp.Symbol("t"), law.coordinate.symbol
    numbers: dict[sp.Basic, sp.Expr] = {}
    for letter in f.free_symbols - {clock, q, law.v}:
        number = None if letter in motion.varying else motion.value.known(letter)
        if number is None:
            return None
        numbers[letter] = sp.Float(number, 17)
    f = f.xreplace(numbers)
    both = sp.Tuple(law.v, f) if law.order == 2 else sp.Tuple(f, sp.diff(f, clock) + sp.diff(f, q) * f)
    functions = both.atoms(sp.Function) - both.atoms(sp.Piecewise)
    if both.has(sp.Integral, sp.Derivative, sp.Subs) or any(part.func not in FUNCTIONS for part in functions):
        return None
    made: Rates = sp.lambdify((clock, q, law.v), both, "math", cse=True)
    return made


def _breaks(motion: MotionTrace, law: Law) -> list[float]:
    """The times at which a law changes."""
    clock = _time(motion)
    found = set[float]()
    for piece in law.f.atoms(sp.Piecewise):
        for _, condition in piece.args:
            for relation in sp.sympify(condition).atoms(sp.core.relational.Relational):
                if clock is not None and clock in relation.args:
                    number = motion.value.known(relation.rhs if relation.lhs == clock else relation.lhs)
                    found |= set() if number is None else {float(number)}
    return sorted(found)


def _known(motion: MotionTrace, law: Law, state: str) -> Instant | None:
    """Where a coordinate is in a state and how fast it grows; None: it is not told."""
    here = {g: x for x, g in motion.general.items() if motion.ledger.roles[x].at == state}
    rate = law.f if law.order == 1 else law.coordinate.rate
    t, q, v = (_number(motion, e, state, here) for e in (_time(motion), law.coordinate.symbol, rate))
    return None if t is None or q is None or v is None else Instant(t, q, v, 0.0)


def _number(
    motion: MotionTrace, expr: sp.Expr | None, state: str, here: dict[sp.Symbol, sp.Symbol] | None = None
) -> float | None:
    if expr is None:
        return None
    if here is None:
        here = {g: x for x, g in motion.general.items() if motion.ledger.roles[x].at == state}
    found = motion.value.known(sp.sympify(expr).xreplace(here))
    return float(found) if found is not None and math.isfinite(found) else None


def _time(motion: MotionTrace) -> sp.Symbol | None:
    return next((g for g in motion.general.values() if g.name == "t"), None)
