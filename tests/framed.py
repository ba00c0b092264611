"""A whole problem seen in another frame: mirrored, or turned about the origin.

The frame sends a place r to T r; directions go from angle a to s a + φ, with s = -1 in a mirror: x -> -x is s = -1 and
φ = 180 deg, a turn is s = 1. All names of the file keep their values, and every relation is written so that it says of
the new scene what it said of the old one: `v(P).x` becomes `-v(P).x`, or `v(P).along(φ)`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, is_dataclass, replace
from decimal import Decimal
from fractions import Fraction
from functools import cache
from typing import Any

from planar_cli.errors import NOWHERE, PlanarError
from planar_cli.joints.belt import Belt
from planar_cli.joints.guide import Guide
from planar_cli.joints.rope import Rope
from planar_cli.loads.impulse import Impulse
from planar_cli.loads.torque import Torque
from planar_cli.problem.expression import (
    Binary,
    Extreme,
    Found,
    Function,
    Grouped,
    Name,
    Negate,
    Number,
    Part,
    PointPair,
    Quantity,
    Relation,
    Scaled,
    Side,
    Statement,
)
from planar_cli.problem.keys import Table
from planar_cli.problem.scene import (
    At,
    Body,
    Case,
    Circle,
    Composite,
    Curve,
    Find,
    Line,
    Particle,
    Place,
    Plate,
    Point,
    Polar,
    Problem,
    Rod,
    Sector,
    Shape,
    Surface,
    TwoFacts,
)
from planar_cli.problem.walk import walk
from planar_cli.solve.run import solve_problem

VECTORS = frozenset(("r", "v", "a", "coriolis", "IC", "friction", "reaction", "force", "momentum", "impulse"))
TURNING = frozenset(("omega", "alpha", "H", "moment"))
"""Numbers that change their sign in a mirror, as every rotation does."""
CURVES = frozenset(("path", "hodograph"))
FLIPPED = {"<": ">", ">": "<", "<=": ">=", ">=": "<="}
NEXT_SIDE = {"right": "above", "above": "left", "left": "below", "below": "right"}
SIDE_WORDS = ("right", "above", "left", "below")
ZERO = Number(Fraction(0), None, 1, NOWHERE)


class NotWritten(Exception):
    """The problem cannot be written in this frame; the text is the reason."""


@dataclass(frozen=True, slots=True)
class Frame:
    """Angles go from a to sense a + turn."""

    name: str
    sense: int
    turn: Side
    radians: float
    """The turn in numbers."""
    quarters: int | None
    """The turn in quarters, where it is so many."""

    def __str__(self) -> str:
        return self.name

    @property
    def mirrors_across_y(self) -> bool:
        """x -> -x and nothing else: what weighs still falls downwards."""
        return self.sense < 0 and self.quarters == 2

    def vector(self, x: Any, y: Any) -> tuple[Any, Any]:
        """T (x, y) in numbers."""
        cosine, sine = self._unit()
        kind = type(x)
        c, s = kind(cosine), kind(sine)
        return c * x - s * y * self.sense, s * x + c * y * self.sense

    def _unit(self) -> tuple[Decimal, Decimal]:
        if self.quarters is not None:
            found = ((1, 0), (0, 1), (-1, 0), (0, -1))[self.quarters % 4]
            return Decimal(found[0]), Decimal(found[1])
        return Decimal("0.6"), Decimal("0.8")


def degrees(number: int) -> Side:
    return Number(Fraction(number), "deg", 1, NOWHERE)


MIRROR = Frame("mirrored", -1, degrees(180), math.pi, 2)
QUARTER = Frame("turned by a quarter", 1, degrees(90), math.pi / 2, 1)
ASKEW = Frame(
    "turned askew",
    1,
    Function(
        "atan",
        Binary("/", Number(Fraction(4), None, 1, NOWHERE), Number(Fraction(3), None, 1, NOWHERE), NOWHERE),
        None,
        NOWHERE,
    ),
    math.atan2(4, 3),
    None,
)
"""By the angle with the cosine 3/5 and the sine 4/5."""


def framed(problem: Problem, frame: Frame) -> Problem:
    """The problem in the other frame. NotWritten: where the language has no words for it."""
    heavy = any(b.mass is not None or b.weight is not None or b.any_mass for b in problem.bodies)
    if problem.plane == "vertical" and heavy and not frame.mirrors_across_y:
        raise NotWritten("weight acts along -y")
    return _Framing(problem, frame).whole()


@dataclass(frozen=True, slots=True)
class Seen:
    """A find as it is asked in the other frame."""

    find: Find
    sign: int = 1
    """The sign of its answer there."""
    turn: float | None = None
    """Of an angle that is told only to whole turns: how far it is turned, rad."""
    flipped: str = ""
    """Which axis of a curve a mirror turns round: that of the scene, or the second one of a body with a direction."""


def as_seen(found: Find, problem: Problem, frame: Frame) -> Seen:
    """A find in the other frame.

    What is asked for by itself stays (`v(B).x`, `theta(b)`); a formula is written so that its value is the same.
    """
    return _Framing(problem, frame).find(found)


@dataclass(frozen=True, slots=True)
class _Affine:
    """A quantity q of the other frame; in the first one it was sense (q - turn)."""

    quantity: Side
    sense: int
    turn: Side | None = None
    counts: bool = False
    """Does it count turns, or lie in (-180, 180] deg?"""


class _Framing:
    """One problem and one frame."""

    def __init__(self, problem: Problem, frame: Frame) -> None:
        self.problem, self.frame = problem, frame
        self.drawn = {b.name: self._has_direction(b.shape) for b in problem.bodies}
        self.joints = {j.name: j for j in problem.joints}
        self.loads = {load.name: load for load in problem.loads}
        self.names = {p.name for p in problem.points}

    # --- the scene ---------------------------------------------------------------------------------------------------

    def whole(self) -> Problem:
        p = self.problem
        return replace(
            p,
            points=tuple(Point(q.name, self.place(q.place), q.mark) for q in p.points),
            surfaces=tuple(self.surface(s) for s in p.surfaces),
            bodies=tuple(replace(b, shape=self.shape(b.shape), **self.scalars_of(b)) for b in p.bodies),
            joints=tuple(self.member(j) for j in p.joints),
            loads=tuple(self.member(load) for load in p.loads),
            motion=tuple(replace(law, statement=self.statement(law.statement)) for law in p.motion),
            instant=None if p.instant is None else tuple(self.statement(s) for s in p.instant),
            states=tuple(replace(s, relations=tuple(self.statement(r) for r in s.relations)) for s in p.states),
            find=tuple(self.find(f).find for f in p.find),
            cases=tuple(Case(c.name, framed(c.problem, self.frame), c.mark) for c in p.cases),
            answers=(),
        )

    def scalars_of(self, body: Body) -> dict[str, Side]:
        """Masses and inertias may be formulas of time and quantities."""
        named = {key: getattr(body, key) for key in ("mass", "weight", "inertia", "gyration")}
        return {key: self.scalar(side) for key, side in named.items() if side is not None}

    def place(self, place: Place) -> Place:
        match place:
            case At():
                return At(*self.vector(place.x, place.y))
            case Polar():
                return replace(place, angle=self.angle(place.angle))
            case TwoFacts():
                return self._two_facts(place)
        return place

    def _two_facts(self, place: TwoFacts) -> TwoFacts:
        line = None if place.line is None else (place.line[0], self.angle(place.line[1]))
        x, y = place.x, place.y
        quarters = self.frame.quarters
        if quarters is None:
            if x is not None or y is not None:
                raise NotWritten("a point of a given x or y")
            if place.side is not None:
                raise NotWritten("a place that lies left or above")
            return replace(place, line=line)
        nothing = Number(Fraction(0), "m", 1, NOWHERE)
        turned = self.vector(x if x is not None else nothing, y if y is not None else nothing)
        if quarters % 2:
            x, y = (turned[0] if y is not None else None), (turned[1] if x is not None else None)
        else:
            x, y = (turned[0] if x is not None else None), (turned[1] if y is not None else None)
        return TwoFacts(x, y, line, place.distances, self._side_word(place.side))

    def _side_word(self, word: str | None) -> str | None:
        if word is None:
            return None
        at = SIDE_WORDS.index(word) * self.frame.sense + (self.frame.quarters or 0)
        return SIDE_WORDS[at % 4]

    def surface(self, surface: Surface) -> Surface:
        match surface.shape:
            case Line():
                shape: Line | Circle | Curve = replace(surface.shape, angle=self.angle(surface.shape.angle))
            case Curve():
                shape = self._curve(surface.shape)
            case _:
                shape = surface.shape
        speed = None if surface.speed is None else self.scalar(surface.speed)
        return replace(surface, shape=shape, speed=speed)

    def _curve(self, curve: Curve) -> Curve:
        if not self.frame.mirrors_across_y:
            raise NotWritten("a curve y(x) or r(theta)")
        variable = "x" if curve.kind == "y" else "theta"
        name = Name(variable, None, NOWHERE)
        other = Negate(name, NOWHERE) if variable == "x" else Binary("-", Name("pi", None, NOWHERE), name, NOWHERE)
        return replace(curve, formula=substituted(curve.formula, variable, other))

    def shape(self, shape: Shape) -> Shape:
        match shape:
            case Particle(place=At()):
                return Particle(self.place(shape.place))
            case Rod() if shape.angle is not None:
                return replace(shape, angle=self.angle(shape.angle))
            case Plate() if shape.angle is not None or not self.frame.mirrors_across_y:
                return replace(shape, angle=self.angle(shape.angle or degrees(0)))
            case Sector():
                return replace(shape, angle=self.angle(shape.angle or degrees(0)))
            case Composite():
                return Composite(tuple(replace(piece, shape=self.shape(piece.shape)) for piece in shape.pieces))
        return shape

    def _has_direction(self, shape: Shape) -> bool:
        """Is its theta measured from a direction that is drawn, and not from where it begins?"""
        match shape:
            case Rod() | Sector():
                return True
            case Plate():
                return shape.angle is not None or not self.frame.mirrors_across_y
            case Composite():
                return self._has_direction(shape.pieces[0].shape)
        return False

    def member(self, member: Any) -> Any:
        """A joint or a load."""
        over = isinstance(member, Rope) and any(stop.way in ("over", "under") for stop in member.path)
        slot = isinstance(member, Guide) and isinstance(member.along, str) and self.drawn.get(member.along) is False
        if (over or slot) and not self.frame.mirrors_across_y:
            raise NotWritten("a rope over a pulley" if over else "a slot in a body without a direction of its own")
        changed: dict[str, Any] = {}
        for field in fields(member):
            changed[field.name] = self._key(member, field.name, getattr(member, field.name))
        return replace(member, **changed)

    def _key(self, member: Any, key: str, value: Any) -> Any:
        match key:
            case "angle" | "along" | "normal" if is_side(value):
                relative = getattr(member, "relative_to", None)
                return self.relative(value) if relative and self.drawn[relative] else self.angle(value)
            case "moment" if isinstance(member, Torque | Impulse) and value is not None:
                return self._signed(value)
            case "relaxed_at" if value is not None:
                return tuple(self.statement(s) for s in value)
        if is_side(value):
            return self.scalar(value)
        if isinstance(value, Table):
            return replace(value, rows=tuple((self.scalar(a), self.scalar(b)) for a, b in value.rows))
        if is_dataclass(value) and not isinstance(value, type) and hasattr(value, "speed"):
            return replace(value, speed=self.scalar(value.speed), angle=self.angle(value.angle))
        return value

    def _signed(self, value: Side | Table) -> Side | Table:
        if isinstance(value, Table):
            return replace(value, rows=tuple((self.scalar(a), self.sensed(self.scalar(b))) for a, b in value.rows))
        return self.sensed(self.scalar(value))

    # --- directions and vectors --------------------------------------------------------------------------------------

    def angle(self, side: Side) -> Side:
        """s a + φ, as a number of degrees where it is one."""
        return self._sum(self.sensed(self.scalar(side)), self.frame.turn)

    def relative(self, side: Side) -> Side:
        """s a: an angle from another direction of the scene."""
        return self.sensed(self.scalar(side))

    def _sum(self, side: Side, turn: Side, once: bool = True) -> Side:
        a, b = in_degrees(side), in_degrees(turn)
        if a is not None and b is not None:
            return Number(wrapped(a + b) if once else a + b, "deg", 1, NOWHERE)
        return Binary("+", side, turn, NOWHERE)

    def sensed(self, side: Side) -> Side:
        return side if self.frame.sense > 0 else negated(side)

    def vector(self, x: Side, y: Side) -> tuple[Side, Side]:
        """T (x, y)."""
        x, y = self.scalar(x), self.scalar(y)
        flipped = self.sensed(y)
        match self.frame.quarters:
            case 0:
                return x, flipped
            case 1:
                return negated(flipped), x
            case 2:
                return negated(x), negated(flipped)
        cosine, sine = (Number(Fraction(n, 5), None, 1, NOWHERE) for n in (3, 4))
        return (
            Binary("-", times(cosine, x), times(sine, flipped), NOWHERE),
            Binary("+", times(sine, x), times(cosine, flipped), NOWHERE),
        )

    # --- statements --------------------------------------------------------------------------------------------------

    def statement(self, statement: Statement) -> Statement:
        match statement:
            case Relation():
                return self.relation(statement)
            case Extreme():
                alone = self.affine(statement.side)
                if alone is None or alone.turn is not None:
                    return replace(statement, side=self.scalar(statement.side))
                return replace(statement, side=alone.quantity, sense=statement.sense * alone.sense)
        return statement

    def relation(self, relation: Relation) -> Relation:
        """What was said of a quantity alone is said of the one that takes its place."""
        if self.is_vector(relation.left) or self.is_vector(relation.right):
            return relation
        alone = self.affine(relation.left)
        if alone is None:
            return replace(relation, left=self.scalar(relation.left), right=self.scalar(relation.right))
        right = self.scalar(relation.right)
        if alone.sense < 0:
            right = negated(right)
        if alone.turn is not None:
            right = self._sum(right, alone.turn, not alone.counts)
        operator = relation.operator if alone.sense > 0 else FLIPPED.get(relation.operator, relation.operator)
        return replace(relation, left=alone.quantity, operator=operator, right=right)

    def find(self, find: Find) -> Seen:
        what = find.found.what
        if isinstance(what, Relation):
            return Seen(replace(find, found=replace(find.found, what=self.relation(what))))
        if self.is_vector(what):
            return Seen(find)
        if isinstance(what, Quantity) and what.word in CURVES:
            body = what.things[1] if len(what.things) == 2 and what.things[1] in self.drawn else None
            return Seen(find, flipped="y" if body is not None and self.drawn[body] else "x")
        alone = self.affine(what)
        if alone is None:
            turn = 0.0 if any(part.kind == "angle" for part in parts_in(what)) else None
            return Seen(replace(find, found=replace(find.found, what=self.scalar(what))), 1, turn)
        turn = self.frame.radians if alone.turn is not None else None
        return Seen(replace(find, found=replace(find.found, what=alone.quantity)), alone.sense, turn)

    # --- sides -------------------------------------------------------------------------------------------------------

    def is_vector(self, side: Side) -> bool:
        match side:
            case Quantity():
                if side.word in ("dot", "ddot", "mean") and not side.parts:
                    return is_side(side.argument) and self.is_vector(side.argument)
                return side.word in VECTORS and not side.parts and not self._about(side) and not self._is_couple(side)
            case Negate() | Scaled() | Grouped():
                return self.is_vector(side.operand)
            case Binary():
                return self.is_vector(side.left) or self.is_vector(side.right)
        return False

    def _about(self, q: Quantity) -> bool:
        """Is it an angular impulse, about a point?"""
        return (
            q.word == "impulse" and len(q.things) == 2 and q.things[1] in self.names and q.things[1] not in self.drawn
        )

    def _is_couple(self, q: Quantity) -> bool:
        load = self.loads.get(q.things[0]) if q.things else None
        couple = isinstance(load, Torque) or (isinstance(load, Impulse) and load.moment is not None)
        return q.word in ("impulse", "force") and couple

    def scalar(self, side: Side) -> Side:
        """A formula of the new scene that is worth what this one was."""
        if self.is_vector(side):
            return side
        match side:
            case Quantity():
                return self._quantity(side)
            case Negate() | Scaled() | Grouped():
                return replace(side, operand=self.scalar(side.operand))
            case Binary():
                return replace(side, left=self.scalar(side.left), right=self.scalar(side.right))
            case Function():
                return replace(side, argument=self.scalar(side.argument))
        return side

    def _quantity(self, q: Quantity) -> Side:
        alone = self.affine(q)
        if alone is None:
            return q if q.argument is None else replace(q, argument=self._argument(q.argument))
        if alone.turn is None:
            return alone.quantity if alone.sense > 0 else negated(alone.quantity)
        shifted = Binary("-", alone.quantity, alone.turn, NOWHERE)
        return shifted if alone.sense > 0 else negated(shifted)

    def _argument(self, argument: Side | Relation) -> Side | Relation:
        return self.relation(argument) if isinstance(argument, Relation) else self.scalar(argument)

    def affine(self, side: Side) -> _Affine | None:
        """A quantity alone that is read otherwise in the new frame; None: it is no quantity, or stays as it is."""
        if not isinstance(side, Quantity):
            return None
        if side.parts:
            if len(side.parts) > 1:
                raise NotWritten("a part of a part")
            return self._part(side, side.parts[0])
        if side.word in ("x", "y"):
            if self.frame.quarters is not None and self.frame.quarters % 2 == 0:
                sign = -1 if self.frame.quarters == 2 else 1
                return _Affine(side, sign if side.word == "x" else sign * self.frame.sense)
            return self._part(replace(side, word="r"), Part(side.word, None, side.mark))
        if side.word == "theta":
            return self._theta(side)
        odd = side.word in TURNING or self._about(side) or self._is_couple(side) or self._has_a_side(side)
        return _Affine(side, self.frame.sense) if odd else None

    def _has_a_side(self, q: Quantity) -> bool:
        """N of a guide along a direction that is drawn, and the tension of a belt, which turns its second disk."""
        joint = self.joints.get(q.things[0]) if q.things else None
        if q.word == "tension":
            return isinstance(joint, Belt)
        if q.word != "N" or not isinstance(joint, Guide):
            return False
        if not isinstance(joint.along, str):
            return True
        if joint.along in self.drawn:
            return self.drawn[joint.along]
        surface = next(s for s in self.problem.surfaces if s.name == joint.along)
        return isinstance(surface.shape, Line)

    def _theta(self, q: Quantity) -> _Affine:
        shares = [self.drawn.get(name, False) for name in q.things]
        turns = shares[0] - sum(shares[1:])
        if turns == 0:
            return _Affine(q, self.frame.sense)
        turn = self.frame.turn if turns > 0 else negated(self.frame.turn)
        return _Affine(q, self.frame.sense, self._whole_turns(q, turn, turns), True)

    def _whole_turns(self, q: Quantity, turn: Side, times: int) -> Side:
        """The angle between the two frames with the whole turns by which the drawn angles differ from it: each is
        counted from a direction in (-180, 180] deg.
        """
        asked = Quantity(q.word, q.things, None, q.parts, None, NOWHERE)
        find = Find("angle", Found(asked, None, "", NOWHERE), NOWHERE)
        bare = replace(self.problem, instant=None, states=(), motion=(), joints=(), loads=(), cases=(), answers=())
        here = replace(bare, find=(find,))
        there = replace(_Framing(replace(here, find=()), self.frame).whole(), find=here.find)
        first, second = (_angle(p) for p in (here, there))
        if first is None or second is None:
            return turn
        whole = (second - self.frame.sense * first - times * self.frame.radians) / (2 * math.pi)
        return self._sum(degrees(360 * round(whole)), turn, False)

    def _part(self, q: Quantity, part: Part) -> _Affine | None:
        if q.argument is not None and not isinstance(q.argument, Relation):
            q = replace(q, argument=self.scalar(q.argument))
        sense = self.frame.sense
        match part.kind:
            case "x" | "y":
                return self._component(q, part)
            case "angle":
                q, turn = replace(q, parts=(part,)), self.frame.turn
                counts = q.word == "r"
                return _Affine(q, sense, self._whole_turns(q, turn, 1) if counts else turn, counts)
            case "theta":
                return _Affine(replace(q, parts=(part,)), sense)
            case "along" | "across":
                return self._directed(q, part)
        return _Affine(q, 1) if q.argument is not None else None

    def _component(self, q: Quantity, part: Part) -> _Affine:
        """A component along an axis of the old frame: T e_x points along φ, T e_y along φ + s 90 deg."""
        quarters = self.frame.quarters
        if quarters is None:
            right = self.frame.turn
            up = Binary("+", right, degrees(90 * self.frame.sense), NOWHERE)
            direction = right if part.kind == "x" else up
            return _Affine(replace(q, parts=(Part("along", direction, part.mark),)), 1)
        at = (quarters + (self.frame.sense if part.kind == "y" else 0)) % 4
        kind, sign = ("x", "y")[at % 2], 1 if at < 2 else -1
        return _Affine(replace(q, parts=(replace(part, kind=kind),)), sign)

    def _directed(self, q: Quantity, part: Part) -> _Affine:
        sign = self.frame.sense if part.kind == "across" else 1
        direction = part.direction
        if isinstance(direction, Name) and direction.at is None and direction.name in self.drawn:
            if not self.drawn[direction.name]:
                if not self.frame.mirrors_across_y:
                    raise NotWritten("a direction of a body without one of its own")
                sign = -sign
        elif isinstance(direction, Name) and any(s.name == direction.name for s in self.problem.surfaces):
            pass
        elif not isinstance(direction, PointPair):
            assert direction is not None
            direction = self.angle(direction)
        return _Affine(replace(q, parts=(replace(part, direction=direction),)), sign)


@cache
def _angle(problem: Problem) -> float | None:
    """The angle [rad] that a problem asks for, where it is drawn."""
    try:
        (found,) = solve_problem(problem).parts[0].found
    except PlanarError:
        return None
    return None if found.values is None else float(found.values[0])


# --- formulas --------------------------------------------------------------------------------------------------------


def is_side(value: Any) -> bool:
    return isinstance(value, Number | Name | Negate | Binary | Scaled | Function | Grouped | Quantity)


def parts_in(side: Side) -> list[Part]:
    """The parts of quantities in a formula."""
    return [part for node in walk(side) if isinstance(node, Quantity) for part in node.parts]


def negated(side: Side) -> Side:
    match side:
        case Number(value=value) if value == 0:
            return side
        case Number():
            return replace(side, value=-side.value)
        case Negate():
            return side.operand
    return Negate(side, NOWHERE)


def times(factor: Side, side: Side) -> Side:
    return side if isinstance(side, Number) and side.value == 0 else Binary("*", factor, side, NOWHERE)


def in_degrees(side: Side) -> Fraction | None:
    """A number of degrees."""
    match side:
        case Number(value=value) if side.unit == "deg":
            return value * side.sense
        case Number(value=value) if value == 0:
            return Fraction(0)
        case Negate():
            inner = in_degrees(side.operand)
            return None if inner is None else -inner
    return None


def wrapped(angle: Fraction) -> Fraction:
    """The same direction in (-180, 180] deg."""
    return 180 - (180 - angle) % 360


def substituted(side: Side, name: str, other: Side) -> Side:
    match side:
        case Name() if side.name == name:
            return other
        case Negate() | Scaled() | Grouped():
            return replace(side, operand=substituted(side.operand, name, other))
        case Binary():
            left, right = (substituted(s, name, other) for s in (side.left, side.right))
            return replace(side, left=left, right=right)
        case Function():
            return replace(side, argument=substituted(side.argument, name, other))
    return side
