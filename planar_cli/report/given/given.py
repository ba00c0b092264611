"""What a file gives beside its letters: numbers and formulas of bodies, points, joints and loads, and the first state.

Each datum is told in the words of the page, and only where something of the page rests on it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from planar_cli.problem.checks.scope import Member, members_of
from planar_cli.problem.implied.lettered import LETTERS
from planar_cli.problem.language.expression import Binary, Name, Number, Quantity, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.impulse_letters import impulse_letters
from planar_cli.problem.scene.keys import DirectionKey, Flow, KeySpec, MagnitudeKey, SideKey, keys_of
from planar_cli.problem.scene.part_names import part_letter, part_names
from planar_cli.problem.scene.scene import (
    ALL,
    GROUND,
    Body,
    Circle,
    Composite,
    Curve,
    Outline,
    Plate,
    Problem,
    Rod,
    Round,
    Sector,
    Shape,
    Surface,
)
from planar_cli.problem.scene.scene import (
    Line as Straight,
)
from planar_cli.records import record
from planar_cli.report.document import blocks
from planar_cli.report.document.blocks import Line, line
from planar_cli.report.document.mentioned import Mentioned
from planar_cli.report.given.given_points import points_given
from planar_cli.report.given.given_states import laws_given, states_given
from planar_cli.report.words.sides import is_zero, number_of, said, said_of_force
from planar_cli.units import MASS, parse_unit

RIGHT_ANGLE = 90
OF_MASS = frozenset({"mass", "I", "KE", "PE", "momentum", "H"})
"""Quantities of a body that its mass makes."""


@record
class Datum:
    """One number or formula of the file: what it is, its value, and where it belongs if others are called the same."""

    what: Line
    value: Line
    place: str = ""


def given_rows(problem: Problem, page: Mentioned, figures: int) -> tuple[tuple[Line, ...], ...]:
    """The data in rows, which may be empty: of bodies, joints and loads; of points; what `motion` says; of
    each state.
    """
    numbers = [
        *(d for b in problem.bodies for d in _of_body(b, problem, page, figures)),
        *(d for s in problem.surfaces for d in _of_surface(s, figures)),
        *(d for m in members_of(problem) for d in _of_member(m, problem, figures)),
    ]
    states = (tuple(row) for row in states_given(problem, figures))
    return (
        _listed(numbers),
        tuple(points_given(problem, page, figures)),
        tuple(laws_given(problem, figures)),
        *states,
    )


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
    for body in () if _forces_by_mass(problem) else problem.bodies:
        turns = _turns_by_its_inertia(body, problem, page)
        named = _mass_letter(body, _heavy(problem)) in page.letters
        if named or not (turns or (not page.kinetic and body.name not in _asked_of(problem))):
            continue
        for what, side in (("mass", body.mass), ("weight", body.weight)):
            if side is not None and number_of(side) is not None and (value := said(side, figures)):
                yield line(f"the {what} of {body.name}, ", value)


def _turns_by_its_inertia(body: Body, problem: Problem, page: Mentioned) -> bool:
    """Does a body turn about a fixed pin at its mass centre, with a moment of inertia that the file gives, and has the
    page no letter of its mass? Its energy and its angular momentum are then I ω²/2 and I ω, and nothing lifts its
    weight. One with a mass that is asked needs more.
    """
    center = getattr(body.shape, "center", None)
    if body.inertia is None or center is None or page.integrated or _mass_letter(body, _heavy(problem)) in page.letters:
        return False
    if body.name in _asked_of(problem, OF_MASS - {"KE"}) or body.about not in (None, center):
        return False
    return any(j.kind == "pin" and j.during is None and _is_between(j, body, center) for j in problem.joints)


def _is_between(joint: Member, body: Body, point: str) -> bool:
    """Does a joint hold the body to the ground at that point?"""
    return getattr(joint, "at", None) == point and {GROUND, body.name} <= {*getattr(joint, "between", ())}


def _forces_by_mass(problem: Problem) -> bool:
    """Is a force written with a mass as a number, which need not be that of the body?"""
    forces = (side for m in problem.loads if isinstance(side := getattr(m, "magnitude", None), Side))
    units = (n.unit for side in forces for n in walk(side) if isinstance(n, Number) and n.unit)
    return any(parse_unit(unit).dimension == MASS for unit in units)


def idle_inertias(problem: Problem, page: Mentioned, figures: int) -> Iterator[Line]:
    """Moments of inertia and radii of gyration that the file gives as numbers, of bodies whose page needs none."""
    for body in () if page.energies else problem.bodies:
        if body.name in _asked_of(problem) or (page.kinetic and _tells_inertia(body, problem, page)):
            continue
        for what, side in (
            (f"moment of inertia{_of(body)}", body.inertia),
            (f"radius of gyration{_of(body)}", body.gyration),
        ):
            told = None if side is None else number_of(side)
            if side is not None and told is not None and told[0] and (value := said(side, figures)):
                yield line(f"the {what}, ", value)


def _of(body: Body) -> str:
    """Of which body a moment of inertia is, and about which point if not its mass centre."""
    return f" of {body.name}" + (f" about {body.about}" if body.about is not None else "")


def _asked_of(problem: Problem, words: Collection[str] = OF_MASS) -> set[str]:
    """The bodies of which something is asked that their mass and its distribution make: one of these quantities."""
    quantities = (q for f in problem.find for q in walk(f.found.what) if isinstance(q, Quantity))
    things = ((q.word, thing) for q in quantities for thing in q.things[:1])
    named = {thing for word, thing in things if word in words or (thing == ALL and word not in OF_MASS)}
    return {b.name for b in problem.bodies} if ALL in named else named


def _tells_inertia(body: Body, problem: Problem, page: Mentioned) -> bool:
    """Does the moment of inertia of a body stand on the page?"""
    center = getattr(body.shape, "center", None)
    own = {f"I_{body.name}"}
    return not page.words.isdisjoint({"I", *own, f"I_{center}"} if len(_heavy(problem)) == 1 else own)


def _heavy(problem: Problem) -> list[Body]:
    """The bodies that have mass."""
    return [b for b in problem.bodies if not b.is_massless or isinstance(b.shape, Composite)]


def _mass_letter(body: Body, heavy: Sequence[Body]) -> str:
    """The letter of a body's mass on the page."""
    return "m" if len(heavy) == 1 else f"m_{body.name}"


