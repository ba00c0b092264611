"""Lengths that the text gives and the file has as differences or sides; and guides of one body on one line."""

from __future__ import annotations

import math

from test_figures_bodies import drawings

from planar_cli.report.document.blocks import Name, Value, line
from planar_cli.report.document.marks import Arc, Dimension, Slot, Tag


def lengths(stem: str) -> list[tuple[str, float]]:
    marks = drawings(stem)["scene"].panels[0].marks
    numbers = [(m, p) for m in marks if isinstance(m, Dimension) for p in m.words if isinstance(p, Value)]
    return sorted((f"{p.number} {p.unit}", round(math.dist(m.start, m.end), 4)) for m, p in numbers)


def test_distances_of_points_that_the_text_gives_are_dimensioned() -> None:
    foot = 1.0
    door = lengths("sliding-door-with-a-seized-roller")
    assert door == [(f"{n} ft", n * foot) for n in (3, 5, 5, 6, 8)]
    assert lengths("rear-wheel-drive") == [("1.4 m", 1.4), ("2.5 m", 2.5)]


def test_two_guides_of_a_body_on_one_line_are_one_track() -> None:
    marks = drawings("sliding-door-with-a-seized-roller")["scene"].panels[0].marks
    assert {(m.start, m.end) for m in marks if isinstance(m, Slot)} == {((-2.5, 4.0), (2.5, 4.0))}


def test_a_part_is_drawn_well_smaller_than_the_whole() -> None:
    """`assume: [r < R]`: the centre of the trough is outside the cylinder."""
    marks = drawings("cylinder-in-a-trough")["scene"].panels[0].marks
    (rim,) = [m for m in marks if isinstance(m, Arc)]
    (center,) = [m.at for m in marks if isinstance(m, Tag) and m.words == line(Name("O"))]
    assert math.dist(center, rim.center) > rim.radius
