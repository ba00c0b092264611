"""Directions as the file writes them: B at 210 deg from A is seen from there at 210 deg, not at -150 deg.

The way from one point to another has a written direction where every piece of it lies along one line and at least the
last pieces are written with an angle: a number, a letter, a coordinate, or a sum of them. Whoever builds a scene takes
that angle; without one, a direction lies in (-180, 180] deg.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import fields, is_dataclass

from planar_cli.problem.language.expression import Binary, Function, Name, Negate, Side
from planar_cli.problem.language.walk import changed, walk, written_alike
from planar_cli.problem.scene.known_values import KnownValues
from planar_cli.problem.scene.scene import (
    At,
    Body,
    Midpoint,
    Particle,
    Place,
    Plate,
    Polar,
    Problem,
    Rod,
    Round,
    Towards,
    TwoFacts,
)
from planar_cli.records import record

ORIGIN = ""
"""The origin of the axes, as the name of a point."""
CLOSE = 1e-9
"""Angles nearer to each other are the same [rad]."""


@record
class Written:
    """An angle with which a direction is written.

    `sense`: 1 where the direction certainly points that way; 0 where the drawing tells whether it does, or the opposite
    one.
    """

    angle: Side
    sense: int


@record
class _Piece:
    """The way to a point from the one it is constructed from; `sense` as in Written, -1 against the angle."""

    to: str
    angle: Side
    sense: int


@record
class _Form:
    """An angle as a sum: the coefficient of each thing without a number, by its text, and a number [rad]."""

    terms: tuple[tuple[str, float], ...]
    number: float


class WrittenDirections:
    """The written directions of one file."""

    def __init__(self, problem: Problem) -> None:
        self._values = KnownValues({g.name: g for g in problem.given})
        self._positive = {s.name for s in (*problem.symbols, *problem.unknowns)}
        self._places: dict[str, Place] = {p.name: p.place for p in problem.points}
        self._bodies = {b.name: b for b in problem.bodies}
        self._ways: dict[str, tuple[str | None, tuple[_Piece, ...]]] = {}

    def between(self, origin: str, to: str) -> tuple[Written, ...]:
        """The angles with which the direction from one point (ORIGIN: of the axes) to another is written, best first;
        empty where it is not. Bodies stand for their mass centres.
        """
        there, here = self._way(to), self._way(origin)
        if there[0] is None or there[0] != here[0]:
            return self._on_line(origin, to)
        shared = next((k for k, (a, b) in enumerate(zip(there[1], here[1], strict=False)) if a.to != b.to), None)
        shared = min(len(there[1]), len(here[1])) if shared is None else shared
        onward, back = there[1][shared:], here[1][shared:]
        return tuple(self._candidates(onward, back)) or self._on_line(origin, to)

    # --- ways --------------------------------------------------------------------------------------------------------

    def _way(self, name: str) -> tuple[str | None, tuple[_Piece, ...]]:
        """From which point a place is constructed in the end, and by which pieces; None while it is being told."""
        if name not in self._ways:
            self._ways[name] = None, ()
            before = self._before(name)
            if before is None:
                self._ways[name] = name, ()
            else:
                start, pieces = self._way(before[0])
                self._ways[name] = start, (*pieces, *before[1])
        return self._ways[name]

    def _before(self, name: str) -> tuple[str, tuple[_Piece, ...]] | None:
        """The point that a place is constructed from along a line, and the piece; None: it is a beginning."""
        place = self._places.get(name)
        if place is None:
            return self._before_body(self._bodies[name]) if name in self._bodies else None
        match place:
            case At():
                return self._before_at(name, place)
            case Polar(origin, distance, angle):
                return origin, (_Piece(name, angle, self._sense(distance)),)
            case Towards(origin, towards, distance, None):
                return self._along(name, origin, towards, self._sense(distance))
            case Midpoint(a, b):
                return self._along(name, a, b, 1)
        return None

    def _before_body(self, body: Body) -> tuple[str, tuple[_Piece, ...]] | None:
        """The same of a mass centre."""
        match body.shape:
            case Particle(place=str() as place):
                return place, ()
            case Particle(place=At() as place):
                return self._before_at(body.name, place)
            case Rod(start, str() as end, _, _):
                return self._along(body.name, start, end, 1)
            case Rod(start, None, angle, _) if angle is not None:
                return start, (_Piece(body.name, angle, 1),)
            case Round(center=center) | Plate(center=center):
                return center, ()
        return None

    def _before_at(self, name: str, place: At) -> tuple[str, tuple[_Piece, ...]] | None:
        """Coordinates that are zero, or l cos φ and l sin φ."""
        if all(self._values.number(side) == 0 for side in (place.x, place.y)):
            return ORIGIN, ()
        turned = [n for n in walk(place.x) if isinstance(n, Function) and n.name == "cos" and n.at is None]
        if len(turned) != 1:
            return None
        (cosine,) = turned
        sine = changed(place.x, lambda n: Function("sin", n.argument, None, n.mark) if n is cosine else None)
        is_factor = isinstance(place.x, Function) or self._is_factor(place.x, cosine)
        if not is_factor or not written_alike(sine, place.y):
            return None
        return ORIGIN, (_Piece(name, cosine.argument, 0),)

    def _is_factor(self, side: Side, part: Side) -> bool:
        """Is a side a product with this factor?"""
        match side:
            case Binary("*", left, right):
                return self._is_factor(left, part) or self._is_factor(right, part)
            case Binary("/", left, _) | Negate(left, _):
                return self._is_factor(left, part)
        return side is part

    def _along(self, name: str, origin: str, towards: str, sense: int) -> tuple[str, tuple[_Piece, ...]] | None:
        """A piece in the direction from one point to another, if that is written."""
        written = self.between(origin, towards)
        if not written:
            return None
        return origin, (_Piece(name, written[0].angle, sense * written[0].sense),)

    def _on_line(self, origin: str, to: str) -> tuple[Written, ...]:
        """A place on a line through the other one, at a written angle: on either side."""
        place = self._places.get(to)
        if not isinstance(place, TwoFacts):
            return ()
        here = self._way(origin)
        return tuple(Written(angle, 0) for through, angle in place.lines if self._way(through) == here)

    # --- one direction -----------------------------------------------------------------------------------------------

    def _candidates(self, onward: tuple[_Piece, ...], back: tuple[_Piece, ...]) -> Iterator[Written]:
        """The angles of the pieces that go onward, the last first, if all pieces are parallel."""
        forms = {id(p): self._form(p.angle) for p in (*onward, *back)}
        tried: list[_Form] = []
        for chosen in reversed(onward):
            form, senses = forms[id(chosen)], set[int]()
            if any(_half_turns(form, other) == 0 for other in tried):
                continue
            tried.append(form)
            for way, pieces in ((1, onward), (-1, back)):
                for piece in pieces:
                    half_turns = _half_turns(forms[id(piece)], form)
                    if half_turns is None:
                        return
                    senses.add(piece.sense * way * (-1 if half_turns % 2 else 1))
            if senses != {-1}:
                yield Written(chosen.angle, 1 if senses == {1} else 0)

    def _form(self, side: Side, factor: float = 1.0) -> _Form:
        number = self._values.number(side)
        if number is not None:
            return _Form((), factor * number)
        match side:
            case Negate(operand, _):
                return self._form(operand, -factor)
            case Binary("+" | "-" as operator, left, right):
                return _sum(self._form(left, factor), self._form(right, factor if operator == "+" else -factor))
            case Binary("*", left, right) if (scale := self._values.number(left)) is not None:
                return self._form(right, factor * scale)
            case Binary("*" | "/" as operator, left, right) if scale := self._values.number(right):
                return self._form(left, factor * scale if operator == "*" else factor / scale)
        return _Form(((_text(side), factor),), 0.0)

    def _sense(self, distance: Side) -> int:
        """The sign of a distance; letters and what is sought are positive."""
        number = self._values.number(distance)
        if number is not None:
            return (number > 0) - (number < 0)
        match distance:
            case Name(name=name):
                return 1 if name in self._positive else 0
            case Negate(operand, _):
                return -self._sense(operand)
            case Binary("*" | "/", left, right):
                return self._sense(left) * self._sense(right)
            case Binary("+", left, right):
                first, second = self._sense(left), self._sense(right)
                return first if first == second else 0
        return 0


def _half_turns(one: _Form, other: _Form) -> int | None:
    """By how many half turns two angles differ; None: they are not parallel, or not always."""
    if dict(one.terms).keys() != dict(other.terms).keys():
        return None
    if any(abs(dict(other.terms)[text] - factor) > CLOSE for text, factor in one.terms):
        return None
    turns = (one.number - other.number) / math.pi
    return round(turns) if abs(turns - round(turns)) < CLOSE else None


def _sum(one: _Form, other: _Form) -> _Form:
    terms = dict(one.terms)
    for text, factor in other.terms:
        terms[text] = terms.get(text, 0.0) + factor
    return _Form(tuple((t, f) for t, f in terms.items() if abs(f) > CLOSE), one.number + other.number)


def _text(tree: object) -> str:
    """What tells formulas apart, wherever they stand."""
    if isinstance(tree, tuple):
        return f"({', '.join(_text(part) for part in tree)})"
    if not is_dataclass(tree):
        return repr(tree)
    inside = ", ".join(_text(getattr(tree, f.name)) for f in fields(tree) if f.name != "mark")
    return f"{type(tree).__name__}({inside})"
