"""Guides that hold nothing, and fixed places over which a rod slides and turns."""

from __future__ import annotations

import pytest
from test_figures_bodies import drawings

from planar_cli.report.document.blocks import Name, line
from planar_cli.report.document.marks import Arrow, Dimension, Hatched, Polyline, Slot, Span, Spot, Symbol, Tag


@pytest.mark.parametrize("name", ["energy/weight-dropped-on-nested-springs", "oscillations/block-hung-on-a-spring"])
def test_a_weight_on_springs_needs_no_slot(name: str) -> None:
    marks = drawings(name)["scene"].panels[0].marks
    assert not [m for m in marks if isinstance(m, Slot | Hatched)]
    (block,) = (m for m in marks if isinstance(m, Symbol) and m.kind == "block")
    assert block.angle == (0.0 if "dropped" in name else pytest.approx(3.14159265)), "on what holds it, or under it"


def test_the_end_of_a_cable_that_is_drawn_straight_out_is_no_slider() -> None:
    marks = drawings("textbook/ex-1-09")["scene"].panels[0].marks
    assert not [m for m in marks if isinstance(m, Slot)]
    assert not [m for m in marks if isinstance(m, Symbol) and m.kind in ("slider", "particle")]


def test_a_slanting_spring_presses_its_collar_on_the_guide() -> None:
    assert [m for m in drawings("energy/collar-with-a-slanting-spring")["scene"].panels[0].marks if isinstance(m, Slot)]


def test_a_rod_that_slides_over_a_fixed_place_may_turn_there() -> None:
    marks = drawings("kinematics/rod-drawn-over-an-edge")["scene"].panels[0].marks
    (sleeve,) = (m for m in marks if isinstance(m, Symbol) and m.kind == "slider" and m.at == (0.0, 1.2))
    assert [m for m in marks if isinstance(m, Symbol) and m.kind == "support" and m.at == sleeve.at]
    assert not [m for m in marks if isinstance(m, Slot) and m.start == sleeve.at]


def test_what_touches_a_guided_body_leaves_no_room_for_ground() -> None:
    floors = [m for m in drawings("kinematics/gear-between-racks")["scene"].panels[0].marks if isinstance(m, Hatched)]
    assert [y for f in floors for _, y in f.places] == [0.0, 0.0], "under the gear, and none between it and its rack"


def test_an_axis_of_turning_is_a_chain_line_on_no_floor() -> None:
    marks = drawings("particles/sphere-on-two-wires-in-a-circle")["scene"].panels[0].marks
    assert not [m for m in marks if isinstance(m, Hatched)]
    (axis,) = (m for m in marks if isinstance(m, Polyline) and m.style == "chain")
    assert {m.at for m in marks if isinstance(m, Symbol) and m.kind == "wall"} == {*axis.places}
    assert line(Name("x_C")) in [m.words for m in marks if isinstance(m, Dimension)]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "ball", "way"),
    [
        ("textbook/ex-4-14", "C", (-1.0, 0.0)),
        ("impact/dumbbell-hit-by-a-ball", "C", (-1.0, 0.0)),
        ("impact/ball-hits-a-hanging-rod", "ball", (-1.0, 0.0)),
        ("impact/ball-on-a-sliding-wedge", "ball", (0.0, 1.0)),
    ],
)
def test_a_striker_stands_beside_what_it_strikes_where_it_comes_from(name: str, ball: str, way: Spot) -> None:
    marks = drawings(name)["scene"].panels[0].marks
    (arrow,) = (m for m in marks if isinstance(m, Arrow) and m.style == "velocity")
    (tag,) = (m for m in marks if isinstance(m, Tag) and m.words == line(Name(ball)))
    assert arrow.inward, "it ends at the ball"
    away = (arrow.at[0] - tag.at[0], arrow.at[1] - tag.at[1])
    assert away[0] * way[0] + away[1] * way[1] > 0
    balls = [m.at for m in marks if isinstance(m, Symbol) and m.kind == "particle"]
    assert len(balls) == len(set(balls)), "none on another one"


def test_a_dumbbell_keeps_its_balls_in_later_states() -> None:
    marks = drawings("impact/dumbbell-hit-by-a-ball")["scene"].panels[0].marks
    (rod,) = (m for m in marks if isinstance(m, Polyline) and m.style == "hidden")
    assert {*rod.places} <= {m.at for m in marks if isinstance(m, Symbol) and m.kind == "place"}


def test_what_is_asked_at_a_time_is_drawn_at_that_time() -> None:
    (pin,) = {m.at for m in drawings("textbook/ex-1-14")["scene"].panels[0].marks if getattr(m, "kind", "") == "slider"}
    assert pin == pytest.approx((-0.26744, 0.5), abs=1e-4), "0.5 m / tan(118.14 deg)"


def test_a_file_of_points_alone_has_its_lines_and_the_vectors_that_are_asked() -> None:
    marks = drawings("textbook/ex-1-02")["scene"].panels[0].marks
    assert len([m for m in marks if isinstance(m, Polyline) and m.style == "thin"]) == 7, "OC, and OA, AB, CB twice"
    assert [m.words for m in marks if isinstance(m, Span)] == [line(Name("r_A2/A")), line(Name("r_B2/B"))]
