"""Strokes of usual kinds on paper: what is moved, arcs, hatching, arrows."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

from planar_cli.formats._paper import Disc, Spot, Stroke, Words

HEAD, WING = 9.0, 3.6
"""The length of an arrow head, and half its width."""
TICK, EVERY = 7.0, 7.0
"""Hatching."""
STEP = math.radians(6)
LATER, WAY = "hidden", "way"
"""The style of a position that a body has later, its outline alone, and of the way there."""
Piece = Stroke | Disc | Words


def moved(start: Spot, angle: float, ahead: float, left: float = 0.0) -> Spot:
    """On paper: the place `ahead` in a direction (counterclockwise as seen), and `left` of it."""
    cos, sin = math.cos(angle), math.sin(angle)
    return start[0] + ahead * cos - left * sin, start[1] - ahead * sin - left * cos


def arc(center: Spot, radius: float, start: float, sweep: float) -> tuple[Spot, ...]:
    """Places along an arc on paper, angles counterclockwise as seen."""
    count = max(int(abs(sweep) / STEP), 2)
    return tuple(moved(center, start + sweep * i / count, radius) for i in range(count + 1))


def hatching(places: tuple[Spot, ...], right: float = 1.0) -> Iterator[Piece]:
    """Short strokes on the right of the way along some places, or on the left (-1)."""
    rest = EVERY / 2
    for (x0, y0), (x1, y1) in pairwise(places):
        length = math.hypot(x1 - x0, y1 - y0)
        angle = math.atan2(-(y1 - y0), x1 - x0)
        while rest < length:
            at = moved((x0, y0), angle, rest)
            yield Stroke((at, moved(at, angle, -TICK * 0.7, -TICK * right)), "hatch")
            rest += EVERY
        rest -= length


def pointed(places: tuple[Spot, ...], kind: str, shaft: str = "") -> Iterator[Piece]:
    """A line with an arrow head at its end. `shaft`: what the kind of the line alone has more."""
    (x0, y0), tip = places[-2:]
    angle = math.atan2(y0 - tip[1], tip[0] - x0)
    # A short arrow has a small head.
    part = min(math.hypot(tip[0] - x0, tip[1] - y0) / HEAD, 1.0) if len(places) == 2 else 1.0
    head, wing = HEAD * part, WING * part
    yield Stroke((*places[:-1], moved(tip, angle, -head * 0.8)), kind + shaft)
    yield Stroke((tip, moved(tip, angle, -head, wing), moved(tip, angle, -head, -wing)), f"{kind} head", True)
