"""What a file gives beside its letters: numbers and formulas of bodies, points, joints and loads, and the first state.

Each datum is told in the words of the page, and only where something of the page rests on it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from planar_cli.problem.expression import AtRest, Name, Quantity, Relation, Side
from planar_cli.problem.impulse_letters import impulse_letters
from planar_cli.problem.keys import DirectionKey, Flow, KeySpec, MagnitudeKey, SideKey, keys_of
from planar_cli.problem.lettered import LETTERS
from planar_cli.problem.scene import (
    At,
    Body,
    Circle,
    Composite,
    Midpoint,
    Particle,
    Plate,
    Point,
    Polar,
    Problem,
    Rod,
    Round,
    Sector,
    Shape,
    Surface,
    Towards,
)
from planar_cli.problem.scene import (
    Line as Straight,
)
from planar_cli.problem.scope import Member, members_of, names_in
from planar_cli.problem.walk import walk
from planar_cli.records import record
from planar_cli.report import blocks
from planar_cli.report.blocks import Block, Equation, Forces, Inline, Line, Math, Text, Value, line
from planar_cli.report.blocks import Relation as Related
from planar_cli.report.sides import AS_WRITTEN, is_zero, number_of, said
from planar_cli.units import pretty_unit

RIGHT_ANGLE = 90
SHORT = 2
"""Two names of so many letters side by side are the line between the points."""


@record
class Datum:
    """One number or formula of the file: what it is, its value, and where it belongs if others are called the same."""

    what: Line
    value: Line
    place: str = ""


@record
class Mentioned:
    """What a page speaks of. `words`: all its names and their pieces; `kinetic`: does it tell energies, or forces that
    accelerate something? `counted`: the names for which it puts numbers into formulas. `letters`: names in formulas,
    which units are not. `energies`: it tells energies.
    """

    words: frozenset[str]
    kinetic: bool
    counted: frozenset[str] = frozenset()
    letters: frozenset[str] = frozenset()
    energies: bool = False
    numeric: bool = False
    """Are numbers put into formulas?"""
    summed: bool = False
    """Does a sum of forces, moments or energies stand in numbers, among which its weights are?"""


def mentioned(page: Iterable[Block]) -> Mentioned:
    """All pieces of names and words on a page."""
    found: set[str] = set()
    letters: set[str] = set()
    counted: set[str] = set()
    kinetic = energies = summed = False
    for block in page:
        summed |= isinstance(block, Equation) and _is_of_forces(block.note)
        kinetic |= isinstance(block, Forces) and block.right != (Text("0"),)
        for piece in pieces_of(block):
            match piece:
                case Text(text):
                    found |= set(re.findall(r"\w+", text))
                case blocks.Name(name):
                    letters |= {name, *name.split("_")}
                    energies |= name.startswith("T_")
                case Math(expr):
                    letters |= {p for s in expr.free_symbols for p in (s.name, *s.name.split("_"))}
                    counted |= {s.name for s in piece.values or ()}
    words = frozenset(found | letters)
    return Mentioned(
        words, kinetic or energies, frozenset(counted), frozenset(letters), energies, bool(counted), summed
    )


def _is_of_forces(note: Line) -> bool:
    """Is an equation in numbers one of forces, moments or energies?"""
    return "".join(p.text for p in note if isinstance(p, Text)).startswith(("in N", "in lbf", "in J"))


def pieces_of(value: object) -> Iterator[Inline]:
    """All pieces of the lines of a block."""
    match value:
        case Text() | blocks.Name() | Math() | Value():
            yield value
        case Related():
            yield from (value.left, value.right)
        case tuple():
            for part in value:
                yield from pieces_of(part)
        case _:
            for slot in getattr(value, "__slots__", ()):
                yield from pieces_of(getattr(value, slot))


def given_rows(problem: Problem, page: Mentioned, figures: int) -> tuple[tuple[Line, ...], ...]:
    """The data in rows, which may be empty: of bodies, joints and loads; of points; of the first state."""
    numbers = [
        *(d for b in problem.bodies for d in _of_body(b, problem, page, figures)),
        *(d for s in problem.surfaces for d in _of_surface(s, figures)),
        *(d for m in members_of(problem) for d in _of_member(m, problem, figures)),
    ]
    start = _at_first(problem, tuple(_start(problem, figures)))
    driven = tuple(_driven(problem, page, figures))
    return _listed(numbers), tuple(_points(problem, page, figures)), driven, start


def _at_first(problem: Problem, row: tuple[Line, ...]) -> tuple[Line, ...]:
    """The data of the first state behind its name."""
    return (line(f"{problem.states[0].name}: ", row[0]), *row[1:]) if problem.states and row else row


def _listed(found: Sequence[Datum]) -> tuple[Line, ...]:
    """Each datum once: what it is = its value, with its place where the same letter has several values."""
    places: dict[tuple[Line, Line], list[str]] = {}
    for d in found:
        places.setdefault((d.what, d.value), []).append(d.place)
    values = [what for what, _ in places]
    return tuple(
        line(what, " = ", value, (" " + " and ".join(dict.fromkeys(where))) if values.count(what) > 1 else "")
        for (what, value), where in places.items()
    )


def _datum(what: Line | str, side: Side | None, figures: int, place: str = "") -> Iterator[Datum]:
    """Nothing of what is a letter of the file, or nought."""
    if side is None or isinstance(side, Name) or is_zero(side):
        return
    value = said(side, figures)
    if value is not None:
        yield Datum(line(what), value, place)


def _oblique(side: Side) -> bool:
    """Is it an angle other than a right one, or a letter?"""
    number = number_of(side)
    return number is None or number[1] != "deg" or number[0] % RIGHT_ANGLE != 0


def idle_masses(problem: Problem, page: Mentioned, figures: int) -> Iterator[Line]:
    """Masses and weights that the file gives as numbers, on a page that tells of no force that would need them."""
    for body in () if page.kinetic else problem.bodies:
        if _mass_letter(body, _heavy(problem)) in page.letters:
            continue
        for what, side in (("mass", body.mass), ("weight", body.weight)):
            if side is not None and number_of(side) is not None and (value := said(side, figures)):
                yield line(f"the {what} of {body.name}, ", value)


def _heavy(problem: Problem) -> list[Body]:
    """The bodies that have mass."""
    return [b for b in problem.bodies if not b.is_massless or isinstance(b.shape, Composite)]


def _mass_letter(body: Body, heavy: Sequence[Body]) -> str:
    """The letter of a body's mass on the page."""
    return "m" if len(heavy) == 1 else f"m_{body.name}"


