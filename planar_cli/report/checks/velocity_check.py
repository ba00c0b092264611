"""A check that a person can make of velocities, from what neighbours say of two points of one body, or of one point.

    v_A/IA = 2.513/0.4362 = 5.761 rad/s, v_B/IB = 2.539/0.4407 = 5.761 rad/s       I: instantaneous centre of AB
    across CD: (v_D - v_C)/CD = (-0.6 - 1.2)/0.06 = -30 rad/s
    v_P = ω OP = 0.5 m/s, √(v_rel² + (ω CP)²) = √(0.3² + 0.4²) = 0.5 m/s           polar coordinates about C

The velocity of a point that is joined to a body on a fixed pin, or to one that rolls, is ω × r from that pin or from
the point of contact, beside a body that translates it is that of this body, in a fixed guide it is along the guide:
none is how the velocities of the body itself were found.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from decimal import Decimal
from itertools import combinations

import sympy as sp

from planar_cli.equation.values.exact import Unvalued
from planar_cli.equation.values.ledger import display
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record
from planar_cli.report.document.blocks import Inline, Line, Name, Text, Value, line
from planar_cli.report.in_numbers.sums import added, agree
from planar_cli.report.kinematics.by_centre import bodies_by_centre
from planar_cli.report.kinematics.component_sums import Term, sum_of_products
from planar_cli.report.notation.enough_figures import figures_of
from planar_cli.report.notation.names import index_of
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import LENGTH, PURE, RATE, VELOCITY, Dimension

SMALL = Decimal("1e-9")
"""In parts of what it is compared with: what is smaller is zero."""


@record
class _Point:
    """A point of a body whose velocity its neighbour tells."""

    name: str
    at: Vec
    """Its place in numbers, m."""
    velocity: Vec
    """In numbers, m/s."""
    by: str
    """The neighbour."""


class _Scene:
    """Places and velocities of one instant in numbers."""

    def __init__(self, instant: InstantSolution, phrases: Phrases) -> None:
        self.system, self.phrases = instant.trial.system, phrases
        motion = self.system.motion
        assert motion is not None
        self.motion = motion
        self.joinings = [j for mode in self.system.modes.values() for j in mode.facts.joinings]
        self.pins: dict[str, tuple[str, Vec]] = {}
        for j in self.joinings:
            for body, other in ((j.mover, j.base), (j.base, j.mover)):
                # A body that rolls on the ground turns about the point of contact, as about a pin.
                if other == GROUND and j.drift is None and (j.path is None or j.rolling is not None):
                    self.pins.setdefault(body, (j.place, self.numbers(j.point)))

    def numbers(self, v: Vec) -> Vec:
        return Vec(*(self.phrases.certain(sp.sympify(p)) for p in (v.x, v.y)))

    def spin(self, body: str) -> Decimal:
        return self.phrases.certain(self.motion.velocities[body].angular)

    def turned(self, body: str, at: Vec) -> Vec:
        """The velocity of a point of a body on a fixed pin, ω × r."""
        return (at - self.pins[body][1]).turned() * self.spin(body)

    def points(self, body: str) -> Iterator[_Point]:
        """The points of a body with velocities that its neighbours tell, each once."""
        seen: list[Vec] = []
        for j in self.joinings:
            if body not in (j.mover, j.base) or j.drift is not None:
                continue
            other = j.base if j.mover == body else j.mover
            at = self.numbers(j.point)
            if any(p == at for p in seen):
                continue
            if other in self.pins and j.path is None:
                seen.append(at)
                yield _Point(j.place, at, self.turned(other, at), other)
            elif other != GROUND and self._translates(other) and (j.path is None or j.rolling is not None):
                seen.append(at)
                yield _Point(j.place, at, self.numbers(self.motion.velocities[other].linear), other)
            elif other == GROUND and j.path is not None and j.mover == body:
                seen.append(at)
                yield self._guided(j, at)

    def _translates(self, body: str) -> bool:
        """Do all points of a body have one velocity, as those of a rack have?"""
        return self.system.scene.bodies[body].rigid and self.spin(body) == 0

    def _guided(self, j: Joining, at: Vec) -> _Point:
        """A point in a fixed guide moves along it."""
        assert j.path is not None
        way, v = self.numbers(j.path.tangent), self.numbers(self.motion.velocity(j.point, j.mover))
        return _Point(j.place, at, way * v.dot(way), GROUND)


def velocity_check(instant: InstantSolution, phrases: Phrases) -> Line:
    """Empty where no body has two such points, or no point two ways to its velocity."""
    if phrases.symbolic or instant.trial.system.motion is None:
        return ()
    try:
        scene, centred = _Scene(instant, phrases), bodies_by_centre(instant, phrases)
        for body, model in scene.system.scene.bodies.items():
            if body in scene.pins or not model.rigid or scene.spin(body) == 0:
                continue
            for one, other in combinations(scene.points(body), 2):
                told = _along(scene, one, other) if body in centred else _centre(scene, body, one, other)
                told = told or _across(scene, one, other, scene.spin(body))
                if told:
                    return told
        return next((told for j in scene.joinings if (told := _polar(scene, j))), ())
    except Unvalued:
        return ()


def _centre(scene: _Scene, body: str, one: _Point, other: _Point) -> Line:
    """ω by the instantaneous centre, from both points."""
    first, last = one.velocity.turned(), other.velocity.turned()
    turn, sizes = first.cross(last), _size(first) * _size(last)
    if not sizes or abs(turn) <= sizes * SMALL:
        return ()
    centre = one.at + first * ((other.at - one.at).cross(last) / turn)
    told: list[str | Inline] = []
    spins = []
    for point in (one, other):
        arm = _size(point.at - centre)
        if not arm:
            return ()
        spins.append(_size(point.velocity) / arm)
        letter = index_of(point.name)
        told += [", " if told else "", Name(f"v_{letter}"), "/", _distance("I", letter), " = "]
        told += _numbers(scene, [(_size(point.velocity), VELOCITY), (arm, LENGTH)], lambda x: x[0] / x[1], ["/"])
        told += [" = ", _rate(scene, spins[-1])]
    if not agree(spins[:1], spins[1:]) or not agree(spins[:1], [abs(scene.spin(body))]):
        return ()
    place = scene.phrases.vector(centre.x, centre.y, LENGTH)
    return line(f"instantaneous centre of {body}: I = ", *place, "; ", *told)


def _along(scene: _Scene, one: _Point, other: _Point) -> Line:
    """The components of both velocities along the line of the points, which keep their distance."""
    reach = other.at - one.at
    length = _size(reach)
    if not length:
        return ()
    way = reach * (1 / length)
    told: list[str | Inline | Line] = []
    for point in (one, other):
        v = [scene.phrases.of_dimension(x, VELOCITY).number for x in (point.velocity.x, point.velocity.y)]
        parts: list[Term] = [(1, ((x, 1), (e, 1))) for x, e in zip(v, (way.x, way.y), strict=True) if x and e]
        along = scene.phrases.of_dimension(point.velocity.dot(way), VELOCITY)
        own = Name(f"v_{index_of(point.name)}")
        told += [", " if told else "", own, " · e = ", sum_of_products(parts, scene.phrases.figures), " = ", along]
    if not agree([one.velocity.dot(way)], [other.velocity.dot(way)]) or not one.velocity.dot(way):
        return ()
    line_of = _distance(index_of(one.name), index_of(other.name))
    return line("along ", line_of, ", e = ", *scene.phrases.vector(way.x, way.y, PURE), ": ", *told)


def _across(scene: _Scene, one: _Point, other: _Point, spin: Decimal) -> Line:
    """ω by the difference of the velocities across the line of both points, which agree along it."""
    reach = other.at - one.at
    length = _size(reach)
    if not length or not any(_size(p.velocity) for p in (one, other)):
        return ()
    way, normal = reach * (1 / length), reach.turned() * (1 / length)
    along = [p.velocity.dot(way) for p in (other, one)]
    across = [p.velocity.dot(normal) for p in (other, one)]
    if not agree(along[:1], along[1:]) or not agree([across[0] / length, -across[1] / length], [spin]):
        return ()
    a, b = (index_of(p.name) for p in (one, other))
    unit, us = coherent_unit(VELOCITY, False, scene.phrases.ledger.us), scene.phrases.ledger.us
    shown = [display(x, unit, us) for x in across] + [_bare(scene, length, LENGTH).number]
    figures = figures_of(shown, lambda x: (x[0] - x[1]) / x[2], scene.phrases.figures)
    terms = added([across[0], -across[1]], unit, scene.phrases, figures)
    reach_name = _distance(a, b)
    head = line(
        "across ", reach_name, ": (", Name(f"v_{b}"), " - ", Name(f"v_{a}"), ")/", reach_name, " = (", *terms, ")/"
    )
    return line(*head, _bare(scene, length, LENGTH, figures), " = ", _rate(scene, spin))


def _polar(scene: _Scene, j: Joining) -> Line:
    """The speed of a point that slides along a line through the pin of its base, by another body and in polar
    coordinates about that pin.
    """
    if j.path is None or j.path.curvature != 0 or j.base not in scene.pins:
        return ()
    at, (pin, centre) = scene.numbers(j.point), scene.pins[j.base]
    arm, way = at - centre, scene.numbers(j.path.tangent)
    if not _size(arm) or abs(arm.cross(way)) > _size(arm) * SMALL:
        return ()
    own = next((p for p in _carried(scene, j, at) if p.by != j.base), None)
    if own is None or not _size(own.velocity):
        return ()
    relative = scene.phrases.certain(scene.motion.slide_speed(j))
    across = abs(scene.spin(j.base)) * _size(arm)
    if not relative or not across or not agree([relative**2, across**2], [_size(own.velocity) ** 2]):
        return ()
    letter, speed = index_of(own.name), scene.phrases.of_dimension(_size(own.velocity), VELOCITY)
    kinds = [(abs(relative), VELOCITY), (abs(scene.spin(j.base)), RATE), (_size(arm), LENGTH)]
    numbers = _numbers(scene, kinds, lambda x: (x[0] ** 2 + (x[1] * x[2]) ** 2).sqrt(), ["² + (", " · "])
    head = line(f"polar coordinates about {pin}: √(", Name("v_rel"), "² + (ω r)²) = √(", *numbers)
    head = line(*head, ")²) = ", speed, "; ", Name(f"v_{letter}"))
    if own.by not in scene.pins:
        return line(*head, " along its path = ", speed)
    pin, centre = scene.pins[own.by]
    return line(*head, f" = ω r about {pin} = ", *_turning(scene, own.by, at - centre), " = ", speed)


def _turning(scene: _Scene, body: str, arm: Vec) -> Line:
    """ω r in numbers."""
    kinds = [(abs(scene.spin(body)), RATE), (_size(arm), LENGTH)]
    return line(*_numbers(scene, kinds, lambda x: x[0] * x[1], [" · "]))


def _carried(scene: _Scene, j: Joining, at: Vec) -> Iterator[_Point]:
    """The point that slides, as the pin of its body or its neighbours tell its velocity."""
    if j.mover in scene.pins:
        yield _Point(j.place, at, scene.turned(j.mover, at), j.mover)
    yield from (p for p in scene.points(j.mover) if _size(p.at - at) <= SMALL)


def _distance(start: str, end: str) -> Inline:
    """AB, or r of points whose names have several letters."""
    return Text(f"{start}{end}") if len(start) == len(end) == 1 else Name(f"r_{end}/{start}")


def _size(v: Vec) -> Decimal:
    return Decimal(v.dot(v)).sqrt()


def _bare(scene: _Scene, value: Decimal, dimension: Dimension, figures: int = 0) -> Value:
    """A number inside a formula."""
    shown = scene.phrases.of_dimension(value, dimension, dimension == RATE)
    return Value(shown.number, "1", figures or shown.figures)


def _numbers(
    scene: _Scene,
    kinds: list[tuple[Decimal, Dimension]],
    worked: Callable[[Sequence[Decimal]], Decimal],
    between: list[str],
) -> list[Inline | str]:
    """Numbers inside a formula, with what stands `between` them, to as many figures as its result needs."""
    shown = [_bare(scene, *kind).number for kind in kinds]
    figures = figures_of(shown, worked, scene.phrases.figures)
    told: list[Inline | str] = [_bare(scene, *kinds[0], figures)]
    for text, kind in zip(between, kinds[1:], strict=True):
        told += [text, _bare(scene, *kind, figures)]
    return told


def _rate(scene: _Scene, value: Decimal) -> Value:
    return scene.phrases.of_dimension(value, RATE, True)
