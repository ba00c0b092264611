"""All formulas of a problem, each with what is expected of it: unit, and what it may use."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from planar_cli.errors import Mark
from planar_cli.problem.checks.scope import Member, members_of
from planar_cli.problem.language.expression import Side, Statement
from planar_cli.problem.scene.keys import (
    DirectionKey,
    Flow,
    KeySpec,
    MagnitudeKey,
    SideKey,
    StatementsKey,
    Table,
    keys_of,
)
from planar_cli.problem.scene.scene import (
    At,
    Body,
    Circle,
    Composite,
    Curve,
    Line,
    Outline,
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
    TwoFacts,
)
from planar_cli.records import record

UNITS = {"length": "m", "angle": "deg", "mass": "kg", "weight": "N", "inertia": "kg*m^2", "speed": "m/s", "pure": "1"}


@record
class Formula:
    """One formula: `what` it is in words, the `unit` whose dimension it must have (None: any), whether it is an angle.

    `time`: may it use `t`? `quantities`: may it use `v(P)` and the like, `places`: `x(P)`, `y(P)`, `theta(b)`?
    `turns`: may it be counted from `theta(b)`? `locals`: variables of a curve.
    """

    tree: Side | Statement
    what: str
    mark: Mark
    unit: str | None = None
    angle: bool = False
    time: bool = False
    quantities: bool = False
    places: bool = False
    turns: bool = False
    locals: frozenset[str] = frozenset()


def formulas(problem: Problem) -> Iterator[Formula]:
    """Every formula of the problem, its cases left out."""
    for symbol in problem.given:
        if symbol.value is not None:
            yield Formula(symbol.value, f"the value of {symbol.name}", symbol.mark)
    for statement in problem.assume:
        yield Formula(statement, "assume", statement.mark)
    for point in problem.points:
        yield from _of_point(point)
    for surface in problem.surfaces:
        yield from _of_surface(surface)
    for body in problem.bodies:
        yield from _of_body(body)
    for member in members_of(problem):
        yield from _of_member(member)
    yield from _of_statements(problem)


def _of_statements(problem: Problem) -> Iterator[Formula]:
    for law in problem.motion:
        yield Formula(law.statement, "motion", law.statement.mark, time=True, quantities=True)
    for statement in problem.instant or ():
        yield Formula(statement, "instant", statement.mark, time=True, quantities=True)
    for state in problem.states:
        for statement in state.relations:
            yield Formula(statement, f"the state {state.name}", statement.mark, time=True, quantities=True)
    for find in problem.find:
        yield Formula(find.found.what, f"the find {find.name}", find.mark, time=True, quantities=True)
    if problem.tolerance is not None:
        yield Formula(problem.tolerance, "tolerance", problem.tolerance.mark, "1")


def _plain(side: Side | None, kind: str, what: str) -> Iterator[Formula]:
    """A formula of names only, of the dimension that `kind` names in UNITS."""
    if side is not None:
        yield Formula(side, what, side.mark, UNITS[kind], angle=kind == "angle")


def _of_point(point: Point) -> Iterator[Formula]:
    what, place = f"of the point {point.name}", point.place
    match place:
        case At():
            yield from _plain(place.x, "length", f"x {what}")
            yield from _plain(place.y, "length", f"y {what}")
        case Polar():
            yield from _plain(place.distance, "length", f"the distance {what}")
            yield from _plain(place.angle, "angle", f"the angle {what}")
        case Towards():
            yield from _plain(place.distance, "length", f"the distance {what}")
            yield from _plain(place.offset, "length", f"the offset {what}")
        case TwoFacts():
            yield from _plain(place.x, "length", f"x {what}")
            yield from _plain(place.y, "length", f"y {what}")
            for _, angle in place.lines:
                yield from _plain(angle, "angle", f"the line {what}")
            for _, distance in place.distances:
                yield from _plain(distance, "length", f"a distance {what}")
        case _:
            return


def _of_surface(surface: Surface) -> Iterator[Formula]:
    what, shape = f"of the surface {surface.name}", surface.shape
    match shape:
        case Line():
            yield from _plain(shape.angle, "angle", f"the angle {what}")
        case Circle():
            yield from _plain(shape.radius, "length", f"the radius {what}")
        case Curve():
            variable = "x" if shape.kind == "y" else "theta"
            yield Formula(shape.formula, f"the curve {what}", shape.formula.mark, "m", locals=frozenset((variable,)))
    yield from _plain(surface.speed, "speed", f"the speed {what}")


def _of_body(body: Body) -> Iterator[Formula]:
    what = f"of the body {body.name}"
    yield from _of_shape(body.shape, what)
    if body.mass is not None:
        yield Formula(body.mass, f"the mass {what}", body.mass.mark, "kg", time=True, places=True)
    yield from _plain(body.weight, "weight", f"the weight {what}")
    if body.inertia is not None:
        words = f"the moment of inertia {what}"
        yield Formula(body.inertia, words, body.inertia.mark, UNITS["inertia"], time=True)
    yield from _plain(body.gyration, "length", f"the radius of gyration {what}")


def _of_shape(shape: Shape, what: str) -> Iterator[Formula]:
    match shape:
        case Particle(place=At() as place):
            yield from _plain(place.x, "length", f"x {what}")
            yield from _plain(place.y, "length", f"y {what}")
        case Rod():
            yield from _plain(shape.angle, "angle", f"the direction {what}")
            yield from _plain(shape.length, "length", f"the length {what}")
        case Outline(rim=Round() as rim):
            yield from _of_shape(rim, what)
        case Round():
            yield from _plain(shape.radius, "length", f"the radius {what}")
            yield from _plain(shape.hub, "length", f"the hub radius {what}")
        case Sector():
            yield from _plain(shape.radius, "length", f"the radius {what}")
            yield from _plain(shape.span, "angle", f"the span {what}")
            yield from _plain(shape.angle, "angle", f"the angle {what}")
        case Plate():
            yield from _plain(shape.width, "length", f"the width {what}")
            yield from _plain(shape.height, "length", f"the height {what}")
            yield from _plain(shape.angle, "angle", f"the angle {what}")
        case Composite():
            yield from _of_pieces(shape, what)
        case _:
            return


def _of_pieces(shape: Composite, what: str) -> Iterator[Formula]:
    for piece in shape.pieces:
        part = f"of a part {what}"
        yield from _of_shape(piece.shape, part)
        yield from _plain(piece.mass, "mass", f"the mass {part}")
        yield from _plain(piece.weight, "weight", f"the weight {part}")
        yield from _plain(piece.inertia, "inertia", f"the moment of inertia {part}")
        yield from _plain(piece.gyration, "length", f"the radius of gyration {part}")


def _of_member(member: Member) -> Iterator[Formula]:
    for spec in keys_of(type(member)):
        value = getattr(member, spec.name)
        if value is not None and not isinstance(value, str):
            for formula in _of_key(value, spec, f"{spec.name} of the {member.kind}"):
                yield replace(formula, unit=None) if spec.name in member.derived else formula


def _of_key(value: object, spec: KeySpec, what: str) -> Iterator[Formula]:
    match spec.type, value:
        case MagnitudeKey(unit=unit), Table():
            for instant, number in value.rows:
                yield Formula(instant, f"an instant in {what}", instant.mark, "s")
                yield Formula(number, what, number.mark, unit)
        case MagnitudeKey(unit=unit), _ if isinstance(value, Side):
            yield Formula(value, what, value.mark, unit, time=True, quantities=True)
        case SideKey(unit=unit, angle=angle, turns=turns), _ if isinstance(value, Side):
            yield Formula(value, what, value.mark, unit, angle=angle, turns=turns)
        case DirectionKey(), _ if isinstance(value, Side):
            yield Formula(value, what, value.mark, "deg", angle=True)
        case StatementsKey(), tuple():
            for statement in value:
                yield Formula(statement, what, statement.mark, quantities=True)
        case _, Flow():
            for side, kind in ((value.speed, "speed"), (value.angle, "angle")):
                words, turned = f"the {kind} in {what}", kind == "angle"
                yield Formula(side, words, side.mark, UNITS[kind], angle=turned, time=True, quantities=True)
        case _:
            return
