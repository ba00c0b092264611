"""What no equation gives in closed form: the motion followed step by step, and the answers read off.

It is the last road of a file with numbers throughout: nothing is derived, so that nothing but the equations of motion,
the start and what happened can be told. The other use is a check: a motion that was solved otherwise is followed by
these independent facts (position residuals and wrenches), with the constants that were found put in.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from planar_cli.equation.exact import Settled, Valuation
from planar_cli.errors import PlanarError
from planar_cli.motion.hybrid import HybridModel
from planar_cli.problem.expression import JustAfter, Name
from planar_cli.problem.facts import FAR
from planar_cli.problem.scene import Problem
from planar_cli.simulate.answers import Answered
from planar_cli.simulate.run import Settings, Simulation, begin, simulate
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import Confirmation, PartSolution

MOST_BODIES = 6
"""Of a motion of more bodies than that no closed form is looked for."""
CERTAIN = 1e-6
"""An answer is read off where its estimated error is below this part of it, or of its scale."""
ROUNDING = 1e-13
"""What is below this part of the scale of its kind is the rounding of zero."""
DIFFERS = 30.0
"""Numbers that are apart by less than so many estimated errors do not differ."""


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
    """Has everything a number, does the file name states to go to, and no principle but Newton's?"""
    free = problem.method in (None, "newton")
    return free and bool(problem.states[1:]) and not (problem.symbols or problem.unknowns)


def followed_part(
    problem: Problem, case: str, earlier: Mapping[str, float], units: Mapping[str, str]
) -> PartSolution | None:
    """All finds of a part read off its motion; None where that does not answer all of them."""
    found = simulate(problem, Settings(values=earlier), units)
    if found.run.trajectory.outcome.refused or any(a.why or not _certain(a) for a in found.answers):
        return None
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


# --- as a check -------------------------------------------------------------------------------------------------------


def confirmation(problem: Problem, found: tuple[Found, ...], earlier: Mapping[str, float]) -> Confirmation:
    """What following the motion says of answers that were found otherwise."""
    constants = {s.name for s in problem.unknowns}
    values = dict(earlier)
    for f in found:
        what = f.find.found.what if f.find is not None else None
        if isinstance(what, Name) and what.name in constants and f.values is not None:
            values[what.name] = float(f.values[0])
    if problem.symbols or constants - values.keys():
        return Confirmation()
    try:
        other = simulate(problem, Settings(values=values, estimate=False), {})
    except PlanarError:
        return Confirmation()
    if other.run.trajectory.outcome.refused:
        return Confirmation()
    compared = _compared(found, other)
    # How good the numbers are that differ, only a second run tells.
    return _compared(found, simulate(problem, Settings(values=values), {})) if compared.differ else compared


def _compared(found: tuple[Found, ...], other: Simulation) -> Confirmation:
    by_name = {a.name: a for a in other.answers}
    same: list[str] = []
    differ: list[str] = []
    for f in found:
        a = by_name.get(f.name)
        if a is None or a.why:
            continue
        if f.word:
            agrees = f.word == a.word
        elif f.values is None or len(f.values) != len(a.values):
            continue
        else:
            apart = max(abs(float(x) - y) for x, y in zip(f.values, a.values, strict=True))
            size = max([*map(abs, a.values), a.scale])
            agrees = apart <= max(CERTAIN * size, DIFFERS * (a.error or 0.0))
        (same if agrees else differ).append(f.name)
    words = f"motion followed by independent facts: {len(same)} of {len(found)} answers agree" if same else ""
    if differ:
        words = f"motion followed by independent facts: does not confirm {', '.join(differ)}"
    return Confirmation(words, frozenset(same), tuple(differ))
