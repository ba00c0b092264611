"""The only stretch that has forces has no heading of its own where the energies lead through states before it."""

from __future__ import annotations

from worked import page_of_file


def test_the_spring_that_is_free_at_first() -> None:
    page = page_of_file("weight-dropped-on-a-spring")
    assert "from 1 to meets: the spring coil is free from meets to lowest: the spring coil pushes STEP 1" in page
    assert "From meets to lowest: s_P: the way of P downward" in page
    assert "MOTION" not in page


def test_a_stretch_after_steps_of_its_own_keeps_it() -> None:
    assert "MOTION from meets to leaves" in page_of_file("block-runs-into-a-spring")


def test_a_speed_is_largest_where_nothing_accelerates_it() -> None:
    page = page_of_file("weight-dropped-on-a-spring")
    assert "|v_P| is largest, where the acceleration along the path is zero: (3) g = k s_P,fastest/m" in page
