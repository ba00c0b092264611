"""Checks of what is physically possible: plane, masses, friction, restitution, partners."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise

from planar_cli.errors import Diagnostic
from planar_cli.problem.checks.check_names import points_of_place
from planar_cli.problem.checks.scope import Scope, members_of
from planar_cli.problem.language.evaluation import ARITHMETIC
from planar_cli.problem.language.expression import (
    AtRest,
    Binary,
    Equilibrium,
    Name,
    Negate,
    Number,
    Quantity,
    Relation,
    Side,
)
from planar_cli.problem.language.walk import Tree, walk
from planar_cli.problem.scene.masses import placed
from planar_cli.problem.scene.scene import (
    GROUND,
    At,
    Body,
    Composite,
    Particle,
    Place,
    Polar,
    Problem,
    Towards,
    TwoFacts,
)
from planar_cli.problem.scene.shapes import own_points

NO_PLANE = frozenset("x y r v theta omega mass I IC KE momentum H path_length".split())
"""Quantities of one instant that no weight has a part in."""
OF_MOTION = NO_PLANE | frozenset("a alpha coriolis rho dot ddot path hodograph mean count".split())
"""Those in which it has none where the motion is told as such."""
ACCELERATIONS = frozenset(("a", "alpha", "ddot"))


def plane_is_given(scope: Scope) -> Iterator[Diagnostic]:
    """`plane` is required once a body has mass, and more is asked than places and velocities of one instant."""
    if scope.problem.plane is not None or _needs_no_plane(scope):
        return
    if not is_told_as_motion(scope.problem):
        yield from no_plane(scope.problem)


def no_plane(problem: Problem) -> Iterator[Diagnostic]:
    """Of a file with masses: that weight may act or not."""
    heavy = next((body for body in problem.bodies if has_mass(body)), None)
    if heavy is not None:
        message = f"the body {heavy.name} has mass, and the file does not say in which plane all this happens"
        yield Diagnostic(
            heavy.mark, "PL450", message, "write `plane: vertical` (weight acts, -y) or `plane: horizontal`"
        )


def is_told_as_motion(problem: Problem) -> bool:
    """Are places and motion asked alone, of what moves as `motion` or stated accelerations say? Whether these tell all
    of it, so that weight has no part, is found as it is solved.
    """
    stated = [*(problem.instant or ()), *(r for state in problem.states for r in state.relations)]
    given = (q.word for r in stated if isinstance(r, Relation) for q in walk(r) if isinstance(q, Quantity))
    if problem.loads or not problem.find or not (problem.motion or ACCELERATIONS & set(given)):
        return False
    return {n.word for find in problem.find for n in walk(find.found.what) if isinstance(n, Quantity)} <= OF_MOTION


def _needs_no_plane(scope: Scope) -> bool:
    """Is nothing asked but what shapes and velocities tell at one instant?"""
    problem = scope.problem
    if problem.states or problem.coordinates or not problem.find:
        return False
    asked = [node for find in problem.find for node in walk(find.found.what)]
    words = {node.word for node in asked if isinstance(node, Quantity)}
    return words <= NO_PLANE and not any(isinstance(node, Name) and node.name in _sought(scope) for node in asked)


def _sought(scope: Scope) -> set[str]:
    return {s.name for s in (*scope.problem.unknowns, *scope.problem.coordinates)} | {"t"}


def has_mass(body: Body) -> bool:
    """Is anything said of the mass?"""
    if isinstance(body.shape, Composite):
        return any(piece.mass is not None or piece.weight is not None for piece in body.shape.pieces)
    return body.mass is not None or body.weight is not None or body.any_mass


def masses_come_from_somewhere(scope: Scope) -> Iterator[Diagnostic]:
    """A mass that goes with places comes and goes with a stream, unless nothing moves."""
    problem = scope.problem
    if not problem.states and (problem.instant is None or any(isinstance(s, AtRest) for s in problem.instant)):
        return
    fed = {getattr(load, "body", None) for load in problem.loads if load.brings_mass}
    for body in problem.bodies:
        if body.name in placed(problem) - fed and has_mass(body):
            text = f"the mass of {body.name} changes as it moves, and nothing says how mass comes or goes"
            yield Diagnostic(body.mark, "PL464", text, "add a `stream`, as `planar explain stream` shows for a chain")


def particles_move(scope: Scope) -> Iterator[Diagnostic]:
    """A particle without mass must be driven by something."""
    for body in scope.problem.bodies:
        if isinstance(body.shape, Particle) and not has_mass(body) and not _is_driven(body, scope):
            hint = (
                f"write `mass: 2 kg` (`mass: any` where it cancels), or drive it: `motion: [v({body.name}).x = 2 m/s]`"
            )
            yield Diagnostic(body.mark, "PL451", f"the particle {body.name} has no mass and nothing drives it", hint)


def _is_driven(body: Body, scope: Scope) -> bool:
    p = scope.problem
    names = {body.name}
    if isinstance(body.shape, Particle) and isinstance(body.shape.place, str):
        names.add(body.shape.place)
    if any(names & scope.mentioned(joint) for joint in p.joints):
        return True
    laws = [law.statement for law in p.motion]
    moments = [s.relations for s in p.states] or [p.instant or ()]
    if all(any(isinstance(r, Equilibrium) for r in relations) for relations in moments):
        # Forces without mass balance, which tells the place.
        return True
    trees: list[Tree] = [*laws, *(p.instant or ())]
    if any(_mentions(tree, names) for tree in trees):
        return True
    if p.states and all(any(_tells_velocity(r, names) for r in state.relations) for state in p.states):
        return True
    accelerations = (node for state in p.states for s in state.relations for node in walk(s))
    if any(isinstance(q, Quantity) and q.word in ("a", "ddot") and names & set(q.things) for q in accelerations):
        return True
    return _moves_with_coordinate(names, scope)


def _tells_velocity(tree: Tree, names: set[str]) -> bool:
    return any(isinstance(q, Quantity) and q.word in ("v", "dot") and names & set(q.things) for q in walk(tree))


def _mentions(tree: Tree, names: set[str]) -> bool:
    return any(isinstance(node, Quantity) and names & set(node.things) for node in walk(tree))


def _moves_with_coordinate(names: set[str], scope: Scope) -> bool:
    """Is the place of one of these points written with a coordinate, or with a point that is?"""
    coordinates = {c.name for c in scope.problem.coordinates}
    places = {point.name: point.place for point in scope.problem.points}
    waiting, seen = list(names), set(names)
    for body in scope.problem.bodies:
        if body.name in names and isinstance(body.shape, Particle) and isinstance(body.shape.place, At):
            places[body.name] = body.shape.place
    while waiting:
        place = places.get(waiting.pop())
        if place is None:
            continue
        sides, points = _parts(place)
        if any(isinstance(n, Name) and n.name in coordinates for side in sides for n in walk(side)):
            return True
        waiting += [p for p in points if p not in seen]
        seen.update(points)
    return False


def _parts(place: Place) -> tuple[list[Side], list[str]]:
    match place:
        case At():
            return [place.x, place.y], []
        case Polar():
            return [place.distance, place.angle], [place.origin]
        case Towards():
            sides = [place.distance] if place.offset is None else [place.distance, place.offset]
            return sides, [place.origin, place.towards]
        case TwoFacts():
            sides = [s for s in (place.x, place.y) if s is not None]
            facts = (*place.lines, *place.distances)
            return [*sides, *(side for _, side in facts)], [name for name, _ in facts]
        case _:
            return [], list(points_of_place(place))


def coefficients(scope: Scope) -> Iterator[Diagnostic]:
    """Coefficients of friction are not negative, mu_k <= mu_s, and 0 <= restitution <= 1."""
    for joint in scope.problem.joints:
        for key in ("mu", "mu_s", "mu_k"):
            side = getattr(joint, key, None)
            value = constant(side, scope)
            if side is not None and value is not None and value < 0:
                yield Diagnostic(
                    side.mark, "PL452", f"{key} is negative", "a coefficient of friction is 0 (smooth) or more"
                )
        static, kinetic = getattr(joint, "mu_s", None), getattr(joint, "mu_k", None)
        high, low = constant(kinetic, scope), constant(static, scope)
        if kinetic is not None and high is not None and low is not None and high > low:
            yield Diagnostic(kinetic.mark, "PL452", "mu_k is larger than mu_s", "are the two exchanged?")
        bounce = getattr(joint, "restitution", None)
        value = constant(bounce, scope)
        if bounce is not None and value is not None and not 0 <= value <= 1:
            hint = "0: they stay together; 1: no energy is lost"
            yield Diagnostic(bounce.mark, "PL453", "the coefficient of restitution is between 0 and 1", hint)


def constant(side: Side | None, scope: Scope, depth: int = 0) -> Fraction | None:
    """The value of a formula of pure numbers and given names, where that is plain; else None."""
    match side:
        case Number(unit=None | "1"):
            return side.value * side.sense
        case Name() if side.at is None and side.name in scope.numbers and depth < 20:
            return constant(scope.numbers[side.name].value, scope, depth + 1)
        case Negate():
            inner = constant(side.operand, scope, depth)
            return None if inner is None else -inner
        case Binary():
            return _combined(side.operator, constant(side.left, scope, depth), constant(side.right, scope, depth))
        case _:
            return None


def _combined(operator: str, left: Fraction | None, right: Fraction | None) -> Fraction | None:
    if left is None or right is None or operator == "^" or (operator == "/" and not right):
        return None
    found: Fraction = ARITHMETIC[operator](left, right)
    return found


def members_act(scope: Scope) -> Iterator[Diagnostic]:
    """A joint or load between points acts on a body of which at least one of them is a point."""
    problem = scope.problem
    members = members_of(problem)
    owned = _owned(problem)
    laws: list[Tree] = [*(law.statement for law in problem.motion), *(problem.instant or ())]
    for member in members if problem.bodies else ():
        named = scope.mentioned(member) & scope.points.keys()
        others = scope.mentioned(member) - named
        if not named or others or named & owned or _moves_with_coordinate(named, scope):
            continue
        if not any(_mentions(law, named) for law in laws):
            listed = ", ".join(sorted(named))
            text = f"the {member.kind} acts on nothing: no body has the point {listed.replace(', ', ' or ')}"
            hint = "name the one that moves with a body under `points` of that body; a corner has no name by itself"
            yield Diagnostic(member.mark, "PL458", text, hint)


def _owned(problem: Problem) -> set[str]:
    """The points of bodies, the bodies themselves, and the surfaces fixed to them."""
    owned = {p for b in problem.bodies for p in (b.name, *own_points(b.shape), *b.points)}
    owned |= {point for member in members_of(problem) for point, _ in member.attachments()}
    return owned | {s.name for s in problem.surfaces if s.body is not None}


def points_held_are_carried(scope: Scope) -> Iterator[Diagnostic]:
    """What joins two things ends on a body or on a fixed point: one that only a coordinate moves holds nothing.

    So does the end of a spring or a damper: whatever moves it takes part in the work, and has a velocity.
    """
    owned = _owned(scope.problem)
    ends = [(load, set(getattr(load, "between", None) or ())) for load in scope.problem.loads]
    for member, named in [*((joint, scope.mentioned(joint)) for joint in scope.problem.joints), *ends]:
        for point in sorted((named & scope.points.keys()) - owned):
            if _moves_with_coordinate({point}, scope):
                text = f"{point} is written with a coordinate, but belongs to no body that could hold the {member.kind}"
                hint = f"give it to the body on which it lies, `points: [{point}]`, or put one there: "
                hint += f"`bodies: {{slider: {{particle: {point}}}}}`"
                yield Diagnostic(member.mark, "PL463", text, hint)


def places_on_surfaces(scope: Scope) -> Iterator[Diagnostic]:
    """What lies on a surface is drawn there, or put there by the relations of the start."""
    problem = scope.problem
    if problem.instant is None and not problem.states and not problem.find:
        # Its cases tell the start.
        return
    free = {b.name for b in scope.problem.bodies if isinstance(b.shape, Particle) and b.shape.place is None}
    surfaces = {s.name for s in scope.problem.surfaces}
    for joint in scope.problem.joints if free and surfaces else ():
        along = getattr(joint, "along", None)
        between = [*getattr(joint, "between", ()), getattr(joint, "point", ""), getattr(along, "name", along)]
        names = {n for n in between if isinstance(n, str)}
        if joint.strikes or not names & surfaces or not names & free:
            continue
        body, surface = min(names & free), min(names & surfaces)
        message = f"{body} is free, and lies on {surface}: where it lies at first is open"
        hint = f"draw it there, as it is at the first state or instant: `{body}: {{particle: [x, y]}}`"
        yield Diagnostic(joint.mark, "PL521", message, hint)


def partners_fit(scope: Scope) -> Iterator[Diagnostic]:
    """A joint is between two different things that can move against each other, of the shapes it needs."""
    for joint in scope.problem.joints:
        between: tuple[str, ...] = getattr(joint, "between", ())
        what = f"the {joint.kind}"
        twice = next((name for index, name in enumerate(between) if name and name in between[:index]), None)
        if twice is not None:
            yield Diagnostic(
                joint.mark, "PL455", f"{what} is between '{twice}' and itself", "name two different partners"
            )
        elif len(between) > 1 and {scope.carrier(name) for name in between} == {GROUND}:
            yield Diagnostic(joint.mark, "PL455", f"{what} joins only fixed things", "name the body that moves")
        elif len(between) == 2 and all(between) and scope.carrier(between[0]) == scope.carrier(between[1]):
            text = f"{between[0]} and {between[1]} are one body, and {what} is between two"
            yield Diagnostic(joint.mark, "PL455", text, "name two different partners")
        stops = ["" if stop.way in ("over", "under") else stop.name for stop in scope.stops(joint)]
        again = next((a for a, b in pairwise(stops) if a and a == b), None)
        if again is not None:
            yield Diagnostic(joint.mark, "PL455", f"{what} goes from {again} to itself", "name two different points")
        yield from joint.objections(scope.problem)