def _of_body(body: Body, problem: Problem, page: Mentioned, figures: int) -> Iterator[Datum]:
    heavy = _heavy(problem)
    letter = _mass_letter(body, heavy)
    formula = body.mass is not None and any(n.name == "t" for n in walk(body.mass) if isinstance(n, Name))
    moved = page.kinetic and not _turns_by_its_inertia(body, problem, page)
    if moved or letter in page.letters or formula:
        yield from _datum(line(blocks.Name(letter)), body.mass, figures)
    if moved or letter in page.letters:
        yield from _datum(f"weight of {body.name}", body.weight, figures)
    named = _tells_inertia(body, problem, page)
    if page.energies or (page.kinetic and named):
        yield from _datum(f"moment of inertia{_of(body)}", body.inertia, figures)
        yield from _datum(f"radius of gyration{_of(body)}", body.gyration, figures)
    inert = page.kinetic and named and body.inertia is None and body.gyration is None
    if isinstance(body.shape, Composite):
        yield from _of_parts(body, body.shape, problem, inert, figures)
    yield from _of_shape(body.shape, body.name, inert, figures)


def _of_shape(shape: Shape, name: str, inert: bool, figures: int) -> Iterator[Datum]:
    """The sizes of a shape. `inert`: does the page use its moment of inertia?"""
    match shape:
        case Rod():
            yield from _datum(f"length of {name}", shape.length, figures)
        case Outline(rim=Round() as rim):
            yield from _of_shape(rim, name, inert, figures)
        case Round():
            yield from _datum(f"radius of {name}", shape.radius, figures)
            yield from _datum(f"radius of the hub of {name}", shape.hub, figures)
        case Sector() if inert:
            yield from _datum(f"radius of {name}", shape.radius, figures)
        case Plate() if inert:
            yield from _datum(f"width of {name}", shape.width, figures)
            yield from _datum(f"height of {name}", shape.height, figures)


