"""Blocks with ropes or forces along the ground: the ground is under them, and ends where a rope goes down."""

from __future__ import annotations

import math

import pytest
from test_figures_bodies import drawings

from planar_cli.figures.sunk import MIDDLE, sunk
from planar_cli.report.document.lines import line
from planar_cli.report.document.marks import Angle, Arc, Arrow, Hatched, Mark, Polyline, Symbol

GROUND = Hatched(((-1.0, 0.0), (3.0, 0.0)))
BLOCK = Symbol("block", (0.0, 0.0), 0.0)
ROPE = Polyline(((0.0, 0.0), (2.0, 0.0)), "rope")
FORCE = Arrow((0.0, 0.0), 0.4, "force", line("P"))


def asides(*marks: Mark) -> list[float]:
    return [m.aside for m in sunk(marks) if isinstance(m, Hatched | Symbol)]


def test_the_ground_is_under_a_block_that_is_pulled() -> None:
    assert asides(GROUND, BLOCK, ROPE) == asides(GROUND, BLOCK, FORCE) == [-MIDDLE, -MIDDLE]


def test_what_is_not_pulled_or_shares_its_ground_stays() -> None:
    wheel = Arc((1.0, 0.5), 0.5, "body")
    aslant = Hatched(((3.0, 0.0), (4.0, 1.0)))
    upward = Polyline(((0.0, 0.0), (0.0, 2.0)), "rope")
    assert asides(GROUND, BLOCK, upward) == asides(GROUND, BLOCK, ROPE, wheel) == [0.0, 0.0]
    assert asides(GROUND, BLOCK, FORCE, aslant) == [0.0, 0.0, 0.0]


def test_the_ground_ends_before_a_wheel_over_which_the_rope_goes_down() -> None:
    for reach in (1.0, 3.0):
        short = Hatched(((-1.0, 0.0), (reach, 0.0)))
        ground = sunk([short, BLOCK, ROPE, Arc((2.0, -0.1), 0.1, "rope", math.pi / 2, -math.pi / 2)])[0]
        assert isinstance(ground, Hatched)
        assert 1.8 < ground.places[1][0] < 1.9


def test_the_angle_of_a_slope_stays_at_its_foot() -> None:
    found = sunk([GROUND, BLOCK, FORCE, Angle((-1.0, 0.0), 0.0, 0.3, line("beta"))])
    assert isinstance(found[3], Angle)
    assert (round(found[3].shift[0], 6), found[3].shift[1]) == (0.0, -MIDDLE)


def test_a_load_on_a_pulley_hangs_under_it() -> None:
    """On the axle itself, or on a light rod; a bob at the end of a rod is seen as a mass."""
    table = drawings("block-on-a-table-and-a-moving-pulley")["scene"].panels[0].marks
    assert (0.15, pytest.approx(-1.16)) in [m.at for m in table if isinstance(m, Symbol) and m.kind == "block"]
    hoist = drawings("hoist-with-moving-pulley")["scene"].panels[0].marks
    assert [m.at for m in hoist if isinstance(m, Symbol) and m.kind == "block"] == [(0.0, -0.8)]
    swing = drawings("swing-from-which-the-cord-just-holds")["scene"].panels[0].marks
    assert {m.kind for m in swing if isinstance(m, Symbol)} == {"particle", "support", "point", "place"}


def test_the_light_rod_between_two_bodies_of_a_group_is_in_its_diagrams() -> None:
    group = drawings("hoist-with-moving-pulley")["pulley, load"]
    for panel in group.panels:
        assert [m.places for m in panel.marks if isinstance(m, Polyline) and m.style == "thin"] == [
            ((0.0, 0.0), (0.0, -0.8))
        ]
