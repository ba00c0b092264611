"""A problem simulated: its scene followed from its first state, and what the file asks answered from that.

    Problem -> MovingScene -> Model -> Trajectory -> answers

The run is made twice, the second time with a tighter tolerance: how far the two are apart estimates the error of what
has come of all steps (motion/follow/estimate.py).
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping, Sequence, Set
from dataclasses import field, replace
from types import MappingProxyType

from planar_cli.errors import Diagnostic, FileProblem, Mark, NoSolution
from planar_cli.integrators.base import MOST_STEPS, Setting
from planar_cli.motion.follow.estimate import by_halving, shifts, tighter
from planar_cli.motion.follow.follow import Follower
from planar_cli.motion.follow.stages import SceneStages, stages_of
from planar_cli.motion.follow.transition import Moment as Instant
from planar_cli.motion.follow.transition import Resolved, resolve
from planar_cli.motion.regime.model import Model
from planar_cli.motion.regime.regime import Regime
from planar_cli.motion.trajectory.automaton import Start
from planar_cli.motion.trajectory.drive import AUTOMATIC, order_of
from planar_cli.motion.trajectory.schedule import Event, Reached, Schedule
from planar_cli.motion.trajectory.trajectory import Trajectory
from planar_cli.problem.implied.static_alone import demand_kinetic
from planar_cli.problem.language.expression import Quantity, Relation, Side
from planar_cli.problem.scene.scene import Answer, Problem
from planar_cli.records import record
from planar_cli.simulate.agreement import demand_agreement
from planar_cli.simulate.answers import Answered, Answers
from planar_cli.simulate.balanced import with_balanced
from planar_cli.simulate.foretold import demand_unchanged, spoken_before
from planar_cli.simulate.measures import START, Measures, Moment, modes_of, moments_of
from planar_cli.simulate.since import Later, Since
from planar_cli.simulate.stops import first_stop
from planar_cli.simulate.timetable import breakpoints_of, schedule_of
from planar_cli.simulate.unbounded import begins_unbounded, departing

TOLERANCE = 1e-9
USUAL: Mapping[str, str] = MappingProxyType({})
"""Every find in the usual unit of its kind."""
FREE_TIMES, SEARCHED_TIMES = 20.0, 2000.0
"""Without an end a scene is followed for so many of its characteristic times; to find a state, for so many at most."""
FREE_STEPS = 3000
"""Without an end so many steps are enough, too."""
BEGINNING = 1e-6
"""So many characteristic times are the first moments."""
ROUND = (1.0, 2.0, 5.0, 10.0)


@record
class Settings:
    """How to simulate."""

    until: float | None = None
    """The end of the motion [s]; None: the last state of the file, else some characteristic times."""
    tolerance: float = TOLERANCE
    """Of one step, in parts of the scene's scales."""
    integrator: str = AUTOMATIC
    """A member of the shelf of integrators, or `auto`."""
    step: float | None = None
    """A fixed step [s]."""
    values: Mapping[str, float] = field(default_factory=dict)
    """Numbers for letters and unknowns [SI], by name."""
    times: float | None = None
    """How many characteristic times a scene is followed that nobody gave an end; None: FREE_TIMES."""
    stops: tuple[Relation, ...] = ()
    """The motion ends where one of these comes to hold."""
    most_steps: int = MOST_STEPS
    """When to give up a run."""
    check: bool = True
    """Is a balance of energy that does not add up a failure?"""
    speeds: Mapping[str, tuple[float, float, float]] = field(default_factory=dict)
    """Those with which bodies begin, along x and y [m/s] and of turning [rad/s], where the file leaves them open."""
    momenta: bool = False
    """Are linear and angular momentum balanced too? It costs about as much as the motion."""
    estimate: bool = True
    """Run twice, to estimate the error?"""
    balanced: bool = True
    """Are balances of energy (and momentum) looked at?"""
    progress: Callable[[float, float], None] | None = None
    """Told how far the motion has been followed, and to where it goes [s]."""


