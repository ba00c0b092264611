"""Checks of what moves with what: where loads and joints act on a particle, and what a coordinate moves."""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.errors import Diagnostic
from planar_cli.problem.checks.scope import Scope, members_of
from planar_cli.problem.checks.shared_points import HOLDING
from planar_cli.problem.checks.unused import coordinates_behind, idle_coordinates, names_of
from planar_cli.problem.language.expression import Quantity, Relation, Statement
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.known_values import KnownValues, NoNumber
from planar_cli.problem.scene.scene import GROUND, At, Body, Particle
from planar_cli.problem.scene.shapes import own_points


def particles_have_one_point(scope: Scope) -> Iterator[Diagnostic]:
    """What acts on a particle acts where it is, not at a point of another body that nothing joins to it."""
    particles = {b.name: b for b in scope.problem.bodies if b.is_particle}
    for load in scope.problem.loads:
        for point, name in load.attachments():
            if name not in particles or point in _points(particles[name]):
                continue
            others = [b.name for b in scope.problem.bodies if b.name != name and point in _points(b)]
            # A link or rope between two particles keeps them apart.
            joined = any({name, point} <= scope.mentioned(j) for j in scope.problem.joints if j.kind in HOLDING)
            if others and not joined:
                owner = "another particle" if others[0] == point else f"a point of {others[0]}"
                text = f"{point} is {owner}; {load.called} acts on {name}, which is a particle elsewhere"
                hint = f"leave `at` out, or let it act on {others[0]}"
                yield Diagnostic(load.mark, "PL465", text, hint)


def particles_move_with_their_points(scope: Scope) -> Iterator[Diagnostic]:
    """A point at which something holds or acts on a particle is written with the same coordinates as the particle."""
    particles = {b.name: b.shape for b in scope.problem.bodies if isinstance(b.shape, Particle) and b.shape.place}
    known = set().union(*({b.name, *_points(b)} for b in scope.problem.bodies))
    for member in members_of(scope.problem):
        for point, name in member.attachments():
            if name not in particles or point in known or not point:
                continue
            apart = coordinates_behind({point}, scope.problem) - coordinates_behind({name}, scope.problem)
            if apart:
                with_it = ", ".join(sorted(apart))
                place = particles[name].place
                where = place if isinstance(place, str) else "its own place"
                text = f"{point} moves with {with_it}; {member.called} acts on {name}, which is a particle at {where}"
                hint = f"put the particle there: `{name}: {{particle: {point}, …}}`, or leave {point} out here"
                yield Diagnostic(member.mark, "PL465", text, hint)


def pins_hold_particles_where_they_are(scope: Scope) -> Iterator[Diagnostic]:
    """A pin or weld that always acts holds a particle at the place where this is."""
    problem = scope.problem
    particles = {b.name: b.shape for b in problem.bodies if isinstance(b.shape, Particle) and b.shape.place}
    for joint in problem.joints:
        for point, name in joint.attachments() if joint.kind in HOLDING and joint.during is None else ():
            place = particles[name].place if name in particles else None
            if place is None or point not in scope.points or place == point:
                continue
            own = {place} if isinstance(place, str) else names_of(place)
            fixed = GROUND in getattr(joint, "between", ()) and not coordinates_behind({point}, problem)
            moves = coordinates_behind(own, problem) if fixed else set()
            if moves or _told_apart(scope, place, point):
                where = f"at {place}" if isinstance(place, str) else "at its own place"
                text = f"the {joint.kind} holds {name} at {point}, and {name} is a particle {where}"
                with_it = f", which moves with {', '.join(sorted(moves))}" if moves else ""
                hint = f"name the body that the {joint.kind} holds at {point}, or put the particle there"
                yield Diagnostic(joint.mark, "PL465", text + with_it, hint)


def _told_apart(scope: Scope, place: object, point: str) -> bool:
    """Are a place and a point given by numbers that differ?"""
    places = {p.name: p.place for p in scope.problem.points}
    here, there = places.get(place) if isinstance(place, str) else place, places.get(point)
    if not isinstance(here, At) or not isinstance(there, At):
        return False
    known = KnownValues(scope.numbers)
    try:
        pairs = [[known.value(a), known.value(b)] for a, b in ((here.x, there.x), (here.y, there.y))]
    except NoNumber:
        return False
    return any(a is not None and b is not None and a != b for a, b in pairs)


def moments_act_on_bodies_with_size(scope: Scope) -> Iterator[Diagnostic]:
    """A particle has no size and no angle: no torque turns it, and no blow with a moment."""
    particles = {b.name for b in scope.problem.bodies if b.is_particle}
    for load in scope.problem.loads:
        if getattr(load, "moment", None) is None:
            continue
        turned = [n for n in (getattr(load, "body", None), *(getattr(load, "between", None) or ())) if n in particles]
        for name in turned:
            text = f"{load.called} acts on {name}, which is a particle and does not turn"
            hint = "let it act on the body that turns, or give this one a shape: `disk`, `rod`, `plate`, `points`"
            yield Diagnostic(load.mark, "PL466", text, hint)


def coordinates_move_something(scope: Scope) -> Iterator[Diagnostic]:
    """A coordinate that states follow from one to the next moves something, or a law tells how it varies."""
    relations = [s for state in scope.problem.states for s in state.relations]
    idle = idle_coordinates(scope.problem) if len(scope.problem.states) > 1 else []
    for coordinate in (c for c in scope.problem.coordinates if c.name in idle):
        told = [s for s in relations if isinstance(s, Relation) and coordinate.name in names_of(s)]
        if told and all(_tells_only_numbers(s) for s in told):
            text = f"nothing moves with {coordinate.name}: no body, joint or load stands at a point written with it"
            hint = f"write the place of a body with it, or tell how it varies: `motion: [{coordinate.name} = …]`"
            yield Diagnostic(coordinate.mark, "PL463", text, hint)


def _tells_only_numbers(statement: Statement) -> bool:
    """Does a statement say nothing of the scene but what numbers and their rates are?"""
    return all(not isinstance(n, Quantity) or n.word in ("dot", "ddot") for n in walk(statement))


def _points(body: Body) -> set[str]:
    """The body and its points, by name."""
    return {body.name, *own_points(body.shape), *body.points}
