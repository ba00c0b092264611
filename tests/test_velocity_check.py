"""Velocities of one instant are checked by the instantaneous centre, a second point, or polar coordinates."""

from __future__ import annotations

import re

import pytest
from worked import page_of_file


@pytest.mark.parametrize("stem", ["four-bar", "slider-crank-offset"])
def test_both_points_turn_about_the_centre(stem: str) -> None:
    found = re.findall(r"v_\w/I\w = ([\d.]+)/([\d.]+) = ([\d.]+) rad/s", page_of_file(stem))
    assert len(found) == 2
    for speed, arm, spin in found:
        assert float(speed) / float(arm) == pytest.approx(float(spin), rel=2e-3)
    assert found[0][2] == found[1][2]


def test_the_difference_of_two_velocities() -> None:
    found = re.search(r"\(v_C - v_P\)/PC = \((\S+) ([+-]) (\S+)\)/(\S+) = (\S+) rad/s", page_of_file("planetary-gear"))
    assert found is not None
    first, sign, last, arm, spin = found.groups()
    assert (float(first) + float(sign + last)) / float(arm) == pytest.approx(float(spin), rel=2e-3)


@pytest.mark.parametrize("stem", ["quick-return", "ex-2-09"])
def test_polar_coordinates_about_the_pin(stem: str) -> None:
    found = re.search(
        r"= √\((\S+)² \+ \((\S+) · (\S+)\)²\) = (\S+) m/s; v_\w = ω r about \w = (\S+) · (\S+) = ", page_of_file(stem)
    )
    assert found is not None
    relative, spin, arm, speed, other, radius = (float(x) for x in found.groups())
    assert (relative**2 + (spin * arm) ** 2) ** 0.5 == pytest.approx(speed, rel=2e-3)
    assert other * radius == pytest.approx(speed, rel=2e-3)


def test_none_of_a_body_on_a_fixed_pin() -> None:
    assert "instantaneous centre of" not in page_of_file("half-disk-swinging")


def test_a_point_of_a_body_that_translates() -> None:
    """The stem of a cam carries the pin of its roller, which rolls on the cam below."""
    page = page_of_file("eccentric-cam-with-roller-follower")
    assert "instantaneous centre of roller: " in page
    assert page.count("= 54.64 rad/s") >= 2


def test_where_the_centre_is_the_road_both_ends_keep_their_distance() -> None:
    """A check by the same centre would be the solution again."""
    found = re.search(
        r"Check along AB, e = .*v_A · e = .* = ([\d.]+) m/s, v_B · e = .* = ([\d.]+) m/s",
        page_of_file("instantaneous-centre"),
    )
    assert found is not None
    assert found[1] == found[2]
