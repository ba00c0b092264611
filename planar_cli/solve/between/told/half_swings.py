"""A harmonic motion from rest to rest: half a period, and as far beyond its midpoint as it began before it.

    q_2 = 2 q_eq - q_1,   t_2 = t_1 + π/ω_n,   |v| at the midpoint = ω_n |q_1 - q_eq|

So it goes again and again where the midpoint jumps at every turn, as dry friction makes it. q̈ = -ω_n² (q - q_eq); ω_n
in rad/s. Source: An Introduction to Planar Dynamics, 1.3.1.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.exact import PI, Valuation
from planar_cli.records import record
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.law import AT_MIDPOINT, HALF_SWINGS, MIRRORED, Law
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.mode_dates import is_dated_by_mode
from planar_cli.solve.regimes.timeline import Stop

CLOSE = Decimal("1e-9")
"""Numbers that were followed agree with a formula so far."""


@record
class _Swing:
    """From rest to the next rest by one law."""

    since: Stop
    stop: Stop
    law: Law
    middle: tuple[Stop, ...]
    """The states that are passed at the midpoint."""

    @property
    def rest(self) -> sp.Expr:
        return sp.S.Zero if self.law.vibration is None else self.law.vibration.steady

    @property
    def natural(self) -> tuple[sp.Symbol, sp.Expr]:
        """ω_n with its formula."""
        assert self.law.vibration is not None
        return self.law.vibration.free[0]


def half_swings(course: MotionEquations, value: Valuation) -> Iterator[Equation]:
    """What half swings tell that follow each other; of a single one a balance of energy tells as much. `value`: numbers
    of everything.
    """
    for q in dict.fromkeys(law.coordinate.symbol for laws in course.laws for law in laws.laws if _is_harmonic(law)):
        for swings in _in_turn(course, q, value):
            yield from (e for s in swings for e in _of_one(s))
            for i, first in enumerate(swings):
                for n, last in enumerate(swings[i:], 1):
                    if first.natural[1] == last.natural[1]:
                        yield _elapsed(first, last, n)


def dates_by_modes(course: MotionEquations, value: Valuation) -> Iterator[Equation]:
    """A state that a mode alone tells is where the motion comes into that mode: a state that was put in."""
    for state in course.states:
        if state.name in course.modes.turnings or not is_dated_by_mode(state):
            continue
        stop, when = course.stops[state.name], value.known(course.stops[state.name].t)
        for name in course.modes.turnings if when is not None and when.is_finite() else ():
            other = course.stops[name]
            if when and (t := value.known(other.t)) is not None and abs(t - when) <= CLOSE * abs(when):
                yield Equation(stop.t - other.t, "link", f"it is state {name}", stop.name, name)


def _is_harmonic(law: Law) -> bool:
    """Is it an undamped vibration that nothing keeps up?"""
    own = law.vibration
    return own is not None and own.ratio is None and own.steady == sp.Add(*own.rest) and law.speed is not None


def _in_turn(course: MotionEquations, q: sp.Symbol, value: Valuation) -> Iterator[Sequence[_Swing]]:
    """Rows of at least two half swings of a coordinate."""
    row: list[_Swing] = []
    since: Stop | None = None
    middle: list[Stop] = []
    for i, state in enumerate(course.states):
        stop, law = course.stops[state.name], _law(course, i - 1, q)
        quarters = None if since is None or law is None else _quarters(law, since, stop, value)
        if since is not None and law is not None and quarters == 2:
            row, since, middle = [*row, _Swing(since, stop, law, tuple(middle))], stop, []
            continue
        if quarters == 1:
            middle.append(stop)
        if quarters is not None:
            continue
        if len(row) > 1:
            yield row
        after = _law(course, i, q)
        row, middle, since = [], [], None if after is None or value.known(_speed(after, stop)) != 0 else stop
    if len(row) > 1:
        yield row


def _law(course: MotionEquations, i: int, q: sp.Symbol) -> Law | None:
    """The harmonic law of a coordinate from state i to the next."""
    if not 0 <= i < len(course.laws) or course.is_impulsive(i):
        return None
    return next((law for law in course.laws[i].laws if law.coordinate.symbol == q and _is_harmonic(law)), None)


def _quarters(law: Law, since: Stop, stop: Stop, value: Valuation) -> int | None:
    """How many quarters of a period pass since a state of rest: 0, where it is somewhere between them; None: it is
    another motion, or longer.
    """
    own, q = law.vibration, law.coordinate.symbol
    assert own is not None
    if not all((t := value.known(s.t)) is not None and t.is_finite() for s in (since, stop)):
        return None
    phase = value.known(own.natural * (stop.t - since.t))
    swing = value.known(own.natural * (since.letters[q] - own.steady))
    speed = value.known(_speed(law, stop))
    if phase is None or speed is None or not swing or not 0 < phase < PI * (1 + CLOSE):
        return None
    if abs(phase - PI) <= PI * CLOSE:
        return 2 if speed == 0 else None
    there = value.known(stop.letters[q] - own.steady)
    near = there is not None and abs(value(own.natural) * there) <= CLOSE * abs(swing)
    return 1 if near and abs(phase - PI / 2) <= PI * CLOSE else 0


def _speed(law: Law, stop: Stop) -> sp.Expr:
    return law.factor * stop.letters[law.speed]


def _of_one(s: _Swing) -> Iterator[Equation]:
    """Where it is at rest again, and how fast it is halfway."""
    q, natural = s.law.coordinate.symbol, s.natural[0]
    first = s.since.letters[q] - s.rest
    residual = s.stop.letters[q] - 2 * s.rest + s.since.letters[q]
    yield _equation(s, residual, MIRRORED, s.stop)
    for stop in s.middle:
        yield _equation(s, _speed(s.law, stop) + natural * first, AT_MIDPOINT, stop)


def _elapsed(first: _Swing, last: _Swing, n: int) -> Equation:
    residual = last.stop.t - first.since.t - n * sp.pi / first.natural[0]
    return _equation(first, residual, HALF_SWINGS, last.stop)


def _equation(s: _Swing, residual: sp.Expr, kind: str, stop: Stop) -> Equation:
    family = (kind, s.law.coordinate.symbol.name, s.since.name, stop.name)
    return Equation(residual, kind, "harmonic motion from rest", stop.name, s.since.name, family=family, law=s.law)
