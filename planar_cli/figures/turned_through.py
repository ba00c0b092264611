"""Angles through which bodies turn about fixed pins from state to state, where they are asked."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from planar_cli.figures.partners import pivot_of
from planar_cli.figures.positions import Later
from planar_cli.figures.rings import way_of
from planar_cli.problem.language.expression import Binary, Quantity, Side
from planar_cli.problem.scene.scene import Problem
from planar_cli.report.document.blocks import Name, line
from planar_cli.report.document.marks import Angle

WIDE = 46.0
"""The radius of their arcs, px: beyond that of an angle from an axis."""
NEAR = 1e-6


def turned_through(where: Mapping[str, Later], problem: Problem) -> Iterator[Angle]:
    """`where`: the states that are drawn to scale."""
    for find in problem.find:
        what = find.found.what
        if not isinstance(what, Binary) or what.operator != "-":
            continue
        (body, state), (other, first) = _angle(what.left), _angle(what.right)
        if not body or body != other or state not in where or first not in where:
            continue
        begin, end = where[first], where[state]
        pivot = pivot_of(begin.there, body)
        angles = begin.angles.get(body), end.angles.get(body)
        if pivot is None or None in angles or math.dist(pivot, begin.at(body)) < NEAR:
            continue
        start, stop = way_of(pivot, begin.at(body)), way_of(pivot, end.at(body))
        sweep = math.remainder(stop - start, 2 * math.pi)
        # What turns farther than half round is not seen in two positions.
        if angles[0] is not None and angles[1] is not None and abs(angles[1] - angles[0] - sweep) < NEAR < abs(sweep):
            yield Angle(pivot, start, sweep, line(Name(find.name)), WIDE)


def _angle(side: Side) -> tuple[str, str]:
    """Of which body, and in which state, it is the angle; "": it is something else."""
    if isinstance(side, Quantity) and side.word == "theta" and len(side.things) == 1 and isinstance(side.at, str):
        return side.things[0], side.at
    return "", ""
