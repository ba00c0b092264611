"""Quantities over a span of a motion: path length, mean, count, work, impulse, heat.

Each is an integral over time. In order of preference it is

    a difference     where the integrand is the rate of a function G of place and time (a force along one coordinate)
    an integral      of q(t), where the laws of motion are integrated, closed or by quadrature
    a flow           integrated along with the motion that was followed

A path length is the sum of its parts between the instants at which the velocity vanishes. A span that never ends is a
difference, or nothing happens in it any more. SI units.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from decimal import Decimal
from functools import cached_property, partial
from itertools import pairwise

import sympy as sp

from planar_cli.calculus.antiderivative import definite, where_real
from planar_cli.calculus.first import all_roots
from planar_cli.calculus.polish import polish
from planar_cli.equation.algebra.plain import derivative, identically_zero, simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import Diagnostic, NoSolution, NoValue, Undecided, undecided_at
from planar_cli.problem.language.expression import Quantity, Relation
from planar_cli.simulate.quadrature import Piece as Part
from planar_cli.simulate.quadrature import integral
from planar_cli.solve.between.branches.exact_segments import ExactSegment, exact_segments
from planar_cli.solve.between.branches.one_sense import demand_one_sense
from planar_cli.solve.between.equations.given_times import endless_times
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.equations.span_quantities import SpanQuantity
from planar_cli.solve.between.roots.followed import Followed
from planar_cli.solve.between.trace.span_trace import Piece, SpanIntegral
from planar_cli.solve.diagnosis.words import names_of
from planar_cli.solve.impulsive.impact import Blow
from planar_cli.solve.impulsive.spans import over_blow
from planar_cli.solve.regimes.gains import gained
from planar_cli.solve.regimes.potential import signed_speed
from planar_cli.solve.regimes.timeline import Stop

CERTAIN = Decimal("1e-9")
"""What an integral in a state's own relations may differ from the same by numbers, relative to its size."""
SAME_TIME = Decimal("1e-20")
ROUNDED = Decimal("1e-12")
"""Roots that machine numbers tell are the end of a span itself where they are no further from it, relative to it."""
FOREVER = Decimal("Infinity")


