"""The flight after a blow on a slope, back to the slope, along it and perpendicular to it, where the blow was resolved:

perpendicular to the slope:   v_n Δt = 1/2 g Δt² cos β
along the slope:              d = v_t Δt + 1/2 g Δt² sin β
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import simplified, trigonometric
from planar_cli.equation.values.ledger import Kind, Role
from planar_cli.problem.scene.scene import GROUND, with_article
from planar_cli.records import record
from planar_cli.report.words.origins import is_steady
from planar_cli.solve.between.trace.trace import MotionTrace, Relation, Request, Result, RouteStep
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.units import parse_unit

RESOLVED = "the velocities after the blow"
"""Words of the relations between the components after a blow along the slope, and along x and y."""
TIME = "Delta_t"


@record
class _Flight:
    """From a blow on a slope back to the slope. `resolved`: the steps of the components along x and y after the blow,
    by those along the slope and perpendicular to it; `step`: where and when it comes back.
    """

    resolved: tuple[RouteStep, RouteStep]
    step: RouteStep
    speeds: tuple[sp.Symbol, sp.Symbol]
    """Along the slope and perpendicular to it."""
    tangent: tuple[sp.Expr, sp.Expr]
    accelerations: tuple[sp.Expr, sp.Expr]
    """Along the slope and perpendicular to it."""
    places: tuple[sp.Symbol, sp.Symbol]
    since: str
    stop: str


def with_flight_axes(part: PartSolution) -> PartSolution:
    """A part whose motion tells such a flight in the axes of the slope."""
    motion = part.motion
    if motion is None or motion.symbolic or TIME in motion.ledger.symbols:
        return part
    found = next((f for f in _flights(motion) if _is_alone(f, motion)), None)
    # What is asked may count the other way than the components after the blow.
    told = None if found is None else next(filter(None, (_told(motion, found, sense) for sense in (1, -1))), None)
    return part if found is None or told is None else _without_forces(replace(part, motion=told), found)


def _without_forces(part: PartSolution, found: _Flight) -> PartSolution:
    """The part without the forces of a regime that acts in such a flight alone: what it falls with stands there."""
    motion = part.motion
    assert motion is not None
    flown = [r for r in motion.regimes if not r.asked and {a for a, _ in r.stretches} == {found.since}]
    if not flown or len(flown) == len(motion.regimes):
        return part
    solutions = [r.solution for r in flown]
    instants = tuple(i for i in part.instants if all(i is not s for s in solutions))
    return replace(
        part, instants=instants, motion=replace(motion, regimes=tuple(r for r in motion.regimes if r not in flown))
    )


def _flights(motion: MotionTrace) -> Iterator[_Flight]:
    resolved = [s for s in motion.route.steps if len(s.relations) == 1 and s.relations[0].words == RESOLVED]
    if len(resolved) != 2 or any(r.formula is None for s in resolved for r in s.results):
        return
    (x, y), since = (s.results[0] for s in resolved), resolved[0].relations[0].stop
    for step in motion.route.steps:
        laws = [e for e in step.relations if e.since == since and e.kind == "q(t)" and is_steady(e)]
        given = [e for e in step.relations if e not in laws]
        if len(laws) != 2 or len(given) != 1 or given[0].kind != "given" or any(e.law is None for e in laws):
            continue
        yield from _flight(motion, (resolved[0], resolved[1]), step, (x, y))


def _flight(
    motion: MotionTrace, resolved: tuple[RouteStep, RouteStep], step: RouteStep, after: tuple[Result, Result]
) -> Iterator[_Flight]:
    """The flight, if it begins on the slope, whose equation the given relation is."""
    x, y = after
    laws = {law.coordinate.words[0]: law for e in step.relations if (law := e.law) is not None}
    if laws.keys() != {"x", "y"} or x.formula is None or y.formula is None:
        return
    given = next(e for e in step.relations if e.law is None)
    ends = [s for s in given.residual.free_symbols & set(motion.general) if motion.ledger.roles[s].at == given.stop]
    places = [next((s for s in ends if motion.general[s] == laws[a].coordinate.symbol), None) for a in "xy"]
    speeds = sorted(x.formula.free_symbols & motion.unknowns, key=lambda s: s.name, reverse=True)
    if None in places or len(speeds) != 2:
        return
    tangent = (sp.diff(x.formula, speeds[0]), sp.diff(y.formula, speeds[0]))
    normal = (sp.diff(x.formula, speeds[1]), sp.diff(y.formula, speeds[1]))
    way = sp.Dummy(positive=True)
    along = given.residual.xreplace({places[0]: way * tangent[0], places[1]: way * tangent[1]})
    starts = [s for s, g in motion.general.items() if g in {motion.general[p] for p in places if p is not None}]
    since = resolved[0].relations[0].stop
    begins = [s for s in starts if motion.ledger.roles[s].at == since]
    told = {**motion.route.formulas, **motion.route.plain}
    if simplified(along) != 0 or any(told.get(s) != 0 for s in begins):
        return
    pulls = [sp.sympify(laws[a].f) for a in "xy"]
    a_t, a_n = (trigonometric(expanded(pulls[0] * d[0] + pulls[1] * d[1])) for d in (tangent, normal))
    if 0 in (a_t, a_n) or (a_t.free_symbols | a_n.free_symbols) & motion.varying:
        return
    both = (places[0], places[1])
    yield _Flight(resolved, step, (speeds[0], speeds[1]), tangent, (a_t, a_n), both, since, given.stop)


def _is_alone(found: _Flight, motion: MotionTrace) -> bool:
    """Does nothing else rest on the components along x and y, and is the clock not asked for?"""
    own = {*found.resolved[0].unknowns, *found.resolved[1].unknowns, *found.step.unknowns}
    others = [s for s in motion.route.steps if s is not found.step and s not in found.resolved]
    clock = own - set(found.places) - {u for s in found.resolved for u in s.unknowns}
    asked = {s for r in motion.requests for p in r.parts for s in p.free_symbols}
    return not any(own & s.needs for s in others) and not clock & asked


def _told(motion: MotionTrace, found: _Flight, sense: int) -> MotionTrace | None:
    """The motion with the flight; None: what is asked along the slope is not its distance in this sense."""
    asked = [r for r in motion.requests if any(p.has(*found.places) for p in r.parts)]
    name = asked[0].find.name if len(asked) == 1 else ""
    if not name or name in motion.ledger.symbols:
        return None
    time, way = sp.Symbol(TIME, positive=True), sp.Symbol(name, real=True)
    (v_t, v_n), (a_t, a_n) = found.speeds, found.accelerations
    flown = -2 * v_n / a_n
    gone = sense * (v_t * time + a_t * time**2 / 2)
    duration = motion.value(flown)
    value = motion.value.extended({time: duration})
    distance = value(gone)
    components = {r.unknown: r.formula for s in found.resolved for r in s.results}
    places = {p: sense * way * t for p, t in zip(found.places, found.tangent, strict=True)}
    requests = tuple(_request(r, {**components, **places}, way, distance) for r in motion.requests)
    if any(r.parts != (way,) for r, old in zip(requests, motion.requests, strict=True) if old is asked[0]):
        return None
    ledger = motion.ledger
    # The solution may be told once more, with letters of its own.
    ledger = replace(ledger, symbols={**ledger.symbols}, units={**ledger.units}, roles={**ledger.roles})
    ledger.adopt(time, parse_unit("s"), Role(Kind.SOUGHT))
    ledger.adopt(way, parse_unit("m"), Role(Kind.SOUGHT))
    slope = with_article(slope_struck(motion))
    kinds = (
        ("given", f"constant acceleration perpendicular to {slope}, back on it after Δt"),
        ("link", f"constant acceleration along {slope}"),
    )
    residuals = (v_n * time + a_n * time**2 / 2, way - gone)
    across, along = (
        Relation(e, kind, words, found.stop, found.since) for e, (kind, words) in zip(residuals, kinds, strict=True)
    )
    steps = [s for s in motion.route.steps if s not in found.resolved and not _is_where_it_begins(s, motion, found)]
    i = steps.index(found.step)
    steps[i : i + 1] = [
        RouteStep((across,), (time,), frozenset((v_n,)), (Result(time, flown, duration),), False),
        RouteStep((along,), (way,), frozenset((v_t, time)), (Result(way, gone, distance),), False),
    ]
    route = replace(
        motion.route,
        steps=_without_clocks(steps, motion, {s for r in requests for e in r.parts for s in e.free_symbols}),
        settled=motion.route.settled | {time, way},
        formulas={**motion.route.formulas, time: flown, way: gone},
    )
    return replace(
        motion,
        ledger=ledger,
        route=route,
        requests=requests,
        value=value.extended({way: distance}),
        unknowns=motion.unknowns | {time, way},
    )


def _without_clocks(steps: list[RouteStep], motion: MotionTrace, asked: set[sp.Symbol]) -> tuple[RouteStep, ...]:
    """The steps without times on which nothing rests any more: the flight has a clock of its own."""
    times = {s for s, general in motion.general.items() if general.name == "t"}
    needed = set(asked)
    kept: list[RouteStep] = []
    for step in reversed(steps):
        if not set(step.unknowns) <= times - needed:
            kept.append(step)
            needed |= step.needs
    return tuple(reversed(kept))


def _is_where_it_begins(step: RouteStep, motion: MotionTrace, found: _Flight) -> bool:
    """Does a step tell but that the flight begins at the origin?"""
    places = {motion.general[p] for p in found.places}
    return all(r.formula == 0 and motion.general.get(r.unknown) in places for r in step.results) and bool(step.results)


def _request(request: Request, put: Mapping[sp.Symbol, sp.Expr], way: sp.Symbol, distance: Decimal) -> Request:
    """What is asked in the letters along the slope and perpendicular to it, with a distance of its own sign."""
    if not any(p.has(*put) for p in request.parts):
        return request
    length, sign = sp.Dummy(positive=True), 1 if distance > 0 else -1
    parts = (trigonometric(expanded(p.xreplace(put)).xreplace({way: sign * length})) for p in request.parts)
    return replace(request, parts=tuple(simplified(p).xreplace({length: sign * way}) for p in parts))


def slope_struck(motion: MotionTrace) -> str:
    """What the blow is against."""
    bodies = {b.name for b in motion.problem.bodies}
    partners = [p for j in motion.problem.joints if j.strikes for p in getattr(j, "between", ())]
    return next((p for p in partners if p not in bodies and p != GROUND), "the ground")
