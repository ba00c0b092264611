"""Velocities, accelerations and rotations that the file gives for the position that is drawn: arrows with their sizes,
and the angles of their directions.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from planar_cli.equation.motion import Motion
from planar_cli.figures.angles import angle_from_its_zero
from planar_cli.figures.drawn import TINY, Drawn, size_of, words_of
from planar_cli.problem.expression import Quantity, Relation, Side
from planar_cli.problem.geometry import Vec
from planar_cli.problem.scene import GROUND, Problem
from planar_cli.records import record
from planar_cli.report.blocks import Name, line
from planar_cli.report.marks import Arrow, Mark, Spot, Style, Turn
from planar_cli.solve.solution import InstantSolution

VECTORS: Mapping[str, Style] = {"v": "velocity", "a": "acceleration"}
ROTATIONS: Mapping[str, Style] = {"omega": "velocity", "alpha": "acceleration"}
UPRIGHT = math.pi / 2
NEAR = 1e-6
ALONG, BESIDE = 0.05, 9.0
"""Arrows of directions that differ by less, rad, lie on each other; one is drawn so far beside the other, px."""
MAG, ANGLE = "mag", "angle"


@record
class Moving:
    """The velocities and accelerations that belong to a position."""

    drawn: Drawn
    motion: Motion

    @classmethod
    def of(cls, drawn: Drawn, solutions: Iterable[InstantSolution]) -> Moving | None:
        """The motion of the scene that is drawn, by the solution of that scene; None: none was worked out."""
        led = next((s.trial.system.motion for s in solutions if s.instant.scene is drawn.scene), None)
        return cls(drawn, led) if led is not None else None

    def vector(self, word: str, name: str) -> Spot | None:
        """The velocity or acceleration of a point or mass centre."""
        scene = self.drawn.scene
        body = name if name in scene.bodies else scene.owner(name)
        place = scene.bodies[name].center if name in scene.bodies else scene.points.get(name)
        if place is None or body == GROUND:
            return None
        found: Vec = self.motion.velocity(place, body) if word == "v" else self.motion.acceleration(place, body)
        return self.drawn.spot(found)

    def place(self, name: str) -> Spot | None:
        """Where it is."""
        scene = self.drawn.scene
        at = scene.bodies[name].center if name in scene.bodies else scene.points.get(name)
        return None if at is None else self.drawn.spot(at)


def given_motion_marks(moving: Moving, problem: Problem, aside: Mapping[str, Spot]) -> Iterator[Mark]:
    """`aside`: by so much bodies are drawn beside their places, m."""
    told: dict[tuple[str, str], dict[str, Side]] = {}
    for word, name, part, size in _given(problem):
        told.setdefault((word, name), {}).setdefault(part, size)
    for (word, name), parts in told.items():
        at = moving.place(name)
        if at is None:
            continue
        at = (at[0] + aside.get(name, (0.0, 0.0))[0], at[1] + aside.get(name, (0.0, 0.0))[1])
        yield from _turn(moving, word, at, parts) if word in ROTATIONS else _vector(moving, word, name, at, parts)


def arrows_apart(marks: Iterable[Mark], before: Iterable[Mark]) -> Iterator[Mark]:
    """The marks, each arrow beside one that begins at the same place in the same direction, under which nobody would
    see it. `before`: what is drawn already.
    """
    drawn = [m for m in before if isinstance(m, Arrow)]
    for mark in marks:
        if isinstance(mark, Arrow):
            again = sum(_lie_together(mark, other) for other in drawn)
            drawn.append(mark)
            yield replace(mark, aside=BESIDE * again)
        else:
            yield mark


def _lie_together(one: Arrow, other: Arrow) -> bool:
    turned = math.remainder(one.angle - other.angle, 2 * math.pi)
    return one.inward == other.inward and math.dist(one.at, other.at) < NEAR and abs(turned) < ALONG


def _given(problem: Problem) -> Iterator[tuple[str, str, str, Side]]:
    """What an instant, the first state and the laws of motion say of one body or point: word, name, part, value."""
    first = problem.states[0].relations if problem.states else ()
    laws = (law.statement for law in problem.motion if law.during is None)
    for relation in (*(problem.instant or ()), *first, *laws):
        if not isinstance(relation, Relation) or relation.operator != "=" or not isinstance(relation.left, Quantity):
            continue
        asked = relation.left
        part = asked.parts[0].kind if len(asked.parts) == 1 else ""
        whole = asked.word in ROTATIONS and not asked.parts
        if len(asked.things) != 1 or asked.at is not None or not (whole or (asked.word in VECTORS and part)):
            continue
        if part in ("", "x", "y", MAG, ANGLE):
            yield asked.word, asked.things[0], part, relation.right


def _turn(moving: Moving, word: str, at: Spot, parts: Mapping[str, Side]) -> Iterator[Mark]:
    (size,) = parts.values()
    number, words = moving.drawn.length(size), size_of(size)
    if number is not None and abs(number) > TINY and words:
        yield Turn(at, 1 if number > 0 else -1, ROTATIONS[word], words)


def _vector(moving: Moving, word: str, name: str, at: Spot, parts: Mapping[str, Side]) -> Iterator[Mark]:
    whole = moving.vector(word, name)
    if MAG in parts or ANGLE in parts:
        if whole is None or math.hypot(*whole) < NEAR:
            return
        words = words_of(parts[MAG]) if MAG in parts else ()
        yield Arrow(at, math.atan2(whole[1], whole[0]), VECTORS[word], words or line(Name(f"{word}_{name}")))
        if ANGLE in parts:
            yield from angle_from_its_zero(moving.drawn, at, parts[ANGLE])
        return
    for axis, part in enumerate("xy"):
        size = moving.drawn.length(parts[part]) if part in parts else None
        if size is None and part in parts and whole is not None:
            size = whole[axis]
        words = size_of(parts[part]) if part in parts else ()
        if size is not None and abs(size) > NEAR and words:
            yield Arrow(at, axis * UPRIGHT + (math.pi if size < 0 else 0.0), VECTORS[word], words)
