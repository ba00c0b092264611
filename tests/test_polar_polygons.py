"""Polygons in polar coordinates: the parts along r and across it, the Coriolis part among them, add up."""

from __future__ import annotations

import math

import pytest
from figure_demands import demand_figure
from test_figures import illustrated_page
from test_graphs import path_of

from planar_cli.figures.illustrated import figures_of
from planar_cli.formats._paper import runs_of
from planar_cli.report.document.marks import Figure, Span


def polygon(stem: str, name: str) -> Figure:
    return dict(figures_of(illustrated_page(path_of(stem))))[name]


def spans(figure: Figure, panel: int = 0) -> dict[str, Span]:
    told = (m for m in figure.panels[panel].marks if isinstance(m, Span))
    return {"".join("".join(r.text for r in runs_of(s.words)).split()): s for s in told}


def length(span: Span) -> float:
    return math.dist(span.start, span.end)


def test_the_coriolis_part_stands_in_the_polygon() -> None:
    """A collar 0.5 m out, at 0.6 m/s and -0.2 m/s² along a rod at 4 rad/s and -3 rad/s²."""
    figure = polygon("collar-on-rotating-rod", "accelerations")
    found = spans(figure)
    by = {name: round(length(s), 6) for name, s in found.items()}
    assert by["rω²"] == pytest.approx(0.5 * 4**2)
    assert by["rα"] == pytest.approx(0.5 * 3)
    assert by["2r\u0307ω"] == pytest.approx(2 * 0.6 * 4)
    whole = found["aP"]
    assert math.dist(whole.end, found["2r\u0307ω"].end) < 1e-9
    demand_figure(figure)


def test_velocity_along_r_and_across_it() -> None:
    found = spans(polygon("collar-on-rotating-rod", "velocities"))
    (along, across) = (found["r\u0307"], found["rω"])
    assert length(along) == pytest.approx(0.6)
    assert length(across) == pytest.approx(2.0)
    turned = [math.atan2(s.end[1] - s.start[1], s.end[0] - s.start[0]) for s in (along, across)]
    assert math.degrees(turned[1] - turned[0]) == pytest.approx(90)


def test_components_that_a_page_tells_alone() -> None:
    """r = 2 + t/2, θ = t²/5 at t = 2: 3 · 0.8² inward, 3 · 0.4 and 2 · 0.5 · 0.8 across."""
    sizes = sorted(length(s) for s in spans(polygon("polar-motion", "accelerations")).values())
    assert sizes == pytest.approx([0.8, 1.2, 1.92, math.hypot(1.92, 2.0)])


def test_a_polygon_closes_where_the_page_takes_it_across_what_it_does_not_need() -> None:
    """a_C of the roller is a_B and both parts about it, also the one with α, which no answer needs."""
    figure = polygon("eccentric-cam-with-roller-follower", "accelerations")
    found = spans(figure)
    (whole,) = (s for name, s in found.items() if name.endswith("roller") and name.startswith("a"))
    (turned,) = (s for name, s in found.items() if name.startswith("ω"))
    assert math.dist(whole.end, turned.end) < 0.03 * length(whole)


def test_accelerations_of_a_moving_frame_in_its_states() -> None:
    figure = polygon("body-oscillating-arm", "accelerations")
    assert len(figure.panels) > 1
    demand_figure(figure)
