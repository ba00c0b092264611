"""Two particles that a tie of constant length joins, and on which beside it only their weights act: the mass centre
keeps its velocity, or is in free flight, and the line between them turns about it at a constant rate.

x_G,2 = m_B x_B,2/(m_A + m_B),   v_Gx = m_B v_Bx,2/(m_A + m_B),   ω = v_B/A,3/l,   β_4 = β + ω (t_4 - t_2)
x_A,4 = x_G,2 + v_Gx (t_4 - t_2) - AG cos β_4,   T = m_A AG ω²

The weights have no moment about G, nor has the pull, which has its line through G: I_G ω is constant. (An Introduction
to Planar Dynamics, 3.3, 4.5.) It is told so where otherwise the equations of motion of both would be integrated in
numbers; the numbers of that integration are compared.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace
from itertools import pairwise

import sympy as sp

from planar_cli.equation.scene.scene import Scene
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record
from planar_cli.report.recast.line_of_blow import without_idle_places
from planar_cli.report.recast.motion_of_pair import Course, PairTelling, Particle
from planar_cli.solve.between.trace.span_trace import SpanIntegral
from planar_cli.solve.between.trace.trace import ImpactEquation, MotionTrace, RegimeTrace, Request, RouteStep
from planar_cli.solve.solved_problem import PartSolution

TWO = 2
FOLLOWED = "followed"


@record
class FreePair:
    """The pair in one regime of a motion. `slide`: the speed of one relative to the other; `stops`: the states that it
    passes there after the first.
    """

    regime: RegimeTrace
    course: Course
    slide: sp.Symbol
    stops: tuple[str, ...]


def with_free_pair(part: PartSolution) -> PartSolution:
    """The part with the motion of such a pair in formulas; the same where there is none, or more is asked of it."""
    motion = part.motion
    if motion is None or motion.symbolic or motion.oscillations or motion.turnings or not _is_alone(motion):
        return part
    pair = next((p for r in motion.regimes if (p := _pair(r, motion)) is not None), None)
    told = None if pair is None or len(motion.regimes) < TWO else _told(motion, pair)
    if pair is None or told is None:
        return part
    return replace(part, instants=tuple(i for i in part.instants if i is not pair.regime.solution), motion=told)


def _is_alone(motion: MotionTrace) -> bool:
    """Are there two particles, one joint, and no forces but weights?"""
    problem = motion.problem
    if len(problem.bodies) != TWO or len(problem.joints) != 1 or problem.loads or problem.motion:
        return False
    return all(b.is_particle and not b.any_mass for b in problem.bodies)


def _pair(regime: RegimeTrace, motion: MotionTrace) -> FreePair | None:
    """The pair of a regime of one stretch, whose tie stands slanting at its beginning."""
    solution = regime.solution
    tied = [e for e in solution.trial.system.tree.edges if e.joining is not None]
    tie = tied[0].joining if len(tied) == 1 else None
    bodies, points = {b.name for b in motion.problem.bodies}, solution.instant.scene.points
    if tie is None or not _is_tie(tie) or {tie.mover, tie.base} != bodies or tied[0].slide is None:
        return None
    start, stops = regime.stretches[0][0], tuple(dict.fromkeys(stop for _, stop in regime.stretches))
    here = {g: own for own, g in motion.general.items() if motion.ledger.roles[own].at == start}
    reach = points[tie.mover] - points[tie.base]
    assert tie.path is not None
    turn = reach.x * tie.path.tangent.y - reach.y * tie.path.tangent.x
    across, up, sense = (motion.value.known(sp.sympify(e).xreplace(here)) for e in (reach.x, reach.y, turn))
    if any(a[1] != b[0] for a, b in pairwise(regime.stretches)):
        return None
    if "" in stops or not across or not up or not sense:
        return None
    # From the left one to the right one: the angle of the line is then an arctan.
    names = (tie.base, tie.mover) if across > 0 else (tie.mover, tie.base)
    one, other = (_particle(name, motion, solution.instant.scene) for name in names)
    if one is None or other is None:
        return None
    blows = {e.stop: e.since for leg in motion.route.steps for e in leg.relations if _is_blow(e.source)}
    apart = tied[0].slide if sense > 0 else -tied[0].slide
    course = Course((one, other), blows.get(start, start), start, motion.problem.joints[0].called, apart)
    return FreePair(regime, course, tied[0].slide, tuple(s for s in stops if s != start))


def _is_blow(source: object) -> bool:
    return isinstance(source, ImpactEquation)


def _is_tie(tie: Joining) -> bool:
    """Does one of both swing about the other?"""
    return bool(tie.far) and tie.path is not None and tie.path.curvature != 0 and not tie.drift and tie.pace is None


def _particle(name: str, motion: MotionTrace, scene: Scene) -> Particle | None:
    """A particle that has coordinates and velocities along x and y of its own in a part of the motion."""
    edges = (e for r in motion.regimes for e in r.solution.trial.system.tree.edges if e.body == name)
    free = next((e for e in edges if e.joining is None and e.slide is not None and e.rise is not None), None)
    if free is None or free.rightward < 0 or free.upward < 0:
        return None
    place = scene.points[name]
    if not sp.sympify(place.x).is_Symbol or not sp.sympify(place.y).is_Symbol:
        return None
    return Particle(name, sp.sympify(scene.bodies[name].mass), place, Vec(free.slide, free.rise))


def _told(motion: MotionTrace, pair: FreePair) -> MotionTrace | None:
    """None: something is asked of the pair that is not told so, or the numbers of the integration are others."""
    later = {s: at for s in motion.general if (at := motion.ledger.roles[s].at) in pair.stops}
    times = {s for s in later if motion.general[s].name == "t"}
    own = [leg for leg in motion.route.steps if set(leg.unknowns) & later.keys() and not times >= set(leg.unknowns)]
    asked = {name for finds in pair.regime.asked.values() for name in finds}
    telling = PairTelling(motion, pair.course)
    if not (asked or any(leg.relations[0].kind == FOLLOWED for leg in own)) or not telling.begin(bool(asked)):
        return None
    requests = tuple(_request(r, asked, pair, telling) for r in motion.requests)
    given = _needed([leg for leg in motion.route.steps if leg not in own], later.keys() - times, requests, motion.spans)
    wanted = _letters(requests, given, motion.spans) & later.keys() - times
    order = sorted(wanted, key=lambda s: (motion.states.index(str(later[s])), s.name))
    # What is followed on from the pair, when the tie has let go, is integrated through its motion.
    mixed = any(times & set(leg.unknowns) for leg in own) or any(leg.relations[0].kind == FOLLOWED for leg in given)
    if mixed or None in requests or not all(telling.step(s, str(later[s])) for s in order):
        return None
    finds = tuple(r for r in requests if r is not None)
    made = telling.told([*order, *(p for r in finds for p in r.parts)])
    resting = [leg for leg in given if leg.needs & wanted]
    before = (leg for leg in given if leg not in resting)
    route = replace(
        motion.route,
        steps=tuple(without_idle_places((*before, *made, *resting), finds)),
        formulas={**motion.route.formulas, **telling.formulas},
        settled=motion.route.settled | telling.formulas.keys(),
    )
    return replace(
        motion,
        route=route,
        value=telling.value,
        requests=finds,
        unknowns=motion.unknowns | telling.formulas.keys(),
        guessed=motion.guessed - wanted,
        regimes=tuple(r for r in motion.regimes if r is not pair.regime),
    )


def _needed(
    steps: Sequence[RouteStep],
    later: Collection[sp.Symbol],
    requests: Iterable[Request | None],
    spans: Iterable[SpanIntegral],
) -> list[RouteStep]:
    """The steps but for those that rest on places and velocities of the pair, as the length of the tie at a later state
    does, and that nothing else needs. `later`: these letters.
    """
    used, kept = _letters(requests, (), spans), list[RouteStep]()
    for leg in reversed(steps):
        if not leg.needs.isdisjoint(later) and used.isdisjoint(leg.unknowns):
            continue
        kept.append(leg)
        used |= leg.needs
    return kept[::-1]


def _letters(
    requests: Iterable[Request | None], steps: Iterable[RouteStep], spans: Iterable[SpanIntegral]
) -> set[sp.Symbol]:
    """The letters in what is asked, and on which other steps rest."""
    exprs = [e for r in requests if r is not None for e in (*r.parts, *(f for _, f in r.beside))]
    exprs += [s.formula for s in spans if s.formula is not None]
    return {s for e in exprs for s in e.free_symbols} | {s for leg in steps for s in leg.needs}


def _request(r: Request, asked: Collection[str], pair: FreePair, telling: PairTelling) -> Request | None:
    """A find with the force in the tie, and velocities, by the letters of the pair; None: it is another force."""
    if r.find.name in asked:
        pull = telling.pull()
        return replace(r, parts=(pull,)) if len(r.parts) == 1 and telling.is_same(pull, r.parts[0]) else None
    kept = {telling.known(pair.slide, s): telling.known(pair.slide, pair.course.start) for s in pair.stops}
    what = r.find.found.what
    if isinstance(what, Quantity) and what.word == "v" and what.at in pair.stops and len(what.things) == 1:
        moving = next((p for p in pair.course.pair if p.name == what.things[0]), None)
        parts = () if moving is None else _components(what, moving)
        letters = tuple(telling.known(e, str(what.at)) for e in parts)
        if len(letters) == len(r.parts) and all(map(telling.is_same, letters, r.parts)):
            return replace(r, parts=letters)
    return replace(r, parts=tuple(p.xreplace(kept) for p in r.parts))


def _components(what: Quantity, moving: Particle) -> tuple[sp.Expr, ...]:
    """Of a velocity that is asked as a vector, or along an axis; empty of anything else."""
    both = {"x": moving.velocity.x, "y": moving.velocity.y}
    if not what.parts:
        return tuple(both.values())
    return tuple(both[p.kind] for p in what.parts if p.kind in both) if len(what.parts) == 1 else ()
