"""The relations of an instant as equations: joints that close loops, rows, what the file states, differentiated where
it holds all the time.

A condition is a residual that vanishes: a vector one may be projected on any direction, a scalar one is as it is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from itertools import combinations
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.kinematics.motion import Motion, Tree
from planar_cli.equation.kinematics.polar import dotted, tells_turns, vector_equations
from planar_cli.equation.kinematics.quantities import LATER, Quantities
from planar_cli.equation.kinematics.ways_told import way_told
from planar_cli.equation.kinematics.written_points import is_written
from planar_cli.equation.scene.places import polar_jets
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.values.determined import led_by
from planar_cli.equation.values.evaluate import Evaluator
from planar_cli.equation.values.jets import Jet, constant, vector_jet
from planar_cli.errors import NOWHERE, Mark
from planar_cli.problem.language.expression import (
    Binary,
    Function,
    Grouped,
    Name,
    Negate,
    Quantity,
    Relation,
    Scaled,
    Side,
)
from planar_cli.problem.scene.facts import Row
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.polar import TOGETHER, VectorStatement, grouped
from planar_cli.problem.scene.scene import At, Body, Particle, Polar
from planar_cli.problem.scene.shapes import own_points
from planar_cli.records import record

POSITION, VELOCITY, ACCELERATION = 0, 1, 2
ORDERS = {
    "r": 0, "x": 0, "y": 0, "theta": 0, "mass": 0, "I": 0, "PE": 0,
    "v": 1, "omega": 1, "coriolis": 1, "IC": 1, "KE": 1, "momentum": 1, "H": 1, "hodograph": 1,
    "a": 2, "alpha": 2, "rho": 2, "N": 2, "friction": 2, "reaction": 2, "moment": 2, "tension": 2, "force": 2,
    "power": 2,
}  # fmt: skip


@record
class Condition:
    """One relation between unknowns of one level.

    `kind`: closure, row, given, coordinate. `residual`: an expression, or a Vec that vanishes. `normal`: the only
    direction in which a vector residual counts (across a path), None: both. `along`: the contact of what rolls. `text`:
    what it says, in words or as in the file. `sense`: what must not be negative, where the residual also lets the
    opposite direction pass. `now`: it is stated of this one instant.
    """

    kind: str
    text: str
    residual: sp.Expr | Vec
    normal: Vec | None = None
    along: Vec | None = None
    place: str = ""
    body: str = ""
    base: str = ""
    mark: Mark = NOWHERE
    sense: sp.Expr | None = None
    now: bool = False
    times: int = 0
    """How often the relation was differentiated that the file states."""

    def rows(self) -> tuple[sp.Expr, ...]:
        """The scalar residuals: one, or two along x and y."""
        if not isinstance(self.residual, Vec):
            return (self.residual,)
        if self.normal is not None:
            return (self.residual.dot(self.normal),)
        return (self.residual.x, self.residual.y)


def order(side: Side | Relation, coordinates: set[str]) -> int:
    """The level of a side: 0 places, 1 velocities, 2 accelerations and forces; -1 for constants."""
    match side:
        case Name():
            return 0 if side.name in coordinates or side.name == "t" else -1
        case Negate() | Scaled() | Grouped():
            return order(side.operand, coordinates)
        case Function():
            return order(side.argument, coordinates)
        case Binary() | Relation():
            return max(order(side.left, coordinates), order(side.right, coordinates))
        case Quantity():
            return _quantity_order(side, coordinates)
    return -1


def _quantity_order(q: Quantity, coordinates: set[str]) -> int:
    if q.word in ("dot", "ddot") and q.argument is not None:
        return max(order(q.argument, coordinates), 0) + (1 if q.word == "dot" else 2)
    level = ORDERS.get(q.word, 0)
    natural = max((1 if p.kind in ("t", "n") else 0 for p in q.parts), default=0)
    return max(level, natural)


def joint_conditions(
    tree: Tree, rows: list[Row], motion: Motion, level: int, rigid: Callable[[str], bool]
) -> list[Condition]:
    """What the joints demand that the tree has not already built in."""
    found: list[Condition] = []
    for joining in tree.closures:
        residual = motion.closure_velocity(joining) if level == VELOCITY else motion.closure_acceleration(joining)
        normal = joining.path.tangent.turned() if joining.path is not None else None
        along = joining.rolling.tangent if joining.rolling is not None else None
        members = joining.place, joining.mover, joining.base
        found.append(Condition("closure", joining.joint, residual, normal, along, *members))
        holds = rigid(joining.base) or joining.keeps
        if not joining.turns and rigid(joining.mover) and holds:
            twists = motion.velocities if level == VELOCITY else motion.accelerations
            turning = twists[joining.mover].angular - twists[joining.base].angular
            found.append(Condition("row", f"{joining.mover} can not turn", turning))
    for row in rows:
        residual = motion.row_velocity(row) if level == VELOCITY else motion.row_acceleration(row)
        found.append(Condition("row", row.title, residual))
    return found


def stated(
    relations: list[tuple[Relation, bool]],
    quantities: Quantities,
    evaluator: Evaluator,
    coordinates: set[str],
    level: int,
) -> list[Condition]:
    """The file's equations at one level; those that hold all the time (True) count at every level from their own on."""
    levels = {id(r): max(order(r, coordinates), 0) for r, _ in relations}
    lasting = {id(r) for r, always in relations if always}
    counted = [r for r, always in relations if levels[id(r)] == level or (always and levels[id(r)] < level)]

    def read(side: Side) -> Any:
        return vector_or_jet(side, quantities, evaluator)

    found: list[Condition] = []
    for item in grouped(counted):
        parts = item.relations if isinstance(item, VectorStatement) else (item,)
        own = max(levels[id(r)] for r in parts)
        try:
            residual, sense = _residual(item, read, level - own, quantities)
        except ValueError:
            continue
        now = any(id(r) not in lasting for r in parts)
        text = TOGETHER.join(r.text for r in parts)
        mark, times = parts[0].mark, level - own
        place = _written(item, quantities)
        found.append(Condition("given", text, residual, mark=mark, sense=sense, now=now, times=times, place=place))
    return found


