"""A motion that was solved, followed once more by independent facts: position residuals, wrenches, and what they do.

It is followed by the file alone, but for constants sought, restitutions that a velocity after a blow tells, velocities
of an open start. Letters have drawn numbers. Where one answer differs, nothing is an answer.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.system.setup import Earlier, numbers_of
from planar_cli.errors import Diagnostic, FileProblem, NoSolution, NoValue
from planar_cli.motion.follow.unstable import growth_note
from planar_cli.problem.language.expression import Equilibrium, JustAfter, Name, Quantity, Relation, Side
from planar_cli.problem.language.walk import is_endless, names_of_states, walk
from planar_cli.problem.scene.scene import Problem
from planar_cli.simulate.answers import NOT_FOLLOWED, Answered
from planar_cli.simulate.run import BEGINNING, Run, Settings, Simulation, answered, simulate
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.contradicted import DIFFERENT, HINT, Seen, disagreement, shown
from planar_cli.solve.diagnosis.left_open import demand_told
from planar_cli.solve.first_stretch import ALONG, CERTAIN, FAINT, FirstStretch, varies
from planar_cli.solve.followable import closed, end_of, most_steps, not_followed
from planar_cli.solve.following.departure import DEPARTS
from planar_cli.solve.instances import Instance, instances
from planar_cli.solve.instant.verify import Disagreement
from planar_cli.solve.only_just import only_just
from planar_cli.solve.solution import AT_A_TOP, Found
from planar_cli.solve.solved_problem import Confirmation, PartSolution
from planar_cli.solve.stated_inequalities import demand_inequalities
from planar_cli.solve.taken import Taken
from planar_cli.solve.undriven import nothing_drives, standing_alone

DIFFERS = 30.0
"""Numbers that are apart by less than so many estimated errors do not differ."""
TOUCHING = 3e-6
"""What comes and goes within this part of the time is one touch: the root of some roundings."""
AT_REST = (0.0, 0.0, 0.0)
READ_OFF = "rests on a number that only the motion that was followed gives"
NOT_ABLE = {
    "PL702": "the equations of motion do not tell how it goes on",
    "PL703": "its steps become too small",
    "PL706": "the restitution of an impact is open",
    "PL712": "a part of a rope has no length any more",
    "PL713": "forces of redundant constraints tell whether something holds",
}
"""What keeps a motion from being followed to its end, by the code of the refusal; everything else contradicts."""
NOT_BEGUN = {
    "PL556": "a law of it gives no direction where it begins",
    "PL704": "its start is not told by the file alone",
    "PL707": "outlines meet in ways that are not followed",
}
"""The same of its beginning."""
NOT_TO_MEND = ("PL609", "PL723")
"""The first state is not as drawn, or another one lies before it, which no solution makes good."""


def confirmation(problem: Problem, part: PartSolution, earlier: Mapping[str, Earlier]) -> Confirmation:
    """What following the motion says of answers that were found otherwise. Disagreement: it gives other ones.

    `earlier`: finds of earlier cases, as `case.find`.
    """
    found, trace = part.found, part.motion
    assert trace is not None
    whole = not_followed(problem, trace.taken)
    if whole:
        return Confirmation("", frozenset(), {f.name: whole for f in found})
    kinds = {f.name: _of_no_motion(f) for f in found}
    if all(kinds.values()):
        return Confirmation("", frozenset(), kinds)
    refused: Disagreement | None = None
    for k, instance in enumerate(instances(problem, found, trace)):
        try:
            run = part.run if k == 0 and part.run is not None and _is_of(part.run, problem, instance) else None
            return _confirmed(problem, found, trace, instance, earlier, run)
        except Disagreement as error:
            # Numbers that were drawn for letters may lie where the formulas do not hold: then others are drawn.
            refused = refused or error
    assert refused is not None
    raise refused


def _is_of(run: Run, problem: Problem, instance: Instance) -> bool:
    """Does a run of this problem begin when its first state is? Told by the file alone it may begin at t = 0, where
    what is given in time says the same of places as it does later.
    """
    name = problem.states[0].name if problem.states else ""
    begun, moment = instance.taken.times.get(name), run.measures.moments.get(name)
    near = CERTAIN * max((abs(t) for t in instance.taken.times.values()), default=0.0)
    return run.problem is problem and (begun is None or moment is None or abs(moment.t - begun) <= near)


def _confirmed(
    problem: Problem,
    found: tuple[Found, ...],
    trace: MotionTrace,
    instance: Instance,
    earlier: Mapping[str, Earlier],
    run: Run | None,
) -> Confirmation:
    """The same for one choice of numbers for the letters. `run`: the motion, where it has been followed already."""
    taken = instance.taken
    asked = closed(problem, taken)
    values = {**numbers_of(earlier, taken.letters), **taken.letters}
    alone = ALONG if any(varies(f, trace) for f in found) else BEGINNING
    settings = Settings(
        most_steps=most_steps(asked, taken),
        until=end_of(asked, taken),
        values=values,
        speeds=taken.speeds,
        momenta=True,
        estimate=False,
        times=None if problem.states[1:] else alone,
    )
    untold: tuple[Diagnostic, ...] = ()
    try:
        other = simulate(asked, settings) if run is None else answered(run)
    except (FileProblem, NoSolution) as refused:
        settings = replace(settings, speeds={**{b.name: AT_REST for b in problem.bodies}, **taken.speeds})
        still = _from_rest(asked, settings, refused)
        if still is None:
            return _unable(problem, found, refused)
        other, untold = still, tuple(refused.diagnostics)
    whole = _stopped(problem, other.run, taken)
    if whole:
        return Confirmation("", frozenset(), {f.name: whole for f in found})
    demand_inequalities(asked, other.run)
    seen = [_Compared(other, trace, instance).see(f) for f in found]
    if any(s.other for s in seen):
        # How good the numbers are that differ, only a second run tells.
        compared = _Compared(simulate(asked, replace(settings, estimate=True)), trace, instance)
        seen = [compared.see(f) for f in found]
    if (wrong := [s for s in seen if s.other]) and untold:
        # With another velocity where the file tells none there are other answers.
        raise NoSolution(untold)
    if wrong:
        raise disagreement(problem, wrong, instance)
    same = frozenset(s.name for s in seen if not s.why)
    begun = " from rest, where no velocity is told" if untold else ""
    words = f"motion followed{begun} by independent facts: {len(same)} of {len(found)} answers agree" if same else ""
    followed = other.run if same and not problem.symbols else None
    return Confirmation(words, same, {s.name: s.why for s in seen if s.why}, followed)


def _from_rest(problem: Problem, settings: Settings, refused: FileProblem | NoSolution) -> Simulation | None:
    """The motion that begins with no velocity but what the file tells; None: not that keeps it from being followed."""
    if isinstance(refused, NoSolution) or refused.diagnostics[0].code not in NOT_BEGUN:
        return None
    try:
        return simulate(problem, settings)
    except (FileProblem, NoSolution):
        return None


# --- what it comes to ------------------------------------------------------------------------------------------------


def _unable(problem: Problem, found: tuple[Found, ...], refused: FileProblem | NoSolution) -> Confirmation:
    """The motion could not begin to be followed. Disagreement: nothing that is known keeps it from that."""
    first = refused.diagnostics[0]
    why = NOT_BEGUN.get(first.code) if isinstance(refused, FileProblem) else None
    if first.code in NOT_TO_MEND:
        raise refused
    if why is None:
        text = f"{first.mark.file}:{first.mark.line}: the motion can not be followed as it was solved: {first.message}"
        raise Disagreement(text, (first,))
    return Confirmation("", frozenset(), {f.name: _because(problem, why, first.message) for f in found})


def _because(problem: Problem, why: str, words: str) -> str:
    """With the words of the refusal, unless these hold numbers that were drawn for letters."""
    return why if problem.symbols else f"{why}: {words}"


def _stopped(problem: Problem, run: Run, taken: Taken) -> str:
    """Why the motion was not followed to its last state; "" where it was. Disagreement: it contradicts the solution."""
    outcome = run.trajectory.outcome
    told = bool(run.trajectory.segments) and all(name in run.measures.moments for name in taken.times)
    demand_told(problem, outcome)
    if not outcome.refused or outcome.kind == "long" or (told and outcome.kind != "unbalanced"):
        return ""
    if outcome.code in NOT_ABLE:
        return _because(problem, NOT_ABLE[outcome.code], outcome.words)
    if state := only_just(problem, run, taken):
        return f"{outcome.joint} only just presses at state {state}: machine numbers do not tell whether it does"
    mark = problem.find[0].mark
    text = f"the motion followed by independent facts contradicts the solution: {outcome.words}"
    raise Disagreement(f"{mark.file}:{mark.line}: {text}", (Diagnostic(mark, DIFFERENT, text, HINT),))


# --- what is compared ------------------------------------------------------------------------------------------------


class _Compared:
    """The finds of a motion that was followed, beside those that were solved."""

    def __init__(self, other: Simulation, trace: MotionTrace, instance: Instance) -> None:
        self.other, self.trace, self.instance = other, trace, instance
        self.problem = other.run.problem
        self.alone = standing_alone(other.run)
        self.answers = {a.name: a for a in other.answers} | self.alone
        self.moments = other.run.measures.moments

    def see(self, f: Found) -> Seen:
        """One find. A state that the motion does not reach contradicts, but for reasons that are stated."""
        assert f.find is not None
        what = f.find.found.what
        kind = _of_no_motion(f)
        if kind or self.trace.is_read_off(f.find):
            return Seen(f.name, kind or READ_OFF)
        answer = self.answers[f.name]
        missed = [s for s in self._states(what) or self._telling(what) if s not in self.moments]
        if missed and f.name not in self.alone:
            return self._missed(f, missed[0], answer)
        if f.word:
            return self._seen(f, f.word == answer.word, f.word, answer.word or answer.why, what)
        numbers = self._numbers(f)
        if numbers is None or answer.why:
            assert not isinstance(what, Relation)
            return FirstStretch(self.other.run, self.trace, self.instance).see(f, what)
        apart = max(abs(float(x) - y) for x, y in zip(numbers, answer.values, strict=True))
        size = max([*map(abs, answer.values), answer.scale])
        agrees = apart <= max(CERTAIN * size, DIFFERS * (answer.error or 0.0))
        others, us = [Decimal(repr(v)) for v in answer.values], self.problem.us
        return self._seen(f, agrees, shown(numbers, f.unit, us), shown(others, f.unit, us), what)

    def _seen(self, f: Found, agrees: bool, found: str, other: str, what: Side | Relation) -> Seen:
        if agrees:
            return Seen(f.name)
        states = [s for s in self._states(what) if s in self.moments]
        about = any(isinstance(n, Quantity) and n.word == "reached" for n in walk(what))
        if about and (barely := next(filter(None, map(self._barely, states)), "")):
            return Seen(f.name, barely)
        where = ", ".join(f"state {s} at t = {self.moments[s].t:.9g} s" for s in states)
        return Seen(f.name, "", other, found, where)

    def _states(self, what: Side | Relation) -> list[str]:
        """The states on which a find rests, in their order."""
        names = names_of_states(what)
        for node in walk(what):
            if isinstance(node, Quantity) and node.word == "reached":
                names.add(node.argument.name if isinstance(node.argument, Name) else node.things[0])
        return [s.name for s in self.problem.states if s.name in names]

    def _telling(self, what: Side | Relation) -> list[str]:
        """The states that the solution passes, where a find rests on constants that they tell: beside the motion these
        are taken from the solution, so that they agree with themselves even where it never passes the states.
        """
        sought = {u.name for u in self.problem.unknowns}
        if not any(isinstance(node, Name) and node.name in sought for node in walk(what)):
            return []
        return [s.name for s in self.problem.states]

    def _numbers(self, f: Found) -> list[Decimal] | None:
        """The values of a find, of a formula in letters for the numbers that were drawn; None: it varies."""
        if f.values is not None:
            return [Decimal(v) for v in f.values]
        found = [sp.sympify(e) for e in f.expressions or ()]
        if not found or varies(f, self.trace):
            return None
        try:
            return [self.instance.value(e) for e in found]
        except NoValue as error:
            mark = self.problem.find[0].mark
            text = f"{mark.file}:{mark.line}: {f.name} is not confirmed: its formula has no value, {error}"
            raise Disagreement(text) from error

    # --- states that are not reached ---------------------------------------------------------------------------------

    def _missed(self, f: Found, state: str, answer: Answered) -> Seen:
        """A find that rests on a state which the motion that was followed does not reach."""
        if f.word and f.word == answer.word:
            return Seen(f.name)
        if why := self._out_of_reach(state):
            return Seen(f.name, why)
        at = self.instance.taken.times.get(state)
        found = "reached" if at is None else f"reached at t = {at:.9g} s"
        return Seen(f.name, "", "not reached", found, f"state {state}")

    def _out_of_reach(self, state: str) -> str:
        """Why a motion that is followed in numbers need not reach a state that is an answer; "" where it must."""
        if self.problem.method not in (None, "newton"):
            return f"{self.problem.method} relates states also where no motion joins them: state {state} is not reached"
        for name in [s.name for s in self.problem.states]:
            if words := self._never(name) or self._barely(name):
                return words
            if name == state:
                break
        if AT_A_TOP in self.trace.checks:
            return AT_A_TOP
        if body := nothing_drives(self.other.run.measures.model):
            return f"nothing drives {body}, so that no motion leads to state {state}"
        trajectory = self.other.run.trajectory
        if note := self._unstable():
            return f"numbers do not leave an unstable equilibrium: {note}"
        if DEPARTS in self.trace.checks:
            return "numbers do not leave an unstable equilibrium"
        at = self.instance.taken.times.get(state, trajectory.t1)
        if self._faint(self.other.run.prepared.start.y) or self._faint(trajectory.at(min(at, trajectory.t1))):
            return f"before state {state} speeds are lost in rounding"
        return ""

    def _barely(self, name: str) -> str:
        """Is a state only just touched, so that machine numbers do not tell whether it is met at all?"""
        trajectory, segments = self.other.run.trajectory, self.other.run.trajectory.segments
        reached = next((e for e in trajectory.events if e.name == name), None)
        crossing = next((e.crossing for e in self.other.run.schedule.events if e.name == name), None)
        if reached is None or crossing is None or not segments:
            return ""
        before = reached.t - TOUCHING * (trajectory.t1 - segments[0].t0)
        segment = segments[min(reached.segment, len(segments) - 1)]
        here = crossing.value(segment.regime, segment.choice, before, trajectory.at(before))
        # What crosses is off by the way that it goes in this time, what only touches by the square of that.
        if before > segments[0].t0 and abs(here) < TOUCHING**1.5 * crossing.scale:
            return f"state {name} is only just met: machine numbers do not tell whether it is passed"
        return ""

    def _faint(self, y: Sequence[float]) -> bool:
        """Does something move, and so slowly that numbers can hardly tell it from rest?"""
        model = self.other.run.measures.model
        half = model.layout.count
        speeds = [abs(v) / s for v, s in zip(y[half:], model.scale[half:], strict=True)]
        return 0 < max(speeds, default=0.0) < FAINT

    def _unstable(self) -> str:
        """Does the motion end at rest where the slightest touch would send it off?"""
        run = self.other.run
        last = run.trajectory.segments[-1] if run.trajectory.segments else None
        if last is None or last.steps:
            return ""
        reached = (*(s.name for s in self.problem.states[:1]), *(e.name for e in run.trajectory.events))
        return growth_note(run.prepared.stages.automaton(reached), last.regime, last.t0, last.start)

    def _never(self, name: str) -> str:
        """Why no motion comes to a state, by what the file says of it."""
        state = next(s for s in self.problem.states if s.name == name)
        for relation in state.relations:
            if isinstance(relation, Equilibrium) and relation.body is None:
                return f"state {name} is an equilibrium, which lies beside the motion"
            if is_endless(state.relations):
                return f"state {name} is only approached"
            if isinstance(relation, JustAfter) and (before := self._never(relation.state)):
                return before
        return ""


def _of_no_motion(f: Found) -> str:
    """Why a find belongs to no single motion; "" where it does."""
    assert f.find is not None
    if any(v.is_infinite() for v in f.values or ()):
        return "is infinite, and no motion is followed so far"
    words = [n.word for n in walk(f.find.found.what) if isinstance(n, Quantity)]
    return next((NOT_FOLLOWED[w] for w in words if w in NOT_FOLLOWED), "")
