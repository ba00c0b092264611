"""The force or torque that keeps a prescribed motion going."""

from __future__ import annotations

import itertools

import sympy as sp

from planar_cli.equation.algebra.form import Nonlinear, linear_form
from planar_cli.equation.kinematics.motion import Motion
from planar_cli.equation.scene.bodies import BodyModel
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.system.conditions import ACCELERATION, order, stated
from planar_cli.equation.system.system import System
from planar_cli.problem.language.expression import Name, Quantity, Relation, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.facts import Action, Push
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.shapes import own_points


def driving_pushes(system: System, free: Motion) -> tuple[Push, ...]:
    """One unknown push for each law of `motion`: it does work through that motion alone. An acceleration of bodies
    without mass that is stated for the instant is driven too: no force on them could tell it.

    `free`: a motion in which no body hangs on another; the law's coefficients there are the push's components.
    """
    system.settle({}, ())
    quantities = system.quantities_of(free, system.reactions)
    names = {s.name for s in system.scene.ledger.coordinates}
    parts: dict[sp.Symbol, tuple[str, str]] = {}
    speeds = _speeds(system, free)
    for edge in free.tree.edges:
        for symbol, part in ((edge.slide_rate, "x"), (edge.rise_rate, "y"), (edge.spin_rate, "turn")):
            if symbol is not None:
                parts[symbol] = (edge.body, part)
    found: list[Push] = []
    for relation, always in system.statements.relations:
        if order(relation, names) > 2 or not (always or order(relation, names) == ACCELERATION):
            continue
        for condition in stated([(relation, always)], quantities, quantities.evaluator, names, ACCELERATION):
            for expr in condition.rows():
                try:
                    form = linear_form(expr, parts)
                except Nonlinear:
                    # The size or direction of an acceleration: no one push belongs to it.
                    continue
                if not always and any(system.scene.bodies[parts[s][0]].mass != 0 for s in form.terms):
                    continue
                actions = _actions(system, {parts[s]: c.xreplace(speeds) for s, c in form.terms.items()})
                if actions:
                    found.append(Push(f"drive_{len(found) + 1}", "drive", "", relation.text, actions))
        if always and not any(p.place == relation.text for p in found):
            actions = _through_coordinate(system, relation)
            if actions:
                found.append(Push(f"drive_{len(found) + 1}", "drive", "", relation.text, actions))
    return tuple(found)


def _speeds(system: System, free: Motion) -> dict[sp.Symbol, sp.Expr]:
    """The velocities of free bodies in the unknowns of the system: on them depends where a given speed drives."""
    assert system.motion is not None
    found: dict[sp.Symbol, sp.Expr] = {}
    for edge in free.tree.edges:
        velocity = system.motion.velocity(system.scene.bodies[edge.body].center, edge.body)
        turn = system.motion.velocities[edge.body].angular
        pairs = ((edge.slide, velocity.x), (edge.rise, velocity.y), (edge.spin, turn))
        found |= {symbol: value for symbol, value in pairs if symbol is not None}
    return found


def _through_coordinate(system: System, relation: Relation) -> tuple[Action, ...]:
    """What drives a coordinate that is given as a function of time, or by its rate."""
    ledger = system.scene.ledger
    sides = (relation.left, relation.right)
    names = {side.name for side in sides if isinstance(side, Name)}
    varying = {q.name for q in ledger.coordinates}
    # Where one coordinate goes with another, no force from outside keeps that up.
    alone = len(varying & {node.name for side in sides for node in walk(side) if isinstance(node, Name)}) == 1
    rates = {_of_rate(side) for side in sides} if sum(map(_has_rate, sides)) == 1 else set()
    for q in ledger.coordinates:
        if q.name not in rates and (q.name not in names or not (alone or q in ledger.values)):
            continue
        if actions := _working_on(system, q):
            return actions
    return ()


def _working_on(system: System, q: sp.Symbol) -> tuple[Action, ...]:
    """What does work through one coordinate and through no other: a torque on a body, or a force on a point, that goes
    with it alone; a torque that two bodies exert on each other; a force across the way that a point goes with the
    others. The first of them that there is; () for none.
    """
    scene = system.scene
    others = [c for c in scene.ledger.coordinates if c != q]
    turns = {name: body.theta for name, body in scene.bodies.items() if scene.rigid(name)}
    for name, theta in turns.items():
        if (turn := sp.diff(theta, q)) != 0 and not any(sp.diff(theta, c) != 0 for c in others):
            return _actions(system, {(name, "turn"): turn})
    places = [(name, p) for name, body in scene.bodies.items() for p in _own_places(scene, body)]
    ways = [(name, p, _way(p, q), [w for c in others if (w := _way(p, c)) != Vec(0, 0)]) for name, p in places]
    for name, point, way, elsewhere in ways:
        if way != Vec(0, 0) and not elsewhere:
            return (Action(name, point, way, sp.S.Zero),)
    for one, other in itertools.permutations(turns, 2):
        between = turns[one] - turns[other]
        if (turn := sp.diff(between, q)) != 0 and all(scene.is_zero(sp.diff(between, c)) for c in others):
            return _actions(system, {(one, "turn"): turn, (other, "turn"): -turn})
    for name, point, way, elsewhere in ways:
        for push in (way, *(w.turned() for w in elsewhere[:1])):
            sense = scene.sign(push.dot(way))
            if sense and all(scene.is_zero(push.dot(w)) for w in elsewhere):
                return (Action(name, point, push * sense, sp.S.Zero),)
    return ()


def _own_places(scene: Scene, body: BodyModel) -> list[Vec]:
    """The mass centre of a body, and the points that tell its shape."""
    return [body.center, *(scene.points[p] for p in own_points(body.shape) if p in scene.points)]


def _way(point: Vec, q: sp.Symbol) -> Vec:
    """How a point goes with a coordinate."""
    return Vec(sp.diff(point.x, q), sp.diff(point.y, q))


def _of_rate(side: Side) -> str:
    """The name of which a side is the rate, or ""."""
    if isinstance(side, Quantity) and side.word in ("dot", "ddot") and isinstance(side.argument, Name):
        return side.argument.name
    return ""


def _has_rate(side: Side) -> bool:
    """Is a rate or another quantity of the motion in it?"""
    return any(isinstance(node, Quantity) for node in walk(side))


def _actions(system: System, terms: dict[tuple[str, str], sp.Expr]) -> tuple[Action, ...]:
    """What a unit of a push does to each body, by the parts of its velocity with which it goes."""
    zero, found = sp.S.Zero, list[Action]()
    for body in dict.fromkeys(b for b, _ in terms):
        x, y, turn = (terms.get((body, part), zero) for part in ("x", "y", "turn"))
        force = None if x == y == 0 else Vec(x, y)
        found.append(Action(body, system.scene.center(body), force, turn))
    return tuple(found)
