"""Graphs of motions that are integrated in closed form: the very numbers of the page, on curves from state to state."""

from __future__ import annotations

import itertools
import math

import pytest
from figure_demands import demand_figure
from test_figures import illustrated_page
from test_graphs import graphs_of, path_of

from planar_cli.figures.illustrated import figures_of
from planar_cli.formats._labels import clashes
from planar_cli.formats._paper import runs_of
from planar_cli.formats._svg import papers_of
from planar_cli.report.document.graphs import Graph
from planar_cli.report.document.lines import Line
from planar_cli.report.document.marks import Polyline, Symbol


def courses(stem: str) -> list[Graph]:
    return [
        g for name, f in figures_of(illustrated_page(path_of(stem))) if name.startswith("motion") for g in graphs_of(f)
    ]


def told(line: Line) -> str:
    return "".join(run.text for run in runs_of(line))


@pytest.mark.parametrize(
    ("stem", "ups"),
    [
        ("car-three-phases", ["a", "v", "x"]),
        ("parachutist", ["a", "v", "s"]),
        ("block-coming-to-rest-by-dry-friction", ["a", "v", "x"]),
        ("block-force-table", ["a", "v", "x"]),
        ("body-rotor-torque-table", ["α", "ω", "θ"]),
        ("damped-block-three-ways", 3 * ["x\u0308", "x\u0307", "x"]),
    ],
)
def test_acceleration_velocity_and_place_stand_over_each_other(stem: str, ups: list[str]) -> None:
    graphs = courses(stem)
    assert [told(g.up.words) for g in graphs] == ups
    for _, figure in figures_of(illustrated_page(path_of(stem))):
        if graphs_of(figure):
            assert len({(g.across.low, g.across.high) for g in graphs_of(figure)}) == 1
            assert not any(clashes(paper) for paper in papers_of(figure))
            demand_figure(figure)


def test_a_curve_is_the_closed_form() -> None:
    """Up with a drag that grows as v²: s = v_t²/g ln(cos(φ - g t/v_t)/cos φ) with tan φ = v_0/v_t."""
    place = courses("ball-up-with-drag")[2]
    (curve,) = place.curves
    v_t = math.sqrt(9.81 / 0.008)
    phi = math.atan(30.0 / v_t)
    for t, s in curve.pieces[0][::20]:
        assert s == pytest.approx(v_t**2 / 9.81 * math.log(math.cos(phi - 9.81 * t / v_t) / math.cos(phi)), abs=2e-5)


def test_what_was_found_stands_at_its_state() -> None:
    a, v, x = courses("train-between-stations")
    assert [told(d.words) for d in a.dots] == ["start", "brake", "stop"]
    assert told(v.dots[1].words) == "brake: 114.5 km/h"
    assert told(x.dots[2].words) == "stop: t = 105.7 s"
    assert [len(c.pieces) for c in a.curves] == [2]


def test_a_time_since_the_start_stands_at_its_end() -> None:
    *_, place = courses("car-three-phases")
    assert told(place.dots[-1].words) == "stop: 1469 m, t = 70 s"


def test_two_that_meet_share_their_graph() -> None:
    *_, place = courses("police-chase")
    assert [told(c.words) for c in place.curves] == ["xB", "xA"]
    assert place.curves[0].pieces[-1][-1] == pytest.approx(place.curves[1].pieces[-1][-1], rel=1e-6)
    assert told(place.dots[-1].words) == "meet: t = 18.79 s, 563.6 m"


@pytest.mark.parametrize("stem", ["ex-1-11", "hoist-driven-by-a-belt"])
def test_one_constant_acceleration_has_no_graph(stem: str) -> None:
    assert courses(stem) == []


@pytest.mark.parametrize(
    ("stem", "on_it"),
    [("shell-in-air-that-hits-after-three-seconds", -1), ("satellite-to-a-second-point-in-forty-minutes", None)],
)
def test_a_way_is_drawn_where_the_speed_was_found_by_trial(stem: str, on_it: int | None) -> None:
    """It ends where the motion does; an orbit is drawn whole, and passes there."""
    marks = dict(figures_of(illustrated_page(path_of(stem))))["scene"].panels[0].marks
    (way,) = [m for m in marks if isinstance(m, Polyline) and m.style == "way"]
    (end,) = [m.at for m in marks if isinstance(m, Symbol) and m.kind == "place"]
    assert len(way.places) > 30
    if on_it is not None:
        assert way.places[on_it] == pytest.approx(end, rel=1e-5)
    else:
        pairs = list(itertools.pairwise(way.places))
        longest = max(math.dist(a, b) for a, b in pairs)
        detour = min(math.dist(a, end) + math.dist(end, b) - math.dist(a, b) for a, b in pairs)
        assert detour < 0.01 * longest
