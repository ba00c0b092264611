"""Where points are that the file constructs from distances and lines: in words, with the coordinates that they give."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.scene.scene import Scene
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.scene import At, Polar, TwoFacts
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Name, Text, Value, line
from planar_cli.report.document.mentioned import pieces_of
from planar_cli.report.kinematics.triangles import with_triangle
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.report.words.sides import said
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.stages import Stage
from planar_cli.units import LENGTH


def constructed(scene: Scene, stages: Collection[Stage]) -> dict[str, set[sp.Symbol]]:
    """The points that are constructed from distances and lines and used, each with its coordinates as symbols."""
    used = {s for x in stages for b in x.blocks for w in b.equations for s in w.residual.free_symbols}
    found = {}
    for point in scene.problem.points:
        if isinstance(point.place, TwoFacts) and (point.place.distances or point.place.lines):
            inside = {s for p in _pair(scene, point.name) for s in sp.sympify(p).free_symbols}
            symbols = inside & set(scene.ledger.definitions)
            if symbols & used:
                found[point.name] = symbols
    return found


def in_numbers(scene: Scene, page: Collection[Block], phrases: Phrases) -> Iterator[Block]:
    """The same of points that numbers alone tell, of which the page has an arm r_D/C."""
    arms = {
        n for b in page for p in pieces_of(b) if isinstance(p, Name) and (n := p.name).startswith("r_") and "/" in n
    }
    ends = {end for arm in arms for end in arm.removeprefix("r_").split("/")}
    two = [p for p in scene.problem.points if isinstance(p.place, TwoFacts) and (p.place.distances or p.place.lines)]
    plain = [p.name for p in two if all(sp.sympify(c).is_number for c in _pair(scene, p.name))]
    for name in plain:
        for place in places(scene, ends.intersection({name}), phrases):
            yield from with_triangle(place, name, scene, phrases)


def places(scene: Scene, names: Collection[str], phrases: Phrases) -> Iterator[Equation]:
    """C is 0.5 m from B and 0.4 m from D: C = [0.5474, 0.3965] m."""
    for point in scene.problem.points:
        if point.name not in names or not isinstance(point.place, TwoFacts):
            continue
        x, y = (phrases.certain(p) for p in _pair(scene, point.name))
        where = phrases.vector(x, y, LENGTH)
        facts = _facts(scene, point.place, phrases)
        joined = line(*(p for i, f in enumerate(facts) for p in ((" and ",) if i else ()) + f))
        side = f", {_SIDES.get(point.place.side, point.place.side)}" if point.place.side else ""
        sides = (line(point.name), *_by_slope(scene, point.place, (x, y), phrases), where)
        yield Equation(sides, None, line(f"{point.name} is ", *joined, f"{side}:"))


def with_coordinates(
    placed: Iterable[Equation], defined: Iterable[Equation], scene: Scene, phrases: Phrases
) -> list[Block]:
    """Lines of places and of coordinates; where one coordinate is all that a place leaves open, one line of both:
    B is l from A and at y = 0, on the right: x_B = R + √(l² - R²) = 1.531 m.
    """
    lines, apart = list(defined), list[Block]()
    for place in placed:
        name = next((p.text for p in pieces_of(place.sides[0]) if isinstance(p, Text)), "")
        at, leads = scene.point(name), [line(f"{axis} of {name}:") for axis in ("x", "y")]
        open_yet = {s for p in (at.x, at.y) for s in sp.sympify(p).free_symbols} & set(scene.ledger.definitions)
        own = [b for b in lines if b.lead in leads]
        if len(own) != 1 or len(open_yet) != 1:
            apart += with_triangle(place, name, scene, phrases)
            continue
        lines = [replace(b, lead=place.lead) if b is own[0] else b for b in lines]
    return [*apart, *lines]


def _by_slope(scene: Scene, place: TwoFacts, where: tuple[Decimal, Decimal], phrases: Phrases) -> list[Line]:
    """[0.4, 0.4 tan 30°], of a point at a given x on a line through the origin."""
    if len(place.lines) != 1 or place.x is None or place.distances:
        return []
    (through, angle), x = place.lines[0], phrases.of_dimension(where[0], LENGTH)
    slope = said(angle, phrases.figures)
    if not slope or len(slope) > 1 or not isinstance(slope[0], Value) or any(c != 0 for c in _pair(scene, through)):
        return []
    size = Value(x.number, "", phrases.figures)
    return [line("[", size, ", ", size, " tan ", *factor(slope), "]")]


def coordinate(scene: Scene, name: str, axis: str, figures: int) -> Line:
    """A coordinate of a point as the file tells its way there: r cos 60° + l; empty where it tells it otherwise,
    or bodies have moved since.
    """
    point = next((p for p in scene.problem.points if p.name == name), None)
    if point is None or scene.displacement is not None:
        return ()
    if isinstance(point.place, At):
        return said(point.place.x if axis == "x" else point.place.y, figures) or ()
    if not isinstance(point.place, Polar):
        return ()
    before = coordinate(scene, point.place.origin, axis, figures)
    distance, angle = (said(side, figures) for side in (point.place.distance, point.place.angle))
    if not before or not distance or not angle:
        return ()
    if isinstance(angle[0], Value) and len(angle) == 1 and not angle[0].number:
        # Along x the arm is its length, and across it nothing.
        return before if axis == "y" else distance if _is_nothing(before) else line(before, " + ", factor(distance))
    turned = factor(angle)
    arm = line(*factor(distance), " cos" if axis == "x" else " sin", "" if turned != angle else " ", *turned)
    return arm if _is_nothing(before) else line(before, " + ", arm)


def factor(side: Line) -> Line:
    """As a factor, behind a minus or a function: a sum, and what begins with its sign, in brackets."""
    sums = any(isinstance(p, Text) and p.text in (" + ", " - ", "-") for p in side)
    signed = isinstance(side[0], Value) and side[0].number < 0
    return line("(", side, ")") if sums or signed else side


def _is_nothing(side: Line) -> bool:
    return len(side) == 1 and isinstance(side[0], Value) and not side[0].number


_SIDES = {"left": "on the left", "right": "on the right", "above": "the upper one", "below": "the lower one"}


def _pair(scene: Scene, name: str) -> tuple[Any, Any]:
    return scene.points[name].x, scene.points[name].y


def _facts(scene: Scene, place: TwoFacts, phrases: Phrases) -> list[Line]:
    """Each of the two facts in words."""
    found: list[Line] = [line(*_plainly(scene, d, phrases), f" from {origin}") for origin, d in place.distances]
    for through, angle in place.lines:
        found.append(line(f"on the line through {through} at ", *_plainly(scene, angle, phrases)))
    for axis, side in (("x", place.x), ("y", place.y)):
        if side is not None:
            found.append(line(f"at {axis} = ", *_plainly(scene, side, phrases)))
    return found


def _plainly(scene: Scene, side: Side, phrases: Phrases) -> Line:
    """A length or an angle in letters; one that is a number as it is written, with its unit."""
    value = sp.sympify(scene.value(side))
    written = said(side, phrases.figures) if value.is_number else None
    return written or line(phrases.math(value))


def measured(expr: sp.Expr, phrases: Phrases) -> Math | None:
    """√(x² + y²) of a length between two places of the drawing, with its numbers; None: it is something else."""
    square = expr.base if expr.is_Pow and expr.exp == sp.Rational(1, 2) else sp.S.Zero
    if phrases.symbolic or not square.is_Add:
        return None
    if not all(a.is_Pow and a.exp == 2 and a.base.is_Rational for a in square.args):
        return None
    texts = {}
    for i, part in enumerate(square.args):
        size = phrases.of_dimension(abs(phrases.value(part.base)), LENGTH)
        texts[sp.Symbol(f"{NUMBER}{i}", real=True)] = significant(size.number, phrases.figures)
    return Math(sp.sqrt(sp.Add(*(s**2 for s in texts), evaluate=False), evaluate=False), texts)
