"""The line between two bodies along which a blow acts, by its angle where its ends are known in numbers:

β = arctan(y_B,2/x_B,2) = 34.34°                            the direction of AB
m_B (v_Bx,2 cos β + v_By,2 sin β) = (m_A + m_B) (v_Ax,3 cos β + v_Ay,3 sin β)

for the sine y/√(x² + y²) and the cosine x/√(x² + y²) in every term.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from itertools import combinations
from typing import Protocol

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.ledger import NAMED
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record
from planar_cli.solve.between.trace.trace import (
    ImpactEquation,
    MotionTrace,
    Relation,
    Request,
    Result,
    RouteStep,
    RouteTrace,
)
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.units import parse_unit

NAMES = ("beta", "gamma", "psi", "phi")
"""Of an angle: the first that the file has not."""
LONG = 160
"""A longer formula is not worked over."""


class Put(Protocol):
    """Writes a formula by the angle. `asked`: it is what a find asks for."""

    def __call__(self, expr: sp.Expr, asked: bool = False) -> sp.Expr: ...


@record
class LineOfBlow:
    """`angle`: the angle of the line at the state after the blow, with its formula; `put`: what makes letters of places
    there its cosine and sine; `length`: a letter for the distance of the ends, which has to cancel.
    """

    words: str
    angle: sp.Symbol
    formula: sp.Expr
    put: Mapping[sp.Symbol, sp.Expr]
    length: sp.Symbol
    distance: sp.Expr
    """The same by the places."""
    of: frozenset[sp.Symbol]
    """The letters of its formula."""
    since: str
    stop: str


def with_line_of_blow(part: PartSolution) -> PartSolution:
    """The part with such an angle in the equations of a blow; the same where there is none."""
    motion = part.motion
    if motion is None or motion.symbolic:
        return part
    blows = [e for leg in motion.route.steps for e in leg.relations if isinstance(e.source, ImpactEquation)]
    oblique = next((e for e in blows if _roots(e.residual)), None)
    found = None if oblique is None else _line(oblique, motion)
    return part if found is None else replace(part, motion=_told(motion, found))


def _roots(expr: sp.Expr) -> list[sp.Expr]:
    """What stands under a square root, and has letters."""
    return [p.base for p in expr.atoms(sp.Pow) if p.exp.is_Rational and p.exp.q == 2 and p.base.free_symbols]


def _line(e: Relation, motion: MotionTrace) -> LineOfBlow | None:
    """The line that the roots of an equation of a blow are the length of."""
    solution = None if not isinstance(e.source, ImpactEquation) else e.source.impact.solution
    if solution is None or not isinstance(e.source, ImpactEquation):
        return None
    here = {g: own for own, g in motion.general.items() if motion.ledger.roles[own].at == e.stop}
    points = solution.instant.scene.points
    bodies = [b for b in e.source.bodies + tuple(b.name for b in motion.problem.bodies) if b in points]
    squares = _roots(e.residual)
    for a, b in combinations(dict.fromkeys(sorted(bodies)), 2):
        reach = points[b] - points[a]
        parts = [sp.sympify(p).xreplace(here) for p in (reach.x, reach.y)]
        if all(expanded(s - parts[0] ** 2 - parts[1] ** 2) == 0 for s in squares):
            return _of(f"{a}{b}" if len(a) == len(b) == 1 else f"the line {a} {b}", Vec(*parts), e, motion)
    return None


def _taken(motion: MotionTrace) -> set[str]:
    """The names that the file has, those of its finds among them: tan β of a β that is asked is another one."""
    return {*motion.ledger.reserved, *motion.ledger.symbols, *(f.name for f in motion.problem.find)}


def direction_of(motion: MotionTrace, x: sp.Expr, y: sp.Expr) -> tuple[sp.Symbol, sp.Expr]:
    """The angle of a line by its parts along x, to the right, and along y, with its formula: the one that was told, or
    another.
    """
    formula, formulas = sp.atan(y / x), motion.route.formulas
    told = next((s for s, f in formulas.items() if s.name in NAMES and motion.value.is_zero(f - formula)), None)
    if told is not None:
        return told, formulas[told]
    taken = {*_taken(motion), *(s.name for s in formulas)}
    angle = sp.Symbol(next(n for n in (*NAMES, "direction") if n not in taken), real=True)
    motion.ledger.units[angle] = parse_unit("deg")
    motion.ledger.roles[angle] = NAMED
    return angle, formula


def _of(words: str, reach: Vec, e: Relation, motion: MotionTrace) -> LineOfBlow | None:
    """None: the line is level or upright, or an end of it has no letter of its own."""
    route, value = motion.route, motion.value
    x, y = (sp.sympify(p).xreplace(dict(route.plain)) for p in (reach.x, reach.y))
    across, up = value.known(x), value.known(y)
    if across is None or up is None or value.is_zero(x) or value.is_zero(y):
        return None
    sense = 1 if across > 0 else -1
    taken = _taken(motion)
    name = next((n for n in NAMES if n not in taken), None)
    if name is None:
        return None
    angle, length = sp.Symbol(name, real=True), sp.Dummy("length", positive=True)
    put: dict[sp.Symbol, sp.Expr] = {}
    for part, share in ((x, sp.cos(angle)), (y, sp.sin(angle))):
        own = next((s for s in sorted(part.free_symbols, key=str) if abs(sp.diff(part, s)) == 1 and s not in put), None)
        if own is None:
            return None
        slope = sp.diff(part, own)
        put[own] = slope * (sense * length * share - (part - slope * own))
    kept = {s: f for leg in route.steps for s, f in _kept(leg)}
    formula = sp.atan((y / x).xreplace(kept))
    return LineOfBlow(
        words, angle, formula, put, length, sp.sqrt(x**2 + y**2), frozenset(formula.free_symbols), e.since, e.stop
    )


def _kept(leg: RouteStep) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
    """A place that stays during a blow is that before it."""
    if len(leg.relations) == 1 and leg.relations[0].kind == "link":
        yield from ((r.unknown, r.formula) for r in leg.results if r.formula is not None and r.formula.is_Symbol)


def _told(motion: MotionTrace, line: LineOfBlow) -> MotionTrace:
    """The motion with the angle; as it is where no equation of the blow becomes shorter."""
    motion.ledger.units[line.angle] = parse_unit("deg")
    motion.ledger.roles[line.angle] = NAMED
    motion = replace(motion, value=motion.value.extended({line.angle: motion.value(line.formula)}))
    put = _putting(line, motion)
    steps, found = [], False
    for leg in motion.route.steps:
        own = _step(leg, line, put)
        if own is not leg and not found:
            steps.append(_angle_step(line, motion))
            found = True
        steps.append(own)
    if not found:
        return motion
    requests = tuple(replace(r, parts=tuple(put(p, asked=True) for p in r.parts)) for r in motion.requests)
    steps = list(without_idle_places(steps, requests))
    results = {r.unknown: r.formula for leg in steps for r in leg.results if r.formula is not None}
    formulas = {s: results.get(s, f) for s, f in motion.route.formulas.items()}
    route = RouteTrace(
        tuple(steps), motion.route.settled | {line.angle}, {**formulas, line.angle: line.formula}, motion.route.plain
    )
    return replace(motion, route=route, requests=requests, unknowns=motion.unknowns | {line.angle})


def _putting(line: LineOfBlow, motion: MotionTrace) -> Put:
    """What writes a formula by the angle; it stays as it is where it would become longer."""
    plain = dict(motion.route.plain)

    def put(expr: sp.Expr, asked: bool = False) -> sp.Expr:
        if not expr.free_symbols & line.put.keys() or longer(expr.xreplace(plain), LONG):
            return expr
        turned = expr.xreplace(plain).xreplace(dict(line.put)).replace(_is_length, _of_length)
        # A sum that is asked keeps its terms: 1/2 m v² of every body.
        kept = asked and turned.is_Add and not turned.has(line.length)
        told = turned if kept else min(_plain(turned, line.angle), turned, key=operations)
        told = told.xreplace({line.length: line.distance})
        known = motion.value.known(told)
        same = known is not None and motion.value.is_zero(told - expr)
        return told if same and not longer(told, operations(expr.xreplace(plain))) else expr

    return put


def _is_length(expr: sp.Expr) -> bool:
    return bool(expr.is_Pow and expr.exp.is_Rational and expr.exp.q == 2 and expr.base.is_Add)


def _of_length(root: sp.Expr) -> sp.Expr:
    """√(l² sin² β + l² cos² β) is l."""
    return simplified(expanded(root.base)) ** root.exp


def _plain(expr: sp.Expr, angle: sp.Symbol) -> sp.Expr:
    """In factors, with sin² + cos² = 1, and no angle doubled."""
    sine, cosine = sp.Dummy("sine"), sp.Dummy("cosine")
    over = sp.together(expr.xreplace({sp.sin(angle): sine, sp.cos(angle): cosine}))
    above, below = (_factors(part, sine, cosine) for part in sp.fraction(sp.cancel(over)))
    found = sp.sympify(above / below).xreplace({sine: sp.sin(angle), cosine: sp.cos(angle)})
    ratio = sp.cos(angle) / sp.sin(angle)
    return found * sp.tan(angle) ** -1 / ratio if found.is_Mul and {*ratio.args} <= {*found.args} else found


def _factors(expr: sp.Expr, sine: sp.Symbol, cosine: sp.Symbol) -> sp.Expr:
    squares = sine**2 + cosine**2 - 1
    forms = [sp.factor(e) for e in (expr, *(sp.rem(expr, squares, s) for s in (sine, cosine)))]
    return min(forms, key=operations)


def _step(leg: RouteStep, line: LineOfBlow, put: Put) -> RouteStep:
    """The equations of the blow in one step of the way, and its results, by the angle."""
    relations = tuple(_relation(e, line, put) for e in leg.relations)
    if all(new is old for new, old in zip(relations, leg.relations, strict=True)):
        return leg
    results = tuple(r if r.formula is None else replace(r, formula=put(r.formula)) for r in leg.results)
    left = {s for e in relations for s in e.residual.free_symbols} | {
        s for r in results if r.formula is not None for s in r.formula.free_symbols
    }
    needs = (leg.needs & left) | {line.angle}
    return replace(leg, relations=relations, results=results, needs=frozenset(needs))


def _relation(e: Relation, line: LineOfBlow, put: Put) -> Relation:
    source = e.source
    if source is None and e.kind == "blow" and e.stop == line.stop:
        residual = put(e.residual)
        return e if residual == e.residual else replace(e, residual=residual)
    if not isinstance(source, ImpactEquation) or e.stop != line.stop:
        return e
    left, right = put(source.left), put(source.right)
    if (left, right) == (source.left, source.right):
        return e
    return replace(e, residual=left - right, source=replace(source, left=left, right=right))


def _angle_step(line: LineOfBlow, motion: MotionTrace) -> RouteStep:
    """The line that tells the angle, by the places before the blow."""
    words = f"the direction of {line.words}"
    relation = Relation(line.angle - line.formula, "link", words, line.since)
    result = Result(line.angle, line.formula, motion.value(line.angle))
    return RouteStep((relation,), (line.angle,), line.of, (result,), False)


def without_idle_places(steps: Iterable[RouteStep], asked: Iterable[Request]) -> Iterator[RouteStep]:
    """The steps but for places that stay during a blow and on which nothing rests after it."""
    steps = list(steps)
    used = {s for leg in steps for s in leg.needs} | {s for r in asked for p in r.parts for s in p.free_symbols}
    yield from (leg for leg in steps if not any(_kept(leg)) or used & set(leg.unknowns))
