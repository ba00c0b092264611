"""The radius of curvature of a path from velocity and acceleration of its point, where nothing shorter tells it:

ρ = |v|³/|v_x a_y - v_y a_x|              (An Introduction to Planar Dynamics, 1.2: a_n = v²/ρ)
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from decimal import Decimal
from typing import Any, Protocol

import sympy as sp

from planar_cli.equation.kinematics.quantities import Quantities
from planar_cli.equation.scene.centres import centre_of
from planar_cli.equation.system.system import System
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.document.blocks import Block, Equation, Name, line
from planar_cli.report.kinematics.rolled_accelerations import RolledTelling
from planar_cli.report.notation.enough_figures import figures_of
from planar_cli.report.notation.names import index_of
from planar_cli.report.notation.numbers import significant
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import Found
from planar_cli.units import ACCELERATION, VELOCITY, Dimension

SHORT = 2
"""A component clings to a name of so many letters."""


class Telling(Protocol):
    """What tells the velocity and the acceleration of the point."""

    system: System
    phrases: Phrases
    rolled: RolledTelling

    def absolute(self, point: str, word: str) -> Iterator[Block]:
        """The line of one of them, where nothing has told it."""

    def is_readable(self, expr: sp.Expr, dimension: Dimension) -> bool:
        """Is a formula short, with the unit that is asked for?"""


def radius_asked(answer: Found, q: object, telling: Telling) -> list[Block]:
    """v and a, then ρ_C = |v_C|³/|v_Cx a_Cy - v_Cy a_Cx| = numbers = value; of the centre of a wheel on a circle the
    radius of its path. Nothing of another quantity, where a formula of the equations tells it, where the path has no
    curvature, and where v or a is not known.
    """
    if not isinstance(q, Quantity) or q.word != "rho" or len(q.things) != 1 or answer.values is None:
        return []
    scene, phrases, own = telling.system.scene, telling.phrases, q.things[0]
    body = own if own in scene.bodies else scene.owner(own)
    wheel = telling.rolled.wheel(body)
    if wheel is not None and wheel.radius is not None and own in (body, centre_of(scene, body)):
        values = phrases.in_units(answer.values[0], answer.unit)
        sides: list[Any] = [phrases.math(wheel.radius), *phrases.substituted(wheel.radius, values[0]), *values]
        return [Equation((line(Name(answer.name)), *sides))]
    numbers = _numbers(q, telling.system.quantities(), phrases)
    if numbers is None or telling.is_readable(answer.asked[0], answer.unit.dimension):
        return []
    found = _equation(answer, own if own in scene.points else centre_of(scene, own), numbers, phrases)
    return [] if found is None else [*telling.absolute(own, "v"), *telling.absolute(own, "a"), found]


def _numbers(q: Quantity, quantities: Quantities, phrases: Phrases) -> list[Decimal] | None:
    """The components of v and a in units of the page; None where they are not known."""
    vectors = [quantities.any(Quantity(word, q.things, None, (), None, q.mark)) for word in ("v", "a")]
    numbers: list[Decimal] = []
    for vector, dimension in zip(vectors, (VELOCITY, ACCELERATION), strict=True):
        if not isinstance(vector, Vec) or any(phrases.value.known(p.value) is None for p in (vector.x, vector.y)):
            return None
        parts = (phrases.certain(p.value) for p in (vector.x, vector.y))
        numbers += [phrases.of_dimension(p, dimension).number for p in parts]
    return numbers


def _equation(answer: Found, point: str, numbers: list[Decimal], phrases: Phrases) -> Equation | None:
    assert answer.values is not None
    if not answer.values[0].is_finite() or not _turning(numbers):
        return None
    size = (numbers[0] ** 2 + numbers[1] ** 2).sqrt()
    n = figures_of([size, *numbers], _radius, phrases.figures)
    shown = [significant(x, n) for x in (size, *numbers)]
    own, clings = index_of(point), "" if len(index_of(point)) <= SHORT else "_"
    v_x, v_y, a_x, a_y = (Name(f"{letter}_{own}{clings}{axis}") for letter in "va" for axis in "xy")
    formula = line("|", Name(f"v_{own}"), "|³/|", v_x, " ", a_y, " - ", v_y, " ", a_x, "|")
    values = [line(v) for v in phrases.in_units(answer.values[0], answer.unit, answer.energy)]
    put = line(f"{shown[0]}³/|{_product(shown[1], shown[4])} - {_product(shown[2], shown[3], second=True)}|")
    return Equation((line(Name(answer.name)), formula, put, *values))


def _radius(numbers: Sequence[Decimal]) -> Decimal:
    size, *parts = numbers
    return size**3 / abs(_turning(parts))


def _turning(parts: Sequence[Decimal]) -> Decimal:
    """v × a."""
    v_x, v_y, a_x, a_y = parts
    return v_x * a_y - v_y * a_x


def _product(one: str, other: str, second: bool = False) -> str:
    """0.8976 (-0.4075); behind a minus the first one in brackets too."""
    first = f"({one})" if second and one.startswith("-") else one
    return f"{first} ({other})" if other.startswith("-") else f"{first} · {other}"