def _written(item: Relation | VectorStatement, quantities: Quantities) -> str:
    """The point written with coordinates of which a relation gives a component; "": it is something else."""
    side = item.left if isinstance(item, Relation) else None
    if not isinstance(side, Quantity) or len(side.things) != 1 or not side.parts:
        return ""
    scene, name = quantities.scene, side.things[0]
    led = name in scene.points and is_written(scene, quantities.motion, name, scene.owner(name))
    return name if led and side.word in ("v", "a") else ""


def _residual(
    item: Relation | VectorStatement, read: Callable[[Side], Any], times: int, quantities: Quantities
) -> tuple[sp.Expr | Vec, sp.Expr | None]:
    """What vanishes, differentiated so many times; what must not be negative is asked of the relation itself."""
    sense: sp.Expr | None = None
    if isinstance(item, VectorStatement) and not tells_turns(item, read):
        vanishing, sense = vector_equations(item, read)
        if not isinstance(vanishing, Vec) and item.angle is None:
            rooted = _rooted(item, read, quantities) if not times else None
            # Half the rate of v² is v · a.
            vanishing = rooted or vanishing * constant(sp.Rational(1, 2) if times else 1)
    else:
        relation = item.relations[0] if isinstance(item, VectorStatement) else item
        vanishing = gap(read(relation.left), read(relation.right))
    sense = None if times else sense
    if isinstance(vanishing, Vec):
        return Vec(dotted(vanishing.x, times), dotted(vanishing.y, times)), sense
    return dotted(vanishing, times), sense


