"""What the head of a page gives: every number on which an equation rests, though the equation hides it."""

from __future__ import annotations

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem


def _page(name: str) -> str:
    page = Terminal(width=200).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))
    return " ".join(page.split())


@pytest.mark.parametrize(
    ("name", "data"),
    [
        ("systems/four-bar-driving-torque", ["g = 9.81 m/s²", "ω_AB = 12 rad/s"]),
        ("systems/gas-force-on-piston", ["g = 9.81 m/s²", "ω_crank = 30 rad/s"]),
        ("systems/double-planet-train", ["ω_sun = 1200 rpm"]),
        ("textbook/ex-4-16", ["g = 9.81 m/s²"]),
        # Only the check has the weight: N_C = m g = 490.5 N > 0.
        ("textbook/ex-4-05", ["g = 9.81 m/s²"]),
    ],
)
def test_weights_and_drives_in_numbers(name: str, data: list[str]) -> None:
    given = _page(name).split("Given ")[1].split(" Find ")[0]
    for one in data:
        assert one in given


def test_a_unit_is_no_letter() -> None:
    """The metre of N m is no mass."""
    assert "60 kg" not in _page("momentum/pipe-bend").split(" Find ")[0]


def test_a_body_without_mass_has_no_acceleration() -> None:
    assert "a_G,arm" not in _page("systems/double-planet-train")


def test_a_direction_that_is_an_axis_is_said() -> None:
    assert "Answer a_A = 8.175 m/s² downward" in _page("textbook/ex-4-16")


def test_a_table_of_what_is_asked() -> None:
    """What stays where it is has no column."""
    page = _page("motion/dog-that-runs-at-a-cyclist")
    assert "t in s x(cyclist) in m x(dog) in m y(dog) in m" in page
    assert "y(cyclist)" not in page


BOB = """
title: Bob of a pendulum
plane: vertical
given: {l: 2 m}
points: {O: [0, 0], B: {from: O, distance: l, angle: -60 deg}}
bodies: {bob: {particle: B, mass: any}}
joints: [rope: {path: [O, B], name: cord}]
instant: [tension(cord) = 2.5*mass(bob)*g]
find: {v: v(bob).mag}
"""
BIKE = """
title: Velocity that grows with the way
bodies: {bike: {particle: [0, 0]}}
joints: [guide: {point: bike, along: 0 deg, name: road}]
motion: [v(bike).x = 0.2 1/s * x(bike) + 5 m/s during 0->full, a(bike).x = 0 during full->end]
states: {0: [t = 0], full: [x(bike) = 100 m], end: [x(bike) = 300 m]}
find: {t_end: t @ end}
"""
SHELL = """
title: A shell
plane: vertical
points: {O: [0, 0]}
bodies: {shell: {particle: O, mass: any}}
states:
  fire: [t = 0, v(shell).x = 100 ft/s, v(shell).y = 64 ft/s]
  land: [y(shell) = 0, t > 0]
find: {t: t @ land in s}
"""


@pytest.mark.parametrize(
    ("text", "datum"),
    [
        (BOB, "the tension in cord = 2.5 m g"),
        (BIKE, "v = 0.2 1/s · x + 5 m/s from 0 to full, a = 0 from full to end"),
        (SHELL, "g = 32.19 ft/s²"),
    ],
)
def test_what_the_page_rests_on_is_given(text: str, datum: str) -> None:
    page = " ".join(Terminal(200).render(narrate(solve_problem(load_text(text)[0]))).split())
    assert datum in page.partition("Find")[0]


@pytest.mark.slow
def test_lengths_that_only_place_what_is_drawn_are_said_to() -> None:
    given = _page("textbook/ex-4-18").split("Given ")[1].split(" Find ")[0]
    assert "M = 10 N·m; frame: mass centre G" in given
    assert "frame: mass centre G; rear: centre O_A, on road at A; front: centre O_B, on road at B; 1: at rest" in given
    # The way down is h, and what is read off a motion that is followed may rest on anything.
    assert "whatever" not in _page("impact/pile-driver")
    assert "whatever" not in _page("hard/two-rods-of-unlike-mass")


def test_a_letter_g_on_which_nothing_rests_is_not_given() -> None:
    """The distance D is a letter, the speeds are numbers, and g is the same for both."""
    assert "D; B(0, 0)" in _page("textbook/ex-1-15")
