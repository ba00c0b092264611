"""An equation on paper: its sides in symbols, its law, its words; and lines that only name something."""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from planar_cli.principles.base import Premise
from planar_cli.records import record


@record
class Written:
    """One numbered equation, left = right.

    `law`: relation, force, moment, or single: as a principle offers it, after its `premises`. `bodies`: the group.
    `lead`: what is equated. `words`: why this one.
    """

    number: int
    law: str
    bodies: tuple[str, ...]
    lead: str
    words: str
    left: sp.Expr
    right: sp.Expr
    source: str
    given: bool = False
    premises: tuple[Premise, ...] = ()
    along: tuple[sp.Expr, sp.Expr] | None = None
    """Of a sum of forces, the direction in which they count as positive; of a vector relation that of its component,
    which is no unit vector where its length is a long formula.
    """

    place: str = ""
    """Of a relation, the point that it is about."""
    times: int = 0
    """How often a relation of the file was differentiated."""
    moments: tuple[tuple[sp.Expr, sp.Expr], ...] = ()
    """What the right side of a sum of moments is put together of: each m a with its arm, each I α with the factor 1."""
    armless: tuple[tuple[sp.Expr, sp.Expr], ...] = ()
    """What has no moment about that point for the numbers of the file alone: each m a with its arm in letters."""

    @property
    def residual(self) -> sp.Expr:
        return self.left - self.right


@record
class Explicit:
    """A line that only names something: symbol = expression (acceleration of a mass centre, moment of inertia)."""

    number: int
    symbol: sp.Symbol
    expression: sp.Expr
    words: str


def each_once(lines: Iterable[Explicit]) -> tuple[Explicit, ...]:
    """The lines without those of a letter that has one: two bodies may have one mass centre, as what is stuck in
    another one has.
    """
    return tuple({line.symbol: line for line in reversed([*lines])}.values())[::-1]


def put_together(parts: Iterable[tuple[sp.Expr, sp.Expr]], right: sp.Expr) -> tuple[tuple[sp.Expr, sp.Expr], ...]:
    """The parts of a side, force and arm, that are not zero; empty where the side is less than their sum."""
    kept = tuple((force, arm) for force, arm in parts if force * arm != 0)
    return kept if sp.Add(*(force * arm for force, arm in kept)) == right else ()