def _of_parts(body: Body, shape: Composite, problem: Problem, inert: bool, figures: int) -> Iterator[Datum]:
    """Masses and sizes of the parts of a body."""
    for i, (piece, name) in enumerate(zip(shape.pieces, part_names(body, problem), strict=True), 1):
        yield from _datum(line(blocks.Name(part_letter("m", i, body, problem))), piece.mass, figures)
        yield from _datum(f"weight of {name}", piece.weight, figures)
        yield from _datum(f"moment of inertia of {name}", piece.inertia, figures)
        yield from _datum(f"radius of gyration of {name}", piece.gyration, figures)
        own = inert and piece.inertia is None and piece.gyration is None
        yield from _of_shape(piece.shape, name, own, figures)


def _of_surface(surface: Surface, figures: int) -> Iterator[Datum]:
    shape = surface.shape
    if isinstance(shape, Straight) and _oblique(shape.angle):
        yield from _datum(f"direction of {surface.name}", shape.angle, figures)
    if isinstance(shape, Circle):
        yield from _datum(f"radius of {surface.name}", shape.radius, figures)
    if isinstance(shape, Curve):
        yield from _datum(line(f"{surface.name}: ", blocks.Name(shape.kind)), shape.formula, figures)
    yield from _datum(f"speed of {surface.name}", surface.speed, figures)


def _of_member(member: Member, problem: Problem, figures: int) -> Iterator[Datum]:
    own = {p.name for p in problem.points} | {b.name for b in problem.bodies}
    named = member.kind if member.name in own else f"{member.kind} {member.name}"
    place = f"at {member.name}" if member.name in own else f"of {member.name}"
    letter = impulse_letters(problem).get(member.name, ("",))[0]
    for spec in keys_of(type(member)):
        value = getattr(member, spec.name)
        if value is not None and spec.name in ("linear", "quadratic"):
            # The magnitude is written out with it.
            continue
        if letter and spec.name == "magnitude":
            yield from _datum(line(blocks.Name(letter)), value, figures, place)
            continue
        if spec.name == "magnitude" and isinstance(value, Binary):
            yield from _of_force(named, value, problem, figures, place)
            continue
        for what, side in _sides(value, spec, named):
            yield from _datum(what, side, figures, place)
        if isinstance(value, Flow) and spec.name == "leaves" and is_zero(value.speed):
            # It exerts no force, so that nothing else speaks of it.
            yield Datum(line("speed of what leaves, relative to the body"), line("0"), place)


def _of_force(named: str, side: Side, problem: Problem, figures: int, place: str) -> Iterator[Datum]:
    """A force by its formula, m K/r², with the letter that a mass has on the page."""
    heavy = _heavy(problem)
    letters = {f"m_{b.name}": _mass_letter(b, heavy) for b in heavy}
    told = said_of_force(side, figures)
    if told is not None:
        own = (blocks.Name(letters[p.name]) if isinstance(p, blocks.Name) and p.name in letters else p for p in told)
        yield Datum(line(named), line(*own), place)


def _sides(value: object, spec: KeySpec, named: str) -> Iterator[tuple[Line | str, Side]]:
    """The formulas of one key, and what they are."""
    match spec.type, value:
        case (_, Flow()):
            yield f"speed of what {spec.name}, relative to the body", value.speed
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
