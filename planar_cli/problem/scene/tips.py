"""The end of a rod, or the corner of a plate, with which a body stands on a straight edge or on the ground."""

from __future__ import annotations

from typing import Any

from planar_cli.errors import refuse
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import Plate, Point, Tip

LEVEL = 1e-9
"""Ends whose heights differ by less than this part of their distance lie level."""


def tip(point: Point, place: Tip, numbers: Any, edge: tuple[Vec, Vec] | None) -> Vec:
    """The place of the tip that stands on the edge; `edge`: a point of it and its direction, None for the ground.

    A plate that lies flush stands with the middle of that edge. FileProblem where no end of a rod is there, or both.
    """
    tips = [numbers.point(end) for end in place.ends] if place.plate is None else _corners(place.plate, numbers)
    if edge is not None:
        base, along = edge
        there = [t for t in tips if numbers.is_nothing((t - base).cross(along))]
    else:
        there = _lowest(tips, numbers)
    if len(there) == 1:
        return there[0]
    if place.plate is not None and edge is not None:
        # Where no corner is on the edge either, the contact itself tells by how much it is off.
        base, along = edge
        foot: Vec = base + along * (numbers.point(place.plate.center) - base).dot(along)
        return foot
    if place.plate is not None and len(there) == 2:
        middle: Vec = (there[0] + there[1]) / numbers.number(2)
        return middle
    what = place.on or "the ground"
    if not there:
        text = f"neither end of {place.body} is on {what}"
        raise refuse(point.mark, "PL535", text, "say where they touch: `at: A`, or correct the place of the line")
    text = f"both ends of {place.body} are on {what}"
    raise refuse(point.mark, "PL535", text, "say with which it touches, `at: A`; where both do, write two")


def _corners(plate: Plate, numbers: Any) -> list[Vec]:
    """The four corners of a plate."""
    center = numbers.point(plate.center)
    one, nothing = numbers.number(1), numbers.number(0)
    along = Vec(one, nothing) if plate.angle is None else numbers.unit_vector(numbers.value(plate.angle))
    ahead = along * (numbers.value(plate.width) / numbers.number(2))
    above = along.turned() * (numbers.value(plate.height) / numbers.number(2))
    return [center + ahead + above, center - ahead + above, center - ahead - above, center + ahead - above]


def _lowest(tips: list[Vec], numbers: Any) -> list[Vec]:
    """Those of which no other lies below; all of them where letters leave their heights open."""
    return [t for t in tips if not any(_is_below(other, t, numbers) for other in tips if other is not t)]


def _is_below(one: Vec, other: Vec, numbers: Any) -> bool:
    apart = numbers.apart(other - one)
    return apart is not None and apart[1] > LEVEL * (abs(apart[0]) + abs(apart[1]))