class SpanSolver:
    """Integrates over spans of one motion. `value`: numbers of names and letters of states; `followed`: the motion in
    numbers.
    """

    def __init__(self, course: MotionEquations, value: Valuation, followed: Followed | None) -> None:
        self.course, self.followed, self._dated = course, followed, value
        self.value = value.extended(dict.fromkeys(endless_times(course), FOREVER))
        """Numbers of names and letters of states; the time of a state that is only approached is infinite."""

    @cached_property
    def segments(self) -> tuple[ExactSegment, ...]:
        return exact_segments(self.course, self._dated, self.followed)

    def solve(self, symbol: sp.Symbol, asked: SpanQuantity) -> SpanIntegral:
        q, dated = asked.quantity, self.course.departure is None
        parts = self._parts(asked)
        if q.word == "count":
            events = tuple(
                t for p, r, segment in parts for t in self._events(p, q, self._rates(asked, segment), segment)
            )
            n = len(events)
            return SpanIntegral(symbol, q, (), Decimal(n), sp.Integer(n), events=events, dated=dated)
        pieces = tuple(self._piece(p, r, asked, segment) for p, r, segment in parts)
        pieces += tuple(self._blow(blow, q) for blow in self._blows(asked))
        number = sum((p.number for p in pieces), Decimal(0))
        formulas = [p.formula for p in pieces]
        formula = None if None in formulas else sp.Add(*formulas)
        if q.word != "mean":
            return SpanIntegral(symbol, q, pieces, number, formula, dated=dated)
        a, b = (self.course.stops[n] for n in asked.span)
        time = b.t - a.t
        return SpanIntegral(
            symbol, q, pieces, number / self.value(time), None if formula is None else formula / time, time
        )

    def _blows(self, asked: SpanQuantity) -> list[Blow]:
        """The blows inside a span."""
        order = {s.name: i for i, s in enumerate(self.course.states)}
        a, b = (order.get(n, -1) for n in asked.span)
        return [blow for i, blow in self.course.blows.items() if a <= i < b]

    def _blow(self, blow: Blow, q: Quantity) -> Piece:
        formula = over_blow(blow, q)
        loose = formula.free_symbols & set(blow.undetermined)
        if loose:
            names = names_of(blow.system, loose, f"{blow.since.name}->{blow.stop.name}")
            text = f"not unique: {names}; the scene has more supports than equations"
            raise NoSolution([Diagnostic(q.mark, "PL603", text, "ask for what is unique, or leave a support out")])
        return Piece(*_ends(blow.since, blow.stop), formula, "blow", self.value(formula), formula)

    def _parts(self, asked: SpanQuantity) -> list[tuple[Stop, Stop, ExactSegment]]:
        """The span cut where a blow falls, and where the regime changes."""
        a, b = (self.course.stops[n] for n in asked.span)
        found = []
        for blow in self._blows(asked):
            found += self._between(a, blow.since, asked) if a is not blow.since else []
            a = blow.stop
        return [*found, *self._between(a, b, asked)] if a is not b else found

    def _between(self, a: Stop, b: Stop, asked: SpanQuantity) -> list[tuple[Stop, Stop, ExactSegment]]:
        """Part of a span without blows, cut where the regime changes."""
        q, ta, tb = asked.quantity, self.value.known(a.t), self.value.known(b.t)
        if ta is None or tb is None:
            text = f"{q.word}(…) @ {a.name}->{b.name} is taken over a time that no formula tells"
            raise undecided_at(q.mark, text)
        if tb < ta:
            text = f"state {b.name} comes before state {a.name}"
            raise NoSolution([Diagnostic(q.mark, "PL633", text, f"write `@ {b.name}->{a.name}`")])
        inside = [segment.start for segment in self.segments[1:] if ta < segment.t0 < tb]
        points = [a, *inside, b]
        found = []
        for p, r in pairwise(points):
            tp = self.value(p.t)
            segment = [x for x in self.segments if x.t0 <= tp + SAME_TIME * max(abs(tp), Decimal(1))][-1:] or [
                self.segments[0]
            ]
            found.append((p, r, segment[0]))
        return found

    def _rates(self, asked: SpanQuantity, segment: ExactSegment) -> tuple[sp.Expr, ...]:
        reader = next(r for r in self.course.distinct_readers() if r.regime is segment.regime)
        return tuple(simplified(reader.closed(e)) for e in asked.rates[id(segment.regime)])

    # --- one piece ---------------------------------------------------------------------------------------------------

    def _piece(self, p: Stop, r: Stop, asked: SpanQuantity, segment: ExactSegment) -> Piece:
        rates = self._rates(asked, segment)
        if asked.quantity.word != "path_length":
            way = self._change if asked.changes else self._integral
            found = way(p, r, rates[0], segment, asked.quantity)
            return replace(found, letter=_steady(asked.rates[id(segment.regime)][0], found, segment))
        speed, signed = signed_speed(rates[0], rates[1], segment.regime)
        if not signed:
            return self._integral(p, r, speed, segment, asked.quantity)
        ta, tb = self.value(p.t), self.value(r.t)
        near = ROUNDED * max(abs(ta), min(abs(tb), segment.t1))
        turns = tuple(t for t in self._zeros(speed, segment, ta, tb) if ta + near < t < tb - near)
        whole = self._integral(p, r, speed, segment, asked.quantity)
        if not turns and self.course.symbolic:
            demand_one_sense(self.course, segment.over_time(speed), p, r, asked.quantity)
        if not turns:
            sense = -1 if whole.number < 0 else 1
            formula, g, over = (
                None if e is None else sense * e for e in (whole.formula, whole.antiderivative, whole.over_time)
            )
            return Piece(*_ends(p, r), sense * speed, whole.how, abs(whole.number), formula, g, over)
        if tb == FOREVER:
            raise self._endless(asked.quantity, p, r)
        ends = [ta, *turns, tb]
        total = sum((abs(self._number(speed, segment, s, t)[0]) for s, t in pairwise(ends)), Decimal(0))
        return Piece(*_ends(p, r), speed, whole.how, total, None, whole.antiderivative, whole.over_time, turns)

    def _change(self, p: Stop, r: Stop, momentum: sp.Expr, segment: ExactSegment, q: Quantity) -> Piece:
        """What changes a momentum between two states of a segment."""
        begun, last = segment.number(momentum, self.value(p.t)), self.value(r.t)
        ended = self.value.known(r.at(momentum)) if last == FOREVER else segment.number(momentum, last)
        if ended is None:
            raise self._endless(q, p, r)
        return Piece(*_ends(p, r), momentum, "change", ended - begun, r.at(momentum) - p.at(momentum), momentum)

    def _integral(self, p: Stop, r: Stop, rate: sp.Expr, segment: ExactSegment, q: Quantity) -> Piece:
        """∫ rate dt between two states of a segment."""
        ta, tb = self.value(p.t), self.value(r.t)
        if tb == FOREVER:
            return self._approached(p, r, rate, segment, q)
        number, how = self._number(rate, segment, ta, tb)
        g = self._known(rate, segment) if number != 0 else None
        g = g if g is not None else _potential(rate, segment, ta, tb)
        if g is not None:
            return Piece(*_ends(p, r), rate, "difference", number, r.at(g) - p.at(g), g)
        over = segment.over_time(rate)
        formula = None
        if over is not None:
            formula = definite(simplified(over), segment.regime.time, p.t, r.t, segment.value)
        return Piece(*_ends(p, r), rate, how, number, formula, None, over)

    def _known(self, rate: sp.Expr, segment: ExactSegment) -> sp.Expr | None:
        """What the page has anyway, of which this is the rate: a free speed, or what a spring has stored."""
        regime = segment.regime
        if not rate.free_symbols & set(regime.letters):
            return None
        for speed, acceleration in regime.accelerations.items():
            for sense in (1, -1):
                if identically_zero(rate - sense * acceleration):
                    return sense * speed
        sources = (s for o in self.course.between.offered.get(id(regime), ()) for s in o.balance.sources)
        for stored in (s.stored for s in sources if s.stored is not None and s.stored.power > 1):
            amount = -regime.closed(stored.factor) * regime.closed(stored.measure) ** stored.power / stored.power
            change = [derivative(amount, q) * pace for q, pace in regime.rates.items()]
            if identically_zero(rate - sp.Add(*change, derivative(amount, regime.time))):
                return amount
        return None

    def _approached(self, p: Stop, r: Stop, rate: sp.Expr, segment: ExactSegment, q: Quantity) -> Piece:
        """∫ rate dt to a state that is only approached: a difference, where it tends to a value."""
        ta = self.value(p.t)
        g = _potential(rate, segment, ta, ta + 1)
        end = None if g is None or segment.regime.time in g.free_symbols else self.value.known(r.at(g))
        if g is None or end is None:
            raise self._endless(q, p, r)
        return Piece(*_ends(p, r), rate, "difference", end - segment.number(g, ta), r.at(g) - p.at(g), g)

    @staticmethod
    def _endless(q: Quantity, p: Stop, r: Stop) -> Undecided:
        text = f"{q.word}(…) from {p.name} on: as the time grows without end, no value was found that it approaches"
        return undecided_at(q.mark, f"{text}; ask up to a time that is given")

    def _number(self, rate: sp.Expr, segment: ExactSegment, ta: Decimal, tb: Decimal) -> tuple[Decimal, str]:
        """∫ rate dt between two times, and how it was done."""
        if ta == tb:
            return Decimal(0), "difference"
        g = _potential(rate, segment, ta, tb)
        if g is not None:
            return segment.number(g, tb) - segment.number(g, ta), "difference"
        over = segment.over_time(rate)
        if over is None:
            return self._flowed(rate, segment, ta, tb), "flow"
        time, start, end = segment.regime.time, sp.Dummy("t_a", real=True), sp.Dummy("t_b", real=True)
        here = segment.value.extended({start: ta, end: tb})
        closed = definite(simplified(over), time, start, end, here)
        number = here.known(closed) if closed is not None else None
        if number is not None:
            return number, "integral"
        return here(sp.Integral(over, (time, start, end))), "quadrature"

    @staticmethod
    def _flowed(rate: sp.Expr, segment: ExactSegment, ta: Decimal, tb: Decimal) -> Decimal:
        g, a, b = segment.function(rate), float(ta), float(tb)
        ends = [a, *(t for f in segment.followed for t in f.ends() if a < t < b), b]
        (number,) = integral(Part(lambda t: (g(t),), since, until) for since, until in pairwise(ends))
        return Decimal(repr(number))

    # --- zeros -------------------------------------------------------------------------------------------------------

    def _zeros(self, expr: sp.Expr, segment: ExactSegment, ta: Decimal, tb: Decimal) -> list[Decimal]:
        """The instants in (ta, tb] at which a formula vanishes."""
        if not expr.free_symbols & set(segment.regime.letters):
            return []
        found = []
        direct = segment.over_time(expr)
        # What is only approached has come there, to all digits of the motion that was followed, where that ends.
        until = tb if tb != FOREVER else max([segment.t1, *(Decimal(repr(f.t1)) for f in segment.followed)])
        for root in all_roots(segment.function(expr), float(ta), float(until)):
            t = Decimal(repr(root.value))
            if direct is not None and root.kind != "stays":
                with suppress(NoValue):
                    t = polish(partial(segment.number, direct), Decimal(root.low), Decimal(root.high))
            found.append(t)
        return found

    def _events(self, p: Stop, q: Quantity, rates: tuple[sp.Expr, ...], segment: ExactSegment) -> list[Decimal]:
        """How often a relation comes true after state p: it holds for an instant, or begins to hold."""
        assert isinstance(q.argument, Relation)
        assert isinstance(q.at, tuple)
        ends = [self.value(self.course.stops[q.at[1]].t), *(x.t0 for x in self.segments if x.t0 > self.value(p.t))]
        ta, tb = self.value(p.t), min(ends)
        times = self._zeros(rates[0], segment, ta, tb)
        if q.argument.operator == "=":
            others = [segment.function(e) for e in rates[1:]]
            return [t for t in times if all(abs(g(float(t))) <= 1e-9 * _size(g, segment) for g in others)]
        sense = 1 if q.argument.operator in (">", ">=") else -1
        g = segment.function(rates[0])
        step = 1e-7 * float(min(tb, segment.t1) - ta)
        return [t for t in times if sense * g(float(t) + step) > 0 > sense * g(float(t) - step)]


