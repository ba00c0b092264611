"""A motion followed from its start: regimes integrated until a guard falls, and what happens then.

Nothing here loops without bound: impacts are counted, sequences of them that end in a finite time are summed up, what
changes at one instant without end is told, and an integrator that can not go on says where.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import field, replace

from planar_cli.integrators.base import Counts, Setting, Step, StepTooSmall, TooManySteps
from planar_cli.motion.follow import endings
from planar_cli.motion.follow.transition import Moment, Resolved, grazing, resolve, turnings
from planar_cli.motion.follow.unstable import growth_note
from planar_cli.motion.follow.waiting import Waiting, at_edge, beyond, fits, meant, telling_of, watch_of
from planar_cli.motion.follow.zeno import Bounces, at_rest, summed_up
from planar_cli.motion.regime.guards import AGAIN, LENGTH
from planar_cli.motion.regime.stops import ENDS, stopped
from planar_cli.motion.terms.crossings import band_at
from planar_cli.motion.terms.source import Singular
from planar_cli.motion.trajectory.automaton import Automaton, Choice, Guard, Regime, Stages, Start
from planar_cli.motion.trajectory.balance import ALLOWED, balance_of
from planar_cli.motion.trajectory.drive import AUTOMATIC, Run, drive
from planar_cli.motion.trajectory.recurrence import Recurrence, Recurrences
from planar_cli.motion.trajectory.schedule import Event, Schedule
from planar_cli.motion.trajectory.segment import Segment
from planar_cli.motion.trajectory.trajectory import Outcome, Trajectory, Transition, Work
from planar_cli.records import changing

RESTING = 1e-12
"""Rates below this part of their scale are zero."""
MOST_IMPACTS = 100_000
"""More impacts or changes of mode than that are refused."""
MOST_AT_ONCE = 20
"""So many changes of mode may follow each other at one instant."""
LEAST_ALLOWED = 1e-7
"""Balances of energy are asked for to this part of their scale at most."""
NOISE, LOUDEST, ROUNDING = 300.0, 1e-3, 1e-12
"""What tells a state is known to so many tolerances, and at any tolerance to this part of its scale."""
UNSTEADY_STEPS = 256
"""At rest under loads that vary in time, the time is cut at least into so many steps."""

Progress = Callable[[float], None]
"""Called with the time that has been reached [s]."""


@changing
class Follower:
    """One run; `trajectory` is what it finds."""

    stages: Stages
    start: Start
    schedule: Schedule
    until: float
    setting: Setting
    """Tolerance and steps; its scale is that of the scene."""
    kind: str = AUTOMATIC
    """The integrator, by the name of its member, or the choice by the scene."""
    progress: Progress | None = None
    rest_ends: bool = True
    """May the run end early where nothing will ever move again, or nothing new happens?"""
    check: bool = True
    """Is a balance that does not add up a failure?"""
    momenta: bool = False
    """Is the balance of momentum looked at over every segment too? It costs as much as the motion."""
    balanced: bool = True
    """Are balances looked at?"""

    t: float = 0.0
    y: tuple[float, ...] = ()
    choice: Choice = ()
    automaton: Automaton = field(init=False)
    segments: list[Segment] = field(default_factory=list)
    transitions: list[Transition] = field(default_factory=list)
    waiting: Waiting = field(init=False)
    bounces: Bounces = field(default_factory=Bounces)
    recurrences: Recurrences = field(default_factory=Recurrences)
    returning: Recurrence | None = None
    """What looks whether the motion repeats itself, since anything happened last."""
    resting_at: float | None = None
    """When the sequence of impacts ends that is being summed up."""
    at_once: int = 0
    work: Work = field(default_factory=Work)
    notes: list[str] = field(default_factory=list)
    outcome: Outcome | None = None
    open_now: tuple[str, str] | None = None
    """An impact that leaves open how its partners go on from here, and in words what."""

    def trajectory(self) -> Trajectory:
        """Follow the motion to its end."""
        self._begin()
        while self.outcome is None:
            self._advance()
        return Trajectory(
            endings.as_presumed(self.segments, self.outcome),
            tuple(self.transitions),
            tuple(self.waiting.reached),
            tuple(e.name for e in self.waiting.left()),
            self.outcome,
            self.work,
            tuple(dict.fromkeys(self.notes)),
        )

    # --- beginning ---------------------------------------------------------------------------------------------------

    def _begin(self) -> None:
        self.automaton = self.stages.automaton((self.schedule.start,))
        self.t, self.y, self.notes = self.start.t, self.start.y, [*self.start.assumed]
        self.choice = self.start.choice or (0,) * len(self.automaton.choices)
        self.waiting = Waiting(self.schedule, self.t)
        if not self._blow(self.schedule.start) and self.outcome is None:
            self._settle("the motion begins")
        if self.outcome is None:
            self._determined(self.y)

    def _determined(self, y: Sequence[float]) -> bool:
        """Do forces tell how everything moves from here, also where it has come to the state `y`?"""
        loose = self.automaton.undetermined(self.choice, self.t, y)
        self.outcome = endings.undetermined_at(loose, self.t) if loose else None
        return not loose

    def _blow(self, state: str) -> bool:
        """What strikes, takes hold or lets go when a state has been reached; False where nothing does."""
        follower = self.waiting.just_after(state)
        changed = self._act(self.waiting.names, follower.name if follower is not None else "")
        if follower is None or self.outcome is not None:
            if changed and self.outcome is None:
                corner = self.stages.corner(self.waiting.names, self.choice, self.t, self.y)
                self.transitions += turnings(corner, self.t, self.y, self.choice)
                self.y = self.y if corner is None else corner.after
                self._settle(f"the state {state}", striking=True)
            return changed
        applied = self.stages.applied(follower.name, self.t, self.y)
        drawn = not (self.segments or changed or applied)
        self._settle(f"the state {follower.name}", applied=applied, striking=True, blow=True, drawn=drawn)
        if self.outcome is not None:
            return True
        if drawn and self.transitions:
            self.open_now = self.automaton.drawn_apart(self.t, self.y, self.transitions[-1].joints)
        self.waiting.arrive(follower, self.t, self.y, self.choice, len(self.segments))
        if not self._blow(follower.name):
            self._settle(f"after the state {follower.name}")
        self._finish()
        return True

    def _act(self, reached: Sequence[str], striking: str) -> bool:
        """Let act what acts once these states are reached (`striking`: see the stages); True where that changes."""
        automaton = self.stages.automaton(reached, striking)
        if automaton is self.automaton:
            return False
        old = dict(zip(self.automaton.choices, self.choice, strict=True))
        self.choice = tuple(old.get(joint, 0) for joint in automaton.choices)
        self.automaton = automaton
        self.open_now = automaton.drawn_apart(self.t, self.y)
        self.outcome = endings.begun_apart(self.stages.apart(reached, self.t, self.y), self.t)
        return True

    # --- one segment -------------------------------------------------------------------------------------------------

    def _advance(self) -> None:
        """One regime until it ends, and what happens then."""
        if self.t >= self.until:
            self.outcome = Outcome("until", f"the time is over at t = {self.t:.9g} s{self.waiting.wanting}", self.t)
            return
        if self._unclear(self.open_now):
            return
        regime = self.automaton.regime(self.choice)
        changed = bool(self.transitions) and self.transitions[-1].t == self.t
        reached = self.waiting.already(regime, self.choice, self.t, self.y) if changed else None
        if reached is not None:
            self._reach(reached)
            return
        taken: list[Step] = []
        end = self._end()
        try:
            if self._rests(regime) and self.automaton.autonomous:
                lasts = self.resting_at is None
                still = self.waiting.at_rest(regime, self.choice, self.t, self.y) if lasts else None
                if still is not None:
                    self._reach(still)
                else:
                    self._stay(regime, end)
                return
            run = self._run(regime, end, taken)
        except (StepTooSmall, Singular) as stuck:
            if taken:
                self._close(regime, taken[-1].t1, tuple(taken[-1].y1), taken)
            self.outcome = endings.stuck_at(stuck, self.t)
            return
        if self._determined(run.y1):
            self._close(regime, run.t1, tuple(run.y1), run.steps)
        if self.outcome is not None or self._unclear(None):
            return
        period = self.returning.period if self.returning is not None else None
        if self.outcome is None and (run.crossings or period is None):
            self._ended(regime, run)
        if self.outcome is None and self.returning is not None and period is not None:
            self.outcome = endings.repeats_every(period, self.t)

    def _unclear(self, drawn_apart: tuple[str, str] | None) -> bool:
        """Does an impact leave open how its partners go on?"""
        found = drawn_apart or self.automaton.sliding_points(self.choice, self.t, self.y)
        if found is not None:
            self.outcome = endings.open_after(found, self.t)
        return found is not None

    def _run(self, regime: Regime, end: float, taken: list[Step]) -> Run:
        """The regime followed to `end`, or to the first guard that falls or relation of a state that is reached."""
        left = self.setting.most_steps - self.work.steps
        if left <= 0:
            raise TooManySteps(f"more than {self.setting.most_steps} steps until t = {self.t:.9g} s", self.t, self.y)
        setting = replace(self.setting, scale=self.automaton.scale, project=regime.project, most_steps=left)
        if not self.automaton.autonomous and self._rests(regime):
            setting = replace(setting, longest=min(setting.longest, (end - self.t) / UNSTEADY_STEPS))

        def seen(step: Step) -> bool:
            taken.append(step)
            # What is watched within the step counts from its beginning: what slides may turn round in it.
            self.automaton.note(step.t0, step.y0, step)
            if self.progress is not None:
                self.progress(step.t1)
            if returns is not None:
                returns.passes(step)
            return returns is not None and returns.period is not None

        counts, returns = Counts(), self._returns(regime, end)
        try:
            run = drive(
                regime.rates,
                self.t,
                self.y,
                end,
                setting,
                kind=self.kind,
                watch=watch_of(regime, self.choice, self.waiting.next()),
                breakpoints=self.schedule.breakpoints,
                band=band_at(regime.watch(self.t, self.y), [g.scale for g in regime.guards]),
                on_step=seen,
                counts=counts,
                reduced=regime.reduced(self.t, self.y),
            )
        finally:
            self.work = self.work.more(counts)
        self.notes += [] if run.changed is None else [run.changed.words]
        return run

    def _returns(self, regime: Regime, end: float) -> Recurrence | None:
        """What looks whether the motion repeats itself, where it may end with that."""
        if not self.rest_ends or end != self.until or not self.automaton.autonomous or not self.waiting.next():
            return None
        if self.returning is None:
            watch, here = watch_of(regime, self.choice, self.waiting.next()), (self.choice, self.waiting.names)
            self.returning = self.recurrences.at(here, regime.rates, self.t, self.y, self.automaton.scale, watch)
        return self.returning

    def _end(self) -> float:
        """The latest time of this segment: the end, or the next time that is known beforehand."""
        known = [self.until, *self.schedule.breakpoints, *self.waiting.times(self.t, self.automaton.time_scale)]
        if self.resting_at is not None:
            known.append(self.resting_at)
        return min(t for t in known if t > self.t or t == self.until)

    def _rests(self, regime: Regime) -> bool:
        """Do neither places nor velocities change now?"""
        rates, scene = regime.rates(self.t, self.y), self.automaton
        return all(abs(r) * scene.time_scale <= RESTING * s for r, s in zip(rates, scene.scale, strict=True))

    def _stay(self, regime: Regime, end: float) -> None:
        """At rest with nothing that varies in time: the state stays as it is, exactly."""
        self.notes += filter(None, [growth_note(self.automaton, regime, self.t, self.y)])
        if self.rest_ends and end == self.until:
            rest = Outcome("rest", f"nothing moves any more from t = {self.t:.9g} s", self.t)
            self._close(regime, self.until, self.y, ())
            self.outcome = rest
            return
        self._close(regime, end, self.y, ())
        self._timed()

    def _close(self, regime: Regime, end: float, y: tuple[float, ...], steps: Sequence[Step]) -> None:
        """The segment that ends here."""
        if end > self.t:
            scene = self.automaton
            outside = scene.outside(self.choice) if self.momenta else None
            what = regime, self.t, self.y, end, y, steps, scene.energy_scale, scene.note, outside
            balance = balance_of(*what) if self.balanced else None
            segment = Segment(self.choice, regime, self.t, end, self.y, y, tuple(steps), balance)
            self.segments.append(segment)
            self.at_once = 0
            allowed = max(ALLOWED * self.setting.tolerance, LEAST_ALLOWED) if self.check else math.inf
            self.outcome = endings.not_as_presumed(segment) or endings.unbalanced(segment, allowed)
        self.t, self.y = end, y

    # --- what ends a segment -----------------------------------------------------------------------------------------

    def _ended(self, regime: Regime, run: Run) -> None:
        """What ended the run: guards, the next state, or the time."""
        number = len(regime.guards)
        fallen = [c.index for c in run.crossings if c.index < number and c.way == "falls"]
        guards = [regime.guards[i] for i in fallen]
        told = telling_of(self.waiting.next())
        grazed = [c.index for c in run.crossings if c.index < number and c.way == "grazes"]
        if (last := next((g for i in (*fallen, *grazed) if (g := regime.guards[i]).kind == LENGTH), None)) is not None:
            self.outcome = endings.spent(last, self.t)
            return
        for guard in (regime.guards[i] for i in grazed if regime.guards[i].kind == "gap"):
            self.transitions.append(grazing(guard.joint, self.t, self.y, self.choice))
        for crossing in (c for c in run.crossings if c.index >= number):
            event, telling = told[crossing.index - number]
            if event in self.waiting.next() and meant(telling, crossing.way):
                noise = min(max(NOISE * self.setting.tolerance, ROUNDING), LOUDEST), self.automaton.time_scale
                real = self.waiting.counts(event, telling, regime, self.choice, run, *noise)
                if real and fits(event, regime, self.choice, self.t, self.y):
                    self._reach(event)
                elif run.t1 == run.t0 and not fallen:
                    self.t, self.y = beyond(regime, self.t, self.y, self.automaton.time_scale)
        if self.outcome is None and (not run.crossings or any(g.kind in ENDS for g in guards)):
            for event in [e for e, c in told if c is e.crossing and e in self.waiting.next()]:
                if at_edge(event, regime, self.choice, run, self.setting.tolerance):
                    self._reach(event)
        again = next((g for g in guards if g.kind == AGAIN), None)
        if self.outcome is None and again is not None and self.automaton.regime(self.choice) is regime:
            self.outcome = endings.spent(again, self.t)  # nothing strikes there, and the motion is to go on
        if self.outcome is None and fallen and not self._stops(regime, guards):
            words = ", ".join(dict.fromkeys(f"no longer: {g.words}" for g in guards))
            # What parts and falls back within rounding does not part.
            self._settle(words, guards[0].joint, inelastic=run.t1 == run.t0)
        elif self.outcome is None and not run.crossings:
            self._timed()

    def _stops(self, regime: Regime, guards: Sequence[Guard]) -> bool:
        """Has a resistance brought the scene to rest, and is it known how that goes on?"""
        stop = stopped(self.automaton, regime, guards, self.t, self.y)
        if isinstance(stop, Outcome):
            self.outcome = stop
        elif stop is not None:
            self.y = stop
            self.automaton.note(self.t, self.y)
        return stop is not None

    def _reach(self, event: Event) -> None:
        """A state has been reached."""
        self.returning = None
        self.waiting.arrive(event, self.t, self.y, self.choice, len(self.segments))
        self._blow(event.name)
        self._finish()

    def _finish(self) -> None:
        """Is it over, as the last state has been reached?"""
        if self.outcome is None and self.waiting.done:
            self.outcome = Outcome("reached", f"the last state is reached at t = {self.t:.9g} s", self.t)

    def _timed(self) -> None:
        """A time that was known beforehand has come."""
        if self.resting_at is not None and self.t >= self.resting_at:
            self.resting_at = None
            self.transitions.append(at_rest(self.transitions, self.t, self.y, self.choice))
        for event in self.waiting.due(self.t):
            self._reach(event)
        if self.outcome is None:
            tends = self.waiting.settles(self.automaton, self.segments, self.setting.tolerance)
            if tends is not None:
                self._reach(tends)
        if self.outcome is None and self.t < self.until:
            self._settle("what acts has changed")

    def _settle(
        self,
        words: str,
        joint: str = "",
        applied: Mapping[str, tuple[float, ...]] | None = None,
        striking: bool = False,
        inelastic: bool = False,
        blow: bool = False,
        drawn: bool = False,
    ) -> None:
        """Impacts and the choice of modes at this instant; `blow`: what the file puts between two states. `drawn`:
        nothing but impacts makes it one, and no motion led there.
        """
        self.at_once, self.returning = self.at_once + 1, None
        if self.at_once > MOST_AT_ONCE or len(self.transitions) > MOST_IMPACTS:
            self.outcome = endings.endless(words, joint, self.t)
            return
        moment = Moment(self.automaton, self.t, self.y, self.choice, words, self.setting.tolerance, lasting=not blow)
        moment = replace(moment, inelastic=inelastic, striking=striking or inelastic)
        moment = replace(moment, applied=applied or {}, forced=blow, drawn=drawn)
        found = resolve(moment)
        if isinstance(found, Resolved):
            found, ends = summed_up(self.bounces, moment, found)
            self.resting_at = self.resting_at if ends is None else ends
        if isinstance(found, Outcome):
            self.outcome = found
            return
        self.choice, self.y = found.choice, found.state
        self.transitions += found.transitions
        self.notes += found.notes
        self.work = replace(self.work, choices=self.work.choices + found.tried)
        if (event := self.waiting.by_modes(self.automaton, self.choice, self.t, self.y)) is not None:
            self._reach(event)
