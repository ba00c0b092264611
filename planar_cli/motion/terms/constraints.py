"""What keeps coordinates, rates or accelerations: one scalar relation of places, velocities or accelerations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from planar_cli.motion.terms.layout import Column, Layout
from planar_cli.motion.terms.replacing import replaced
from planar_cli.motion.terms.terms import Term
from planar_cli.records import record


@record
class Constraint:
    """φ(q, t) = 0, or only its rate φ̇ = row · v + drift = 0, and always row · a + rest = 0."""

    joint: str
    """The joint that keeps it; "" for what the file prescribes."""
    title: str
    """What it keeps, in words."""
    place: Term | None
    """φ, where the relation is one of places."""
    rate: Term | None
    """φ̇ as a term of the state, where it is one of places or velocities."""
    row: Column
    """The coefficients of velocities in φ̇ and of accelerations in φ̈."""
    rest: Term
    """φ̈ where all accelerations are zero."""
    moving: Term
    """-φ̇ where all velocities are zero: what a drive demands of row · v."""


def of_places(layout: Layout, joint: str, title: str, place: Term) -> Constraint:
    """A relation of places and time: it is zero."""
    graph = layout.graph
    slopes = graph.gradient(place)
    drift = slopes.pop(layout.time, graph.number(0.0))
    row = {layout.numbers[v]: t for v, t in slopes.items() if not (t.constant and t.value == 0)}
    rate = drift
    for i, t in row.items():
        rate = rate + t * layout.slots[i].rate
    return Constraint(joint, title, place, rate, row, graph.rate(rate, layout.rates()), -drift)


def of_velocities(layout: Layout, title: str, rate: Term) -> Constraint:
    """A relation of velocities: it is zero. Where it is not linear in them, the row is that of the present ones."""
    graph = layout.graph
    numbers = {s.rate: i for i, s in enumerate(layout.slots)}
    row = coefficients(rate, numbers, layout)
    moving = graph.number(0.0)
    for i, t in row.items():
        moving = moving + t * layout.slots[i].rate
    return Constraint("", title, None, rate, row, graph.rate(rate, layout.rates()), moving - rate)


def of_accelerations(layout: Layout, title: str, second: Term, accelerations: Sequence[Term]) -> Constraint:
    """A relation that is linear in the accelerations, in which these are variables: it is zero."""
    zero = layout.graph.number(0.0)
    row = coefficients(second, {a: i for i, a in enumerate(accelerations)}, layout)
    rest = replaced(second, dict.fromkeys(accelerations, zero))
    return Constraint("", title, None, None, row, rest, zero)


def coefficients(term: Term, numbers: Mapping[Term, int], layout: Layout) -> dict[int, Term]:
    """∂term/∂variable, by the number of the variable."""
    slopes = layout.graph.gradient(term)
    return {numbers[v]: t for v, t in slopes.items() if v in numbers and not (t.constant and t.value == 0)}
