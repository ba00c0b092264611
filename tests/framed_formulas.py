"""Formulas and statements of a problem as they are written in another frame: mirrored, or turned about the origin.

The frame sends a place r to T r; directions go from angle a to s a + φ, with s = -1 in a mirror: x -> -x is s = -1 and
φ = 180 deg, a turn is s = 1. All names of the file keep their values, and every relation is written so that it says of
the new scene what it said of the old one: `v(P).x` becomes `-v(P).x`, or `v(P).along(φ)`.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache

from frame import Frame, NotWritten, degrees, in_degrees, is_side, negated, times, wrapped

from planar_cli.errors import NOWHERE, PlanarError
from planar_cli.joints.belt import Belt
from planar_cli.joints.guide import Guide
from planar_cli.loads.impulse import Impulse
from planar_cli.loads.torque import Torque
from planar_cli.problem.language import expression as tree
from planar_cli.problem.scene.scene import (
    Composite,
    Find,
    Line,
    Plate,
    Problem,
    Rod,
    Sector,
    Shape,
)
from planar_cli.solve.run import solve_problem

VECTORS = frozenset(("r", "v", "a", "coriolis", "IC", "friction", "reaction", "force", "momentum", "impulse"))
TURNING = frozenset(("omega", "alpha", "H", "moment"))
"""Numbers that change their sign in a mirror, as every rotation does."""
CURVES = frozenset(("path", "hodograph"))
FLIPPED = {"<": ">", ">": "<", "<=": ">=", ">=": "<="}
NEXT_SIDE = {"right": "above", "above": "left", "left": "below", "below": "right"}
SIDE_WORDS = ("right", "above", "left", "below")
ZERO = tree.Number(Fraction(0), None, 1, NOWHERE)


@dataclass(frozen=True, slots=True)
class Affine:
    """A quantity q of the other frame; in the first one it was sense (q - turn)."""

    quantity: tree.Side
    sense: int
    turn: tree.Side | None = None
    counts: bool = False
    """Does it count turns, or lie in (-180, 180] deg?"""


class Framing(ABC):
    """What is said of one problem, in one frame."""

    def __init__(self, problem: Problem, frame: Frame) -> None:
        self.problem, self.frame = problem, frame
        self.drawn = {b.name: self._has_direction(b.shape) for b in problem.bodies}
        self.joints = {j.name: j for j in problem.joints}
        self.loads = {load.name: load for load in problem.loads}
        self.names = {p.name for p in problem.points}

    @abstractmethod
    def bare(self, problem: Problem) -> Problem:
        """A problem of places alone in the other frame."""

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

    # --- directions and vectors --------------------------------------------------------------------------------------

    def angle(self, side: tree.Side) -> tree.Side:
        """s a + φ, as a number of degrees where it is one."""
        return self._sum(self.sensed(self.scalar(side)), self.frame.turn)

    def relative(self, side: tree.Side) -> tree.Side:
        """s a: an angle from another direction of the scene."""
        return self.sensed(self.scalar(side))

    def _sum(self, side: tree.Side, turn: tree.Side, once: bool = True) -> tree.Side:
        a, b = in_degrees(side), in_degrees(turn)
        if a is not None and b is not None:
            return tree.Number(wrapped(a + b) if once else a + b, "deg", 1, NOWHERE)
        return tree.Binary("+", side, turn, NOWHERE)

    def sensed(self, side: tree.Side) -> tree.Side:
        return side if self.frame.sense > 0 else negated(side)

    def vector(self, x: tree.Side, y: tree.Side) -> tuple[tree.Side, tree.Side]:
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
        cosine, sine = (tree.Number(Fraction(n, 5), None, 1, NOWHERE) for n in (3, 4))
        return (
            tree.Binary("-", times(cosine, x), times(sine, flipped), NOWHERE),
            tree.Binary("+", times(sine, x), times(cosine, flipped), NOWHERE),
        )

    # --- statements --------------------------------------------------------------------------------------------------

    def statement(self, statement: tree.Statement) -> tree.Statement:
        match statement:
            case tree.Relation():
                return self.relation(statement)
            case tree.Extreme():
                alone = self.affine(statement.side)
                if alone is None or alone.turn is not None:
                    return replace(statement, side=self.scalar(statement.side))
                return replace(statement, side=alone.quantity, sense=statement.sense * alone.sense)
        return statement

    def relation(self, relation: tree.Relation) -> tree.Relation:
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

    # --- sides -------------------------------------------------------------------------------------------------------

    def is_vector(self, side: tree.Side) -> bool:
        match side:
            case tree.Quantity():
                if side.word in ("dot", "ddot", "mean") and not side.parts:
                    return is_side(side.argument) and self.is_vector(side.argument)
                return side.word in VECTORS and not side.parts and not self._about(side) and not self._is_couple(side)
            case tree.Negate() | tree.Scaled() | tree.Grouped():
                return self.is_vector(side.operand)
            case tree.Binary():
                return self.is_vector(side.left) or self.is_vector(side.right)
        return False

    def _about(self, q: tree.Quantity) -> bool:
        """Is it an angular impulse, about a point?"""
        return (
            q.word == "impulse" and len(q.things) == 2 and q.things[1] in self.names and q.things[1] not in self.drawn
        )

    def _is_couple(self, q: tree.Quantity) -> bool:
        load = self.loads.get(q.things[0]) if q.things else None
        couple = isinstance(load, Torque) or (isinstance(load, Impulse) and load.moment is not None)
        return q.word in ("impulse", "force") and couple

    def scalar(self, side: tree.Side) -> tree.Side:
        """A formula of the new scene that is worth what this one was."""
        if self.is_vector(side):
            return side
        match side:
            case tree.Quantity():
                return self._quantity(side)
            case tree.Negate() | tree.Scaled() | tree.Grouped():
                return replace(side, operand=self.scalar(side.operand))
            case tree.Binary():
                return replace(side, left=self.scalar(side.left), right=self.scalar(side.right))
            case tree.Function():
                return replace(side, argument=self.scalar(side.argument))
        return side

    def _quantity(self, q: tree.Quantity) -> tree.Side:
        alone = self.affine(q)
        if alone is None:
            return q if q.argument is None else replace(q, argument=self._argument(q.argument))
        if alone.turn is None:
            return alone.quantity if alone.sense > 0 else negated(alone.quantity)
        shifted = tree.Binary("-", alone.quantity, alone.turn, NOWHERE)
        return shifted if alone.sense > 0 else negated(shifted)

    def _argument(self, argument: tree.Side | tree.Relation) -> tree.Side | tree.Relation:
        return self.relation(argument) if isinstance(argument, tree.Relation) else self.scalar(argument)

    def affine(self, side: tree.Side) -> Affine | None:
        """A quantity alone that is read otherwise in the new frame; None: it is no quantity, or stays as it is."""
        if not isinstance(side, tree.Quantity):
            return None
        if side.parts:
            if len(side.parts) > 1:
                raise NotWritten("a part of a part")
            return self._part(side, side.parts[0])
        if side.word in ("x", "y"):
            if self.frame.quarters is not None and self.frame.quarters % 2 == 0:
                sign = -1 if self.frame.quarters == 2 else 1
                return Affine(side, sign if side.word == "x" else sign * self.frame.sense)
            return self._part(replace(side, word="r"), tree.Part(side.word, None, side.mark))
        if side.word == "theta":
            return self._theta(side)
        odd = side.word in TURNING or self._about(side) or self._is_couple(side) or self._has_a_side(side)
        return Affine(side, self.frame.sense) if odd else None

    def _has_a_side(self, q: tree.Quantity) -> bool:
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

    def _theta(self, q: tree.Quantity) -> Affine:
        shares = [self.drawn.get(name, False) for name in q.things]
        turns = shares[0] - sum(shares[1:])
        if turns == 0:
            return Affine(q, self.frame.sense)
        turn = self.frame.turn if turns > 0 else negated(self.frame.turn)
        return Affine(q, self.frame.sense, self._whole_turns(q, turn, turns), True)

    def _whole_turns(self, q: tree.Quantity, turn: tree.Side, times: int) -> tree.Side:
        """The angle between the two frames with the whole turns by which the drawn angles differ from it: each is
        counted from a direction in (-180, 180] deg.
        """
        asked = tree.Quantity(q.word, q.things, None, q.parts, None, NOWHERE)
        find = Find("angle", tree.Found(asked, None, "", NOWHERE), NOWHERE)
        bare = replace(self.problem, instant=None, states=(), motion=(), joints=(), loads=(), cases=(), answers=())
        here = replace(bare, find=(find,))
        there = replace(self.bare(replace(here, find=())), find=here.find)
        first, second = (_angle(p) for p in (here, there))
        if first is None or second is None:
            return turn
        whole = (second - self.frame.sense * first - times * self.frame.radians) / (2 * math.pi)
        return self._sum(degrees(360 * round(whole)), turn, False)

    def _part(self, q: tree.Quantity, part: tree.Part) -> Affine | None:
        if q.argument is not None and not isinstance(q.argument, tree.Relation):
            q = replace(q, argument=self.scalar(q.argument))
        sense = self.frame.sense
        match part.kind:
            case "x" | "y":
                return self._component(q, part)
            case "angle":
                q, turn = replace(q, parts=(part,)), self.frame.turn
                counts = q.word == "r"
                return Affine(q, sense, self._whole_turns(q, turn, 1) if counts else turn, counts)
            case "theta":
                return Affine(replace(q, parts=(part,)), sense)
            case "along" | "across":
                return self._directed(q, part)
        return Affine(q, 1) if q.argument is not None else None

    def _component(self, q: tree.Quantity, part: tree.Part) -> Affine:
        """A component along an axis of the old frame: T e_x points along φ, T e_y along φ + s 90 deg."""
        quarters = self.frame.quarters
        if quarters is None:
            right = self.frame.turn
            up = tree.Binary("+", right, degrees(90 * self.frame.sense), NOWHERE)
            direction = right if part.kind == "x" else up
            return Affine(replace(q, parts=(tree.Part("along", direction, part.mark),)), 1)
        at = (quarters + (self.frame.sense if part.kind == "y" else 0)) % 4
        kind, sign = ("x", "y")[at % 2], 1 if at < 2 else -1
        return Affine(replace(q, parts=(replace(part, kind=kind),)), sign)

    def _directed(self, q: tree.Quantity, part: tree.Part) -> Affine:
        sign = self.frame.sense if part.kind == "across" else 1
        direction = part.direction
        if isinstance(direction, tree.Name) and direction.at is None and direction.name in self.drawn:
            if not self.drawn[direction.name]:
                if not self.frame.mirrors_across_y:
                    raise NotWritten("a direction of a body without one of its own")
                sign = -sign
        elif isinstance(direction, tree.Name) and any(s.name == direction.name for s in self.problem.surfaces):
            pass
        elif not isinstance(direction, tree.PointPair):
            assert direction is not None
            direction = self.angle(direction)
        return Affine(replace(q, parts=(replace(part, direction=direction),)), sign)


@cache
def _angle(problem: Problem) -> float | None:
    """The angle [rad] that a problem asks for, where it is drawn."""
    try:
        (found,) = solve_problem(problem).parts[0].found
    except PlanarError:
        return None
    return None if found.values is None else float(found.values[0])
