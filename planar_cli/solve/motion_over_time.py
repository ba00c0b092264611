"""A motion over time from the problem to its answers."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.values.exact import Unvalued
from planar_cli.equation.values.sample import other_draws, seeded
from planar_cli.errors import NoSolution, Undecided, undecided_at
from planar_cli.problem.scene.scene import Problem
from planar_cli.solve.between.branches.agreement import compared, integrated
from planar_cli.solve.between.branches.complete import completed
from planar_cli.solve.between.branches.reached import reaching
from planar_cli.solve.between.branches.solved_motion import SolvedMotion
from planar_cli.solve.between.equations.asked_finds import AskedFind, asked_letters
from planar_cli.solve.between.equations.masses import demand_mass
from planar_cli.solve.between.equations.methods import by_method, not_reached_by
from planar_cli.solve.between.equations.part_equations import NO_PARTS, PartEquations, part_equations
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.between.route.by_given import with_constants
from planar_cli.solve.between.route.by_numbers import ByNumbers, by_numbers
from planar_cli.solve.between.route.route import Router
from planar_cli.solve.between.route.throughout import Throughout
from planar_cli.solve.between.told.accelerations_asked import accelerated
from planar_cli.solve.between.told.answers import AnsweredFind, Answering, closed_formula
from planar_cli.solve.between.told.assumptions import presumed
from planar_cli.solve.between.told.half_swings import dates_by_modes, half_swings
from planar_cli.solve.between.told.in_order import in_order
from planar_cli.solve.between.told.independence import rests_on
from planar_cli.solve.between.told.motion_trace import motion_trace
from planar_cli.solve.between.told.needed import laws_of
from planar_cli.solve.between.told.provisos import course_provisos
from planar_cli.solve.between.trace.derivation import Route
from planar_cli.solve.curves.formulas import at_given_time
from planar_cli.solve.diagnosis.any_mass import demand_cancelled
from planar_cli.solve.diagnosis.directions_left_open import by_method_alone
from planar_cli.solve.diagnosis.left_open import moved_by_nothing
from planar_cli.solve.diagnosis.motions import missing
from planar_cli.solve.following.foreseen import fitting_draws
from planar_cli.solve.following.mode_search import ModeSearch
from planar_cli.solve.following.straight_ways import along_straight_ways_found
from planar_cli.solve.following.turns import count_turns
from planar_cli.solve.impulsive.checks import blow_checks
from planar_cli.solve.instant.unreached import not_reached
from planar_cli.solve.instant.verify import Disagreement
from planar_cli.solve.passages import Tale
from planar_cli.solve.regimes.mode_sequence import Workshop
from planar_cli.solve.regimes.regime_sequence import RegimeSequence
from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.solved_problem import PartSolution


def solve_course(
    problem: Problem, case: str, units: dict[str, str], earlier: Mapping[str, Any], trial: Mapping[str, float]
) -> PartSolution:
    """All finds of a problem whose states follow each other in time. `trial`: numbers of sought constants [SI] with
    which the motion passes all states, where they are known beforehand.
    """
    with seeded(*fitting_draws(problem, earlier)):
        try:
            return _part(problem, case, units, earlier, trial)
        except NoSolution:
            if not (problem.symbols and problem.unknowns):
                raise
            found = _otherwise_drawn(lambda: _part(problem, case, units, earlier, trial))
            if found is None:
                raise
            return found


def _otherwise_drawn(solve: Callable[[], PartSolution]) -> PartSolution | None:
    """The same with other numbers for letters. What is sought is not known, so that none can be chosen beforehand with
    which the motion passes all states; that none passes with the first ones says nothing. None: with all it is so.
    """
    for draw in other_draws()[1:]:
        try:
            with seeded(*draw):
                return solve()
        except (NoSolution, Undecided):
            continue
    return None


def _part(
    problem: Problem, case: str, units: dict[str, str], earlier: Mapping[str, Any], trial: Mapping[str, float]
) -> PartSolution:
    """The same with the numbers that are drawn for letters now; along the axes of the file, where it is not found in
    the ways in which things go.
    """
    workshop = Workshop(earlier)
    try:
        return _part_in(workshop, problem, case, units, trial)
    except (NoSolution, Undecided, Disagreement):
        if not workshop.left:
            raise
    return _part_in(Workshop(earlier, by_axes=True), problem, case, units, trial)


def _part_in(
    workshop: Workshop, problem: Problem, case: str, units: dict[str, str], trial: Mapping[str, float]
) -> PartSolution:
    """The same in one workshop."""

    def search(problem: Problem) -> SolvedMotion:
        return ModeSearch(problem, workshop, units=units, trial=trial).run()

    try:
        solved = reaching(problem, search)
        if problem.unknowns and (counted := along_straight_ways_found(problem, solved, workshop)) is not None:
            workshop = Workshop(workshop.earlier)
            solved = reaching(counted, search)
    except Unvalued as error:
        raise moved_by_nothing(problem) or error from error
    try:
        part = _told(solved, case)
    except Unvalued as error:
        lack = missing(solved.course)
        if lack is None and problem.unknowns and not trial:
            # As long as a constant is open the motion is not followed, and other modes may happen than those assumed.
            text = "not decided, with the modes that were assumed a state stays open"
            raise undecided_at(problem.states[0].mark, text) from error
        raise lack or error from error
    curves = part.tale.passages if part.tale is not None else ()
    tale = at_given_time(problem, solved, curves)
    return part if tale is None else replace(part, tale=tale)


def _told(solved: SolvedMotion, case: str) -> PartSolution:
    """The answers of a motion, and the way to them. Unvalued: something that is asked is open."""
    found = completed(solved)
    count_turns(found)
    course = found.course
    demand_mass(course, found.value)
    _demand_told(course)
    router, route = _route(found)
    begun = router.route(course.first.letters.values())
    start = {s: closed_formula(s, begun, course) for s in course.first.letters.values()}
    throughout = Throughout(course, found.followed, found.value, start)
    assumed = presumed(found, (route, begun))
    found = replace(found, checks=(*found.checks, *blow_checks(found), *compared(found)))
    found = integrated(found, asked_letters(found.finds).union(*(s.derivation.needs for s in route.steps)))
    answering = Answering(course, route, found.value, found.spans, throughout, found.oscillations)
    answers = _answers(answering, found.finds)
    demand_cancelled(course.scene, [a.found.find for a in answers], [a.found for a in answers])
    instants = _instants(course)
    passages = tuple(a.passage for a in answers if a.passage is not None)
    tale = Tale(passages, whole=False) if passages else None
    trace = motion_trace(found, route, answers, assumed, instants)
    trace = replace(trace, provisos=course_provisos(found, router.route))
    seen = found.followed.run if found.followed is not None and found.followed.foreseen else None
    # What is only approached is looked for again, less finely.
    seen = None if seen is not None and seen.trajectory.missed else seen
    return PartSolution(case, instants, tuple(a.found for a in answers), trace, tale, run=seen)


def _answers(answering: Answering, finds: tuple[AskedFind, ...]) -> tuple[AnsweredFind, ...]:
    """All answers. Undecided: some have none, with the names of those that have, so that these may be asked alone."""
    told, names, refused = list[AnsweredFind](), list[str](), list[Undecided]()
    for asked in finds:
        try:
            told.append(answering.answer(asked))
            names.append(f"`{asked.find.name}`")
        except Undecided as error:
            refused.append(error)
    if not refused:
        return tuple(told)
    rest = f"; asked for without what is open, {', '.join(names)} can be told" if names else ""
    raise Undecided("; ".join(dict.fromkeys(map(str, refused))) + rest) from refused[0]


def _route(found: SolvedMotion) -> tuple[Router, Route]:
    """The way to what is asked, by the method of the file, and who plans it. Where it rests on a law of motion anyway,
    the equations of kinetics are there to tell a tension too, and the work on a part would tell it again.
    """
    parts = part_equations(found.course, found.value)
    router, route = _route_with(found, parts)
    if parts.numbers and any(
        law.f != 0 for step in route.steps for e in step.derivation.equations for law in laws_of(e)
    ):
        parts = NO_PARTS
        router, route = _route_with(found, parts)
    found.course.between.tensions = dict(parts.tensions)
    return router, route


def _route_with(found: SolvedMotion, parts: PartEquations) -> tuple[Router, Route]:
    """The way with the balances of these parts."""
    course, method = found.course, found.course.problem.method
    unknowns, equations = course.chain().unknowns, course.equations
    balanced, placed = course.equilibria, set(course.equilibria.branch.values)
    if placed & set(course.sought()) or any(placed & e.residual.free_symbols for e in equations):
        unknowns, equations = unknowns | placed, (*balanced.equations, *equations)
    value = found.value.extended(parts.numbers)
    swings = half_swings(course, value)
    harmonic = (replace(e, offered=frozenset(course.between.integrating)) for e in swings)
    more = (*parts.equations, *harmonic, *dates_by_modes(course, value))
    unknowns, equations = unknowns | set(parts.numbers), (*equations, *more)
    allowed = by_method(equations, method)
    steps = tuple(s for s in found.branch.steps if len(by_method(s.equations, method)) == len(s.equations))
    lettered = rests_on(course, found.value)
    loose = found.guessed | {s for s in unknowns & set(found.value.values) if s not in found.branch.values}
    followed = ByNumbers() if lettered else by_numbers(course, loose, course.sought(), found.value)
    follows = method is None or method in course.between.integrating
    by_steps = followed if follows else None
    natural = course.natural(unknowns)
    # A tension that the work on a part tells needs no acceleration.
    kinetics = frozenset[str]() if parts.numbers else accelerated(course, found.finds)
    router = Router(allowed, unknowns, value, course.symbolic, steps, by_steps, natural, kinetics)
    asked = [*in_order(course, found.finds, asked_letters(found.finds) & unknowns), *parts.numbers]
    route = router.route(wanted := with_constants(asked, router.plain, unknowns))
    if method is not None:
        free = Router(equations, unknowns, value, course.symbolic, found.branch.steps, followed, natural, kinetics)
        if missing := not_reached_by(follows, route, wanted, lambda: free.route(wanted)):
            raise by_method_alone(course, missing, allowed)
    return router, route


def _demand_told(course: StatedMotion) -> None:
    """FileProblem: the principle that was named does not tell a force that the file states or asks for."""
    for regime in course.distinct_regimes():
        said = {s for e in course.said.get(id(regime), ()) for s in sp.sympify(e).free_symbols}
        missing = [s.name.replace("__", "_") for s in regime.general.unreached if s in said]
        if missing:
            raise not_reached(course.problem.method, missing, course.problem.find[0].mark)


def _instants(course: RegimeSequence) -> tuple[InstantSolution, ...]:
    """The general positions of the regimes in which time passes; in a file of blows alone the one before the first."""
    regimes = course.distinct_regimes()
    for regime in regimes:
        if regime.general.solution is not None:
            regime.general.solution.quiet = not regime.runs
    running = [r for r in regimes if r.runs] or regimes[:1]
    return tuple(r.general.solution for r in running if r.general.solution is not None)