def _size(g: Callable[[float], float], segment: ExactSegment) -> float:
    span = float(segment.t1 - segment.t0)
    return max(abs(g(float(segment.t0) + span * k / 7)) for k in range(8))


def _potential(rate: sp.Expr, segment: ExactSegment, ta: Decimal, tb: Decimal) -> sp.Expr | None:
    """The function of time, place and speed of which this is the rate, real between two times; None: there is none."""
    g = gained(rate, segment.regime)
    return None if g is None else where_real(g, segment.value.extended(segment.at((ta + tb) / 2)))


def _steady(rate: sp.Expr, found: Piece, segment: ExactSegment) -> sp.Expr | None:
    """The rate itself where it is one letter, or its opposite, that is the same all the time."""
    one = rate.is_Symbol or (-rate).is_Symbol
    moving = found.integrand.free_symbols & set(segment.regime.letters)
    return rate if one and not moving and found.how != "change" else None


def _ends(since: Stop, until: Stop) -> tuple[str, str, tuple[sp.Symbol, sp.Symbol]]:
    """Between which states a part of a span is, and their times."""
    return since.name, until.name, (since.t, until.t)


def solve_spans(course: MotionEquations, value: Valuation, followed: Followed | None) -> tuple[SpanIntegral, ...]:
    """All quantities over spans. Those that stand in states are checked by numbers; NoSolution: the motion turns."""
    solver = SpanSolver(course, value, followed)
    found = []
    for symbol, asked in course.spanned.items():
        solved = solver.solve(symbol, asked)
        told = course.told.get(symbol)
        if told is not None and abs(value(told) - solved.number) > CERTAIN * max(abs(solved.number), CERTAIN):
            a, b = asked.span
            text = f"the motion turns between {a} and {b}, so that {asked.quantity.word}(…) is not what was assumed"
            raise NoSolution([Diagnostic(asked.quantity.mark, "PL633", text, "put a state where it turns")])
        found.append(solved)
    return tuple(found)
