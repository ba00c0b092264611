"""A scene in numbers, as it is drawn: places in metres, angles in radians."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

import sympy as sp

from planar_cli.equation.scene.bodies import BodyModel
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.system.setup import Earlier, Setup
from planar_cli.equation.system.system import Statements
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import PlanarError
from planar_cli.problem.language.expression import Binary, Negate, Number, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND, Problem
from planar_cli.records import record
from planar_cli.report.document.blocks import Line, Text, line
from planar_cli.report.document.marks import Spot
from planar_cli.report.words.sides import said
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.solution import InstantSolution

FIGURES = 4


@record
class Beside:
    """What is drawn beside its place, m. `moves`: bodies and fixed points, by their names; `sheaves`: by the rope and
    the number of the stop there, of a body with several wheels each, beside the body.
    """

    moves: Mapping[str, Spot]
    sheaves: Mapping[tuple[str, int], Spot]


AS_WRITTEN = Beside({}, {})


@record
class Drawn:
    """A scene in one position. `value`: the numbers of its letters; `here`: what stands for its coordinates there;
    `beside`: what in the scene is not where the file has it.
    """

    scene: Scene
    value: Valuation
    here: Mapping[sp.Symbol, sp.Expr]
    beside: Beside = AS_WRITTEN

    @classmethod
    def as_in_the_file(cls, instant: InstantSolution) -> Drawn:
        """The position in which the file draws an instant, or in which it was found."""
        scene = instant.instant.scene
        moves = scene.displacement.coordinates if scene.displacement is not None else ()
        return cls(scene, instant.value, {c.symbol: c.drawn for c in moves if c.drawn is not None})

    @classmethod
    def in_state(cls, motion: MotionTrace, state: str) -> Drawn | None:
        """The position of a motion in one of its states, by what holds as it comes there; of the first state by what
        holds from there on. None: no motion comes there, or what holds does not tell where all bodies are.
        """
        here = {general: x for x, general in motion.general.items() if motion.ledger.roles[x].at == state}
        return next((d for s in _scenes(motion, state) if (d := cls(s, motion.value, here)).is_placed), None)

    @classmethod
    def at_first(cls, problem: Problem, values: Mapping[str, float]) -> Drawn | None:
        """The position in which a motion that was followed in numbers alone begins. `values`: numbers for letters [SI].
        None: the file does not draw it without the equations of an instant.
        """
        now = problem.states[0].relations if problem.states else problem.instant or ()
        told = {name: Earlier(sp.Float(value), "1") for name, value in values.items()}
        try:
            scene = Setup(problem, Statements.of(problem.assume, now), told, False).scene
            drawn = cls(scene, scene.valuations[0], {})
            return drawn if drawn.is_placed else None
        except (PlanarError, ArithmeticError):
            return None

    @property
    def is_placed(self) -> bool:
        """Is it told where all bodies are, and how they are turned?"""
        told = (part for body in self.scene.bodies.values() for part in (body.center.x, body.center.y, body.theta))
        return all(self.value.known(sp.sympify(part).xreplace(dict(self.here))) is not None for part in told)

    def number(self, expr: Any) -> float | None:
        """An expression as a number; None: nothing tells it."""
        placed = sp.sympify(expr).xreplace(dict(self.here))
        number = self.value.known(placed)
        if number is None:
            number = self.scene.valuations[0].known(placed)
        return None if number is None or not math.isfinite(float(number)) else float(number)

    def spot(self, place: Vec) -> Spot | None:
        """A place; None: nothing tells it."""
        x, y = self.number(place.x), self.number(place.y)
        return None if x is None or y is None else (x, y)

    def angle(self, direction: Vec) -> float | None:
        """The angle of a direction; None: nothing tells it, or it has none."""
        way = self.spot(direction)
        return None if way is None or math.hypot(*way) < TINY else math.atan2(way[1], way[0])

    def length(self, side: Side) -> float | None:
        """A length, angle or other size of the file; None: nothing tells it, as where it rests on a velocity."""
        try:
            return self.number(self.scene.value(side))
        except PlanarError:
            return None

    def at_rest(self) -> Drawn:
        """The scene where the file draws it; where it is now, if that does not tell where all bodies are."""
        moves = self.scene.displacement.coordinates if self.scene.displacement is not None else ()
        rest = Drawn(self.scene, self.value, {c.symbol: c.drawn for c in moves if c.drawn is not None}, self.beside)
        return rest if all(rest.spot(b.center) is not None for b in self.scene.bodies.values()) else self

    def body(self, name: str) -> BodyModel | None:
        """A body as it is drawn; None: there is none of that name."""
        return self.scene.bodies.get(name)

    def named(self, name: str) -> Spot | None:
        """A point of the file, or a particle, by its name."""
        problem = self.scene.problem
        known = {*(p.name for p in problem.points), *(b.name for b in problem.bodies if b.is_particle)}
        return self.spot(self.scene.point(name)) if name in known else None

    def center(self, body: str) -> Spot | None:
        """The mass centre of a body."""
        return self.spot(self.scene.center(body))

    def moved_by(self, point: str) -> Spot:
        """By how much a point is drawn beside its place, m."""
        owner = self.scene.owner(point)
        return self.beside.moves.get(point if owner == GROUND else owner, (0.0, 0.0))

    def everything(self) -> list[Spot]:
        """All points and mass centres of the scene."""
        problem = self.scene.problem
        places = [
            *map(self.named, (p.name for p in problem.points)),
            *map(self.center, (b.name for b in problem.bodies)),
        ]
        return [s for s in places if s is not None]

    def carried(self, body: str | None, point: str) -> Spot | None:
        """A named point that goes with a body, or stays with the ground."""
        return self.spot(self.scene.carried(body or GROUND, point))


def _scenes(motion: MotionTrace, state: str) -> Iterator[Scene]:
    """The scenes of what ends in a state, then of what begins there."""
    for end in (1, 0):
        for regime in motion.regimes:
            if any(stretch[end] == state for stretch in regime.stretches):
                yield regime.solution.instant.scene


TERMS = 2
"""So many signs + and -, those in brackets too, are too many for words in a drawing."""
INDEX = 2
"""A piece of a name that is not longer is an index."""
TINY = 1e-12
"""A direction that is shorter is none."""


def size_of(side: Side, value: float | None = None) -> Line:
    """A quantity as the size of what is drawn on its own side, or turns its own way: a negative θ as -θ, a negative -x
    as x. `value`: what it is there [SI]; None: nothing tells it, and a minus sign before it stands for the side.
    """
    return words_of(_sized(side, value))


def _sized(side: Side, value: float | None) -> Side:
    negative = value < 0 if value is not None else isinstance(side, Negate) or _number(side) < 0
    return _opposite(side) if negative else side


def _number(side: Side) -> float:
    return float(side.value) * side.sense if isinstance(side, Number) else 0.0


def _opposite(side: Side) -> Side:
    """The formula of the opposite value."""
    match side:
        case Negate(operand=inner):
            return inner
        case Number(value=value, unit=unit, sense=sense, mark=mark):
            return Number(abs(value), unit, 1, mark) if value * sense < 0 else Number(-value, unit, sense, mark)
        case Binary(operator="-", left=left, right=right, mark=mark) if not _begins_with_minus(left):
            return Binary("-", right, left, mark)
        case Binary(operator="+" | "-" as sign, left=left, right=right, mark=mark):
            return Binary("-" if sign == "+" else "+", _opposite(left), right, mark)
        case Binary(operator="*" | "/" as sign, left=Negate() | Number() | Binary() as left, right=right, mark=mark):
            return Binary(sign, _opposite(left), right, mark)
        case _:
            return Negate(side, side.mark)


def brief(side: Side, value: float | None = None) -> Line:
    """The same, where it can stand beside what it measures: no sum of more than two terms, nor one that begins with a
    minus.
    """
    shown = _sized(side, value)
    signs = sum(isinstance(node, Binary) and node.operator in "+-" for node in walk(shown))
    minus = isinstance(shown, Binary) and _begins_with_minus(shown)
    return () if signs >= TERMS or minus else words_of(shown)


def _begins_with_minus(side: Side) -> bool:
    while isinstance(side, Binary):
        side = side.left
    return isinstance(side, Negate) or _number(side) < 0


def named_body(body: str) -> Line:
    """The name of a body in a drawing: gear_A with an index, sliding_block in words."""
    stem, _, index = body.rpartition("_")
    words = body.replace("_", " ")
    return line(Text(f"{stem.replace('_', ' ')}_{index}" if stem and len(index) <= INDEX else words))


def words_of(side: Side) -> Line:
    """A quantity as the file writes it; nothing where only a sentence could tell it."""
    return said(side, FIGURES) or ()
