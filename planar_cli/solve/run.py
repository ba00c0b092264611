"""Solve a whole file: its own finds, then each case with the finds of earlier ones."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import replace
from decimal import DecimalException
from typing import Any

import sympy as sp
from sympy.core.random import seed

from planar_cli.equation.system.setup import Earlier, first_unit, numbers_of
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import Unvalued
from planar_cli.errors import Mark, NoSolution, NoValue, Undecided, refuse
from planar_cli.problem.implied.as_meant import as_meant
from planar_cli.problem.implied.instants_in_time import with_dated_instants
from planar_cli.problem.implied.lettered import lettered
from planar_cli.problem.scene.scene import Find, Problem
from planar_cli.solve.angles_given import with_angles_put_in
from planar_cli.solve.central import best_placed
from planar_cli.solve.diagnosis.any_mass import demand_cancelled
from planar_cli.solve.diagnosis.beginning import demand_direction
from planar_cli.solve.diagnosis.cases import several
from planar_cli.solve.diagnosis.clash import check_positions
from planar_cli.solve.diagnosis.failures import explain_failure, place, singular_position
from planar_cli.solve.diagnosis.impacts import pressing_impact, unnamed_impact
from planar_cli.solve.diagnosis.known import demand_stated
from planar_cli.solve.diagnosis.no_value import without_value
from planar_cli.solve.held import outcome_that_holds
from planar_cli.solve.instant.by_direction import SPEEDS, alike, is_settled, with_speeds, with_statements
from planar_cli.solve.instant.finish import Finisher
from planar_cli.solve.instant.instant import NONLINEAR, OPEN, Instant, Lift, Trial, make_instant
from planar_cli.solve.instant.modes_search import search
from planar_cli.solve.instant.seek import seek
from planar_cli.solve.instant.sign_pairs import BothWays, demand_one_way
from planar_cli.solve.instant.unreached import not_reached
from planar_cli.solve.instant.verify import Disagreement
from planar_cli.solve.limits_at_start import with_limits_at_start
from planar_cli.solve.modes_after_blows import with_modes_followed
from planar_cli.solve.passages import Tale
from planar_cli.solve.principled import instant_words, principle_of, usual
from planar_cli.solve.regimes.mode_dates import told_by_modes
from planar_cli.solve.roads import in_general, is_curve, is_kinematic, runs_in_time, without
from planar_cli.solve.solution import Found, InstantSolution
from planar_cli.solve.solved_problem import PartSolution, Solution
from planar_cli.solve.states import solve_states, stand_at_states
from planar_cli.solve.where_asked import where_asked
from planar_cli.solve.with_drivers import with_drivers

NO_MOTION = frozenset(("PL620", "PL621", "PL622"))
"""Verdicts that a motion which is followed to all states refutes."""
AT_ONCE = "PL528"
"""Where several corners strike at once one point of impact does not do."""
SEED = 1
"""SymPy factors and tests for zero at places that it draws: the same ones whenever, and after whatever, it solves."""


def solve_problem(problem: Problem, method: str | None = None) -> Solution:
    """All finds of a problem, told by a method (None: the file's own, else the plan chooses). Raises FileProblem,
    NoSolution or Undecided.
    """
    return best_placed(with_limits_at_start(as_meant(problem)), lambda p: _solved(p, method))


def _solved(problem: Problem, method: str | None) -> Solution:
    """The same in the coordinates of the problem."""
    started = time.perf_counter()
    seed(SEED)
    if not problem.find and not any(case.problem.find for case in problem.cases):
        raise refuse(Mark(problem.file, 1, 1), "PL571", "nothing is asked", "write `find: {a: a(G)}`")
    problem = with_dated_instants(lettered(_by(problem, method or problem.method)))
    objection = "" if problem.method is None else principle_of(problem.method).objection(problem)
    if objection:
        hint = f"leave `method` out, or write {instant_words()}"
        raise refuse(Mark(problem.file, 1, 1), "PL570", f"method {problem.method}: {objection}", hint)
    units = {a.name: u for a in problem.answers if (u := _answer_unit(a.value)) is not None}
    earlier: dict[str, Earlier] = {}
    parts: list[PartSolution] = []
    if problem.find:
        parts.append(with_angles_put_in(where_asked(_part, problem, "", units, {})))
    for case in problem.cases:
        letters = {s.name for s in case.problem.symbols} | {"g"} - {s.name for s in case.problem.given}
        fit = {n: e for n, e in earlier.items() if {s.name for s in e.value.free_symbols} <= letters}
        own = replace(case.problem, clockwise=parts[-1].clockwise if parts else ())
        part = with_angles_put_in(where_asked(_part, own, case.name, units, fit))
        parts.append(part)
        for found in part.found:
            if (exact := _exact(found)) is not None:
                earlier[f"{case.name}.{found.name}"] = Earlier(exact, found.unit.text)
    return Solution(problem, tuple(parts), {"solve": time.perf_counter() - started})


def _exact(found: Found) -> sp.Expr | None:
    """The one number that is found, exact where it can be; in letters its formula; None: it is neither."""
    formula = found.expressions[0] if found.expressions and len(found.expressions) == 1 else None
    if found.values is None:
        return formula if found.kind == "number" else None
    if len(found.values) != 1:
        return None
    return sp.Rational(str(found.values[0])) if formula is None or formula.free_symbols else formula


def _by(problem: Problem, method: str | None) -> Problem:
    """The problem and its cases by another method than their own."""
    if method is None:
        return problem
    cases = tuple(replace(c, problem=replace(c.problem, method=method)) for c in problem.cases)
    return replace(problem, method=method, cases=cases)


def _part(problem: Problem, case: str, units: dict[str, str], earlier: dict[str, Earlier]) -> PartSolution:
    """One part; what is not decided otherwise is read off the motion, if there is one."""
    numbers = numbers_of(earlier)
    demand_stated(problem, earlier)
    if not problem.states[1:]:
        return _confirmed(problem, _derived(problem, case, units, earlier), earlier)
    from planar_cli.solve.followed import (
        SOME_STEPS,
        can_be_followed,
        followed_part,
        many_bodies,
        pressed_by_impacts,
        strikes_unnamed,
    )
    from planar_cli.solve.steady import with_steady_states
    from planar_cli.solve.struck_turns import counted_as_struck

    problem = counted_as_struck(with_steady_states(problem, numbers), earlier)
    pressed = pressed_by_impacts(problem)
    if strikes_unnamed(problem) or many_bodies(problem) or pressed:
        part = followed_part(problem, case, numbers, units) if can_be_followed(problem) else None
        if part is not None:
            return part
        if strikes_unnamed(problem):
            raise unnamed_impact(problem)
        if pressed:
            raise pressing_impact(problem)
    try:
        derived = _derived(problem, case, units, earlier)
    except Disagreement:
        raise  # a third road does not settle what two of them see differently
    except (Undecided, NoSolution) as error:
        if problem.unknowns:
            return _shot(problem, case, units, earlier, error)
        # Where the modes change in ways that no equation tells, as from blow to blow, it is only followed. And that no
        # motion comes to a state does not stand against one that does.
        by_steps = isinstance(error, Undecided) or told_by_modes(problem) or _steps_may_tell(error)
        follows = by_steps and can_be_followed(problem)
        ends = isinstance(error, Undecided)
        part = followed_part(problem, case, numbers, units, SOME_STEPS, ends) if follows else None
        if part is None:
            raise
        return part
    try:
        return _confirmed(problem, derived, earlier)
    except Disagreement as error:
        if not problem.unknowns:
            raise
        # The equations are those of modes that do not happen: a constant that is open kept it from being followed.
        return _shot(problem, case, units, earlier, error)


def _steps_may_tell(error: NoSolution) -> bool:
    """Does it say that there is no motion, or none that comes to some state, or that several corners strike at once?"""
    return any(d.code in NO_MOTION or d.code == AT_ONCE for d in error.diagnostics)


def _shot(
    problem: Problem,
    case: str,
    units: dict[str, str],
    earlier: dict[str, Earlier],
    error: Undecided | NoSolution,
) -> PartSolution:
    """One part whose unknown the first equations did not give: it is found by shooting, and then the equations of what
    happens give it, or the motion alone. `error`: why not otherwise, raised where this fails too.
    """
    from planar_cli.solve.sought import by_motion, root_of

    sought = root_of(problem, earlier, error)
    try:
        part = _in_time(sought.problem, case, units, earlier, sought.values)
    except (Undecided, NoSolution):
        if (followed := by_motion(sought.problem, case, units, earlier, sought.values)) is None:
            raise error from None
        part = followed
    return _confirmed(sought.problem, part, earlier)


def _confirmed(problem: Problem, part: PartSolution, earlier: Mapping[str, Earlier]) -> PartSolution:
    """The part with what following its motion says. Disagreement: it gives other answers."""
    if part.motion is None:
        return part
    from planar_cli.solve.confirmation import confirmation

    confirmed = confirmation(problem, part, earlier)
    return replace(part, confirmed=confirmed, run=part.run or confirmed.run)


def _derived(problem: Problem, case: str, units: dict[str, str], earlier: dict[str, Earlier]) -> PartSolution:
    """One part. Undecided: a numerical method stops before its goal, or a formula has no value."""
    try:
        return with_modes_followed(solve_part, problem, case, units, earlier)
    except (NoValue, DecimalException) as error:
        raise without_value(problem, error) from error


def solve_part(problem: Problem, case: str, units: dict[str, str], earlier: dict[str, Earlier]) -> PartSolution:
    """One part: formulas and curves; a motion over time; or instants that are each complete in themselves."""
    if in_general(problem):
        return _formulas(problem, case, units, earlier)
    if is_kinematic(problem):
        try:
            return _formulas(problem, case, units, earlier)
        except NoSolution:
            pass
    if runs_in_time(problem):
        return _in_time(problem, case, units, earlier)
    curves = [f for f in problem.find if is_curve(f.found.what)]
    if curves:
        return _with_curves(problem, curves, case, units, earlier)
    always = tuple(law.statement for law in problem.motion)
    if problem.states and not stand_at_states(problem):
        return _in_time(problem, case, units, earlier)
    if problem.states:
        try:
            return solve_states(problem, case, always, units, earlier, solve_instant)
        except NoSolution:
            return _in_time(problem, case, units, earlier)
        except Undecided as error:
            try:
                return _in_time(problem, case, units, earlier)
            except NoSolution:
                raise error from None
    try:
        solution, found = solve_instant(
            problem, always, problem.instant or (), problem.find, units, earlier, problem.instant is None
        )
    except (NoSolution, Unvalued):
        if problem.instant is not None or not problem.coordinates:
            raise
        return _formulas(problem, case, units, earlier)
    return PartSolution(case, (solution,), tuple(found))


def _formulas(problem: Problem, case: str, units: dict[str, str], earlier: dict[str, Earlier]) -> PartSolution:
    """Formulas that hold throughout; imported when needed, as one instant needs none of it."""
    from planar_cli.solve.curves.formulas import solve_formulas

    return solve_formulas(problem, case, units, earlier)


def _in_time(
    problem: Problem,
    case: str,
    units: dict[str, str],
    earlier: dict[str, Earlier],
    trial: Mapping[str, float] | None = None,
) -> PartSolution:
    """A motion from state to state; imported when needed. `trial`: numbers of sought constants, found before."""
    from planar_cli.solve.motion_over_time import solve_course

    return solve_course(problem, case, units, earlier, trial or {})


def _with_curves(
    problem: Problem, curves: list[Find], case: str, units: dict[str, str], earlier: dict[str, Earlier]
) -> PartSolution:
    """Curves hold throughout, whatever instant the other finds are about."""
    rest = without(problem, curves)
    apart = replace(problem, find=tuple(curves), instant=None, states=())
    drawn = _formulas(apart, case, units, earlier)
    if not rest.find:
        return drawn
    part = solve_part(rest, case, units, earlier)
    by_name = {f.name: f for f in (*part.found, *drawn.found)}
    part.found = tuple(by_name[f.name] for f in problem.find)
    told = part.tale.passages if part.tale is not None else ()
    passages = (*told, *(drawn.tale.passages if drawn.tale is not None else ()))
    part.tale = Tale(passages, part.tale.whole if part.tale is not None else False)
    return part


def solve_instant(
    problem: Problem,
    always: tuple[Any, ...],
    now: tuple[Any, ...],
    finds: tuple[Find, ...],
    units: dict[str, str],
    earlier: dict[str, Earlier],
    open_form: bool,
    state: str = "",
) -> tuple[InstantSolution, list[Found]]:
    """One instant."""
    instant = make_instant(problem, always, now, earlier, open_form)
    if instant.principle.general:
        instant.lift = _lift(problem, always, earlier)
    return with_drivers(instant, lambda: _solve(instant, finds, units, state))


def _lift(problem: Problem, always: tuple[Any, ...], earlier: dict[str, Earlier]) -> Lift:
    """How a principle gets a general position of this problem; imported when needed."""
    from planar_cli.solve.regimes.lifted import Lift as Lifting

    return Lifting(problem, always, earlier)


def _solve(
    instant: Instant, finds: tuple[Find, ...], units: dict[str, str], state: str
) -> tuple[InstantSolution, list[Found]]:
    check_positions(instant)
    if instant.must_seek():
        return _searched(instant, [], finds, units, state)
    held, rejected = search(instant)
    if not held and any(t.objection in (OPEN, NONLINEAR) for t in rejected):
        singular_position(instant, rejected, finds)
        return _searched(instant, rejected, finds, units, state)
    if not held:
        raise explain_failure(instant, rejected, finds)
    trials = several(instant, held)
    demand_direction(trials[0], finds)
    return outcome_that_holds(instant, trials, tuple(rejected), finds, units, state)


def _searched(
    instant: Instant, rejected: list[Trial], finds: tuple[Find, ...], units: dict[str, str], state: str
) -> tuple[InstantSolution, list[Found]]:
    """As `_seek`, or else by the direction of open speeds; `rejected`: modes that numbers alone did not settle."""
    try:
        return _seek(instant, finds, units, state)
    except BothWays:
        raise
    except NoSolution as error:
        if (told := _by_direction(instant, finds, units, state)) is not None:
            return told
        if any(t.objection == OPEN for t in rejected):
            raise explain_failure(instant, rejected, finds) from error
        raise
    except Unvalued as error:
        # A load depends on a speed which nothing tells.
        rejected = rejected or search(instant)[1]
        if not any(t.objection == OPEN for t in rejected):
            raise
        raise explain_failure(instant, rejected, finds) from error


def _by_direction(
    instant: Instant, finds: tuple[Find, ...], units: dict[str, str], state: str
) -> tuple[InstantSolution, list[Found]] | None:
    """Answers that depend on the direction of open speeds alone, where inequalities tell it; None: there are none."""
    told: list[tuple[InstantSolution, list[Found]]] = []
    for speed in SPEEDS:
        for statements in with_speeds(instant.statements, speed):
            other = with_statements(instant, statements)
            if other.must_seek() or is_settled(other):
                told.append(_solve(other, finds, units, state))
                break
    return told[0] if len(told) == len(SPEEDS) and alike(*told) else None


def _seek(
    instant: Instant, finds: tuple[Find, ...], units: dict[str, str], state: str
) -> tuple[InstantSolution, list[Found]]:
    """Constants, angles, speeds or extremes are sought."""

    def asked(system: System) -> list[sp.Expr]:
        return Finisher(instant, Trial((), system, (), (), ""), (), units, state).asked(finds)

    def targets(system: System) -> set[sp.Symbol]:
        return {s for e in asked(system) for s in e.free_symbols}

    try:
        sought, rejected = seek(instant, targets)
    except (NoSolution, Unvalued):
        if not instant.principle.general:
            raise
        # What the named principle does not lead to may be there all the same: then it is the method that fails.
        named, instant.principle = instant.principle, usual()
        try:
            seek(instant, targets)
        finally:
            instant.principle = named
        raise not_reached(instant.scene.problem.method, [f.name for f in finds], finds[0].mark) from None
    if not instant.statements.extremes:
        sought = demand_one_way(instant, sought, asked, place(instant, finds))
    solution, found = Finisher(instant, sought.trial, (), units, state).solve_sought(sought, finds)
    demand_cancelled(instant.scene, finds, found)
    solution.left_out = (*rejected, *sought.others)
    return solution, found


def _answer_unit(value: Any) -> str | None:
    if isinstance(value, tuple):
        return next((u for u in map(_answer_unit, value) if u is not None), None)
    if isinstance(value, bool | str):
        return None
    return first_unit(value)
