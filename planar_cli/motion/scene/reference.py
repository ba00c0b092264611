"""The reference configuration: time, coordinates and free particles at the first state or instant of the file."""

from __future__ import annotations

from planar_cli.motion.terms.sides import Constants, Sides, has_quantity, names_in
from planar_cli.motion.terms.terms import Graph, Term
from planar_cli.problem.language.expression import Name, Quantity, Relation, Side
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import Particle, Problem
from planar_cli.records import record
from planar_cli.units import parse_unit

GUESSED_ANGLE, GUESSED_LENGTH = 0.5, 0.9731
"""From where an open coordinate is sought, rad and m: any place that is not a special one, as where ends meet."""


@record
class Reference:
    """Where and when a scene is drawn."""

    time: float
    """s."""
    coordinates: dict[str, float]
    """In SI units, by name."""
    free: dict[str, Vec]
    """Places of particles that the file calls `free`, as plain numbers."""
    open: frozenset[str]
    """Coordinates and free particles whose place nothing tells: they are anywhere."""


def reference_of(problem: Problem, graph: Graph, constants: Constants) -> Reference:
    """What the first state (or the instant) and `motion` say of places. Unknowns that they settle become constants."""
    equations = [(r.left, r.right) for r in _relations(problem)]
    equations += [(right, left) for left, right in equations]
    known: dict[str, Term] = {}
    sides = Sides(graph, constants, known)
    known["t"] = graph.number(0.0)
    for left, right in equations:
        if isinstance(left, Name) and left.name == "t" and not has_quantity(right) and _valued(right, known, constants):
            known["t"] = sides.value(right)
    sought = {s.name for s in (*problem.coordinates, *problem.unknowns)} - constants.values.keys()
    going = True
    while going:
        going = False
        for left, right in equations:
            if not isinstance(left, Name) or left.name not in sought or has_quantity(right):
                continue
            if not _valued(right, known, constants):
                continue
            sought.discard(left.name)
            going = True
            if any(s.name == left.name for s in problem.coordinates):
                known[left.name] = sides.value(right)
            else:
                constants.settled[left.name] = right
    coordinates, unsure = {}, set()
    for symbol in problem.coordinates:
        if symbol.name in constants.values:
            coordinates[symbol.name] = constants.values[symbol.name]
        elif symbol.name in known:
            coordinates[symbol.name] = known[symbol.name].value
        else:
            unsure.add(symbol.name)
            angle = symbol.unit is not None and parse_unit(symbol.unit).angle
            coordinates[symbol.name] = GUESSED_ANGLE if angle else GUESSED_LENGTH
    free, lost = _free(problem, equations, sides, known)
    return Reference(known["t"].value, coordinates, free, frozenset(unsure | lost))


def _relations(problem: Problem) -> list[Relation]:
    """The equations of the start."""
    now = problem.instant if problem.instant is not None else problem.states[0].relations if problem.states else ()
    always = tuple(law.statement for law in problem.motion if law.during is None)
    return [s for s in (*now, *always) if isinstance(s, Relation) and s.operator == "="]


def _valued(side: Side, known: dict[str, Term], constants: Constants) -> bool:
    """Have all its names numbers?"""
    return all(n in known or n == "pi" or constants.valued(n) for n in names_in(side))


def _free(
    problem: Problem, equations: list[tuple[Side, Side]], sides: Sides, known: dict[str, Term]
) -> tuple[dict[str, Vec], set[str]]:
    """Free particles: where `x(P) = …` and `y(P) = …` put them, else at the origin."""
    found, lost = {}, set()
    for body in problem.bodies:
        if not isinstance(body.shape, Particle) or body.shape.place is not None:
            continue
        parts = {}
        for left, right in equations:
            told = isinstance(left, Quantity) and left.things == (body.name,) and left.at is None
            if (
                told
                and isinstance(left, Quantity)
                and not has_quantity(right)
                and _valued(right, known, sides.constants)
            ):
                axis = left.word if left.word in ("x", "y") and not left.parts else ""
                if left.word == "r" and [p.kind for p in left.parts] in (["x"], ["y"]):
                    axis = left.parts[0].kind
                if axis:
                    parts[axis] = sides.value(right).value
        if len(parts) < 2:
            lost.add(body.name)
        found[body.name] = Vec(parts.get("x", 0.0), parts.get("y", 0.0))
    return found, lost