@record
class Prepared:
    """A scene ready to be followed: what all runs of it share, the generated code above all."""

    problem: Problem
    stages: SceneStages
    model: Model
    """Of the first stage."""
    start: Start

    def begin(self, shift: float) -> Start:
        """Forget earlier runs. `shift`: the start is displaced by this part of the scales, as far as joints allow."""
        t, y = self.start.t, self.start.y
        self.stages.begin(t, y)
        if shift:
            moved = [a + b for a, b in zip(y, shifts(self.model.scale, shift), strict=True)]
            y = tuple(self._first_regime().project(t, moved))
            self.stages.begin(t, y)
        return replace(self.start, y=y)

    def _first_regime(self) -> Regime:
        """The modes that the motion begins with; where these are not told, the natural ones."""
        automaton, start = self.stages.automaton((_first(self.problem),)), self.start
        choice = start.choice or (0,) * len(automaton.choices)
        found = resolve(Instant(automaton, start.t, start.y, choice, "", TOLERANCE))
        return automaton.model.regime(found.choice) if isinstance(found, Resolved) else self.model.regime()


@record
class Run:
    """One motion that was followed."""

    prepared: Prepared
    problem: Problem
    model: Model
    measures: Measures
    schedule: Schedule
    trajectory: Trajectory
    settings: Settings
    until: float
    """To where it was to be followed [s]."""
    seconds: float
    """What the following took, without the preparation."""


@record
class Simulation:
    """A motion with what was asked of it."""

    run: Run
    answers: tuple[Answered, ...]
    compared: bool
    """Were two runs compared, so that errors are estimated?"""


def simulate(problem: Problem, settings: Settings, units: Mapping[str, str] = USUAL) -> Simulation:
    """Follow a scene and answer its finds, in these units by their names, or in the usual ones.

    Raises FileProblem or NoSolution where the file does not say how the motion begins, Undecided where it can not be
    followed.
    """
    scene = prepared(problem, settings.values, settings.speeds)
    first = _to_stop(followed(scene, settings))
    settings = first.settings
    found = Answers(problem, first.measures, first.trajectory, units).all()
    if not settings.estimate:
        return Simulation(first, found, False)
    step = None if settings.step is None else settings.step / 2
    # What it is compared with has been balanced.
    second = followed(scene, replace(settings, tolerance=tighter(settings.tolerance), step=step, balanced=False))
    better = Answers(problem, second.measures, second.trajectory, units).all()
    part = 1.0 if step is None else by_halving(order_of(settings.integrator))
    pairs = zip(found, better, strict=True)
    return Simulation(first, tuple(_with_error(a, b, part) for a, b in pairs), True)


def answered(run: Run) -> Simulation:
    """What a motion that was followed answers, without an estimate of errors."""
    return Simulation(run, Answers(run.problem, run.measures, run.trajectory, USUAL).all(), False)


def _to_stop(run: Run) -> Run:
    """The run as far as to where it is to end."""
    end = first_stop(run.settings.stops, run.measures, run.trajectory)
    if end is None:
        return run
    return followed(run.prepared, replace(run.settings, until=end, stops=()))


def begin(problem: Problem) -> Run:
    """The first moments of a motion."""
    return follow(replace(problem, states=problem.states[:1]), Settings(tolerance=1e-3, times=BEGINNING))


def follow(problem: Problem, settings: Settings) -> Run:
    """One run."""
    return followed(prepared(problem, settings.values, settings.speeds), settings)


def prepared(
    problem: Problem, values: Mapping[str, float], speeds: Mapping[str, tuple[float, float, float]] | None = None
) -> Prepared:
    """The scene, and where its motion begins. `values`: numbers for letters and unknowns [SI]; `speeds`: of bodies at
    the start, where the file leaves them open.
    """
    demand_kinetic(problem)
    problem = with_balanced(problem, lambda beside: prepared(beside, values))
    stages = stages_of(problem, values, speeds or {})
    model = stages.automaton((_first(problem),)).model
    return Prepared(problem, stages, model, stages.start())


def _first(problem: Problem) -> str:
    """The name of the first state."""
    return problem.states[0].name if problem.states else ""


