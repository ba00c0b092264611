"""What the head of a page gives: every number on which an equation rests, though the equation hides it."""

from __future__ import annotations

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.narrate import narrate


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
    page = _page("systems/planetary-gear-with-three-planets")
    assert "t in s theta(sun) in ° theta(spider) in °" in page
    assert "x(planet_A)" not in page
