"""Where the points are: every way of giving a place, as coordinates with their time derivatives."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from planar_cli.equation.evaluate import Evaluator
from planar_cli.equation.exact import CERTAIN, Valuation
from planar_cli.equation.jets import Jet, constant, magnitude
from planar_cli.equation.ledger import Ledger
from planar_cli.errors import refuse
from planar_cli.problem.expression import Name, Relation, Statement
from planar_cli.problem.geometry import Vec
from planar_cli.problem.scene import (
    At,
    Midpoint,
    Point,
    Polar,
    Towards,
    TwoFacts,
)

Lookup = Callable[[str], Vec]
Decide = Callable[[], Valuation]


def place_jet(point: Point, evaluator: Evaluator, lookup: Lookup, decide: Decide) -> Vec:
    """A point's place as a Vec of jets. `lookup`: the jets of other points; `decide`: numbers to choose between two
    places.
    """
    place = point.place
    match place:
        case At():
            return Vec(evaluator.jet(place.x), evaluator.jet(place.y))
        case Polar():
            angle = evaluator.jet(place.angle)
            direction = Vec(angle.through(sp.cos), angle.through(sp.sin))
            return lookup(place.origin) + direction * evaluator.jet(place.distance)
        case Towards():
            origin = lookup(place.origin)
            reach = lookup(place.towards) - origin
            length = magnitude(reach)
            if length.value == 0:
                raise refuse(
                    point.mark, "PL510", f"{place.origin} and {place.towards} are the same place: no direction"
                )
            return origin + reach * (evaluator.jet(place.distance) / length)
        case Midpoint():
            return (lookup(place.a) + lookup(place.b)) * constant(sp.Rational(1, 2))
        case TwoFacts():
            return _two_facts(point, place, evaluator, lookup, decide)
    raise TypeError(type(place).__name__)


def _two_facts(point: Point, place: TwoFacts, evaluator: Evaluator, lookup: Lookup, decide: Decide) -> Vec:
    """The intersection of two of: a vertical (x), a horizontal (y), a line, circles (distances)."""
    lines = _lines(place, evaluator, lookup)
    circles = [(lookup(name), evaluator.jet(distance)) for name, distance in place.distances]
    if len(lines) + len(circles) != 2:
        raise refuse(point.mark, "PL511", f"{point.name} needs just two facts of x, y, line, distances")
    if len(lines) == 2:
        return _two_lines(point, lines)
    if len(lines) == 1:
        base, direction = lines[0]
        candidates = _line_and_circle(base, direction, *circles[0])
    else:
        candidates = _two_circles(*circles[0], *circles[1])
    return _choose(point, place, candidates, decide)


def _lines(place: TwoFacts, evaluator: Evaluator, lookup: Lookup) -> list[tuple[Vec, Vec]]:
    zero, one = constant(0), constant(1)
    lines: list[tuple[Vec, Vec]] = []
    if place.x is not None:
        lines.append((Vec(evaluator.jet(place.x), zero), Vec(zero, one)))
    if place.y is not None:
        lines.append((Vec(zero, evaluator.jet(place.y)), Vec(one, zero)))
    if place.line is not None:
        angle = evaluator.jet(place.line[1])
        lines.append((lookup(place.line[0]), Vec(angle.through(sp.cos), angle.through(sp.sin))))
    return lines


def _two_lines(point: Point, lines: list[tuple[Vec, Vec]]) -> Vec:
    (p, d), (q, e) = lines
    determinant = d.cross(e)
    if determinant.value == 0:
        raise refuse(point.mark, "PL512", f"{point.name}: the two lines are parallel")
    found: Vec = p + d * ((q - p).cross(e) / determinant)
    return found


def _line_and_circle(base: Vec, direction: Vec, center: Vec, radius: Jet) -> tuple[Vec, Vec]:
    """Foot of the perpendicular from the centre, plus and minus half the chord."""
    along = (center - base).dot(direction)
    across = (center - base).cross(direction)
    half = (radius * radius - across * across).power(sp.Rational(1, 2))
    return base + direction * (along + half), base + direction * (along - half)


def _two_circles(a: Vec, r: Jet, b: Vec, s: Jet) -> tuple[Vec, Vec]:
    """Intersection of two circles: along the line of centres by (r² - s² + d²)/(2 d²), across it by half the chord."""
    d = b - a
    square = d.dot(d)
    half = constant(sp.Rational(1, 2))
    along = ((r * r - s * s) / square + constant(1)) * half
    across = (r * r / square - along * along).power(sp.Rational(1, 2))
    foot = a + d * along
    offset = Vec(-d.y, d.x) * across
    return foot + offset, foot - offset


def _choose(point: Point, place: TwoFacts, candidates: tuple[Vec, Vec], decide: Decide) -> Vec:
    """The place on the named side of the other one."""
    one, other = candidates
    valuation = decide()
    try:
        dx, dy = valuation(one.x.value - other.x.value), valuation(one.y.value - other.y.value)
        apart = not (valuation.is_zero(one.x.value - other.x.value) and valuation.is_zero(one.y.value - other.y.value))
    except ArithmeticError:
        raise refuse(
            point.mark,
            "PL513",
            f"{point.name}: there is no such place, the distances do not reach",
            "make a distance larger, or move a point: a link cannot be shorter than the gap that it spans",
        ) from None
    if not apart:
        return one
    if place.side is None:
        raise refuse(
            point.mark, "PL514", f"{point.name}: two places fit", "add `side: left`, right, above or below (the other)"
        )
    lead = {"right": dx, "left": -dx, "above": dy, "below": -dy}[place.side]
    if abs(lead) <= (abs(dx) + abs(dy)) * CERTAIN:
        raise refuse(
            point.mark, "PL515", f"{point.name}: neither place is {place.side} of the other", "choose by the other axis"
        )
    return one if lead > 0 else other


def at_relations(ledger: Ledger, evaluator: Evaluator, relations: tuple[Statement, ...], expr: sp.Expr) -> sp.Expr:
    """An expression at other values of the coordinates, each given by a relation `theta = 30 deg`."""
    for relation in relations:
        if not isinstance(relation, Relation) or not isinstance(relation.left, Name):
            raise refuse(
                relation.mark,
                "PL542",
                "a relaxed position is given by its coordinates",
                "write `relaxed_at: [theta = 30 deg]`",
            )
        expr = expr.subs(ledger.symbols[relation.left.name], evaluator.value(relation.right))
    return expr
