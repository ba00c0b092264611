"""Lengths of rods that are stated beside the places of both ends: they are checked."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.setup import Earlier
from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.problem.expression import Side
from planar_cli.problem.scene import Body, Problem, Rod
from planar_cli.solve.diagnosis.words import in_unit, unit_of
from planar_cli.solve.instant.instant import Instant, make_instant

ROUNDED = Decimal("5e-4")
"""Places are drawn with some four digits: a length may differ from their distance by this part."""


def demand_lengths(problem: Problem, earlier: Mapping[str, Earlier]) -> None:
    """NoSolution: a rod is said to be longer or shorter than the distance of its ends."""
    places = {p.name for p in problem.points}
    stated: list[tuple[Body, str, str, Side]] = []
    for body in problem.bodies:
        match body.shape:
            case Rod(start, str(end), _, length) if length is not None and {start, end} <= places:
                stated.append((body, start, end, length))
    if not stated:
        return
    now: tuple[Any, ...] = problem.instant or (problem.states[0].relations if problem.states else ())
    instant = make_instant(problem, tuple(law.statement for law in problem.motion), now, dict(earlier), False)
    wrong = [found for one in stated if (found := _unfit(instant, *one)) is not None]
    if wrong:
        raise NoSolution(wrong)


def _unfit(instant: Instant, body: Body, start: str, end: str, side: Side) -> Diagnostic | None:
    scene, value = instant.scene, instant.scene.valuations[0]
    length = sp.sympify(scene.value(side))
    apart = sp.sympify(scene.length(scene.point(end) - scene.point(start)))
    if scene.rests_on_sought(apart) or scene.rests_on_sought(length):
        text = f"the length of {body.name} and the places of {start} and {end} both tell how far apart these are"
        return Diagnostic(body.mark, "PL615", text, f"leave `length` out, and state `r({end}/{start}).mag = …`")
    off = value(apart - length)
    if abs(off) <= ROUNDED * abs(value(length)):
        return None
    text = f"{body.name} does not reach from {start} to {end}"
    if not scene.ledger.symbolic:
        unit = unit_of(instant, side)
        told, between = in_unit(value(length), unit), in_unit(value(apart), unit)
        text = f"{body.name} has the length {told}, but from {start} to {end} there are {between}"
    return Diagnostic(body.mark, "PL615", text, "leave `length` out, as the places tell it, or correct a place")
