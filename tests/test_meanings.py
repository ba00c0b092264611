"""What the coordinates are that the machine brings stands where the first of their letters occurs, once."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(
    ("stem", "words"),
    [
        ("ex-4-10", "θ: the angle of AB from the x axis, counterclockwise"),
        ("ex-4-08", "θ: the angle by which the spool has turned, clockwise"),
        (
            "reaction-wheel",
            "θ_satellite, θ_wheel: the angles by which the satellite and the wheel have turned, counterclockwise",
        ),
        ("slider-crank-with-a-spring", "θ_crank, θ_AB: the angles of OA and AB from the x axis, counterclockwise"),
        ("car-on-a-circle", "s_A: the way of A along its path, from where it is drawn"),
        ("cylinder-that-rolls-off-a-cylinder", "φ: the angle of OG from the vertical, counterclockwise"),
        ("block-down-a-free-wedge", "s_P: the way of P along its path, from where it is drawn"),
    ],
)
def test_a_coordinate_of_the_machine_is_defined_once(stem: str, words: str) -> None:
    assert page_of_file(stem).count(words) == 1


@pytest.mark.parametrize("stem", ["ex-4-11", "ex-1-07", "block-down-a-rough-quarter-circle"])
def test_coordinates_of_the_file_and_places_need_no_words(stem: str) -> None:
    assert ": the angle" not in page_of_file(stem)


def test_a_coordinate_is_defined_before_the_step_that_uses_it() -> None:
    """The solution of one equation has no heading of its own, and belongs to the step before it."""
    page = page_of_file("body-wheel-rim-point")
    assert page.index("θ: the angle by which the wheel has turned") < page.index("Velocities:")
    assert "(2) -R α = 1/2 in m/s² (2): α = -1/(2 R)" in page


def test_a_way_whose_acceleration_is_told_is_defined() -> None:
    page = page_of_file("sledge-down-a-slope-and-out-over-level-snow")
    assert page.index("s: the way of P along its path, from where it is drawn") < page.index("s̈ = a_1")
