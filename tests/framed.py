"""A whole problem seen in another frame: mirrored, or turned about the origin."""

from __future__ import annotations

from dataclasses import dataclass, fields, is_dataclass, replace
from fractions import Fraction
from typing import Any

from frame import Frame, NotWritten, degrees, is_side, parts_in, substituted
from framed_formulas import CURVES, SIDE_WORDS, Framing

from planar_cli.errors import NOWHERE
from planar_cli.joints.guide import Guide
from planar_cli.joints.rope import Rope
from planar_cli.loads.impulse import Impulse
from planar_cli.loads.torque import Torque
from planar_cli.problem.language.expression import (
    Binary,
    Name,
    Negate,
    Number,
    Quantity,
    Relation,
    Side,
)
from planar_cli.problem.scene.keys import Table
from planar_cli.problem.scene.scene import (
    At,
    Body,
    Case,
    Circle,
    Composite,
    Curve,
    Find,
    Foot,
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


def framed(problem: Problem, frame: Frame) -> Problem:
    """The problem in the other frame. NotWritten: where the language has no words for it."""
    if problem.plane == "vertical" and any(map(_weighs, problem.bodies)) and not frame.mirrors_across_y:
        raise NotWritten("weight acts along -y")
    return _Scene(problem, frame).whole()


def _weighs(body: Body) -> bool:
    pieces = body.shape.pieces if isinstance(body.shape, Composite) else ()
    return body.any_mass or any(p.mass is not None or p.weight is not None for p in (body, *pieces))


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
    return _Scene(problem, frame).find(found)


class _Scene(Framing):
    """One problem and one frame."""

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
            case Foot(angle=angle) if angle is not None:
                return replace(place, angle=self.angle(angle))
        return place

    def _two_facts(self, place: TwoFacts) -> TwoFacts:
        lines = tuple((through, self.angle(angle)) for through, angle in place.lines)
        x, y = place.x, place.y
        quarters = self.frame.quarters
        if quarters is None:
            if x is not None or y is not None:
                raise NotWritten("a point of a given x or y")
            if place.side is not None:
                raise NotWritten("a place that lies left or above")
            return replace(place, lines=lines)
        nothing = Number(Fraction(0), "m", 1, NOWHERE)
        turned = self.vector(x if x is not None else nothing, y if y is not None else nothing)
        if quarters % 2:
            x, y = (turned[0] if y is not None else None), (turned[1] if x is not None else None)
        else:
            x, y = (turned[0] if x is not None else None), (turned[1] if y is not None else None)
        return TwoFacts(x, y, lines, place.distances, self._side_word(place.side))

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

    def bare(self, problem: Problem) -> Problem:
        return _Scene(problem, self.frame).whole()

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
