"""The time of a turning point by the tangent of its phase; a work and a mean by what is known at both ends."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(
    ("stem", "line"),
    [
        ("crate-on-a-floor-that-gets-rougher", "tan(ω_n t_1) = -v_0/(x_P,eq ω_n) = -4 / (-0.6667 · 1.213) = 4.946"),
        ("crate-on-a-floor-that-gets-rougher", "t_1 = arctan(4.946)/ω_n = 1.130 s"),
        ("bungee-jump", "-1.732 t_low = (π - arctan(1.732))/ω_n + t_taut = 3.863 s"),
    ],
)
def test_the_tangent_comes_before_the_time(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


def test_a_mean_acceleration_and_the_only_work_follow_from_both_ends() -> None:
    page = page_of_file("crate-on-a-floor-that-gets-rougher")
    assert "a_1 = (v_P,1 - v_P,0)/t_1 = (0 - 4)/1.1305 = -3.538 m/s²" in page
    assert "W = U of the drag rubbing = T_1 - T_0 = -1/2 m v_0² = -1/2 · 10 · 4² = -80 J" in page
    # What is asked first is found first.
    assert page.index("x_P,1 = (√") < page.index("tan(ω_n t_1)")


def test_a_mean_of_what_is_no_rate_keeps_its_integral() -> None:
    assert "v_mean = ∫[t_start → t_stop] v dt/(t_stop - t_start)" in page_of_file("train-between-stations")
