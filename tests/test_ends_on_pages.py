"""What a rope says of its own ends stands before what rolling makes of it; parts along a slope have a direction."""

from __future__ import annotations

from worked import page_of_file


def test_a_rope_tied_to_the_centre_of_what_rolls_says_so_of_that_centre() -> None:
    page = page_of_file("wheel-pulled-uphill")
    assert "The cord keeps its length, a_B = a_G, with (1): (2) a_B = R α" in page
    assert page.index("(1) wheel rolls without slipping: a_G = R α") < page.index("a_B = a_G")


def test_an_answer_along_a_slope_tells_its_direction() -> None:
    page = page_of_file("wheel-pulled-uphill")
    assert "a_G = 1.642 m/s² up the slope" in page
    assert "friction_C = F_C = 22.08 N down the slope" in page
