"""A body without a resultant force keeps its velocity, in one line and not as a balance of momenta."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(
    ("stem", "line"),
    [
        ("three-carriages", "From 2 to 3, no resultant force acts on A along x: (3) v_A,3 = v_A,2 = 7.875 ft/s"),
        ("three-carriages", "A, no impulse along x: (4) v_A,4 = v_A,3 = 7.875 ft/s"),
        ("puck-hits-a-free-rod", "puck, no impulse along y: (5) v_puck,y,2 = v_puck,y,1 = 2.736 m/s"),
        ("blow-handed-on-by-a-ball", "From 3 to 4, no resultant force acts on A: (8) v_Ax,4 = v_Ax,3"),
        (
            "rope-that-jerks-taut",
            "From 1 to 2, no resultant force acts on B: (1) v_Bx,2 = v_Bx,1 = 2.5 m/s (2) v_By,2 = v_By,1 = 4.330 m/s",
        ),
    ],
)
def test_one_line(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


def test_a_velocity_by_several_letters_has_its_balance() -> None:
    assert "From 2 to 3, ladder: conservation of momentum:" in page_of_file("ladder-leaving-the-wall")


def test_both_axes_have_one_heading() -> None:
    page = page_of_file("rope-that-jerks-taut")
    assert "From 1 to 2, constant velocity of B: (4) x_B,2 = x_B,1 + v_Bx,1 t_2 (5) y_B,2 = v_By,1 t_2" in page