def _of_body(body: Body, problem: Problem, page: Mentioned, figures: int) -> Iterator[Datum]:
    heavy = _heavy(problem)
    letter = _mass_letter(body, heavy)
    if page.kinetic or letter in page.letters:
        yield from _datum(line(blocks.Name(letter)), body.mass, figures)
        yield from _datum(f"weight of {body.name}", body.weight, figures)
    center = getattr(body.shape, "center", None)
    named = not page.words.isdisjoint({"I", f"I_{body.name}", f"I_{center}"} if len(heavy) == 1 else {f"I_{body.name}"})
    if page.energies or (page.kinetic and named):
        yield from _datum(f"moment of inertia of {body.name}", body.inertia, figures)
        yield from _datum(f"radius of gyration of {body.name}", body.gyration, figures)
    inert = page.kinetic and named and body.inertia is None and body.gyration is None
    yield from _of_shape(body.shape, body.name, inert, figures)


def _of_shape(shape: Shape, name: str, inert: bool, figures: int) -> Iterator[Datum]:
    """The sizes of a shape. `inert`: does the page use its moment of inertia?"""
    match shape:
        case Rod():
            yield from _datum(f"length of {name}", shape.length, figures)
        case Round():
            yield from _datum(f"radius of {name}", shape.radius, figures)
            yield from _datum(f"radius of the hub of {name}", shape.hub, figures)
        case Sector() if inert:
            yield from _datum(f"radius of {name}", shape.radius, figures)
        case Plate() if inert:
            yield from _datum(f"width of {name}", shape.width, figures)
            yield from _datum(f"height of {name}", shape.height, figures)
        case Composite():
            for i, piece in enumerate(shape.pieces, 1):
                yield from _datum(line(blocks.Name(f"m_{name}_{i}")), piece.mass, figures)
                yield from _datum(f"weight of part {i} of {name}", piece.weight, figures)
                yield from _datum(f"moment of inertia of part {i} of {name}", piece.inertia, figures)
                yield from _datum(f"radius of gyration of part {i} of {name}", piece.gyration, figures)
                own = inert and piece.inertia is None and piece.gyration is None
                yield from _of_shape(piece.shape, f"part {i} of {name}", own, figures)


def _of_surface(surface: Surface, figures: int) -> Iterator[Datum]:
    shape = surface.shape
    if isinstance(shape, Straight) and _oblique(shape.angle):
        yield from _datum(f"direction of {surface.name}", shape.angle, figures)
    if isinstance(shape, Circle):
        yield from _datum(f"radius of {surface.name}", shape.radius, figures)
    yield from _datum(f"speed of {surface.name}", surface.speed, figures)


def _of_member(member: Member, problem: Problem, figures: int) -> Iterator[Datum]:
    own = {p.name for p in problem.points} | {b.name for b in problem.bodies}
    named = member.kind if member.name in own else f"{member.kind} {member.name}"
    place = f"at {member.name}" if member.name in own else f"of {member.name}"
    letter = impulse_letters(problem).get(member.name, ("",))[0]
    for spec in keys_of(type(member)):
        value = getattr(member, spec.name)
        if letter and spec.name == "magnitude":
            yield from _datum(line(blocks.Name(letter)), value, figures, place)
            continue
        for what, side in _sides(value, spec, named):
            yield from _datum(what, side, figures, place)
        if isinstance(value, Flow) and spec.name == "leaves" and is_zero(value.speed):
            # It exerts no force, so that nothing else speaks of it.
            yield Datum(line("speed of what leaves, relative to the body"), line("0"), place)


