"""The polar coordinates of a point: r from its pole, and θ from its zero."""

from __future__ import annotations

import math
from collections.abc import Iterator

from planar_cli.figures.shapes import moved
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.document.marks import Angle, Mark, Polyline, Spot, Tag

FLAT = 1e-6


def arm(pole: Spot, at: Spot, words: Line) -> Iterator[Mark]:
    """The line from the pole, with its name."""
    far, angle = math.dist(pole, at), math.atan2(at[1] - pole[1], at[0] - pole[0])
    yield Polyline((pole, at), "thin")
    yield Tag(moved(pole, angle, far / 2), words)


def turned_arm(pole: Spot, at: Spot) -> Iterator[Mark]:
    """r, and θ from the x axis, which nobody would see where it is zero."""
    far, angle = math.dist(pole, at), math.atan2(at[1] - pole[1], at[0] - pole[0])
    yield from arm(pole, at, line(Name("r")))
    if abs(angle) > FLAT:
        yield Polyline((pole, moved(pole, 0.0, far / 2)), "dashed")
        yield Angle(pole, 0.0, angle, line("-" if angle < 0 else "", Name("theta")))
