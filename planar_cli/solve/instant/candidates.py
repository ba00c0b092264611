"""Equations that could be written: every family of equations with the multipliers that a teacher would choose.

A family is the space of all equations of one law: of a group of bodies (force along a direction, moment about a point),
of a vector loop (projection on a direction), of a single relation. A candidate is a member of it: its numbers decide
which unknowns it contains; its words and symbols are made only when the plan uses it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from decimal import Decimal

import sympy as sp

from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.system.conditions import Condition
from planar_cli.equation.values.exact import CERTAIN, ONE, ZERO
from planar_cli.principles.base import Single
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record
from planar_cli.solve.multibody.linear import Row, clean, rank, scaled

ALONG_CONTACT = 0.95
"""Along and across a slope is how it is drawn."""
VIRTUAL_MOTION = "the direction of the common virtual motion"
AXIS, NAMED_POINT, ACROSS, NAMED_SLANT, CONSTRUCTED, FAR = 1.0, 1.1, 1.2, 1.3, 2.0, 3.0
CONTACT = "along the contact"
PER_BODY, PER_UNKNOWN = 0.6, 0.15
MOMENTUM = "momentum"
"""The word of the principle that integrates equations of forces over time."""


@record
class Choice:
    """Which member of a family: a direction, or a moment centre (`moment`), in symbols and in words.

    `name`: of the moment centre, or of the axis ("x", "y"); "" where it is constructed. `through`: the unknowns whose
    lines of action meet in a constructed centre, or across whose line a direction is. `place`: the vector, or what
    makes it when the plan uses this candidate, as few ever are used.
    """

    moment: bool
    place: Vec | Callable[[], Vec]
    words: str
    through: tuple[sp.Symbol, ...] = ()
    name: str = ""

    @property
    def vector(self) -> Vec:
        return self.place if isinstance(self.place, Vec) else self.place()


@record
class Candidate:
    """One equation that could be written. `mask`: bit j set when it contains unknown j; `row`: its numbers. `single`:
    the equation itself, where a principle offers it as a whole.
    """

    bodies: tuple[str, ...]
    condition: Condition | None
    choice: Choice | None
    row: Row
    mask: int
    cost: float
    single: Single | None = None


def mask_of(row: Row) -> int:
    """The unknowns with a coefficient that is not zero, as bits."""
    return sum(1 << j for j, c in enumerate(row[:-1]) if c)


def of_whole(scene: Scene, bodies: tuple[str, ...], form: float) -> float:
    """The form of an equation that the method of momentum integrates over time: the course begins with the whole
    system, in which the impulses between its bodies cancel.
    """
    whole = scene.problem.method == MOMENTUM and len(bodies) == len(scene.bodies)
    return form - PER_BODY * len(bodies) if whole else form


def priced(
    bodies: tuple[str, ...],
    condition: Condition | None,
    choice: Choice | None,
    row: Row,
    form: float,
    single: Single | None = None,
) -> Candidate | None:
    """A candidate with its cost; None when nothing is left of it."""
    row = scaled([c if abs(c) > CERTAIN * 10**6 * size else ZERO for c, size in zip(row, _sizes(row), strict=True)])
    mask = mask_of(row)
    if not mask and not row[-1]:
        return None
    cost = form + PER_BODY * max(len(bodies) - 1, 0) + PER_UNKNOWN * mask.bit_count()
    return Candidate(bodies, condition, choice, row, mask, cost, single)


def _sizes(row: Row) -> list[Decimal]:
    size = max((abs(c) for c in row), default=ZERO)
    return [size] * len(row)


def combine(rows: Iterable[Row], factors: Iterable[Decimal]) -> Row:
    """Σ factor · row, with what cancels cleaned to zero."""
    total: Row = []
    sizes: Row = []
    for row, factor in zip(rows, factors, strict=True):
        if not total:
            total, sizes = [ZERO] * len(row), [ZERO] * len(row)
        if factor:
            total = [t + factor * c for t, c in zip(total, row, strict=True)]
            sizes = [s + abs(factor * c) for s, c in zip(sizes, row, strict=True)]
    return [ZERO if abs(t) <= CERTAIN * s else t for t, s in zip(total, sizes, strict=True)]


def cheapest(candidates: Iterable[Candidate | None], most: int = 1) -> list[Candidate]:
    """Of the candidates of one family with the same unknowns the nicest one, or as many (at most) as tell different
    things.
    """
    families: dict[tuple[object, int], list[Candidate]] = {}
    for c in candidates:
        if c is not None:
            families.setdefault((c.bodies or id(c.condition or c.single), c.mask), []).append(c)
    kept = (_telling(same, most) for same in families.values())
    return sorted((c for same in kept for c in same), key=lambda c: c.cost)


def _telling(same: list[Candidate], most: int) -> list[Candidate]:
    if most == 1:
        return [min(same, key=lambda c: c.cost)]
    kept: list[Candidate] = []
    for c in sorted(same, key=lambda c: c.cost):
        rows = [scaled(list(other.row)) for other in (*kept, c)]
        if len(kept) < most and rank(rows, len(c.row)) > len(kept):
            kept.append(c)
    return kept


def cross3(
    a: tuple[Decimal, Decimal, Decimal], b: tuple[Decimal, Decimal, Decimal]
) -> tuple[Decimal, Decimal, Decimal]:
    """The multiplier that kills two wrenches at once."""
    return (
        clean(a[1] * b[2] - a[2] * b[1], ONE),
        clean(a[2] * b[0] - a[0] * b[2], ONE),
        clean(a[0] * b[1] - a[1] * b[0], ONE),
    )
