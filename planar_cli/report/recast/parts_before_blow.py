"""The velocity with which a particle strikes a rough slope, in its parts, before the blow is told by them:

v_n,2 = v_2 cos β   into the slope          v_t,2 = v_2 sin β   down the slope
v_n,3 = e v_n,2
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import simplified, trigonometric
from planar_cli.equation.kinematics.struck import StruckScene
from planar_cli.equation.values.ledger import Kind, Role
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import with_article
from planar_cli.records import record
from planar_cli.report.recast.flight_axes import slope_struck
from planar_cli.solve.between.trace.trace import ImpactEquation, MotionTrace, Relation, Result, RouteStep
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.units import parse_unit


@record
class _Part:
    """A part of the velocity before the blow: its letter, its formula, in which sense it counts, and whither."""

    letter: sp.Symbol
    formula: sp.Expr
    way: str


def with_parts_before(part: PartSolution) -> PartSolution:
    """A part whose motion tells such a blow by the parts of the velocity before it."""
    motion = part.motion
    first = None if motion is None else next((s for s in motion.route.steps if _oblique(s) is not None), None)
    if motion is None or first is None:
        return part
    source = _oblique(first)
    assert source is not None
    found = list(_parts(motion, source))
    speeds = {s for p in found for s in p.formula.free_symbols & motion.unknowns}
    told = [_told(s, source, found, speeds, motion.route.plain) for s in motion.route.steps]
    used = [p for p in found if any(p.letter in s.needs for s in told)]
    if not used:
        return part
    return replace(part, motion=_with_letters(motion, told, used, motion.route.steps.index(first), source.impact.since))


def _oblique(step: RouteStep) -> ImpactEquation | None:
    """The equation of a step, if it is of the one body that strikes something oblique."""
    source = step.relations[0].source if len(step.relations) == 1 else None
    solution = source.impact.solution if isinstance(source, ImpactEquation) else None
    if solution is None or not isinstance(source, ImpactEquation):
        return None
    builder = solution.trial.system.builder
    return source if len(builder.oblique) == 1 else None


def _parts(motion: MotionTrace, source: ImpactEquation) -> Iterator[_Part]:
    """Both parts, each in the sense in which it is positive; none where one of them is zero or the letters are used."""
    solution = source.impact.solution
    assert solution is not None
    builder, scene, since = solution.trial.system.builder, solution.instant.scene, source.impact.since
    assert isinstance(scene, StruckScene)
    ((body, tangent),) = builder.oblique.items()
    before = scene.before[body].linear
    ways: tuple[tuple[str, Vec], ...] = (("n", -tangent.turned()), ("t", tangent))
    names = [f"v_{index}__{since}" for index, _ in ways]
    sizes = [simplified(sp.sympify(before.dot(way)).xreplace(dict(motion.route.plain))) for _, way in ways]
    if any(motion.value.vanishes(e) for e in sizes) or set(names) & {s.name for s in motion.ledger.units}:
        return
    slope = with_article(slope_struck(motion))
    for (index, way), name, size in zip(ways, names, sizes, strict=True):
        sense = 1 if motion.value(size) > 0 else -1
        downhill = motion.value(sense * way.y) < 0
        whither = ("into" if index == "n" else "down" if downhill else "up") + f" {slope}"
        yield _Part(sp.Symbol(name, real=True), sense * size, whither)


def _told(
    step: RouteStep,
    source: ImpactEquation,
    parts: list[_Part],
    speeds: set[sp.Symbol],
    plain: Mapping[sp.Symbol, sp.Expr],
) -> RouteStep:
    """A step of the blow by the part of the velocity that it rests on, if it rests on one alone."""
    own = _oblique(step)
    if own is None or own.impact is not source.impact or not speeds:
        return step
    for part in parts:
        speed = min(speeds & part.formula.free_symbols, key=str)
        put = {speed: (part.letter - part.formula.xreplace({speed: sp.S.Zero})) / sp.diff(part.formula, speed)}

        def told(expr: sp.Expr, put: dict[sp.Symbol, sp.Expr] = put) -> sp.Expr:
            return trigonometric(simplified(expr.xreplace(dict(plain)).subs(put)))

        residual, left, right = (told(e) for e in (step.relations[0].residual, own.left, own.right))
        if residual.free_symbols & (speeds | _angles(part, speeds)):
            continue
        results = tuple(replace(r, formula=None if r.formula is None else told(r.formula)) for r in step.results)
        relation = replace(step.relations[0], residual=residual, source=replace(own, left=left, right=right))
        return replace(step, relations=(relation,), results=results, needs=step.needs - speeds | {part.letter})
    return step


def _angles(part: _Part, speeds: set[sp.Symbol]) -> set[sp.Symbol]:
    """What the formula of a part holds beside speeds: the angle of the slope."""
    return set(part.formula.free_symbols) - speeds


def _with_letters(motion: MotionTrace, told: list[RouteStep], used: list[_Part], at: int, since: str) -> MotionTrace:
    """The motion with the steps of these parts before the blow."""
    ledger = replace(motion.ledger, symbols={**motion.ledger.symbols}, units={**motion.ledger.units})
    ledger = replace(ledger, roles={**motion.ledger.roles})
    value, route = motion.value, motion.route
    for p in used:
        ledger.adopt(p.letter, parse_unit("m/s"), Role(Kind.SOUGHT))
    numbers = {p.letter: value(p.formula) for p in used}
    steps = [
        RouteStep(
            (Relation(p.letter - p.formula, "given", f"the velocity {p.way}", since),),
            (p.letter,),
            frozenset(p.formula.free_symbols & motion.unknowns),
            (Result(p.letter, p.formula, numbers[p.letter]),),
            False,
        )
        for p in used
    ]
    letters = {p.letter for p in used}
    route = replace(
        route,
        steps=(*told[:at], *steps, *told[at:]),
        settled=route.settled | (letters if not motion.symbolic else set()),
        formulas={**route.formulas, **{p.letter: p.formula for p in used}},
    )
    return replace(
        motion, ledger=ledger, route=route, value=value.extended(numbers), unknowns=motion.unknowns | letters
    )