def _rooted(item: VectorStatement, read: Callable[[Side], Any], quantities: Quantities) -> Jet | None:
    """|v| = m in a general position, where all of v goes with one speed: that speed has the sign with which the motion
    arrives, or that the first state tells, else it is positive towards growing coordinate, so that the relation stays
    linear.
    """
    scene = quantities.scene
    if scene.displacement is None or item.size is None:
        return None
    v = read(item.vector)
    factors = {c.speed: c.factor for c in scene.displacement.coordinates}
    factors |= dict.fromkeys(scene.evaluator.speeds, sp.S.One)
    inside = [s for s in v.x.value.free_symbols | v.y.value.free_symbols if s in factors]
    if len(inside) != 1:
        return None
    u = inside[0]
    along = Vec(*(sp.diff(p.value, u) for p in (v.x, v.y)))
    if any(expanded(p.value - e * u) != 0 for p, e in ((v.x, along.x), (v.y, along.y))):
        return None
    length = simplified(sp.sqrt(simplified(along.dot(along))))
    told = way_told(u, read, scene, partial(_led_by, u, quantities)) or scene.sign(factors[u]) or 1
    way = scene.heading_of(u, told)
    found: Jet = Jet(length * u * way, None, None) - read(item.size)
    return found


def _led_by(speed: sp.Symbol, quantities: Quantities) -> dict[sp.Symbol, sp.Rational]:
    """The speeds that joints make multiples of one speed, in a general position."""
    scene, motion = quantities.scene, quantities.motion
    unknowns = [*motion.tree.velocity_unknowns(), *scene.evaluator.speeds]
    conditions = [
        *joint_conditions(motion.tree, [], motion, VELOCITY, scene.rigid),
        *coordinate_conditions(quantities, set(scene.ledger.coordinates), VELOCITY, motion.tree),
    ]
    return led_by(speed, [e for c in conditions for e in c.rows()], unknowns, scene.valuations[0])


def vector_or_jet(side: Side, quantities: Quantities, evaluator: Evaluator) -> Any:
    """A side as a Jet, or as a Vec of jets where it is a vector quantity, their sum, difference or multiple."""
    if isinstance(side, Quantity) and side.at is None and side.word not in LATER:
        return quantities.any(side)
    if isinstance(side, Negate):
        found = vector_or_jet(side.operand, quantities, evaluator)
        return -found
    if isinstance(side, Binary) and side.operator in "+-":
        left, right = (vector_or_jet(s, quantities, evaluator) for s in (side.left, side.right))
        if isinstance(left, Vec) == isinstance(right, Vec):
            return left + right if side.operator == "+" else left - right
    if isinstance(side, Binary) and side.operator in "*/":
        left, right = (vector_or_jet(s, quantities, evaluator) for s in (side.left, side.right))
        if isinstance(left, Vec) and not isinstance(right, Vec):
            return Vec(left.x * right, left.y * right) if side.operator == "*" else Vec(left.x / right, left.y / right)
        if isinstance(right, Vec) and not isinstance(left, Vec) and side.operator == "*":
            return Vec(left * right.x, left * right.y)
    return evaluator.jet(side)


def gap(left: Jet | Vec, right: Jet | Vec) -> Jet | Vec:
    """Left less right; a plain zero beside a vector is the zero vector."""
    if isinstance(left, Vec):
        return left - right if isinstance(right, Vec) else left
    return -right if isinstance(right, Vec) else left - right


def _moves_with(scene: Scene, origin: str, coordinates: set[sp.Symbol]) -> bool:
    """Is the origin of a place written with a coordinate, without being a point of a body itself?"""
    if origin in scene.own_points or origin not in scene.formulas:
        return False
    formula = scene.formulas[origin]
    return bool(coordinates & (formula.x.value.free_symbols | formula.y.value.free_symbols))


