"""The speed, or its rate, `a(car).t = 7 ft/s^2`, of what starts from rest on a track that is fixed.

At rest nothing has a direction along its velocity, and both ways along the track are alike. The positive one is taken:
counterclockwise round a circle, along the angle of a line, along a curve the way in which its variable grows; the other
one where an inequality of the first state says so, `a(car).y < 0`, as a particle at rest is accelerated the way it
goes. Where `motion` states the direction of the velocity, that is the way. From then on the velocity has that
direction. A law of the speed itself, `v(car).mag = a*t`, is one of a start from rest where it is zero then.
"""

from __future__ import annotations

import math
from dataclasses import replace

from planar_cli.problem.implied.drawn_directions import DrawnDirections
from planar_cli.problem.implied.tracks import Parts, called, positive_way, stated_way
from planar_cli.problem.language.expression import (
    AtRest,
    Binary,
    Function,
    Name,
    Negate,
    Number,
    Part,
    Quantity,
    Relation,
    Scaled,
    Side,
    Statement,
)
from planar_cli.problem.scene.scene import Problem, State

LEVEL = 1e-9
"""A component below this part of a direction is the rounding of zero."""


def with_ways_from_rest(problem: Problem) -> Problem:
    """The problem in which such laws are told along the track."""
    first = next((s for s in problem.states if not s.before), None)
    if first is None:
        return problem
    motion = list(problem.motion)
    for i, law in enumerate(problem.motion):
        told = _speed_told(law.statement)
        if told is None or not problem.holds_at_first(law.during):
            continue
        point = told.things[0]
        names = called(problem, point)
        way = (stated_way(problem, point) if told.word == "a" else None) or positive_way(problem, point)
        assert isinstance(law.statement, Relation)
        drawn = DrawnDirections(problem.given, problem.points, problem.bodies)
        still = way is not None and any(_rests_along(drawn, s, names, way) for s in first.relations)
        if way is not None and (still or _begins_at_rest(law.statement, told, first, names)):
            # A rate below zero already says that it goes against the positive way.
            grows = all((drawn.number(s) or 0) >= 0 for s in (law.statement.left, law.statement.right))
            against = grows and any(_against(drawn, s, names, way) for s in first.relations)
            motion[i] = replace(law, statement=_along(law.statement, told.word, way, against))
    return replace(problem, motion=tuple(motion))


def _speed_told(statement: Statement) -> Quantity | None:
    """The speed of a point, or its rate, that is one side of an equation: v(P) or a(P)."""
    if not isinstance(statement, Relation) or statement.operator != "=":
        return None
    return next((q for side in (statement.left, statement.right) if (q := _plain(side)) is not None), None)


def _plain(side: Side) -> Quantity | None:
    match side:
        case Quantity(word="v", things=(_,), parts=(Part(kind="mag" | "t"),), at=None):
            return side
        case Quantity(word="a", things=(_,), parts=(Part(kind="t"),), at=None):
            return side
        case Quantity(word="dot", argument=Quantity(word="v", things=(_,), parts=(Part(kind="mag" | "t"),)) as speed):
            return replace(speed, word="a")
    return None


def _begins_at_rest(law: Relation, told: Quantity, first: State, names: frozenset[str]) -> bool:
    """Does the first state say so, or is the speed that the law tells zero then?"""
    if any(_rests(s, names) for s in first.relations):
        return True
    other = law.left if _plain(law.right) is not None else law.right
    return told.word == "v" and not any(_later(s) for s in first.relations) and _vanishes(other)


def _later(statement: Statement) -> bool:
    """Does the first state say that its time is not zero?"""
    match statement:
        case Relation(left=Name(name="t", at=None), right=other) | Relation(left=other, right=Name(name="t", at=None)):
            return not (isinstance(other, Number) and other.value == 0)
    return False


def _vanishes(side: Side) -> bool:
    """Is a formula zero at t = 0, whatever its letters are?"""
    match side:
        case Number():
            return side.value == 0
        case Name():
            return side.name == "t" and side.at is None
        case Negate() | Scaled():
            return _vanishes(side.operand)
        case Binary(operator="+" | "-"):
            return _vanishes(side.left) and _vanishes(side.right)
        case Binary(operator="*"):
            return _vanishes(side.left) or _vanishes(side.right)
        case Binary(operator="/"):
            return _vanishes(side.left)
        case Binary(operator="^", right=Number(value=power)):
            return power > 0 and _vanishes(side.left)
        case Function(name="sin" | "tan" | "sqrt"):
            return _vanishes(side.argument)
    return False


def _rests(statement: Statement, names: frozenset[str]) -> bool:
    match statement:
        case AtRest(body=body):
            return body is None or body in names
        case Relation(left=Quantity(word="v", things=(point,), parts=(Part(kind="mag" | "t"),)), right=Number(value=0)):
            return statement.operator == "=" and point in names
    return False


def _rests_along(drawn: DrawnDirections, statement: Statement, names: frozenset[str], way: Parts) -> bool:
    """Is a component of the velocity zero that the way of the point has where it is drawn?"""
    match statement:
        case Relation(operator="=", left=Quantity(word="v", things=(point,), parts=(part,)), right=Number(value=0)):
            asked, ahead = drawn.direction(part), drawn.direction(way[0])
        case _:
            return False
    if point not in names or asked is None or ahead is None:
        return False
    along = asked[0] * ahead[0] + asked[1] * ahead[1]
    return abs(along) > LEVEL * math.hypot(*asked) * math.hypot(*ahead)


def _against(drawn: DrawnDirections, statement: Statement, names: frozenset[str], way: Parts) -> bool:
    """Does an inequality say that it is accelerated against the positive way?"""
    match statement:
        case Relation(left=Quantity(word="a", things=(point,), parts=(part,)), right=Number(value=0)):
            below = statement.operator in ("<", "<=")
        case Relation(left=Number(value=0), right=Quantity(word="a", things=(point,), parts=(part,))):
            below = statement.operator in (">", ">=")
        case _:
            return False
    asked, ahead = drawn.direction(part), drawn.direction(way[0])
    if statement.operator == "=" or point not in names or asked is None or ahead is None:
        return False
    along = asked[0] * ahead[0] + asked[1] * ahead[1]
    if abs(along) <= LEVEL * math.hypot(*asked) * math.hypot(*ahead):
        return False
    return (along > 0) is below


def _along(statement: Relation, word: str, way: Parts, against: bool) -> Relation:
    def read(side: Side) -> Side:
        plain = _plain(side)
        if plain is not None and plain.word == word:
            return Quantity(word, plain.things, None, way, None, statement.mark)
        return Negate(side, statement.mark) if against else side

    return replace(statement, left=read(statement.left), right=read(statement.right))
