"""What no equation gives in closed form: the motion followed step by step, and the answers read off.

It is the last road of a file with numbers throughout: nothing is derived, so that nothing but the equations of motion,
the start and what happened can be told.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from planar_cli.equation.values.exact import Settled, Valuation
from planar_cli.errors import Diagnostic, NoSolution, PlanarError
from planar_cli.integrators.base import MOST_STEPS
from planar_cli.motion.regime.hybrid import HybridModel
from planar_cli.problem.language.expression import JustAfter, Relation
from planar_cli.problem.scene.facts import FAR
from planar_cli.problem.scene.scene import Problem
from planar_cli.simulate.answers import Answered
from planar_cli.simulate.dated_by_spans import dated_by_spans, span_relation
from planar_cli.simulate.run import Run, Settings, begin, simulate
from planar_cli.solve.between.branches.reached import asked_about
from planar_cli.solve.diagnosis.left_open import demand_told
from planar_cli.solve.diagnosis.other_masses import demand_any_mass
from planar_cli.solve.following.dated import is_told_by_a_span, told_by_what_follows
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.solve.stated_inequalities import demand_inequalities

SOME_STEPS = 6000
"""So many are enough to look for a state that no equation leads to."""
FINAL = frozenset(("rest", "repeats"))
"""Ends of a motion after which nothing new happens."""
MOST_BODIES = 6
"""Of a motion of more bodies than that no closed form is looked for."""
CERTAIN = 1e-6
"""An answer is read off where its estimated error is below this part of it, or of its scale."""
ROUNDING = 1e-13
"""What is below this part of the scale of its kind is the rounding of zero."""


def strikes_unnamed(problem: Problem) -> bool:
    """Do bodies strike each other without a state of the file saying when?"""
    named = any(isinstance(r, JustAfter) for state in problem.states for r in state.relations)
    return not named and any(j.strikes and j.during is None for j in problem.joints)


def many_bodies(problem: Problem) -> bool:
    """Are there more bodies than a closed form of their motion is looked for?"""
    return len(problem.bodies) > MOST_BODIES


def pressed_by_impacts(problem: Problem) -> bool:
    """Do bodies that may strike each other rest on each other from the start, with but the impact between them?

    A block stands on one edge until another one strikes: then the impact is a contact too, whose forces act before.
    """
    if not can_be_followed(problem) or not any(j.strikes for j in problem.joints):
        return False
    try:
        run = begin(problem)
    except PlanarError:
        # What keeps the motion from beginning is told by whoever solves it.
        return False
    trajectory, model = run.trajectory, run.model
    if not trajectory.segments or any(x.kind == "impact" for x in trajectory.transitions):
        return False
    assert isinstance(model, HybridModel)
    modes = dict(zip(model.choices, trajectory.segments[0].choice, strict=True))
    ours = (e.name for found in model.encounters.values() for e in found)
    return any(model.choices[name][modes[name]].name not in ("apart", FAR) for name in ours if name in modes)


def can_be_followed(problem: Problem) -> bool:
    """Has everything a number, does the file name states to go to that a motion finds by itself, and no principle but
    Newton's?
    """
    free = problem.method in (None, "newton")
    free = free and not any(is_told_by_a_span(s) and span_relation(s) is None for s in problem.states)
    free = free and not told_by_what_follows(problem)
    return free and bool(problem.states[1:]) and not (problem.symbols or problem.unknowns)


def followed_part(
    problem: Problem,
    case: str,
    earlier: Mapping[str, float],
    units: Mapping[str, str],
    most_steps: int = MOST_STEPS,
    ends: bool = False,
) -> PartSolution | None:
    """All finds of a part read off its motion; None where that does not answer all of them. NoSolution, where it is
    asked whether the motion `ends`: it comes to rest or repeats itself before it has passed all states, or the file
    leaves open how it goes on. What rests from the start on ends nothing: from an unstable equilibrium a slight touch
    may lead on.
    """
    timed = dated_by_spans(problem, earlier)
    if timed is None:
        return None
    problem = timed
    found = simulate(problem, Settings(values=earlier, momenta=True, most_steps=most_steps), units)
    if ends:
        demand_told(problem, found.run.trajectory.outcome)
    if ends and found.run.trajectory.outcome.kind in FINAL and found.run.trajectory.outcome.t > 0:
        _demand_all_reached(problem, found.run)
    if found.run.trajectory.outcome.refused or any(a.why or not _certain(a) for a in found.answers):
        return None
    demand_inequalities(problem, found.run)
    once = Settings(values=earlier, most_steps=most_steps, estimate=False, balanced=False)
    demand_any_mass(problem, found, lambda other: simulate(other, once, units))
    finds = {f.name: f for f in problem.find}
    answers = tuple(
        Found(
            a.name,
            _kind(a),
            a.unit,
            tuple(_settled(v, a.scale) for v in a.values) or None,
            None,
            a.word,
            finds[a.name],
        )
        for a in found.answers
    )
    return PartSolution(case, (), answers, followed=found)


def _demand_all_reached(problem: Problem, run: Run) -> None:
    """NoSolution: a state is never reached, as the motion is over. Whether one is may be what is asked."""
    asked = asked_about(problem)
    for state in problem.states:
        if state.name not in run.measures.moments and state.name not in asked:
            texts = "; ".join(dict.fromkeys(r.text for r in state.relations if isinstance(r, Relation)))
            text = f"state {state.name} is never reached: {texts}" if texts else f"state {state.name} is never reached"
            raise NoSolution([Diagnostic(state.mark, "PL621", text, run.trajectory.outcome.words)])


def _settled(value: float, scale: float) -> Settled:
    """A machine number as the number of an answer; rounding is zero."""
    exact = sp.Rational(repr(value)) if abs(value) > ROUNDING * scale else sp.S.Zero
    return Valuation({}).settled(exact, exact)


def _kind(answer: Answered) -> str:
    if answer.word:
        return "truth" if answer.word in ("true", "false") else "word"
    return "vector" if len(answer.values) == 2 else "number"


def _certain(answer: Answered) -> bool:
    size = max((abs(v) for v in answer.values), default=0.0)
    return not answer.values or answer.error is None or answer.error <= CERTAIN * max(size, answer.scale)
