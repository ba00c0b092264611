"""The motion followed in numbers from its first state: when each state is reached, and where an assumption ends.

It decides which regime acts when (slip, stick, slack, which way), the order of states, and which of several roots
happens; the equations of the motion then give the same values in closed form where there is one.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.calculus.flow import Flow
from planar_cli.equation.exact import Valuation
from planar_cli.equation.scales import SLACK, Here, Sizes, measured
from planar_cli.errors import NoValue
from planar_cli.solve.between.apart import TOUCHES, demand_together
from planar_cli.solve.between.events import (
    LOOKS,
    FollowedSegment,
    State,
    angular_speeds,
    events,
    far_along,
    is_zero,
    length_of,
    swing_of,
    vanishes_throughout,
)
from planar_cli.solve.between.followed import Ends, Followed
from planar_cli.solve.between.given_times import asked_without_end, given_time, latest_given, without_end
from planar_cli.solve.between.motion_equations import MotionEquations
from planar_cli.solve.following.admissible import demand_possible, objection, transferred_number
from planar_cli.solve.following.gaps import closing, openings
from planar_cli.solve.following.passage_times import by_formula, steady_time
from planar_cli.solve.impulsive.impact import Stroke
from planar_cli.solve.regimes.after import asked_after
from planar_cli.solve.regimes.directions import ways_at
from planar_cli.solve.regimes.mode_sequence import fixed_time
from planar_cli.solve.regimes.regime import Regime, corners, number_function
from planar_cli.solve.regimes.timeline import Demand, Stop

CHOICES = 8
TOGETHER = 1e-6
"""So near to a state, in parts of the time up to it, what ends may end in it."""
SMALL = 1e-4
"""This part of the size of the scene, or of a radian, counts as no smaller size."""


class Follower:
    """Follows one course. `value`: numbers of everything that does not vary. `until`: so many stretches; None: all."""

    def __init__(self, course: MotionEquations, value: Valuation, until: int | None = None) -> None:
        self.course, self.value, self.until = course, value, until
        self.done = Followed()
        self.sizes = Sizes(course.scales, 0.0)

    def run(self, start: Mapping[sp.Symbol, float]) -> Followed:
        """From the letters of the first state, by the letters of the general position."""
        course, done = self.course, self.done
        state: State = dict(start)
        self._record(course.first, state, course.regimes[0])
        for i, regime in enumerate(course.regimes):
            if i + 1 >= len(course.states):
                break
            if i == self.until:
                return done
            done.at = state
            if i in course.blows:
                stroke = self._struck(i, state)
                done.far[i] = stroke.far
                if stroke.objection:
                    done.blow, done.why = i, stroke.objection
                    return done
                if stroke.misfit:
                    done.misfit, done.why = i + 1, stroke.misfit
                    return done
                state = stroke.after
                done.values |= stroke.own
                self._record(course.stops[course.states[i + 1].name], state, course.blows[i].after)
                continue
            arrived = course.readers[course.states[i].name].regime
            if not self._fits(i, regime, arrived, state):
                return done
            if course.is_dated(i):
                done.dated = i
                return done
            begun = self.begin(regime, state, arrived)
            if not all(self._tends(i, regime, begun, k) for k in asked_without_end(course, i + 1)):
                return done
            if without_end(course, i + 1):
                continue
            reached = self._stretch(i, regime, begun)
            if reached is None:
                return done
            state = reached
            self._record(course.stops[course.states[i + 1].name], state, regime)
        done.at = state
        last = len(course.states) - 1
        if course.beyond is not None and last > 0 and asked_after(course.problem, course.states[last].name):
            arrived = course.readers[course.states[last].name].regime
            self._fits(last, course.beyond, arrived, state)
        return done

    def _struck(self, i: int, state: State) -> Stroke:
        """What comes of the blow between state i and the next."""
        blow = self.course.blows[i]
        self._here(blow.before, state)
        state = blow.placed(state, self.done.values)
        here, near = blow.arrived(state, self.value), TOUCHES * self.sizes.length
        demand_together(self.course, i, here, near)
        return blow.strike(state, here, near)

    def _fits(self, i: int, regime: Regime, old: Regime, before: State) -> bool:
        """Do the assumptions of a regime hold where it takes over from an old one, at state i?"""
        done = self.done
        here = self._here(regime, self.begin(regime, before, old))
        done.why = objection(self.course, i, regime, here, old, before)
        done.ways = {} if done.why else ways_at(regime, here)
        done.misfit = i if done.why or done.ways else None
        return done.misfit is None

    def _here(self, regime: Regime, state: State) -> Here:
        """A state in the letters of a regime, measured by what the motion has shown so far."""
        still = [0.0] * (len(regime.letters) - 1)
        numbers = self._rates(regime)(*(state[s] for s in regime.letters)) if regime.runs else still
        self._pass(state, length_of(regime, state, numbers, self.value, self.course.scales.length))
        sizes = self.sizes.by_letter(self.course.first.letters, self.course.ledger.units)
        return Here({s: state[s] for s in regime.letters}, sizes, self.value)

    def _pass(self, state: State, length: float) -> None:
        """Speeds and lengths of a state that the motion passes."""
        self.sizes = self.sizes.passing(state, self.course.ledger.units, length)

    def _rates(self, regime: Regime) -> Callable[..., list[float]]:
        return self._numbers(regime, [*regime.rates.values(), *regime.accelerations.values()])

    def _record(self, stop: Stop, state: State, regime: Regime) -> None:
        """A state that is reached, also in the letters of other regimes."""
        for letter, own in stop.letters.items():
            if letter in state:
                self.done.values[own] = state[letter]
        if all(s in state for s in regime.letters):
            for letter, expr in self.course.transfer(regime).items():
                self.done.values[stop.letters[letter]] = transferred_number(regime, expr, state, self.value)

    # --- beginning ---------------------------------------------------------------------------------------------------

    def begin(self, regime: Regime, state: State, old: Regime) -> State:
        """The letters of a regime where it takes over from an old one: places and velocities stay."""
        begun = dict(state)
        transfer = self.course.transfers[id(old)] if all(s in state for s in old.letters) else {}
        for c in regime.coordinates:
            if c.symbol in transfer:
                begun[c.symbol] = transferred_number(old, transfer[c.symbol], state, self.value)
            elif c.symbol not in begun and c.drawn is not None:
                begun[c.symbol] = float(self.value(c.drawn))
        for u in regime.free:
            if u not in begun and u in transfer:
                begun[u] = transferred_number(old, transfer[u], state, self.value)
            begun.setdefault(u, 0.0)
        lost = self.course.first.speeds.union(self.course.transfers[id(regime)])
        return {s: v for s, v in begun.items() if s in regime.letters or s not in lost}

    def _numbers(self, regime: Regime, exprs: Sequence[sp.Expr]) -> Callable[..., list[float]]:
        return number_function(exprs, regime.letters, self.value)

    # --- one stretch -------------------------------------------------------------------------------------------------

    def _stretch(self, i: int, regime: Regime, state: State) -> State | None:
        """Up to the next state, or None: something else comes first, or nothing does."""
        t0 = state[regime.time]
        segment = self.segment(regime, state)
        stop = self.course.stops[self.course.states[i + 1].name]
        told = None if fixed_time(stop.relations) else steady_time(self.course, stop, segment)
        time = self._time_of(i + 1, stop, segment) if told is None else None
        there = told[0] if told is not None else by_formula(self.course, stop, segment) if time is None else None
        time = time if there is None else there[regime.time]
        ends = self._ends(i, segment, time)
        if ends is not None:
            self.done.ends = ends
            self._done(replace(segment, t1=ends.time))
            return None
        if time is None:
            earlier = self._before_given_times(i, stop)
            if earlier is None:
                self.done.missed = stop.name
            return earlier
        demand_possible(regime, segment, time, self.value)
        self._done(replace(segment, t1=time))
        if there is not None:
            return there
        return segment.at(time) if time >= t0 else self._earlier(time)

    def _tends(self, i: int, regime: Regime, state: State, k: int) -> bool:
        """Where a motion tends after state i that goes on to state k without end; False: an assumption ends first."""
        segment = self.segment(regime, state)
        ends = self._ends(i, segment, None)
        if ends is not None:
            self.done.ends = ends
            self._done(replace(segment, t1=ends.time))
            return False
        stop = self.course.stops[self.course.states[k].name]
        self.done.tends |= {stop.letters[s]: v for s, v in far_along(segment).items() if s in stop.letters}
        return True

    def _done(self, segment: FollowedSegment) -> None:
        """A segment that is passed."""
        self.done.segments.append(segment)
        for k in range(LOOKS + 1):
            # Between instants that lie next to each other nothing may be told.
            with suppress(NoValue):
                here = segment.at(segment.t0 + (segment.t1 - segment.t0) * k / LOOKS)
                self._pass({s: here[s] for s in segment.regime.letters}, segment.length)

    def _before_given_times(self, i: int, stop: Stop) -> State | None:
        """A state at given times stands anywhere: what never happens after it may have happened before it."""
        index = i + 1
        while i > 0 and fixed_time(self.course.states[i].relations) is not None:
            i -= 1
            segment = self.done.segments[i] if i < len(self.done.segments) else None
            if segment is None or segment.regime is not self.course.regimes[i + 1]:
                return None
            time = self._time_of(index, stop, segment)
            if time is not None and time <= segment.t1:
                return segment.at(time)
        return None

    def _earlier(self, time: float) -> State:
        """A state at a given time that lies before others."""
        for segment in self.done.segments:
            if segment.t0 <= time <= segment.t1:
                return segment.at(time)
        return self.done.segments[0].at(time)

    def segment(self, regime: Regime, state: State) -> FollowedSegment:
        """What one regime makes of a state, as far as it is asked for."""
        t0 = state[regime.time]
        rhs = self._rates(regime)
        numbers = rhs(*(state[s] for s in regime.letters))
        length = length_of(regime, state, numbers, self.value, self.course.scales.length)
        before = max((x.length for x in self.done.segments), default=0.0)
        length = length if length > SLACK * before else before
        flow = self._flow(regime, state, rhs, length)
        swing = swing_of(regime, state, self.value)
        departure = self.course.departure
        swing = swing if departure is None else min(swing, departure.time)
        return FollowedSegment(regime, flow, t0, t0, state, swing, length, self.course.scales.time)

    def _flow(self, regime: Regime, state: State, rhs: Callable[..., list[float]], size: float) -> Flow | None:
        letters = regime.letters[1:]
        if not letters:
            return None
        begin = [state[s] for s in letters]
        breaks = corners(regime, self.value, Decimal(repr(state[regime.time])), latest_given(self.course, self.value))
        floors = [SMALL * (size if c.unit != "rad" else 1.0) for c in regime.coordinates]
        turning = angular_speeds(regime)
        for u, a in zip(regime.free, rhs(*(state[s] for s in regime.letters))[len(floors) :], strict=True):
            floors.append(SMALL * max(abs(state[u]), math.sqrt(abs(a) * (1.0 if u in turning else size))))
        return Flow(lambda t, y: rhs(t, *y), state[regime.time], begin, digits=13, breaks=breaks, floors=floors)

    def _time_of(self, index: int, stop: Stop, segment: FollowedSegment) -> float | None:
        """When a state is reached."""
        stated = fixed_time(self.course.states[index].relations)
        demands = self.course.demands[stop.name]
        equations = [d for d in demands if d.kind == "equation"]
        if stated is not None:
            return given_time(self.course, self.value, stop.name)
        extreme = next((d for d in demands if d.kind == "extreme"), None)
        if extreme is not None and not equations:
            return self._extreme(extreme, segment)
        turning = self.course.modes.turnings.get(stop.name)
        if turning is not None:
            g = self.function(stop.at(turning[0]), stop, segment)
            return next((r.value for r in events(g, segment)), None)
        if not equations:
            return None
        gs = [self.function(d.residual, stop, segment) for d in equations]
        sizes = [self.size(d.residual, stop, segment) for d in equations]
        order = sorted(range(len(gs)), key=lambda k: vanishes_throughout(gs[k], segment, sizes[k]))
        # A limiting case turns back just before one of its relations holds, and passes the others.
        for first in order if len(gs) > 1 else order[:1]:
            for root in itertools.islice(events(gs[first], segment), 60):
                others = [(g, size) for k, (g, size) in enumerate(zip(gs, sizes, strict=True)) if k != first]
                if all(is_zero(g, root.value, segment, size) for g, size in others) and self._allowed(
                    demands, stop, segment, root.value
                ):
                    return root.value
        return None

    def function(self, residual: sp.Expr, stop: Stop, segment: FollowedSegment) -> Callable[[float], float]:
        """A residual of a state as a function of time along a segment."""
        letters = [stop.letters[s] for s in segment.regime.letters]
        f = number_function([residual], letters, self._known(stop, segment))

        def g(t: float) -> float:
            here = segment.at(t)
            return f(*(here[s] for s in segment.regime.letters))[0]

        return g

    def _known(self, stop: Stop, segment: FollowedSegment) -> Valuation:
        """Numbers of everything that does not vary along a segment: states before it, and what rests meanwhile."""
        before = {**self.done.tends, **self.done.values}
        known = self.value.extended({s: Decimal(repr(v)) for s, v in before.items() if math.isfinite(v)})
        others = {s: own for s, own in stop.letters.items() if s not in segment.regime.letters and s in segment.start}
        return known.extended({own: Decimal(repr(segment.start[s])) for s, own in others.items()})

    def size(self, residual: sp.Expr, stop: Stop, segment: FollowedSegment, t: float | None = None) -> float:
        """What a residual of a state is measured by, at a time along a segment."""
        here = segment.at(segment.t0 if t is None else t)
        sizes = self.sizes.by_letter(segment.regime.letters, self.course.ledger.units)
        letters = {stop.letters[s]: here[s] for s in segment.regime.letters}
        by_own = {stop.letters[s]: size for s, size in sizes.items()}
        return measured([residual], letters, by_own, self._known(stop, segment))[0][1]

    def _along(self, expr: sp.Expr, segment: FollowedSegment) -> Callable[[float], float]:
        """A formula of the general position as a function of time along a segment."""
        regime = segment.regime
        f = self._numbers(regime, [expr])

        def g(t: float) -> float:
            here = segment.at(t)
            return f(*(here[s] for s in regime.letters))[0]

        return g

    def _allowed(self, demands: Sequence[Demand], stop: Stop, segment: FollowedSegment, t: float) -> bool:
        for d in demands:
            expr = d.residual if d.kind == "inequality" else d.trend
            if expr is None:
                continue
            if self.function(expr, stop, segment)(t) < -SLACK * self.size(expr, stop, segment, t):
                return False
        return True

    def _extreme(self, demand: Demand, segment: FollowedSegment) -> float | None:
        """The first of the largest (smallest) of the next stationary values; where they grow and grow, the first."""
        regime = segment.regime
        found = list(
            itertools.islice(events(self._along(regime.derivative(demand.residual), segment), segment), CHOICES)
        )
        height = self._along(demand.residual, segment)
        best: float | None = None
        for root in found:
            v = demand.extreme * height(root.value)
            if best is None or v > demand.extreme * height(best) + SLACK * abs(v):
                best = root.value
        tops = [r.value for r in found if height(r.value) * demand.extreme > height(segment.t0) * demand.extreme]
        if len(found) == CHOICES and best in [r.value for r in found[-2:]] and len(tops) > 1:
            self.done.growing.append(demand.text)
            return tops[0]
        return best

    # --- what ends ---------------------------------------------------------------------------------------------------

    def _ends(self, i: int, segment: FollowedSegment, time: float | None) -> Ends | None:
        """The first assumption that fails before `time`."""
        regime = segment.regime
        watched = [(w.expr, w.test.words) for w in regime.watches]
        watched += [(s, "it stops sliding") for s in regime.slips]
        watched += [(sign * u, "it turns round") for u, sign in regime.going().items()]
        watched += [(e, "it comes to the other side") for _, e in regime.sided.values()]
        best: Ends | None = None
        until = time
        for expr, words in watched:
            g = self._along(expr, segment)
            if expr.is_number or not (expr.free_symbols & set(regime.letters)):
                continue
            if until is not None and until <= segment.t0:
                continue
            for root in itertools.islice(events(g, segment, until), 20):
                crossing = root.kind == "crossing" and (root.sense < 0 or expr in regime.free)
                before = until is None or root.value < until - SLACK * (until - segment.t0)
                if crossing and before and not self._just_then(i, segment, time, root.value):
                    best = Ends(i, root.value, expr, words)
                    until = root.value
                    break
        for expr, words in openings(self.course, i, regime):
            met = closing(self._along(expr, segment), segment, until)
            if met is not None and (until is None or met < until - SLACK * (until - segment.t0)):
                best, until = Ends(i, met, expr, words, again=True), met
        return best

    def _just_then(self, i: int, segment: FollowedSegment, time: float | None, t: float) -> bool:
        """Does what ends at t end in the very state that is reached at `time`? Where both are only touched, machine
        numbers do not tell which is first.
        """
        if time is None or time - t > TOGETHER * (time - segment.t0):
            return False
        stop = self.course.stops[self.course.states[i + 1].name]
        equations = [d.residual for d in self.course.demands[stop.name] if d.kind == "equation"]
        sizes = [self.size(e, stop, segment, t) for e in equations]
        pairs = zip(equations, sizes, strict=True)
        return bool(equations) and all(is_zero(self.function(e, stop, segment), t, segment, size) for e, size in pairs)