def coordinate_conditions(
    quantities: Quantities, coordinates: set[sp.Symbol], level: int, tree: Tree
) -> list[Condition]:
    """Points of bodies that are written with a coordinate move as their formula says."""
    scene = quantities.scene
    found = list(_turning_conditions(quantities, coordinates, level))
    # The other points of a body whose angle is told go with the first one; of one that only turns about where it is
    # joined, all of them do.
    turned = {c.body for c in found}
    told = {e.body for e in tree.edges if e.slide is None and e.rise is None} & turned
    placed = {e.body for e in quantities.motion.tree.edges if e.components is not None}
    for point in scene.problem.points:
        owner = scene.owner(point.name)
        place = point.place
        if owner in told or owner in placed:
            continue
        if owner == "ground" or not isinstance(place, At | Polar) or point.name not in scene.own_points:
            continue
        parts = (place.x, place.y) if isinstance(place, At) else (place.distance, place.angle)
        written = any(coordinates & scene.value(p).free_symbols for p in parts)
        if not written and not (isinstance(place, Polar) and _moves_with(scene, place.origin, coordinates)):
            continue
        if isinstance(place, At):
            formula = Vec(scene.evaluator.jet(place.x), scene.evaluator.jet(place.y))
        else:
            reach = polar_jets(scene.evaluator.jet(place.distance), scene.evaluator.jet(place.angle))
            own = place.origin in scene.own_points
            formula = quantities.place(place.origin) + reach if own else scene.formulas[point.name]
        at, motion = scene.point(point.name), quantities.motion
        difference = vector_jet(at, motion.velocity(at, owner), motion.acceleration(at, owner)) - formula
        pick = "rate" if level == VELOCITY else "second"
        residual = Vec(getattr(difference.x, pick), getattr(difference.y, pick))
        found.append(
            Condition(
                "coordinate", f"the position of {point.name}, differentiated", residual, place=point.name, body=owner
            )
        )
        told |= {owner} & turned
    return found + _particle_conditions(quantities, coordinates, level)


def _turning_conditions(quantities: Quantities, coordinates: set[sp.Symbol], level: int) -> Iterator[Condition]:
    """Bodies turn as two of their points do that are written with coordinates, always r apart:

    ω = (r × dr/dt)/r²,  α = (r × d²r/dt²)/r²

    Reference: An Introduction to Planar Dynamics, 2.2: the relative velocity of two points of a body is ω × r.
    """
    scene = quantities.scene
    for body in scene.problem.bodies:
        if body.name not in quantities.motion.velocities or not scene.rigid(body.name):
            continue
        names = [p for p in (*own_points(body.shape), *body.points) if p in scene.formulas]
        for one, other in combinations(names, 2):
            reach = scene.formulas[other] - scene.formulas[one]
            if not coordinates & (reach.x.value.free_symbols | reach.y.value.free_symbols):
                continue
            square = simplified(reach.x.value**2 + reach.y.value**2)
            if square == 0 or square.free_symbols & coordinates:
                continue
            pick = "rate" if level == VELOCITY else "second"
            turn = reach.x.value * getattr(reach.y, pick) - reach.y.value * getattr(reach.x, pick)
            twist = quantities.motion.velocities if level == VELOCITY else quantities.motion.accelerations
            residual = twist[body.name].angular - simplified(turn / square)
            yield Condition("coordinate", f"angle of {body.name}", residual, body=body.name)
            break
        else:
            yield from _direction_conditions(quantities, coordinates, level, body)


def _direction_conditions(
    quantities: Quantities, coordinates: set[sp.Symbol], level: int, body: Body
) -> Iterator[Condition]:
    """A body whose direction is written with coordinates, `rod: [O, theta]`, turns as that does."""
    scene, angle = quantities.scene, getattr(body.shape, "angle", None)
    if angle is None or not coordinates & scene.value(angle).free_symbols:
        return
    told = scene.evaluator.jet(angle)
    twist = quantities.motion.velocities if level == VELOCITY else quantities.motion.accelerations
    residual = twist[body.name].angular - (told.rate if level == VELOCITY else told.second)
    yield Condition("coordinate", f"angle of {body.name}", residual, body=body.name)


def _particle_conditions(quantities: Quantities, coordinates: set[sp.Symbol], level: int) -> list[Condition]:
    """The same of particles that are written in place, `particle: [x, y]`."""
    scene = quantities.scene
    found = []
    for body in scene.problem.bodies:
        place = body.shape.place if isinstance(body.shape, Particle) else None
        if not isinstance(place, At) or not any(coordinates & scene.value(p).free_symbols for p in (place.x, place.y)):
            continue
        difference = quantities.place(body.name) - Vec(scene.evaluator.jet(place.x), scene.evaluator.jet(place.y))
        pick = "rate" if level == VELOCITY else "second"
        residual = Vec(getattr(difference.x, pick), getattr(difference.y, pick))
        words = f"the position of {body.name}, differentiated"
        found.append(Condition("coordinate", words, residual, place=body.name, body=body.name))
    return found
