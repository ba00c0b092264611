"""Guides that hold nothing, and fixed places over which a rod slides and turns."""

from __future__ import annotations

import pytest
from test_figures_bodies import drawings

from planar_cli.report.marks import Hatched, Slot, Symbol


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
