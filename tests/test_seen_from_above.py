"""Tracks seen from above, tracks that end, the ground behind them, and the lengths of ways."""

from __future__ import annotations

import math

import pytest
from test_figures_bodies import drawings as of_file

from planar_cli.figures.illustrated import figures_of, illustrated
from planar_cli.problem.structure import load_text
from planar_cli.report.document.marks import Figure, Hatched, Polyline, Span, Symbol, Tag
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

ROAD = """
title: Van on a round road
text: A van slows down on a round road of 50 m radius at 2 m/s^2, from 15 m/s at 1; 2 is 40 m farther on.
points: {O: [0, 0], P: {from: O, distance: 50 m, angle: -90 deg}}
surfaces: {road: {center: O, radius: 50 m}}
bodies: {van: {particle: P}}
joints: [guide: {point: P, along: road}]
motion: [a(P).t = -2 m/s^2]
states:
  1: [t = 0, v(P).x = 15 m/s]
  2: [path_length(P) @ 1->2 = 40 m]
find: {a_1: a(P).mag @ 1, v_2: v(P).mag @ 2}
"""
CHUTE = """
title: Bead off a chute
text: A bead is let go at A of a round chute, leaves it level at the lowest place and falls to the floor.
plane: vertical
given: {R: 2 m, h: 1 m}
points: {A: [-R, h + R], E: [0, h + R]}
surfaces: {chute: {center: E, radius: R}}
bodies: {bead: {particle: A, mass: any}}
joints: [guide: {point: A, along: chute, during: rim->edge}]
states: {rim: [at rest], edge: [x(bead) = 0], floor: [y(bead) = 0]}
find: {d: x(bead) @ floor}
"""


def drawings(text: str) -> dict[str, Figure]:
    problem, wrong = load_text(text, "scene.yaml")
    assert problem is not None, wrong
    solution = solve_problem(problem)
    return dict(figures_of(illustrated(narrate(solution), solution)))


def test_a_road_in_plan_is_no_bowl() -> None:
    drawn = drawings(ROAD)
    marks = drawn["scene"].panels[0].marks
    assert not [m for m in marks if isinstance(m, Hatched)]
    (road,) = (m for m in marks if isinstance(m, Polyline) and m.style == "lane")
    assert [math.dist(s, (0.0, 0.0)) for s in road.places] == pytest.approx([50.0] * len(road.places))
    assert [m.at for m in marks if isinstance(m, Symbol) and m.kind == "slider"] == [(0.0, -50.0)]


def test_the_length_of_a_bent_way_stands_at_its_middle() -> None:
    marks = drawings(ROAD)["scene"].panels[0].marks
    middle = [m.at for m in marks if isinstance(m, Tag) and "40" in str(m.words)]
    assert middle == [pytest.approx((50 * math.sin(0.4), -50 * math.cos(0.4)), abs=0.01)]


def test_the_size_of_an_acceleration_on_a_curve_is_drawn_with_its_parts() -> None:
    panel = drawings(ROAD)["vectors of P"].panels[-1]
    assert len([m for m in panel.marks if isinstance(m, Span) and m.style == "acceleration"]) == 3


def test_a_track_that_is_left_ends_there_and_the_ground_lies_under_the_fall() -> None:
    marks = drawings(CHUTE)["scene"].panels[0].marks
    chute, floor = sorted((m.places for m in marks if isinstance(m, Hatched)), key=len, reverse=True)
    assert sorted((chute[0], chute[-1])) == [pytest.approx((-2.0, 3.0)), pytest.approx((0.0, 1.0))]
    assert {y for _, y in floor} == {0.0}


def test_a_ring_in_which_gears_roll_is_no_road() -> None:
    marks = of_file("kinematics/two-planetary-stages")["scene"].panels[0].marks
    assert not [m for m in marks if isinstance(m, Polyline) and m.style == "lane"]
    assert [m for m in marks if isinstance(m, Hatched)]
