"""Where a page reasons with an instantaneous centre, it is drawn with the perpendiculars to the velocities."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest
from conftest import PROBLEMS
from worked import worked

from planar_cli.figures.illustrated import figures_of, illustrated
from planar_cli.report.document.blocks import Line, Name, Text
from planar_cli.report.document.marks import Arrow, Figure, Polyline, Spot, Tag
from planar_cli.report.page.narrate import narrate


def figure_of(stem: str, body: str) -> Figure:
    path: Path = next(p for p in PROBLEMS if p.stem == stem)
    solution = worked(path)[0]
    return dict(figures_of(illustrated(narrate(solution), solution)))[f"centre of {body}"]


def word(words: Line) -> str:
    return "".join(p.name if isinstance(p, Name) else p.text for p in words if isinstance(p, Name | Text))


def perpendicular(way: float, start: Spot, end: Spot) -> bool:
    along = (math.cos(way), math.sin(way))
    far = math.dist(start, end)
    return abs(along[0] * (end[0] - start[0]) + along[1] * (end[1] - start[1])) < 1e-9 * far


@pytest.mark.parametrize(
    ("stem", "body", "centre", "speeds"),
    [
        ("instantaneous-centre", "AB", (-0.19282, 1.2), {"v_A": 0.8, "v_B": 5.74894}),
        ("wheel-on-conveyor", "wheel", (0.0, 0.24), {"v_C": 2.0, "v_G": 0.5, "v_T": 3.0}),
        ("puck-hits-a-free-rod", "rod", (0.0, -0.3), {"v_G": 1.0}),
        ("four-bar", "BC", (0.4878, 0.8449), {"v_B": 2.0, "v_C": 1.1664}),
        ("rod-drawn-over-an-edge", "AB", (-1.6, 3.33333), {"v_A": 0.8, "v_B": 0.6835, "v_D′": 0.64}),
    ],
)
def test_velocities_are_perpendicular_to_the_ways_to_the_centre(
    stem: str, body: str, centre: Spot, speeds: dict[str, float]
) -> None:
    """By what the page asks for, by what it checks; of a motion in its state. Arrows are to one scale."""
    marks = figure_of(stem, body).panels[0].marks
    arrows = {word(m.words): m for m in marks if isinstance(m, Arrow) and re.match("v_", word(m.words))}
    dashed = {m.places[0]: m.places[1] for m in marks if isinstance(m, Polyline) and m.style == "dashed"}
    (at,) = (m.at for m in marks if isinstance(m, Tag) and word(m.words) == "I")
    assert math.dist(at, centre) < 1e-4
    assert arrows.keys() == speeds.keys()
    assert {word(m.words) for m in marks if isinstance(m, Tag)} >= {f"I{name[2:].removesuffix('′')}" for name in speeds}
    largest = max(arrows.values(), key=lambda a: a.reach)
    for name, arrow in arrows.items():
        assert dashed[arrow.at] == at
        assert perpendicular(arrow.angle, arrow.at, at)
        assert arrow.reach / largest.reach == pytest.approx(speeds[name] / max(speeds.values()), rel=0.01)
