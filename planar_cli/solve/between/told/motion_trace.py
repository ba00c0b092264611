"""From a solved motion to its trace: what is said of it, apart from what solved it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from copy import copy
from dataclasses import replace
from itertools import pairwise
from typing import Any

import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.problem.scene.facts import Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.solve.between.branches.solved_motion import SolvedMotion
from planar_cli.solve.between.branches.taken import taken_of
from planar_cli.solve.between.equations.asked_finds import AskedFind
from planar_cli.solve.between.equations.balances import StateBalance, balance_equations
from planar_cli.solve.between.equations.by_centres import in_centres, without_places
from planar_cli.solve.between.equations.energies import energy_parts, impulse_integral
from planar_cli.solve.between.equations.modes_of_oscillation import modes_told
from planar_cli.solve.between.equations.oscillation import Oscillation, roots_of, stability
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.between.roots.extremes import Aim
from planar_cli.solve.between.told.answers import AnsweredFind
from planar_cli.solve.between.told.asked_speed import by_the_speed_asked
from planar_cli.solve.between.told.asked_unknown import by_what_is_asked
from planar_cli.solve.between.told.by_functions import by_functions
from planar_cli.solve.between.told.dead_positions import by_triangles
from planar_cli.solve.between.told.elapsed import by_what_passes
from planar_cli.solve.between.told.independence import lettered_starts, settled
from planar_cli.solve.between.told.linear_parts import energies_near, linear_parts
from planar_cli.solve.between.told.links_in_line import by_lines, line_of
from planar_cli.solve.between.told.near_rest import near_rest
from planar_cli.solve.between.told.needed import asked_at, laws_of_motion, modes_asked, wanted_of
from planar_cli.solve.between.told.one_body import as_one_body
from planar_cli.solve.between.told.rates_beside import with_rates_beside
from planar_cli.solve.between.told.terminal import by_terminal_speed
from planar_cli.solve.between.told.times_in_turn import times_in_turn
from planar_cli.solve.between.told.told_finds import FindTeller
from planar_cli.solve.between.told.told_vibrations import VibrationTracer
from planar_cli.solve.between.trace.derivation import DerivedStep, Route, at_right_angles, levels
from planar_cli.solve.between.trace.oscillation_trace import OscillationTrace
from planar_cli.solve.between.trace.span_trace import SpanIntegral
from planar_cli.solve.between.trace.trace import (
    AimTrace,
    BalanceTrace,
    Centre,
    Impact,
    ImpactEquation,
    MotionTrace,
    RegimeTrace,
    Relation,
    RouteStep,
    RouteTrace,
    Turning,
)
from planar_cli.solve.impulsive.impact import Blow
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Written
from planar_cli.solve.regimes.constant_rates import constants_of, lasting_letters
from planar_cli.solve.regimes.equations import DATA, Equation
from planar_cli.solve.regimes.meetings import Together
from planar_cli.solve.regimes.mode_sequence import fixed_time
from planar_cli.solve.solution import InstantSolution


def motion_trace(
    found: SolvedMotion,
    route: Route,
    answers: Sequence[AnsweredFind],
    presumed: tuple[sp.Expr, ...],
    instants: tuple[InstantSolution, ...],
) -> MotionTrace:
    """All that is said of a motion. `route`: the way to what is asked; `presumed`: what is positive, and need not be;
    `instants`: the general positions of its regimes that are told.
    """
    course = found.course
    whole = any(a.passage is not None for a in answers)
    level = levels(route.formulas.items())
    routes = [route, *(a.passing for a in answers if a.passing is not None)]
    tracer = _Tracer(course, found.value, lettered_starts(course, found.value))
    told = tracer.route(route)
    lasting = lasting_letters(course.distinct_regimes(), course.given())
    worked = {s: found.value(course.regimes[0].closed(s)) for s in course.between.tensions.values()}
    lasting = replace(lasting, numbers={**lasting.numbers, **worked})
    teller = FindTeller(course, lasting, found.value.extended(lasting.numbers), level)
    requests = teller.requests(found.finds)
    made = MotionTrace(
        problem=course.problem,
        states=tuple(s.name for s in course.states),
        ledger=course.ledger,
        value=found.value.extended({**lasting.numbers, **tracer.vibrations.numbers, **teller.numbers}),
        symbolic=course.symbolic,
        unknowns=course.chain().unknowns | worked.keys(),
        general={own: general for stop in course.stops.values() for general, own in stop.letters.items()},
        varying=frozenset(s for regime in course.distinct_regimes() for s in regime.letters),
        free=frozenset(course.regimes[0].free if course.regimes else ()),
        guessed=found.guessed,
        integrated=found.integrated,
        followed=None if found.followed is None else found.followed.values,
        turnings=_turnings(found),
        route=told,
        requests=requests,
        passing={a.found.name: tracer.route(a.passing) for a in answers if a.passing is not None},
        spans=tuple(_span(s, level) for s in found.spans),
        oscillations=tuple(_oscillation(course, o, found.value, found.finds) for o in found.oscillations),
        regimes=tuple(_regime(found, i, () if whole else routes) for i in instants),
        stretches=tuple(
            (a.name, b.name, course.laws[k].laws)
            for k, (a, b) in enumerate(pairwise(course.states))
            if not course.is_impulsive(k)
        ),
        unused=tuple(_unused(course, route)),
        checks=found.checks,
        presumed=presumed,
        corners=_corners(found),
        taken=taken_of(found),
    )
    by_asked = by_the_speed_asked(by_what_is_asked(by_triangles(made) or by_lines(made)))
    return with_rates_beside(by_functions(by_terminal_speed(by_what_passes(by_asked))))


def _span(found: SpanIntegral, level: Mapping[sp.Symbol, sp.Expr]) -> SpanIntegral:
    """A quantity over a span with its formula as the finds have it."""
    return found if found.formula is None else replace(found, formula=at_right_angles(found.formula, level))


def _unused(course: StatedMotion, route: Route) -> Iterator[BalanceTrace]:
    """Balances of energies between states, where the route has none."""
    sources = (e.source for step in route.steps for e in step.derivation.equations)
    if any(isinstance(b, StateBalance) and b.law.letter for b in sources):
        return
    for k in range(1, len(course.states)):
        for e in balance_equations(course, course.between.closed, k):
            b = e.source
            if isinstance(b, StateBalance) and b.law.letter:
                yield BalanceTrace(b.law, b.since.name, b.stop.name, b.before, b.after, b.brought, b.amounts)


def _corners(found: SolvedMotion) -> tuple[str, ...]:
    """States of the file at which the motion that was followed passes over a corner."""
    run = None if found.followed is None else found.followed.run
    if run is None:
        return ()
    times = {x.t for x in run.trajectory.transitions if x.kind == "corner"}
    return tuple(e.name for e in run.trajectory.events if e.t in times)


def _turnings(found: SolvedMotion) -> tuple[Turning, ...]:
    course = found.course
    turnings = []
    for name, (expr, words) in course.modes.turnings.items():
        t = course.stops[name].t
        # After a slight touch the time depends on the touch alone.
        timed = not course.symbolic and t in found.value.values and course.departure is None
        names = [s.name for s in course.states]
        following = course.states[names.index(name) + 1 :][:1] if name in names else ()
        dated = next((r.text for s in following if (r := fixed_time(s.relations)) is not None), "")
        turnings.append(Turning(name, t if timed else None, expr, words, dated))
    return tuple(turnings)


def _oscillation(
    course: StatedMotion, found: Oscillation, value: Valuation, finds: Sequence[AskedFind]
) -> OscillationTrace:
    rates = (found.regime.general.rate_of(u) for u in found.speeds)
    return OscillationTrace(
        state=found.stop.name,
        motion=tuple(zip(rates, found.laws, strict=True)),
        stiffness=found.stiffness[0][0],
        damping=found.damping[0][0],
        square=found.square,
        period=found.period,
        roots=() if found.single else tuple(roots_of(found, value)),
        verdict=stability(found, value),
        linear=linear_parts(course, found, value),
        near=near_rest(found, value),
        modes=modes_told(found, finds, value),
        energies=energies_near(course, found),
    )


def _regime(motion: SolvedMotion, instant: InstantSolution, routes: Sequence[Route]) -> RegimeTrace:
    """One regime. `routes`: what rests on it; none: all of it is told."""
    course = motion.course
    asked = asked_at(course, motion.finds, instant)
    wanted, resting = wanted_of(course, routes, instant, asked, motion.value) if routes else (None, None)
    if wanted is not None and (sticking := modes_asked(course, motion.finds, instant)):
        wanted, resting = wanted | sticking, (resting or frozenset()) | sticking
    # A state that is never reached is none of these: what goes towards it goes on without end.
    names = [*(s.name for s in course.states), ""]
    spans = zip(pairwise(names), course.regimes, strict=False)
    acts = [span for span, r in spans if r.general.solution is instant]
    if not acts and course.beyond is not None and course.beyond.general.solution is instant:
        acts = [(names[-2], "")]
    acts += [
        (state.name, state.name)
        for state, stretch in course.modes.equilibria
        if course.workshop.regime(stretch).general.solution is instant
    ]
    regime = next((r for r in course.distinct_regimes() if r.general.solution is instant), None)
    constants = {} if regime is None else constants_of(regime, course.given())
    ways = {} if regime is None else regime.going()
    return RegimeTrace(instant, tuple(acts), wanted, resting, asked, laws_of_motion(course, instant), constants, ways)


class _Tracer:
    """Turns equations and routes into what is said of them. `value`: numbers of everything; `lettered`: letters of the
    first state whose numbers rest on drawn ones.
    """

    def __init__(self, course: StatedMotion, value: Valuation, lettered: frozenset[sp.Symbol]) -> None:
        self.course, self.value, self.base, self.lettered = course, value, course.base(), lettered
        self._impacts: dict[str, Impact] = {}
        self.vibrations = VibrationTracer(course, value)
        self._level: dict[sp.Symbol, sp.Expr] = {}
        """Angles of directions along the axes."""

    def route(self, route: Route) -> RouteTrace:
        known = settled(route, self.value, self.base, self.lettered)
        self._level = levels(route.formulas.items())
        steps = without_places([self._step(step, route.plain) for step in route.steps])
        names = [s.name for s in self.course.states]
        times = [stop.t.name for stop in self.course.stops.values()]
        steps = times_in_turn(steps, names, times, self.course.ledger)
        return RouteTrace(steps, known, route.formulas, route.plain)

    def _step(self, step: DerivedStep, plain: Mapping[sp.Symbol, sp.Expr]) -> RouteStep:
        d = step.derivation
        relations = tuple(self.vibrations.told(self._relation(e), plain) for e in d.equations)
        results = self.vibrations.results(relations, step.results)
        return RouteStep(relations, d.unknowns, d.needs, results, step.datum, line_of(relations, results))

    def _relation(self, e: Equation) -> Relation:
        aim = e.source if isinstance(e.source, Aim) else None
        source = self._source(None if aim is not None else e.source)
        law = None if aim is None or aim.law is None else self._source(aim.law.source)
        told = None
        if aim is not None and (isinstance(law, BalanceTrace) or aim.law is None):
            told = AimTrace(aim.quantity, aim.formula, law if isinstance(law, BalanceTrace) else None, aim.timed)
        data = e.kind in DATA
        here = in_centres(self.course, e, self._level)
        return Relation(
            e.residual, e.kind, e.words, e.stop, e.since, data, e.span, e.law, source, e.offered, told, here, e.of
        )

    def _source(self, source: Any) -> BalanceTrace | ImpactEquation | None:
        if source is None or isinstance(source, Together):
            return None
        if isinstance(source, StateBalance):
            b = source
            parts = energy_parts(self.course, b, self.value)
            whole = impulse_integral(self.course, b)
            ends = b.since.name, b.stop.name
            return as_one_body(BalanceTrace(b.law, *ends, b.before, b.after, b.brought, b.amounts, parts, whole))
        blow, written = source
        return self._impact_equation(blow, written)

    # --- impacts -----------------------------------------------------------------------------------------------------

    def _impact_equation(self, blow: Blow, w: Written) -> ImpactEquation:
        impact = self._impacts.setdefault(blow.since.name, self._impact(blow))
        left, right = self._here(blow, w.left), self._here(blow, w.right)
        along = None if w.along is None else (self._here(blow, w.along[0]), self._here(blow, w.along[1]))
        return ImpactEquation(impact, left, right, w.law, w.lead, w.words, w.bodies, _centre(blow, w), along)

    def _here(self, blow: Blow, expr: Any) -> sp.Expr:
        """In letters of the states of a blow, with the right angles of its place put in."""
        return at_right_angles(blow.here(sp.sympify(expr), told=True), self._level)

    def _impact(self, blow: Blow) -> Impact:
        hits = [j for j in blow.struck.joints if j.strikes and blow.system.modes[j.name].facts.pushes]
        if blow.stage is None:
            return Impact(blow.since.name, len(hits), None)
        known = self.value.values
        places = {s: known[own] for s, own in blow.stop.letters.items() if own in known}
        value = blow.scene.valuations[0].extended({**known, **places})
        before = {c.symbol: blow.since.letters[c.symbol] for c in blow.before.coordinates}

        def here(expr: Any) -> sp.Expr:
            return at_right_angles(sp.sympify(expr).xreplace(before), self._level)

        stages = (_in_velocities(blow.stage, here),)
        system = copy(blow.system)
        system.wrenches = tuple(_moved(w, here) for w in system.wrenches)
        trial = replace(blow.trial, system=system)
        solution = InstantSolution("", blow.struck, trial, (), stages, blow.stage.lines, value)
        return Impact(blow.since.name, len(hits), solution)


def _centre(blow: Blow, w: Written) -> Centre | None:
    """The moment centre of an equation, where it has no name of its own."""
    found = None if blow.stage is None or w.law != "moment" else blow.stage.centres.get(w.lead)
    if found is None:
        return None
    place, through = found
    return Centre(blow.here(sp.sympify(place.x)), blow.here(sp.sympify(place.y)), tuple(through))


def _in_velocities(stage: Stage, here: Callable[[Any], sp.Expr]) -> Stage:
    """A plan of a blow with the velocities just after it by its unknowns, where an instant names accelerations."""
    explicit = {x.symbol: x.expression for x in stage.lines}
    put = {
        b: [(Vec(here(d.x), here(d.y)), here(c.xreplace(explicit))) for d, c in parts]
        for b, parts in stage.accelerations.items()
    }
    return replace(stage, accelerations=put)


def _moved(wrench: Wrench, here: Callable[[Any], sp.Expr]) -> Wrench:
    """An impulse or a momentum at the place of a blow."""
    force = None if wrench.force is None else Vec(here(wrench.force.x), here(wrench.force.y))
    return replace(wrench, force=force, couple=here(wrench.couple), magnitude=here(wrench.magnitude))
