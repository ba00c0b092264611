"""Checks of names: all distinct, none reserved, every reference to a thing found."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from planar_cli.errors import Diagnostic, Mark
from planar_cli.problem.checks.scope import Member, Scope, members_of, names_in
from planar_cli.problem.language.words import is_reserved
from planar_cli.problem.nodes.reading import did_you_mean
from planar_cli.problem.scene.keys import (
    BodyKey,
    DirectionKey,
    PartnersKey,
    RopePathKey,
    keys_of,
)
from planar_cli.problem.scene.scene import (
    GROUND,
    Body,
    Circle,
    Foot,
    Line,
    Midpoint,
    Particle,
    Place,
    Plate,
    Polar,
    Rims,
    Round,
    Tip,
    Towards,
    TwoFacts,
)
from planar_cli.problem.scene.shapes import own_points

BOOLEANS = frozenset("on off yes no true false null".split())


def reserved_names(scope: Scope) -> Iterator[Diagnostic]:
    """No name is a word of the language."""
    for name, what, mark in _all_names(scope):
        if is_reserved(name):
            yield Diagnostic(
                mark, "PL401", f"'{name}' is a word of the language and cannot name {what}", _other_name(name)
            )
    p = scope.problem
    for name, what, mark in (
        *((s.name, "a state", s.mark) for s in p.states),
        *((f.name, "a find", f.mark) for f in p.find),
    ):
        if name.lower() in BOOLEANS:
            yield Diagnostic(
                mark, "PL401", f"'{name}' cannot name {what}; other readers of YAML take it for true or false", ""
            )


def _other_name(name: str) -> str:
    habits = {"t": "time is always `t`", "pi": "`pi` is 3.1416 by itself", "ground": "the ground is there by itself"}
    return habits.get(name, f"write another name, such as `{name}_1`")


def distinct_names(scope: Scope) -> Iterator[Diagnostic]:
    """All names of a file differ; a particle may share its point's name, a disk or plate that of its centre."""
    seen: dict[str, tuple[str, Mark]] = {}
    for name, what, mark in _all_names(scope):
        if name not in seen:
            seen[name] = (what, mark)
            continue
        before, place = seen[name]
        body = scope.bodies.get(name)
        if body is not None and _middle(body) == name and {before, what} == {"a point", "a body"}:
            continue
        message = f"'{name}' names {what} here and {before} in line {place.line}"
        yield Diagnostic(mark, "PL402", message, _repair(name, body, before, what))


def _middle(body: Body) -> str | None:
    """The point that a body may share its name with: its place, or its centre, where its mass centre is too."""
    if isinstance(body.shape, Particle):
        return body.shape.place if isinstance(body.shape.place, str) else None
    return body.shape.center if isinstance(body.shape, Round | Plate) else None


def _repair(name: str, body: Body | None, before: str, what: str) -> str:
    roles = {"a given value", "a symbol", "an unknown", "a coordinate"}
    if {before, what} <= roles:
        return "`given` has a value, `symbols` stay letters, `unknowns` are solved for: choose one"
    if body is not None and isinstance(body.shape, Particle) and {before, what} == {"a point", "a body"}:
        return f"a particle may share its own point's name: `{name}: {{particle: {name}}}`"
    return "all names of a file differ; rename one of them"


def _all_names(scope: Scope) -> Iterator[tuple[str, str, Mark]]:
    p = scope.problem
    yield from ((s.name, "a given value", s.mark) for s in p.given)
    yield from ((s.name, "a symbol", s.mark) for s in p.symbols)
    yield from ((s.name, "an unknown", s.mark) for s in p.unknowns)
    yield from ((s.name, "a coordinate", s.mark) for s in p.coordinates)
    yield from ((s.name, "a point", s.mark) for s in p.points)
    yield from ((s.name, "a surface", s.mark) for s in p.surfaces)
    yield from ((s.name, "a body", s.mark) for s in p.bodies)
    yield from ((m.name, f"the {m.kind}", m.mark) for m in members_of(p) if m.name and not _called_by_own(m, scope))


def _called_by_own(member: Member, scope: Scope) -> bool:
    """Is a joint or load called by one of its own points, bodies or surfaces? That is no name of its own."""
    return member.name in scope.mentioned(member)


def points_found(scope: Scope) -> Iterator[Diagnostic]:
    """Every point that a point, surface or body names exists."""
    for point in scope.problem.points:
        for name in points_of_place(point.place):
            yield from _missing_point(name, scope, point.mark)
    for surface in scope.problem.surfaces:
        if isinstance(surface.shape, Line):
            yield from _missing_point(surface.shape.through, scope, surface.mark)
        if isinstance(surface.shape, Circle):
            yield from _missing_point(surface.shape.center, scope, surface.mark)
        yield from _missing(surface.body, scope.bodies, "body", surface.mark)
    for body in scope.problem.bodies:
        for used in (*own_points(body.shape), *body.points, body.about):
            yield from _missing_point(used, scope, body.mark, body)