def followed(scene: Prepared, settings: Settings, shift: float = 0.0) -> Run:
    """One run. `shift`: from a start that is displaced by this part of the scales.

    What relations speak of that is reached later is found first, without the states of these relations.
    """
    spoken = spoken_before(scene.problem)
    first = _in_order(scene, settings, shift, frozenset(spoken), {})
    asked = {name for names in spoken.values() for name in names}
    known = {name: moment for name, moment in first.measures.moments.items() if name in asked}
    if not spoken or len(known) < len(asked):
        return first
    run = _in_order(scene, settings, shift, frozenset(), known)
    for name, moment in known.items():
        demand_unchanged(scene.problem, run.model, name, moment, run.measures.moments.get(name))
    return run


def _in_order(scene: Prepared, settings: Settings, shift: float, without: Set[str], known: Mapping[str, Moment]) -> Run:
    """One run, in which a state that never happens after the given time listed before it may happen before that."""
    back: dict[str, int] = {}
    run = _followed(scene, settings, shift, _Known(without, known, back))
    while (event := _never_after_its_time(run)) is not None:
        back[event.name] = event.back + 1
        run = _followed(scene, settings, shift, _Known(without, known, back))
    return run


@record
class _Known:
    """What earlier runs have told of the states."""

    without: Set[str]
    """States that are not looked for."""
    moments: Mapping[str, Moment]
    """States of which relations speak before they are reached."""
    back: Mapping[str, int]
    """Before how many of the given times listed just before them some states come."""


def _never_after_its_time(run: Run) -> Event | None:
    """A state that has not happened after the given time that it comes after."""
    events, missed = run.schedule.events, run.trajectory.missed
    for k, event in enumerate(events):
        given = events[k - 1 - event.back] if k > event.back else None
        passed = given is not None and given.time is not None and given.name not in missed
        if passed and event.time is None and event.name in missed:
            return event
    return None


def _demand_later(problem: Problem, schedule: Schedule, t: float) -> None:
    """NoSolution: a state is given at a time before the motion begins."""
    for event in schedule.events:
        if event.time is not None and event.time < t:
            mark = next(s.mark for s in problem.states if s.name == event.name)
            text = f"state {event.name} is at t = {event.time:g} s, before the motion begins at t = {t:g} s"
            hint = "give it a later time, or give the first state an earlier one"
            raise NoSolution([Diagnostic(mark, "PL723", text, hint)])


def goes_on(run: Run, state: str, y: tuple[float, ...]) -> Run:
    """The same motion from a state that it reached on, from other places and velocities `y` there."""
    moments, first = run.measures.moments, _first(run.problem)
    order = [first, *(r.name for r in run.trajectory.events)]
    before = tuple(order[: order.index(state)])
    here = replace(moments[state], y=y, after=None)
    kept = {name: moments[name] for name in before} | {state: here}
    kept[START] = moments[START] if before else here
    reached = run.trajectory.event(state)
    choice = run.prepared.start.choice if reached is None else reached.choice
    since = Since(state, before, Start(here.t, y, choice), kept)
    run.prepared.stages.begin(here.t, y)
    return _followed(run.prepared, run.settings, 0.0, _Known(frozenset(), {}, {}), since)


def _at_first(scene: Prepared, shift: float) -> Since:
    """From the first state on."""
    start, first = scene.begin(shift), _first(scene.problem)
    here = Moment(scene.model.regime(), {}, start.t, start.y)
    return Since(first, (), start, {first: here, START: here})


