"""The motion of a course as the engine follows it: from the first state on, in the modes that happen."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.system.setup import numbers_of
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import FileProblem, NoSolution, Undecided
from planar_cli.integrators.base import MOST_STEPS
from planar_cli.joints.base import distinct
from planar_cli.motion.follow.transition import Moment as Instant
from planar_cli.motion.follow.transition import Resolved, resolve
from planar_cli.motion.trajectory.automaton import Choice, Start
from planar_cli.motion.trajectory.segment import Segment
from planar_cli.motion.trajectory.trajectory import Transition
from planar_cli.problem.scene.facts import Mode
from planar_cli.problem.scene.scene import Problem
from planar_cli.records import record
from planar_cli.simulate.dated_by_spans import dated_by_spans
from planar_cli.simulate.measures import Moment
from planar_cli.simulate.run import Prepared, Run, Settings, followed, prepared
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.following.dated import dated, is_told_by_a_span, told_by_what_follows
from planar_cli.solve.following.letters import Letters
from planar_cli.solve.impulsive.impact import arriving
from planar_cli.solve.regimes.mode_sequence import Stretch, Workshop, fixed_time

TOLERANCES = (1e-15, 1e-12, 1e-9)
"""Of the steps of a motion that decides what happens, in parts of the scene's scales; the next where one is too fine to
get through a singular position.
"""
SEARCHED_STEPS, SOUGHT_STEPS = 6000, 3000
"""So many steps are taken to find a state that no time tells, and for one of many numbers of a constant."""
PATIENT = 20_000
"""After so many steps it is asked whether the next tolerance needs a quarter of them at most: then rounding made them
short.
"""
TRIED_TIMES = 100.0
"""With numbers that are only tried it is followed over so many time scales."""
AFTERWARDS = 2.0, 1000
"""For so many characteristic times, in so many steps at most, a motion is followed after the only state of a file."""
FEW = 30.0
"""So few characteristic times should not take all steps."""
BEYOND = 0.01
"""A motion is followed this part of its time beyond the last state."""
SOON = 1e-9
"""A piece that lasts for a smaller part of an ordinary time is none."""
NOT_TOLD = "PL704"
"""The diagnostic of a start that the file does not tell."""
Label = tuple[str, int, int, str, int]
"""What tells a mode of a joint from its others: name, direction, side, words, and its number among those alike."""


@record
class Traced:
    """One motion that was followed."""

    run: Run

    def moment(self, name: str) -> Moment | None:
        """A state of the file; None: it was not reached."""
        return self.run.measures.moments.get(name)

    @property
    def refused(self) -> bool:
        """Could it not be followed on, for another reason than that a state does not come?"""
        outcome = self.run.trajectory.outcome
        return outcome.refused and outcome.kind != "long"

    @property
    def crawls(self) -> bool:
        """Have the steps been used up within a few characteristic times?"""
        trajectory = self.run.trajectory
        return trajectory.outcome.kind == "long" and self.end - trajectory.t0 < FEW * self.run.model.time_scale

    @property
    def end(self) -> float:
        """To where it was followed [s]."""
        return self.run.trajectory.t1

    def pieces(self, since: float, until: float) -> list[Segment]:
        """The segments in which time passes between two times."""
        return [s for s in self.run.trajectory.segments if s.t1 > since and s.t0 < until]

    def transitions(self, since: float, until: float) -> Iterator[Transition]:
        """What happens after a time, up to another."""
        return (x for x in self.run.trajectory.transitions if since < x.t <= until)

    def reached(self, t: float) -> tuple[str, ...]:
        """The states of the file that have been reached up to a time."""
        first = self.run.problem.states[:1]
        return (*(s.name for s in first), *(e.name for e in self.run.trajectory.events if e.t <= t))

    def modes(self, piece: Segment) -> dict[str, Label]:
        """The modes of a segment, by joint."""
        return self._labelled(self.reached(piece.t0), piece.choice)

    def _labelled(self, reached: tuple[str, ...], choice: Choice) -> dict[str, Label]:
        automaton = self.run.prepared.stages.automaton(reached)
        pairs = zip(automaton.choices.items(), choice, strict=True)
        found = {joint: labels(modes)[k] for (joint, modes), k in pairs}
        for impact, ways in automaton.model.encounters.items():
            # Of the ways in which an impact's partners may touch, the one in which they do.
            told = [found[way.name] for way in ways if way.name in found]
            if len(told) > 1:
                found[impact] = next((label for label in told if label[0] != "apart"), told[0])
        return found

    def choice(self, workshop: Workshop, stretch: Stretch, modes: Mapping[str, Label]) -> tuple[int, ...]:
        """The choice on a stretch that has these modes; a joint that has but one way to act keeps its own."""
        # Two joints that act one after the other may share a name, which only the whole file tells apart.
        joints = self.run.problem.joints
        lines = Counter(joint.mark for joint in joints)
        names = {joint.mark: joint.name for joint in distinct(joints) if lines[joint.mark] == 1}
        found = []
        for (joint, own), now in zip(workshop.drawn(stretch.span).modes, stretch.choice, strict=True):
            label, known = modes.get(names.get(joint.mark, joint.name)), labels(own)
            found.append(known.index(label) if label is not None and label in known else now)
        return tuple(found)

    def begins(self, t: float, pace: float) -> tuple[dict[str, Label], tuple[float, ...]] | None:
        """The modes just after a time, and the state of the scene; None: nothing tells. `pace`: an ordinary time."""
        soon = t + SOON * pace
        piece = next(iter(self.pieces(soon, math.inf)), None)
        if piece is None:
            # The last state may be a rounding later than the time at hand.
            return self._after(soon)
        return self.modes(piece), piece.start if piece.t0 >= t else tuple(piece.at(t))

    def _after(self, t: float) -> tuple[dict[str, Label], tuple[float, ...]] | None:
        """The same at the end of the motion; None: nothing consistent follows."""
        names = self.reached(t)
        moment, last = self.moment(names[-1]), self.run.trajectory.event(names[-1])
        automaton = self.run.prepared.stages.automaton(names)
        if moment is None:
            return None
        same = last is not None and len(last.choice) == len(automaton.choices)
        choice = last.choice if last is not None and same else (0,) * len(automaton.choices)
        found = resolve(Instant(automaton, moment.t, moment.y, choice, "", TOLERANCES[0]))
        return (self._labelled(names, found.choice), found.state) if isinstance(found, Resolved) else None


def labels(modes: Sequence[Mode]) -> list[Label]:
    """What tells the modes of a joint from each other."""
    count: Counter[tuple[str, int, int, str]] = Counter()
    found = []
    for mode in modes:
        key = (mode.name, mode.direction, mode.side, mode.words)
        found.append((*key, count[key]))
        count[key] += 1
    return found


def traced(
    course: StatedMotion,
    problem: Problem,
    value: Valuation,
    start: Mapping[sp.Symbol, float],
    by: float = math.inf,
) -> Traced | str:
    """The motion of a problem from the letters of its first state, or why it can not be followed. `value`: numbers of
    what does not vary; `by`: it is not followed beyond this time [s].
    """
    opened = {n: s for blow in course.blows.values() for n, s in blow.scene.open_names.items()}
    told = {n: float(number) for n, s in opened.items() if (number := value.known(s)) is not None}
    problem = replace(problem, joints=tuple(j.told(told) for j in problem.joints))
    times = _times(course, value)
    problem = dated(problem, times)
    spanned = next((s.name for s in problem.states if is_told_by_a_span(s)), "")
    if spanned:
        return (
            f"state {spanned} is told by a quantity over a span, which is not looked for step by step; "
            "a place, a speed or a time of it helps"
        )
    for name in sorted(told_by_what_follows(problem)):
        return f"state {name} is told by a later one, which it leads to"
    values = _values(course, problem, value)
    speeds = _speeds(course, value, start)
    try:
        scene = _prepared(problem, values, speeds, {s.name: v for s, v in start.items()})
        scene = _departing(course, scene, value, start)
        departure = getattr(course, "departure", None)
        if departure is not None and not problem.states[1:]:
            # Until then the only state of the file is hardly left.
            by = min(by, scene.start.t + (1 + BEYOND) * departure.grown)
        return _traced(scene, values, _end(problem, times, by), bool(problem.unknowns))
    except (FileProblem, NoSolution) as refused:
        return refused.diagnostics[0].message
    except Undecided as undecided:
        return str(undecided)


def as_told(problem: Problem, values: Mapping[str, float], trial: bool = False) -> Traced | None:
    """The motion of a problem that tells its start itself; None: it can not be followed. `values`: numbers for its
    letters, and of earlier finds; `trial`: as far and as well as tells which states are passed.
    """
    try:
        timed = dated_by_spans(problem, values)
        if timed is None:
            return None
        found = _traced(prepared(timed, values), values, trial=trial)
    except (FileProblem, NoSolution, Undecided):
        # Whoever solves it tells what keeps it from being followed.
        return None
    return None if found.refused else found


def _end(problem: Problem, times: Mapping[str, float], by: float) -> float | None:
    """A little beyond the last state, where it is known beforehand when that is, or by when it has to be [s]."""
    known = [times[s.name] for s in problem.states if s.name in times]
    first, last = min(known, default=0.0), max(known, default=0.0)
    if len(known) == len(problem.states) and last > first:
        return last + BEYOND * (last - first)
    return None if math.isinf(by) else by


def _traced(
    scene: Prepared,
    values: Mapping[str, float],
    until: float | None = None,
    sought: bool = False,
    trial: bool = False,
) -> Traced:
    """The motion at the first tolerance at which it can be followed to its end; else at the first one. `until`: that
    end, where it is known [s]; `sought`: is it one of many, for other numbers of a constant? `trial`: see `as_told`.
    """
    found: list[Traced] = []
    timed = all(fixed_time(s.relations) is not None for s in scene.problem.states[1:])
    most = SOUGHT_STEPS if sought else MOST_STEPS if timed else SEARCHED_STEPS
    tries = [(tolerance, most) for tolerance in (TOLERANCES[1:] if sought else TOLERANCES)]
    if most > PATIENT:
        tries[:0] = [(TOLERANCES[0], PATIENT), (TOLERANCES[1], PATIENT // 4)]
    times = None
    if not scene.problem.states[1:] and until is None:
        # Of what follows the only state the beginning is enough.
        times, most = AFTERWARDS
        tries = [(TOLERANCES[0], most)]
    elif trial:
        times, tries = TRIED_TIMES, [(TOLERANCES[-1], most)]
    for tolerance, steps in tries:
        settings = Settings(
            until, tolerance, values=values, times=times, estimate=False, most_steps=steps, momenta=not sought
        )
        settings = replace(settings, momenta=False, balanced=False) if trial else settings
        one = Traced(followed(scene, settings))
        if one.run.trajectory.outcome.kind == "long" and steps < most:
            continue
        found.append(one)
        if not one.refused and not one.crawls:
            return one
    return next((f for f in found if not f.refused), found[0])


def _prepared(
    problem: Problem,
    values: Mapping[str, float],
    speeds: Mapping[str, tuple[float, float, float]],
    start: Mapping[str, float],
) -> Prepared:
    """The scene. Where the file does not tell its coordinates at the start, they are those of `start`."""
    try:
        return prepared(problem, values, speeds)
    except FileProblem as refused:
        told = {c.name: start[c.name] for c in problem.coordinates if c.name in start and c.name not in values}
        if refused.diagnostics[0].code != NOT_TOLD or not told:
            raise
        return prepared(problem, {**values, **told}, speeds)


def _times(course: StatedMotion, value: Valuation) -> dict[str, float]:
    """When states are, as far as that is known beforehand [s]."""
    known = {name: value.known(stop.t) for name, stop in course.stops.items()}
    return {name: float(t) for name, t in known.items() if t is not None}


def _values(course: StatedMotion, problem: Problem, value: Valuation) -> dict[str, float]:
    """Numbers of letters and sought constants, and finds of earlier cases."""
    names = [s.name for s in (*problem.symbols, *problem.unknowns)]
    names += ["g"] if problem.symbols else []
    symbols = {n: course.ledger.symbols[n] for n in names if n in course.ledger.symbols}
    numbers = {n: number for n, s in symbols.items() if (number := value.known(s)) is not None}
    own = {n: float(v) for n, v in numbers.items()}
    return {**numbers_of(course.workshop.earlier, own), **own}


def _speeds(
    course: StatedMotion, value: Valuation, start: Mapping[sp.Symbol, float]
) -> dict[str, tuple[float, float, float]]:
    """Of the mass centres along x and y, and of turning, in the first state."""
    regime = course.readers[course.states[0].name].regime
    letters = Letters.exact(start)
    here = value.extended({s: letters[s] for s in regime.letters if s in letters})
    found = {}
    for body, (v, spin) in arriving(regime).items():
        parts = [here.known(regime.closed(sp.sympify(e))) for e in (v.x, v.y, spin)]
        numbers = [float(p) for p in parts if p is not None]
        if len(numbers) == len(parts):
            found[body] = (numbers[0], numbers[1], numbers[2])
    return found


def _departing(course: StatedMotion, scene: Prepared, value: Valuation, start: Mapping[sp.Symbol, float]) -> Prepared:
    """From an unstable equilibrium, with the slight touch by which it is left."""
    departure = getattr(course, "departure", None)
    if departure is None:
        return scene
    letters = Letters(course.regimes[0], scene.model, value)
    touch = letters.velocities(start)
    t, y = scene.start.t, scene.start.y
    half = len(y) // 2
    moved = [*y[:half], *(v + touch.get(i, 0.0) for i, v in enumerate(y[half:]))]
    return replace(scene, start=Start(t, tuple(scene.model.regime().project(t, moved)), scene.start.choice))
