"""Speeds that a file leaves open but for their direction: `v(crate).x > 0` tells which way friction acts.

Each such inequality is given a speed that makes it true. What comes out the same for two speeds depends on the
direction alone.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from decimal import Decimal
from fractions import Fraction

from planar_cli.equation.system.setup import Setup
from planar_cli.equation.system.system import Statements
from planar_cli.problem.language.expression import Binary, Number, Quantity, Relation
from planar_cli.problem.language.outermost import quantities_in
from planar_cli.solve.instant.instant import NONLINEAR, OPEN, TINY, Instant
from planar_cli.solve.instant.modes_search import search_modes
from planar_cli.solve.solution import Found, InstantSolution

SPEEDS = (Fraction(37, 29), Fraction(83, 31))
"""Two speeds (m/s or rad/s) with no simple ratio."""
RATES = frozenset(("v", "omega", "dot"))
SIZES = frozenset(("mag", "angle", "t", "n"))
"""Parts of a velocity that tell no direction along a line."""


def with_speeds(statements: Statements, speed: Fraction) -> Iterator[Statements]:
    """The statements with the first inequality of velocities as a speed, with the first two, and so on."""
    now = statements
    for relation in statements.inequalities:
        if _tells_direction(relation):
            left = tuple(r for r in now.inequalities if r is not relation)
            now = replace(now, inequalities=left, relations=(*now.relations, (_as_speed(relation, speed), False)))
            yield now


def _tells_direction(relation: Relation) -> bool:
    """Is one side a component of a velocity or an angular velocity, and the other none?"""
    for side, other in ((relation.left, relation.right), (relation.right, relation.left)):
        if isinstance(side, Quantity) and side.word in RATES and not quantities_in(other):
            return not any(part.kind in SIZES for part in side.parts)
    return False


def _as_speed(relation: Relation, speed: Fraction) -> Relation:
    """The relation as an equation: the sides differ by this speed, as its sign says."""
    sign = "+" if relation.operator.startswith(">") else "-"
    right = Binary(sign, relation.right, Number(speed, None, 1, relation.mark), relation.mark)
    return replace(relation, operator="=", right=right)


def has_speed_of_ours(statements: Statements) -> bool:
    """Does a relation have a speed that only stands for a direction?"""
    rights = (r.right for r, _ in statements.relations)
    return any(isinstance(s, Binary) and isinstance(s.right, Number) and s.right.value in SPEEDS for s in rights)


def with_statements(instant: Instant, statements: Statements) -> Instant:
    """The instant with other statements, and what drives it where something does."""
    setup = instant.setup
    other = Instant(Setup(setup.problem, statements, setup.earlier, setup.open_form))
    other.lift = instant.lift
    if instant.drivers:
        other.add_drivers()
    return other


def is_settled(instant: Instant) -> bool:
    """Do the statements leave no speed open?"""
    held, rejected = search_modes(instant, instant.scene.valuations)
    return bool(held) or not any(t.objection in (OPEN, NONLINEAR) for t in rejected)


def alike(one: tuple[InstantSolution, list[Found]], other: tuple[InstantSolution, list[Found]]) -> bool:
    """Do both solutions have the same modes and answers?"""
    return one[0].trial.choice == other[0].trial.choice and all(
        a.word == b.word and _close(a.values or (), b.values or ()) and (a.values is None) == (b.values is None)
        for a, b in zip(one[1], other[1], strict=True)
    )


def _close(one: tuple[Decimal, ...], other: tuple[Decimal, ...]) -> bool:
    return all(abs(a - b) <= TINY * max(abs(a), abs(b)) for a, b in zip(one, other, strict=True))