def _beside(body: Body, scope: Scope) -> Iterable[str]:
    """The points at which a body may be placed: a particle is no place for itself."""
    own = isinstance(body.shape, Particle) and all(p.name != body.name for p in scope.problem.points)
    return (p for p in scope.points if not own or p != body.name)


def points_of_place(place: Place) -> tuple[str, ...]:
    match place:
        case Polar():
            return (place.origin,)
        case Towards():
            return (place.origin, place.towards)
        case Midpoint():
            return (place.a, place.b)
        case TwoFacts():
            return tuple(name for name, _ in (*place.lines, *place.distances))
        case Foot():
            return (place.center, place.through, *((place.towards,) if place.towards else ()))
        case Rims():
            return (place.a, place.b)
        case Tip():
            center = () if place.plate is None else (place.plate.center,)
            return (*place.ends, *center, *(n for n in (place.through, place.towards) if n))
        case _:
            return ()


def _missing_point(name: str | None, scope: Scope, mark: Mark, body: Body | None = None) -> Iterator[Diagnostic]:
    """The same of a point; those that the file does not name are not told. `body`: to be placed there."""
    known = list(scope.points if body is None else _beside(body, scope))
    hidden = {p.name for p in scope.problem.points if p.unnamed}
    if name not in known:
        yield from _missing(name, (n for n in known if n not in hidden), "point", mark)


def _missing(name: str | None, known: Iterable[str], what: str, mark: Mark) -> Iterator[Diagnostic]:
    """An error unless `name` is known, or was not readable."""
    names = list(known)
    if name and name not in names:
        hint = (
            did_you_mean(name, names, f"{'points' if what == 'point' else 'there'} are ") or f"there is no {what} yet"
        )
        yield Diagnostic(mark, "PL403", f"there is no {what} '{name}'", hint)


def members_found(scope: Scope) -> Iterator[Diagnostic]:
    """Every point, body and surface that a joint or load names exists."""
    for member in members_of(scope.problem):
        for name, key_type in _references(member):
            yield from _missing_in_member(name, key_type, member, scope)
        if member.during:
            for state in member.during:
                yield from missing_state(state, scope, member.mark)


def missing_state(state: str, scope: Scope, mark: Mark) -> Iterator[Diagnostic]:
    """An error unless the file has that state."""
    if state in scope.states:
        return
    if not scope.states:
        hint = f"write `states: {{{state}: [at rest], …}}`"
        if scope.problem.instant is not None:
            hint = f"all is at the one instant: leave state {state} out, or {hint} in place of `instant`"
        yield Diagnostic(mark, "PL405", f"there is no state '{state}': the file has no `states`", hint)
        return
    hint = did_you_mean(state, scope.states, "states are ")
    more = "" if hint.startswith("did") else f"; or add `{state}: […]` to `states`"
    yield Diagnostic(mark, "PL405", f"there is no state '{state}'", f"{hint}{more}")


def _references(member: Member) -> Iterator[tuple[str, object]]:
    """Names that a joint or load refers to, each with its key type."""
    for spec in keys_of(type(member)):
        value = getattr(member, spec.name)
        if value is not None:
            yield from ((name, spec.type) for name in names_in(value, spec))


def _missing_in_member(name: str, key_type: object, member: Member, scope: Scope) -> Iterator[Diagnostic]:
    what = f"the {member.kind}"
    match key_type:
        case PartnersKey():
            known: set[str] = {*scope.bodies, *scope.surfaces, GROUND}
            kind = "body or surface"
        case BodyKey():
            known, kind = set(scope.bodies), "body"
        case RopePathKey():
            known, kind = scope.point_like, "point or body"
        case DirectionKey():
            known, kind = {*scope.bodies, *scope.surfaces}, "body or surface"
        case _:
            known, kind = set(scope.points), "point"
    if not name or name in known:
        return
    yield Diagnostic(
        member.mark, "PL403", f"there is no {kind} '{name}', named in {what}", _member_hint(name, kind, known, scope)
    )


def _member_hint(name: str, kind: str, known: set[str], scope: Scope) -> str:
    if kind == "point" and name in scope.bodies:
        return f"'{name}' is a body; name one of its points"
    if kind.startswith("body") and name in scope.points:
        return f"'{name}' is a point; name the body or surface, or make it `{name}: {{particle: {name}}}`"
    if kind == "body" and name in scope.surfaces:
        return f"'{name}' is a surface"
    return did_you_mean(name, sorted(known), "there are ") or f"there is no {kind} yet"
