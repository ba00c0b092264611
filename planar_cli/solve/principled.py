"""Which principle of the shelf speaks where: at an instant, between states, across a sudden change."""

from __future__ import annotations

from collections.abc import Iterable

from planar_cli.equation.scene.displacement import Coordinate
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import Valuation
from planar_cli.principles.base import Family, Position, Principle
from planar_cli.registry import members


def principle_of(kind: str) -> Principle:
    """The member of the shelf that `method:` names."""
    found: Principle = members("principles")[kind]()
    return found


def every_principle() -> list[Principle]:
    """All members of the shelf, by their words."""
    return [principle_of(kind) for kind in members("principles")]


def usual() -> Principle:
    """What is taken at an instant where nothing else is named."""
    return next(p for p in every_principle() if p.usual)


def at_instants(method: str | None) -> Principle:
    """The principle that tells accelerations and forces: the one that is named; the usual one where that has equations
    between states only, or where none is named.
    """
    named = None if method is None else principle_of(method)
    return named if named is not None and named.offers("at_instant") else usual()


def across(method: str | None) -> list[Principle]:
    """The principles that tell what a sudden change does: the one that is named; all that do where it has no such
    equations, or where none is named.
    """
    named = [] if method is None else [principle_of(method)]
    return [p for p in named if p.offers("across")] or [p for p in every_principle() if p.offers("across")]


def position_of(system: System, value: Valuation, coordinates: Iterable[Coordinate] = ()) -> Position:
    """What a principle may ask of a system whose velocities are settled."""
    assert system.motion is not None
    return Position(system, system.motion, value, tuple(coordinates), tuple(system.rates().items()))


def families_across(method: str | None, position: Position) -> tuple[Family, ...]:
    """What may be written of a sudden change."""
    return tuple(family for p in across(method) for family in p.across(position))


def instant_words() -> str:
    """The words of the principles that answer at one instant: `newton or dalembert`."""
    *first, last = [p.kind for p in every_principle() if p.offers("at_instant")]
    return f"{', '.join(first)} or {last}" if first else last
