"""A course read off the motion that was followed: where each state is, and which assumption ends before it.

What is followed decides which regime acts when (slip, stick, slack, which way), the order of states, and which of
several roots happens; the equations of the motion then give the same values in closed form where there is one.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.scales import Here, Sizes, measured
from planar_cli.errors import NoValue
from planar_cli.problem.scene.scene import Problem
from planar_cli.solve.between.branches.apart import TOUCHES, demand_together
from planar_cli.solve.between.equations.given_times import asked_without_end, without_end
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.between.roots.events import LOOKS, FollowedSegment, State, length_of
from planar_cli.solve.between.roots.followed import Followed
from planar_cli.solve.diagnosis.left_open import demand_told, spent
from planar_cli.solve.following.ends import TOGETHER, EndSearch, is_put_in
from planar_cli.solve.following.letters import Letters
from planar_cli.solve.following.passage_times import by_formula, steady_time
from planar_cli.solve.following.traced import SOON, Traced, traced
from planar_cli.solve.impulsive.impact import Stroke
from planar_cli.solve.regimes.after import asked_after
from planar_cli.solve.regimes.directions import ways_at
from planar_cli.solve.regimes.mode_sequence import fixed_time
from planar_cli.solve.regimes.regime import Regime, number_function
from planar_cli.solve.regimes.timeline import Demand, Stop


class Follower:
    """Reads one course. `value`: numbers of everything that does not vary. `until`: so many stretches; None: all.
    `seen`: the motion, where it is known already. `by`: it is not followed beyond this time [s].
    """

    def __init__(
        self,
        course: StatedMotion,
        value: Valuation,
        until: int | None = None,
        seen: Traced | None = None,
        by: float = math.inf,
    ) -> None:
        self.course, self.value, self.until, self.seen, self.by = course, value, until, seen, by
        self.done = Followed()
        self.sizes = Sizes(course.scales, 0.0)
        self.units = course.ledger.units
        self.readers: dict[int, Letters] = {}
        self.begun: State = {}
        """The letters with which the present stretch begins."""

    def run(self, start: Mapping[sp.Symbol, float]) -> Followed:
        """From the letters of the first state, by the letters of the general position."""
        course, done = self.course, self.done
        found = self.seen or traced(course, self._problem(), self.value, start, self.by)
        if isinstance(found, str):
            done.lost = found
            return done
        self.motion, done.run, done.foreseen = found, found.run, self.seen is not None
        state: State = dict(start)
        self._record(course.first, state, course.regimes[0])
        try:
            self._walk(state)
        except NoValue as error:
            done.lost = str(error)
        for regime in course.distinct_regimes() if done.segments else ():
            ordinary = course.natural(regime.letters)
            sizes = self.sizes.by_letter(regime.letters, self.units)
            done.sizes |= {s: size or float(ordinary[s]) for s, size in sizes.items()}
        return done

    def _problem(self) -> Problem:
        """The problem as far as it is followed."""
        problem = self.course.problem
        if self.until is None:
            return problem
        names = {s.name for s in self.course.states[: self.until + 1]}
        return replace(problem, states=tuple(s for s in problem.states if s.name in names))

    def _walk(self, state: State) -> None:
        course, done = self.course, self.done
        for i, regime in enumerate(course.regimes):
            if i + 1 >= len(course.states) or i == self.until:
                break
            done.at = state
            if i in course.blows:
                struck = self._blow(i, state)
                if struck is None:
                    return
                state = struck
                continue
            if not self._begins(i, regime, state):
                return
            if course.is_dated(i):
                done.dated = i
                return
            reached = self._stretch(i, regime)
            if reached is None:
                return
            state = reached
        done.at = state
        self._onward(state)

    def _begins(self, i: int, regime: Regime, state: State) -> bool:
        """As `_fits`; of a state that the beginning of these modes tells nothing that follows it needs a value: what is
        about to slide in a plane has no direction of sliding yet.
        """
        try:
            return self._fits(i, regime, state)
        except NoValue:
            if not self.course.is_dated(i):
                raise
            return True

    def _onward(self, state: State) -> None:
        """What follows the last state, as far as something is asked of it."""
        course = self.course
        last = len(course.states) - 1
        if last > 0 and without_end(course, last):
            return
        if last > 0 and course.beyond is not None and asked_after(course.problem, course.states[last].name):
            self._fits(last, course.beyond, state)
        elif last == 0:
            self.begun = state
            self.done.onward = self._segment(course.regimes[0], math.inf)

    # --- blows -------------------------------------------------------------------------------------------------------

    def _blow(self, i: int, state: State) -> State | None:
        """The state just after a blow; None: its modes do not hold."""
        done, blow, name = self.done, self.course.blows[i], self.course.states[i + 1].name
        stroke = self._struck(i, state)
        done.far[i] = stroke.far
        if stroke.objection:
            done.blow, done.why = i, stroke.objection
            return None
        if stroke.misfit:
            done.misfit, done.why = i + 1, stroke.misfit
            return None
        done.values |= stroke.own
        self._record(self.course.stops[name], stroke.after, blow.after)
        return dict(stroke.after)

    def _struck(self, i: int, state: State) -> Stroke:
        """What comes of the blow between state i and the next."""
        blow = self.course.blows[i]
        self._here(blow.before, state)
        state = blow.placed(state, self.done.values)
        here, near = blow.arrived(state, self.value), TOUCHES * self.sizes.length
        demand_together(self.course, i, here, near)
        return blow.strike(state, here, near, self.value)

    # --- where a stretch begins --------------------------------------------------------------------------------------

    def _fits(self, i: int, regime: Regime, before: State) -> bool:
        """Are the modes of a regime those that follow state i, and do things go its way?"""
        done = self.done
        begins = self._start_of(i)
        if begins is None:
            demand_told(self.course.problem, self.motion.run.trajectory.outcome)
            done.lost = self.motion.run.trajectory.outcome.words or "what follows is not told"
            return False
        _, choice, _ = begins
        if choice != self.course.modes.stretch(i).choice:
            done.misfit, done.choice = i, choice
            return False
        self.begun = self._begin(regime, begins, before)
        turned = self._letters(regime).turned_round(begins[2], self.begun)
        done.ways = ways_at(regime, self._here(regime, self.begun)) | turned
        done.misfit = i if done.ways else None
        return done.misfit is None

    def _start_of(self, i: int) -> tuple[float, tuple[int, ...], tuple[float, ...]] | None:
        """When stretch i begins, its modes, and the state of the scene."""
        course, t = self.course, self.times(i)
        found = self.motion.begins(t, course.scales.time)
        if found is None:
            return None
        return t, self.motion.choice(course.workshop, course.modes.stretch(i), found[0]), found[1]

    def times(self, i: int) -> float:
        """When state i is [s]; of one that is only approached, when the state before it is."""
        while without_end(self.course, i):
            i -= 1
        return self.done.values[self.course.stops[self.course.states[i].name].t]

    def _begin(self, regime: Regime, begins: tuple[float, tuple[int, ...], tuple[float, ...]], before: State) -> State:
        """The letters of a regime where it takes over."""
        t, _, y = begins
        near = dict(before)
        for c in regime.coordinates:
            if c.symbol not in near:
                near[c.symbol] = float(self.value(c.drawn)) if c.drawn is not None else 0.0
        lost = self.course.first.speeds.union(self.course.transfers[id(regime)])
        kept = {s: v for s, v in near.items() if s in regime.letters or s not in lost}
        letters = self._letters(regime)
        begun = {**kept, **letters.at(t, y, near)}
        letters.count(t, y, begun)
        return begun

    def _letters(self, regime: Regime) -> Letters:
        if id(regime) not in self.readers:
            self.readers[id(regime)] = Letters(regime, self.motion.run.model, self.value)
        return self.readers[id(regime)]

    def _here(self, regime: Regime, state: State) -> Here:
        """A state in the letters of a regime, measured by what the motion has shown so far."""
        still = [0.0] * (len(regime.letters) - 1)
        exprs = [*regime.rates.values(), *regime.accelerations.values()]
        numbers = self._numbers(regime, exprs)(*(state[s] for s in regime.letters)) if regime.runs else still
        length = length_of(regime, state, numbers, self.value, self.course.scales.length)
        self.sizes = self.sizes.passing(state, self.units, length)
        sizes = self.sizes.by_letter(self.course.first.letters, self.units)
        return Here({s: state[s] for s in regime.letters}, sizes, self.value)

    def _numbers(self, regime: Regime, exprs: list[sp.Expr]) -> Callable[..., list[float]]:
        return number_function(exprs, regime.letters, self.value)

    # --- one stretch -------------------------------------------------------------------------------------------------

    def _stretch(self, i: int, regime: Regime) -> State | None:
        """The next state, or None: something else comes first, or nothing does."""
        course, done, since = self.course, self.done, self.begun[regime.time]
        state = course.states[i + 1]
        segment = self._segment(regime, math.inf)
        until = self._next_of_file(i)
        exact = None if is_put_in(course, i + 1) else self._exactly(i + 1, segment, until)
        near = exact is not None and math.isfinite(until) and abs(exact[0] - until) <= TOGETHER * abs(until - since)
        until = until if exact is None or near else exact[0]
        search = EndSearch(course, self.motion, self.value)
        ends = search.find(i, segment, until, self.sizes)
        done.lost, done.struck = search.lost, search.struck
        put_in = is_put_in(course, i + 1)
        if put_in and ends is None:
            done.lost = done.lost or f"what was to end before the state after {course.states[i].name} does not"
        if done.lost or done.struck is not None or (ends is not None and not put_in):
            done.ends = None if done.lost or done.struck is not None else ends
            self._passed(segment, since if ends is None else ends.time)
            return None
        until = ends.time if ends is not None else until
        self._tend(i, segment)
        if without_end(course, i + 1):
            self._passed(segment, max(since, self.motion.end))
            return dict(self.begun)
        if math.isinf(until) and self.motion.refused:
            demand_told(self.course.problem, self.motion.run.trajectory.outcome)
            done.lost = self.motion.run.trajectory.outcome.words
            done.spent = spent(self.course.problem, self.motion.run.trajectory.outcome)
            return None
        if math.isinf(until):
            done.missed, done.onward = state.name, segment
            return None
        self._passed(segment, max(until, since), state.name)
        there = segment.at(until) if until >= since else self._earlier(until)
        there = there if exact is None else {**there, **exact[1]}
        self._record(course.stops[state.name], there, regime)
        return there

    def _exactly(self, i: int, segment: FollowedSegment, until: float) -> tuple[float, State] | None:
        """When state i is, and its letters, by a formula that tells whether a place is just touched or just missed;
        None: none tells.
        """
        stop = self.course.stops[self.course.states[i].name]
        if fixed_time(stop.relations) is not None or not isinstance(self.course, MotionEquations):
            return None
        told = steady_time(self.course, stop, segment)
        there = by_formula(self.course, stop, segment) if told is None and math.isinf(until) else told and told[0]
        if there is None:
            return None if told is None else (math.inf, {})
        return there[segment.regime.time], there

    def _segment(self, regime: Regime, until: float) -> FollowedSegment:
        """What begins now."""
        since, scales = self.begun[regime.time], self.course.scales
        pieces = self.motion.pieces(since + SOON * scales.time, math.inf)
        length = self.sizes.length or scales.length
        letters = self._letters(regime)
        return FollowedSegment(regime, letters, pieces, since, until, self.begun, self.value, length, scales.time)

    def _passed(self, segment: FollowedSegment, until: float, reaches: str = "") -> None:
        """A segment that is passed, up to this time and perhaps this state."""
        self.done.segments.append(replace(segment, t1=until, reaches=reaches))
        for k in range(LOOKS + 1) if segment.regime.letters[1:] else ():
            here = segment.at(segment.t0 + (until - segment.t0) * k / LOOKS)
            self.sizes = self.sizes.passing({s: here[s] for s in segment.regime.letters}, self.units, segment.length)

    def _next_of_file(self, i: int) -> float:
        """When the next state of the file after state i is [s]; infinite: it is not reached."""
        following = (k for k in range(i + 1, len(self.course.states)) if not is_put_in(self.course, k))
        moment = self.motion.moment(self.course.states[next(following)].name)
        return math.inf if moment is None or not self._acts(i, moment.t) else moment.t

    def _acts(self, i: int, until: float) -> bool:
        """Does what acts from state i on act up to a time? A later state at a given time may have ended it before."""
        stages, own = self.motion.run.prepared.stages, {s.name for s in self.course.problem.states}
        listed = tuple(s.name for s in self.course.states[: i + 1] if s.name in own)
        since = self.begun[self.course.first.time] + SOON * self.course.scales.time
        acting = (stages.automaton(self.motion.reached(p.t0)) for p in self.motion.pieces(since, until))
        return all(automaton is stages.automaton(listed) for automaton in acting)

    def _tend(self, i: int, segment: FollowedSegment) -> None:
        """Where states are that the motion after state i only approaches."""
        for k in asked_without_end(self.course, i + 1):
            stop = self.course.stops[self.course.states[k].name]
            moment = self.motion.moment(stop.name)
            far = segment.at(self.motion.end if moment is None else moment.t)
            self.done.tends |= {stop.letters[s]: v for s, v in far.items() if s in stop.letters}

    def _earlier(self, time: float) -> State:
        """A state at a given time that lies before others."""
        for segment in self.done.segments:
            if segment.t0 <= time <= segment.t1:
                return segment.at(time)
        return self.done.segments[0].at(time)

    def _record(self, stop: Stop, state: State, regime: Regime) -> None:
        """A state that is reached, also in the letters of other regimes."""
        for letter, own in stop.letters.items():
            if letter in state:
                self.done.values[own] = state[letter]
        if all(s in state for s in regime.letters):
            for letter, expr in self.course.transfer(regime).items():
                self.done.values[stop.letters[letter]] = self._numbers(regime, [regime.closed(expr)])(
                    *(state[s] for s in regime.letters)
                )[0]

    # --- formulas along a stretch ------------------------------------------------------------------------------------

    def size(self, expr: sp.Expr, stop: Stop, segment: FollowedSegment, t: float) -> float:
        """What a formula of a state is measured by, at a time along a segment."""
        here = segment.at(t)
        sizes = self.sizes.by_letter(segment.regime.letters, self.units)
        letters = {stop.letters[s]: here[s] for s in segment.regime.letters}
        by_own = {stop.letters[s]: size for s, size in sizes.items()}
        return measured([expr], letters, by_own, self._known())[0][1]

    def _known(self) -> Valuation:
        """Numbers of everything that does not vary along a segment: also of states before it."""
        before = {**self.done.tends, **self.done.values}
        return self.value.extended({s: Decimal(repr(v)) for s, v in before.items() if math.isfinite(v)})

    @staticmethod
    def can_read(demands: Sequence[Demand], stop: Stop, segment: FollowedSegment) -> bool:
        """Are all coordinates of a state that these relations hold among those of a segment?"""
        absent = set(stop.letters.values()) - {stop.letters[s] for s in segment.regime.letters}
        return all(absent.isdisjoint(d.residual.free_symbols) for d in demands)

    def along(self, expr: sp.Expr, stop: Stop, segment: FollowedSegment) -> Callable[[float], float]:
        """A formula of a state as a function of time along a segment."""
        letters = [stop.letters[s] for s in segment.regime.letters]
        f = number_function([expr], letters, self._known())

        def g(t: float) -> float:
            here = segment.at(t)
            return f(*(here[s] for s in segment.regime.letters))[0]

        return g