def _sides(value: object, spec: KeySpec, named: str) -> Iterator[tuple[Line | str, Side]]:
    """The formulas of one key, and what they are."""
    match spec.type, value:
        case (_, Flow()):
            yield f"speed at which the stream {spec.name}", value.speed
            if _oblique(value.angle):
                yield f"direction in which the stream {spec.name}", value.angle
        case (SideKey() | MagnitudeKey() | DirectionKey(), _) if isinstance(value, Side):
            turned = isinstance(spec.type, DirectionKey) or (isinstance(spec.type, SideKey) and spec.type.angle)
            if turned and not _oblique(value):
                return
            if turned:
                yield f"direction of the {named if spec.name in ('angle', 'along') else spec.name}", value
            elif spec.name in LETTERS:
                yield line(blocks.Name(LETTERS[spec.name])), value
            else:
                main = spec.name in ("magnitude", "moment")
                yield named if main else f"{spec.name.replace('_', ' ')} of the {named}", value


def _points(problem: Problem, page: Mentioned, figures: int) -> Iterator[Line]:
    """Where the points are that the page, a body or what acts speaks of; an origin alone needs no telling."""
    used = page.words | _referred(problem)
    places = [p for p in problem.points if p.name in used]
    drops = [
        Point(b.name, b.shape.place, b.mark)
        for b in problem.bodies
        if isinstance(b.shape, Particle)
        and isinstance(b.shape.place, At)
        and not (is_zero(b.shape.place.x) and is_zero(b.shape.place.y))
    ]
    told = [(p, found) for p in (*places, *drops) if (found := _place(p, figures))]
    if any(not (isinstance(p.place, At) and is_zero(p.place.x) and is_zero(p.place.y)) for p, _ in told):
        yield from (found for _, found in told)


def _referred(problem: Problem) -> set[str]:
    """The points on which bodies, joints, loads and finds rest."""
    found = {name for m in members_of(problem) for s in keys_of(type(m)) for name in names_in(getattr(m, s.name), s)}
    for body in problem.bodies:
        shapes = [p.shape for p in body.shape.pieces] if isinstance(body.shape, Composite) else [body.shape]
        slots = ("start", "end", "apex", "place")
        found |= {n for s in shapes for slot in slots if isinstance(n := getattr(s, slot, None), str)}
        if isinstance(body.shape, Composite):
            found |= {p.shape.center for p in body.shape.pieces if isinstance(p.shape, Round | Plate)}
    for find in problem.find:
        what = find.found.what
        found |= {t for n in walk(what) if isinstance(n, Quantity) for t in n.things}
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
        case Towards(origin, towards, distance):
            one = said(distance, figures)
            return line(f"{point.name} on {origin}{towards} with {origin}{point.name} = ", one) if one else ()
        case Midpoint(a, b):
            return line(f"{point.name} midpoint of {a}{b}")
    return ()


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


def _start(problem: Problem, figures: int) -> Iterator[Line]:
    """What the first state, or the only instant, gives: relations with numbers or letters on one side."""
    relations = problem.states[0].relations if problem.states else problem.instant or ()
    unknown = {s.name for s in problem.unknowns}
    for relation in relations:
        if isinstance(relation, AtRest):
            yield line(f"{relation.body} at rest" if relation.body else "at rest")
        elif isinstance(relation, Relation) and relation.operator == "=" and _gives(relation, unknown):
            left, right = said(relation.left, figures), said(relation.right, figures)
            if left and right:
                yield line(left, " = ", right)


def _driven(problem: Problem, page: Mentioned, figures: int) -> Iterator[Line]:
    """The numbers with which something is driven, such as the speed of a crank; in letters what the page speaks of says
    it.
    """
    unknown = {s.name for s in problem.unknowns}
    for relation in (law.statement for law in problem.motion):
        if isinstance(relation, Relation) and relation.operator == "=" and _gives(relation, unknown):
            left, right = said(relation.left, figures), said(relation.right, figures)
            names = {p.name for p in pieces_of(left) if isinstance(p, blocks.Name)}
            number = number_of(relation.right) is not None and not is_zero(relation.right)
            if left and right and number and (page.numeric or page.words.isdisjoint(names)):
                yield line(left, " = ", right)


def _gives(relation: Relation, unknown: set[str]) -> bool:
    """Does it say what something is, without asking anything? That the clock begins at nought is no datum."""
    if not isinstance(relation.left, Quantity | Name) or _begins_the_clock(relation):
        return False
    nodes = list(walk(relation.right))
    return not any(isinstance(n, Quantity) or (isinstance(n, Name) and n.name in unknown) for n in nodes)


def _begins_the_clock(relation: Relation) -> bool:
    return isinstance(relation.left, Name) and relation.left.name == "t" and is_zero(relation.right)