def _followed(scene: Prepared, settings: Settings, shift: float, known: _Known, since: Since | None = None) -> Run:
    """One run; `since`: from a later state on."""
    problem, stages, model = scene.problem, scene.stages, scene.model
    measures = Measures(model, known=known.moments)
    schedule = schedule_of(problem, measures, breakpoints_of(stages.scene))
    at = since or _at_first(scene, shift)
    first, before, start = at.state, at.before, at.start
    past = (*known.without, *before, first)
    events = tuple(replace(e, back=known.back.get(e.name, 0)) for e in schedule.events if e.name not in past)
    schedule = replace(schedule, start=first, events=events)
    measures.moments |= at.moments
    _demand_later(problem, schedule, start.t)
    until = settings.until if settings.until is not None else _end(schedule, model, start.t, settings)
    if until <= start.t:
        text = f"the motion begins at t = {start.t:g} s, so it can not end at t = {until:g} s"
        raise FileProblem([Diagnostic(Mark(problem.file, 1, 1), "PL704", text, "write a later time behind --until")])
    names, followers = [*before, first], {e.name for e in events if e.after}

    def heard(reached: Reached) -> None:
        striking = reached.name if reached.name in followers else ""
        regime = stages.automaton(tuple(names), striking).model.regime(reached.choice)
        measures.moments[reached.name] = Moment(regime, {}, reached.t, reached.y)
        names.append(reached.name)

    def settled(moment: Moment) -> tuple[Regime, tuple[float, ...]] | None:
        automaton = stages.automaton(tuple(names))
        choice = automaton.model.choice_of(modes_of(moment.regime))
        found = resolve(Instant(automaton, moment.t, moment.y, choice, "", settings.tolerance))
        return (automaton.model.regime(found.choice), found.state) if isinstance(found, Resolved) else None

    shown = settings.progress
    free = settings.until is None and not schedule.events and not settings.stops
    most = min(settings.most_steps, FREE_STEPS) if free else settings.most_steps
    setting = Setting(model.scale, settings.tolerance, settings.step, most_steps=most)
    follower = Follower(
        Later(stages, before) if before else stages,
        start,
        replace(schedule, heard=heard),
        until,
        setting,
        settings.integrator,
        None if shown is None else lambda t: shown(t, until),
        check=settings.check,
        momenta=settings.momenta,
        balanced=settings.balanced,
        rest_ends=settings.until is None and not any(e.time is not None for e in schedule.events),
    )
    began = time.perf_counter()
    trajectory = follower.trajectory()
    if since is None and begins_unbounded(trajectory):
        beside = departing(stages, model, scene.start, first, settings.tolerance)
        if beside is not None:
            return _followed(replace(scene, start=beside), settings, shift, known)
    if free:
        trajectory = _as_far(trajectory)
    seconds = time.perf_counter() - began
    measures.followed = trajectory
    measures.moments |= moments_of(trajectory, measures.moments, settled)
    demand_agreement(problem, measures)
    return Run(scene, problem, model, measures, schedule, trajectory, settings, until, seconds)


def _as_far(trajectory: Trajectory) -> Trajectory:
    """A motion that nobody gave an end: it is followed as far as it goes by itself, and in reasonable time."""
    outcome = trajectory.outcome
    if outcome.kind not in ("spent", "long") or not trajectory.segments:
        return trajectory
    words = f"{outcome.words}; with --until it is followed further" if outcome.kind == "long" else outcome.words
    return replace(trajectory, outcome=replace(outcome, words=words, code=""))


def _end(schedule: Schedule, model: Model, t0: float, settings: Settings) -> float:
    """To where a motion is followed that nobody gave an end."""
    times = [e.time for e in schedule.events if e.time is not None]
    if schedule.events and len(times) == len(schedule.events):
        return max(times)
    many = settings.times or (SEARCHED_TIMES if schedule.events or settings.stops else FREE_TIMES)
    return max([t0 + rounded(many * model.time_scale), *times])


def rounded(time: float) -> float:
    """1, 2 or 5 times a power of ten, not below this time."""
    power = 10.0 ** math.floor(math.log10(time))
    return next(power * r for r in ROUND if power * r >= time * (1 - 1e-12))


def _with_error(first: Answered, second: Answered, part: float) -> Answered:
    """The answer with its error, by what it is off from that of the finer run."""
    if len(first.values) != len(second.values) or not second.values:
        return first
    return replace(first, error=part * math.hypot(*(a - b for a, b in zip(first.values, second.values, strict=True))))


def units_of(answers: Sequence[Answer]) -> dict[str, str]:
    """The units in which answers are stated, by find."""
    return {a.name: unit for a in answers if (unit := _unit(a.value)) is not None}


def _unit(value: Side | tuple[Side, ...] | bool | str) -> str | None:
    from planar_cli.problem.language.walk import walk

    sides = value if isinstance(value, tuple) else (value,)
    for side in sides:
        if isinstance(side, bool | str):
            continue
        for node in walk(side):
            unit = getattr(node, "unit", None)
            if unit is not None and not isinstance(node, Quantity):
                return str(unit)
    return None
