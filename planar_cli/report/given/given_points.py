"""Where the points of a file are, as it says it: those on which something of the page rests."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping

from planar_cli.problem.checks.scope import members_of, names_in
from planar_cli.problem.language.expression import Name, Negate, Quantity, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.keys import RopeStop, keys_of
from planar_cli.problem.scene.scene import (
    At,
    Body,
    Composite,
    Midpoint,
    Outline,
    Particle,
    Plate,
    Point,
    Polar,
    Problem,
    Rod,
    Round,
    Towards,
    TwoFacts,
)
from planar_cli.report.document.blocks import Line, Value, line
from planar_cli.report.document.mentioned import Mentioned
from planar_cli.report.words.sides import AS_WRITTEN, is_zero, number_of, said
from planar_cli.units import pretty_unit

AXES = ("x", "y", "t", "n", "r", "theta")
SHORT = 2
"""Two names of so many letters side by side are the line between the points."""
RATES = ("v", "a")
"""What is asked of a particle that does not rest on where it is."""


def points_given(problem: Problem, page: Mentioned, figures: int) -> Iterator[Line]:
    """Where the points are that the page, a body or what acts speaks of; an origin alone needs no telling."""
    joined, drawn = _joined(problem), _drawn(problem)
    used = page.words | joined | drawn
    idle = set() if page.kinetic else drawn - joined - page.words
    used -= set() if page.kinetic else _only_moving(problem, page)
    used |= _origins(problem, used & page.words)
    turning = {p.name: d for p in problem.points if p.name in idle and (d := _direction(p, problem, page, figures))}
    places = [p for p in problem.points if p.name in used and p.name not in turning]
    drops = [
        Point(b.name, b.shape.place, b.mark)
        for b in problem.bodies
        if isinstance(b.shape, Particle)
        and isinstance(b.shape.place, At)
        and not (is_zero(b.shape.place.x) and is_zero(b.shape.place.y))
        and (page.kinetic or b.name in joined or _is_placed(b.name, page))
    ]
    told = [(p, found) for p in (*places, *drops) if p.name not in page.built and (found := _place(p, figures))]
    owners = {p.name: who for p, _ in told if (who := _at_it(p, problem, page))}
    if owners or any(not (isinstance(p.place, At) and is_zero(p.place.x) and is_zero(p.place.y)) for p, _ in told):
        yield from (*turning.values(), *(line(*found, _owned(p, owners)) for p, found in told))
    yield from (line(f"{b.name} {ends}") for b in problem.bodies if (ends := _ends(b, page)))


def _origins(problem: Problem, used: Collection[str]) -> set[str]:
    """The points from which others are told that the page speaks of, which are told from others themselves."""
    from_others = {p.name: p.place.origin for p in problem.points if isinstance(p.place, Polar)}
    found: set[str] = set()
    for point in reversed(problem.points):
        if point.name in found or point.name in used:
            found |= {from_others.get(point.name, "")} & from_others.keys()
    return found


def _ends(body: Body, page: Mentioned) -> str:
    """AB of a rod from A to B that has another name, which letters carry as an index."""
    if not isinstance(body.shape, Rod) or not any(x.endswith(f"_{body.name}") for x in page.letters):
        return ""
    one, other = body.shape.start, body.shape.end or ""
    plain = other and max(len(one), len(other)) <= SHORT
    return f"{one}{other}" if plain and body.name not in (f"{one}{other}", f"{other}{one}") else ""


def _at_it(point: Point, problem: Problem, page: Mentioned) -> str:
    """The particles at a point whose letters have its name, v_F of what is called A, or that is at a distance that
    changes; empty: they are called so.
    """
    name = point.name
    bodies = [b.name for b in problem.bodies if isinstance(b.shape, Particle) and b.shape.place == name]
    reach = walk(point.place.distance) if isinstance(point.place, Polar) else ()
    moved = {n.name for n in reach if isinstance(n, Name)} & {s.name for s in problem.coordinates}
    if name in bodies or (not moved and page.letters.isdisjoint(f"{name}{axis}" for axis in ("", *AXES))):
        return ""
    return ", ".join(bodies)


def _owned(point: Point, owners: Mapping[str, str]) -> str:
    """Behind the place of a point what is there: (A), or (B: the slider) where it is the end of a line."""
    who = owners.get(point.name, "")
    lead = "" if isinstance(point.place, At | TwoFacts) else f"{point.name}: "
    return f" ({lead}{who})" if who else ""


def _direction(point: Point, problem: Problem, page: Mentioned, figures: int) -> Line:
    """Of a point that nothing but its direction is used of, as θ is that of OB: that direction."""
    if not isinstance(point.place, Polar):
        return ()
    turned, reach = (
        {n.name for n in walk(s) if isinstance(n, Name)} for s in (point.place.angle, point.place.distance)
    )
    if not turned & {s.name for s in problem.coordinates} or reach & page.letters:
        return ()
    angle = said(point.place.angle, figures)
    return line(f"{point.place.origin}{point.name} at ", angle) if angle else ()


def _is_placed(name: str, page: Mentioned) -> bool:
    """Does the page speak of where a particle is, not of its velocity alone?"""
    return any(x.startswith((f"x_{name}", f"y_{name}", f"r_{name}")) for x in page.letters)


def _only_moving(problem: Problem, page: Mentioned) -> set[str]:
    """The ends of ropes that the page tells nothing of but velocities and accelerations, and the points where ropes
    leave the bodies on which they are wound, of which it tells nothing; not an end from which a rope goes on at a
    slant, on which rates depend.
    """
    stops = [s for j in problem.joints for s in getattr(j, "path", ()) if isinstance(s, RopeStop)]
    leaving = {s.name for s in stops if s.way == "on"} - page.words
    rates = re.compile(r"[va](?:_\w+)?")
    spoken = page.letters | {w for w in page.words if w.isupper()}
    particles = {b.shape.place for b in problem.bodies if isinstance(b.shape, Particle)}
    ends = {
        s.name
        for s in stops
        if s.name in particles and all(rates.fullmatch(w) for w in spoken if s.name in w and w != s.name)
    }
    return leaving | ends - _asked_places(problem) - _slanting_ends(problem)


def _slanting_ends(problem: Problem) -> set[str]:
    """The ends of ropes of which the next stop differs in both coordinates."""
    places = {p.name: p.place for p in problem.points}
    paths: list[tuple[RopeStop, ...]] = [getattr(j, "path", ()) for j in problem.joints]
    pairs = [pair for p in paths if len(p) > 1 for pair in ((p[0], p[1]), (p[-1], p[-2]))]
    stops = [(a.name, places.get(a.name), places.get(b.name)) for a, b in pairs if b.way in ("point", "on")]
    return {name for name, a, b in stops if isinstance(a, At) and isinstance(b, At) and _differ(a, b)}


def _differ(one: At, other: At) -> bool:
    """Do two places differ in both coordinates, as the file has them?"""
    pairs = ((one.x, other.x), (one.y, other.y))
    return all(said(a, AS_WRITTEN) != said(b, AS_WRITTEN) and not (is_zero(a) and is_zero(b)) for a, b in pairs)


def _asked_places(problem: Problem) -> set[str]:
    """The points of which more is asked than a velocity or an acceleration."""
    asked = (n for f in problem.find if f.found.what is not None for n in walk(f.found.what) if isinstance(n, Quantity))
    return {t for q in asked if q.word not in RATES or len(q.things) > 1 for t in q.things}


def _joined(problem: Problem) -> set[str]:
    """The points on which joints, loads and finds rest; of a particle whose velocity is asked, its place is none."""
    found = {name for m in members_of(problem) for s in keys_of(type(m)) for name in names_in(getattr(m, s.name), s)}
    return found | _asked_places(problem)


def _drawn(problem: Problem) -> set[str]:
    """The points from which bodies are drawn."""
    found: set[str] = set()
    for body in problem.bodies:
        shapes = [p.shape for p in body.shape.pieces] if isinstance(body.shape, Composite) else [body.shape]
        slots = ("start", "end", "apex", "place")
        found |= {n for s in shapes for slot in slots if isinstance(n := getattr(s, slot, None), str)}
        found |= {body.shape.rim.center} if isinstance(body.shape, Outline) and body.shape.rim is not None else set()
        if isinstance(body.shape, Composite):
            found |= {p.shape.center for p in body.shape.pieces if isinstance(p.shape, Round | Plate)}
    return found


def _place(point: Point, figures: int) -> Line:
    """A(0.5, 0) m, or by what the file says of it; empty of a point that is told by more."""
    match point.place:
        case At(x, y):
            return _pair(point.name, x, y, figures)
        case Polar(origin, distance, angle):
            one, other = said(distance, figures), said(angle, figures)
            short = len(origin) <= SHORT and len(point.name) <= SHORT
            head = f"{origin}{point.name} = " if short else f"{point.name} from {origin}: "
            return line(head, one, " at ", other) if one and other else ()
        case Towards(origin, towards, distance, None):
            one = said(distance, figures)
            return line(f"{point.name} on {origin}{towards} with {origin}{point.name} = ", one) if one else ()
        case Towards():
            return _beside(point.name, point.place, figures)
        case Midpoint(a, b):
            return line(f"{point.name} midpoint of {a}{b}")
        case TwoFacts():
            return _by_two(point.name, point.place, figures)
    return ()


def _beside(name: str, place: Towards, figures: int) -> Line:
    """K 140 mm from A along AB and 80 mm to the left of it."""
    offset, side = place.offset, "left"
    if isinstance(offset, Negate):
        offset, side = offset.operand, "right"
    along, across = said(place.distance, figures), offset and said(offset, figures)
    way = f" from {place.origin} along {place.origin}{place.towards} and "
    return line(f"{name} ", along, way, across, f" to the {side} of it") if along and across else ()


def _by_two(name: str, place: TwoFacts, figures: int) -> Line:
    """P at y = 500 mm on the line through O at θ."""
    facts: list[Line] = []
    for axis, side in (("x", place.x), ("y", place.y)):
        if side is not None:
            facts.append(line(f"at {axis} = ", said(side, figures) or ()))
    for through, angle in place.lines:
        facts.append(line(f"on the line through {through} at ", said(angle, figures) or ()))
    facts += [line(said(d, figures) or (), f" from {origin}") for origin, d in place.distances]
    joined = [
        p
        for i, fact in enumerate(facts)
        for p in (*([" and "] if i and (place.distances or place.lines[1:]) else [" "]), *fact)
    ]
    return line(name, *joined)


def _pair(name: str, x: Side, y: Side, figures: int) -> Line:
    """The coordinates of a point, the unit of both behind them."""
    numbers = [number_of(x), number_of(y)]
    units = {n[1] for n in numbers if n is not None and n[0]}
    sides = [said(s, figures) for s in (x, y)]
    if not all(sides):
        return ()
    if len(units) != 1 or None in numbers:
        one, other = ("0" if is_zero(s) else shown or () for s, shown in zip((x, y), sides, strict=True))
        return line(f"{name}(", one, ", ", other, ")")
    first, second = (Value(n[0], "1", max(figures, AS_WRITTEN)) for n in numbers if n is not None)
    return line(f"{name}(", first, ", ", second, f") {pretty_unit(next(iter(units)))}")
