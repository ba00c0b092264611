"""Where the instantaneous centre of a body is of which two points move at right angles, and how far from its middle."""

from __future__ import annotations

from decimal import Decimal
from typing import Protocol

from planar_cli.equation.algebra.plain import longer
from planar_cli.principles.base import Moving
from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.kinematics.told import Told
from planar_cli.report.words.words import Phrases

NEARLY = Decimal("1e-12")
LONGEST = 5
"""A velocity of more operations is no reason that is seen."""


class Centre(Protocol):
    """An instantaneous centre I. `from_place` and `to`: the points by which it was found; `place`: where it is, in
    metres; `letters`: the same in letters where the directions of both are those of the axes, else None.
    """

    @property
    def from_place(self) -> str: ...
    @property
    def to(self) -> str: ...
    @property
    def place(self) -> tuple[Decimal, Decimal]: ...
    @property
    def letters(self) -> Vec | None: ...


def reason_of(made: Moving, phrases: Phrases) -> Line:
    """Why a mass centre has its velocity: of an instantaneous centre, why it rests, v_C = -2 l θ̇ sin θ = 0."""
    if made.resting is None or longer(made.resting[1], LONGEST):
        return line(made.why) if made.why else ()
    point, speed = made.resting
    return line(f"{made.why}: ", Name(f"v_{point}"), " = ", phrases.math(speed), " = 0")


def beside(c: Centre, told: Told) -> Line:
    """`above O, at the height of E;`: where both normals are those of the axes; else nothing."""
    start, end = _place(c.from_place, told), _place(c.to, told)
    if c.letters is None or start is None or end is None:
        return ()
    (x, y), size = c.place, max(abs(a - b) for a, b in zip(start, end, strict=True)) * NEARLY
    if abs(x - start[0]) <= size and abs(y - end[1]) <= size:
        return line(f"{'above' if y > start[1] else 'below'} {c.from_place}, at the height of {c.to}; ")
    if abs(y - start[1]) <= size and abs(x - end[0]) <= size:
        return line(f"beside {c.from_place}, {'below' if y < end[1] else 'above'} {c.to}; ")
    return ()


def half_of_diagonal(c: Centre, at: Vec, name: str, told: Told) -> Line:
    """Why the midpoint of a body is half its length from its centre: it is the middle of the circle of Thales.
    `name`: that of the midpoint.
    """
    start, end = _place(c.from_place, told), _place(c.to, told)
    if c.letters is None or start is None or end is None or len(c.from_place) != 1 or len(c.to) != 1:
        return ()
    here = (told.phrases.certain(at.x), told.phrases.certain(at.y))
    size = max(abs(a - b) for a, b in zip(start, end, strict=True)) * NEARLY
    if any(abs(a + b - 2 * p) > size for a, b, p in zip(start, end, here, strict=True)):
        return ()
    return line(f"{name} is the midpoint of {c.from_place}{c.to}, angle {c.from_place}I{c.to} is 90°")


def _place(name: str, told: Told) -> tuple[Decimal, Decimal] | None:
    """The coordinates of a named point, in metres."""
    scene = told.system.scene
    if name not in scene.points:
        return None
    at = scene.point(name)
    return told.phrases.certain(at.x), told.phrases.certain(at.y)
