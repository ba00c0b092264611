"""Velocities, accelerations and rotations that the file gives for the position that is drawn: arrows with their sizes,
and the angles of their directions.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Protocol

from planar_cli.equation.kinematics.motion import Motion
from planar_cli.figures.angles import angle_from_its_zero
from planar_cli.figures.drawn import TINY, Drawn, size_of, words_of
from planar_cli.figures.partners import pivot_of
from planar_cli.problem.language.expression import PointPair, Quantity, Relation, Side
from planar_cli.problem.scene.facts import Push
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND, Problem
from planar_cli.records import record
from planar_cli.report.document.blocks import Name, line
from planar_cli.report.document.marks import Arrow, Mark, Spot, Style, Turn
from planar_cli.solve.solution import InstantSolution

VECTORS: Mapping[str, Style] = {"v": "velocity", "a": "acceleration"}
ROTATIONS: Mapping[str, Style] = {"omega": "velocity", "alpha": "acceleration"}
UPRIGHT = math.pi / 2
NEAR = 1e-6
ALONG, BESIDE = 0.05, 9.0
"""Arrows of directions that differ by less, rad, lie on each other; one is drawn so far beside the other, px."""
MANY = 2
RIM = 0.7
"""The edge of a particle, in parts of how far it is drawn beside its place."""
MAG, ANGLE = "mag", "angle"
AXES: Mapping[str, float] = {"x": 0.0, "y": UPRIGHT}
LINES: Mapping[str, float] = {"along": 0.0, "across": UPRIGHT}
"""Parts of a vector, and by how much each is turned from x, or from the direction that is named with it."""


class Moving(Protocol):
    """The velocities and accelerations that belong to a position."""

    @property
    def drawn(self) -> Drawn: ...

    def vector(self, word: str, name: str) -> Spot | None:
        """The velocity or acceleration of a point or mass centre, in size or at least in direction; None: nothing
        tells it.
        """

    def pressed(self, joint: str) -> Sequence[tuple[Spot, Spot]]:
        """Where and in which directions a joint presses on bodies; nothing where that was not worked out."""


@record
class Found:
    """Those of a motion that was worked out. `pushes`: the reactions with which it was."""

    drawn: Drawn
    motion: Motion
    pushes: tuple[Push, ...]

    @classmethod
    def of(cls, drawn: Drawn, solutions: Iterable[InstantSolution]) -> Found | None:
        """The motion of the scene that is drawn, by the solution of that scene; None: none was worked out."""
        system = next((s.trial.system for s in solutions if s.instant.scene is drawn.scene), None)
        return cls(drawn, system.motion, system.pushes) if system is not None and system.motion is not None else None

    def pressed(self, joint: str) -> Sequence[tuple[Spot, Spot]]:
        normal = [p for p in self.pushes if p.joint == joint and p.kind == "normal"]
        acting = [a for p in normal for a in p.actions if a.body != GROUND and a.force is not None]
        told = ((self.drawn.spot(a.point), self.drawn.spot(a.force)) for a in acting if a.force is not None)
        return [(at, way) for at, way in told if at is not None and way is not None]

    def vector(self, word: str, name: str) -> Spot | None:
        scene = self.drawn.scene
        body = name if name in scene.bodies else scene.owner(name)
        place = scene.bodies[name].center if name in scene.bodies else scene.points.get(name)
        if place is None or body == GROUND:
            return None
        found: Vec = self.motion.velocity(place, body) if word == "v" else self.motion.acceleration(place, body)
        return self.drawn.spot(found)


@record
class Told:
    """Those that the file itself gives."""

    drawn: Drawn

    def pressed(self, joint: str) -> Sequence[tuple[Spot, Spot]]:
        return ()

    def vector(self, word: str, name: str) -> Spot | None:
        parts = {g.part: g for g in _given(self.drawn.scene.problem) if (g.word, g.name) == (word, name)}
        told = {part: self.drawn.length(g.size) for part, g in parts.items()}
        for part, turned in LINES.items():
            along = _along(self.drawn, parts[part], turned) if part in parts else None
            if along is not None and (size := told[part]) is not None:
                return size * math.cos(along), size * math.sin(along)
        if (angle := told.get(ANGLE)) is not None:
            size = told.get(MAG)
            size = 1.0 if size is None else size
            return size * math.cos(angle), size * math.sin(angle)
        x, y = told.get("x"), told.get("y")
        # Of a size alone the direction may be what is sought.
        short = x is None or y is None if MAG in parts or ANGLE in parts else x is None and y is None
        return None if short else (x or 0.0, y or 0.0)


@record
class _Given:
    """What the file says of one body or point: the part of which vector, for `along` and `across` of what direction."""

    word: str
    name: str
    part: str
    size: Side
    direction: Side | None


def given_motion_marks(
    moving: Moving, problem: Problem, aside: Mapping[str, Spot], led: Collection[str] = (), edge: float = math.inf
) -> Iterator[Mark]:
    """`aside`: by so much bodies are drawn beside their places, m; `led`: those that are in guides, with a
    size; `edge`: how far a particle reaches, m.
    """
    told: dict[tuple[str, str], dict[str, _Given]] = {}
    for one in _given(problem):
        told.setdefault((one.word, one.name), {}).setdefault(one.part, one)
    places = {key: _where(moving.drawn, *key) for key in told}
    for (word, name), parts in told.items():
        at = places[word, name]
        if at is None:
            continue
        at = (at[0] + aside.get(name, (0.0, 0.0))[0], at[1] + aside.get(name, (0.0, 0.0))[1])
        if word not in ROTATIONS:
            for arrow in _vector(moving, word, name, at, parts):
                yield (
                    _up_to(arrow, aside[name], edge)
                    if name in aside and name not in led and isinstance(arrow, Arrow)
                    else arrow
                )
            continue
        alone = all(other == (word, name) or places[other] != places[word, name] for other in told if other[0] == word)
        for mark in _turn(moving, word, at, parts):
            # Of several at one place nobody would see whose each is.
            yield mark if alone else replace(mark, words=line(Name(f"{word}_{name}"), " = ", *mark.words))


def _up_to(arrow: Arrow, aside: Spot, edge: float) -> Arrow:
    """An arrow that would run into what its body meets ends at the body."""
    x, y = math.cos(arrow.angle), math.sin(arrow.angle)
    if aside[0] * x + aside[1] * y >= -NEAR * math.hypot(*aside):
        return arrow
    back = RIM * min(edge, math.hypot(*aside))
    return replace(arrow, at=(arrow.at[0] - back * x, arrow.at[1] - back * y), inward=True)


def _where(drawn: Drawn, word: str, name: str) -> Spot | None:
    """Where a vector begins; a rotation about a fixed pin is drawn there."""
    pivot = pivot_of(drawn, name) if word in ROTATIONS else None
    return pivot or _place(drawn, name)


def _place(drawn: Drawn, name: str) -> Spot | None:
    """Where a body or point is."""
    scene = drawn.scene
    at = scene.bodies[name].center if name in scene.bodies else scene.points.get(name)
    return None if at is None else drawn.spot(at)


def arrows_apart(marks: Iterable[Mark], before: Iterable[Mark]) -> Iterator[Mark]:
    """The marks, each arrow beside one that lies on the same side of the same place, under which nobody would see it.
    `before`: what is drawn already.
    """
    drawn, told = [m for m in before if isinstance(m, Arrow)], list(marks)
    arrows = [m for m in told if isinstance(m, Arrow)]
    for mark in told:
        if not isinstance(mark, Arrow):
            yield mark
            continue
        again = sum(_lie_together(mark, other) for other in drawn)
        drawn.append(mark)
        against = [m for m in arrows if _lie_together(mark, m) and m.inward != mark.inward]
        # Two that are opposite have one side each.
        yield replace(mark, aside=BESIDE / 2 if len(against) == 1 and again < MANY else BESIDE * again)


def _lie_together(one: Arrow, other: Arrow) -> bool:
    """Also where one ends at the place from which the other goes back on the same line."""
    turned = math.remainder(one.angle - other.angle + (math.pi if one.inward != other.inward else 0.0), 2 * math.pi)
    return math.dist(one.at, other.at) < NEAR and abs(turned) < ALONG


def _given(problem: Problem) -> Iterator[_Given]:
    """What an instant, the first state and the laws of motion say of one body or point."""
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
        direction = asked.parts[0].direction if asked.parts else None
        if part in ("", "x", "y", MAG, ANGLE) or (part in LINES and not isinstance(direction, PointPair | None)):
            way = None if isinstance(direction, PointPair) else direction
            yield _Given(asked.word, asked.things[0], part, relation.right, way)


def _turn(moving: Moving, word: str, at: Spot, parts: Mapping[str, _Given]) -> Iterator[Turn]:
    (one,) = parts.values()
    number = moving.drawn.length(one.size)
    words = size_of(one.size, number)
    if number is not None and abs(number) > TINY and words:
        yield Turn(at, 1 if number > 0 else -1, ROTATIONS[word], words)


def _vector(moving: Moving, word: str, name: str, at: Spot, parts: Mapping[str, _Given]) -> Iterator[Mark]:
    whole = moving.vector(word, name)
    if MAG in parts or ANGLE in parts:
        # Before a blow the motion that was worked out may be that behind it.
        whole = Told(moving.drawn).vector(word, name) or whole
        if whole is None or math.hypot(*whole) < NEAR:
            return
        words = words_of(parts[MAG].size) if MAG in parts else ()
        yield Arrow(at, math.atan2(whole[1], whole[0]), VECTORS[word], words or line(Name(f"{word}_{name}")))
        if ANGLE in parts:
            yield from angle_from_its_zero(moving.drawn, at, parts[ANGLE].size)
        return
    for part, zero in (*AXES.items(), *LINES.items()):
        if part not in parts:
            continue
        along = zero if part in AXES else _along(moving.drawn, parts[part], zero)
        size = moving.drawn.length(parts[part].size)
        if size is None and whole is not None and along is not None:
            size = whole[0] * math.cos(along) + whole[1] * math.sin(along)
        words = size_of(parts[part].size, size)
        if size is not None and along is not None and abs(size) > NEAR and words:
            yield Arrow(at, along + (math.pi if size < 0 else 0.0), VECTORS[word], words)


def _along(drawn: Drawn, one: _Given, turned: float) -> float | None:
    """The direction in which a component counts; None: nothing tells it."""
    zero = drawn.length(one.direction) if one.direction is not None else None
    return None if zero is None else zero + turned
