"""A flight between two states of which no line tells when they are: by the time that it lasts."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize("said", [
    "(10), (11) in (9): v_x,3 Δt tan β + v_y,3 Δt = 1/2 g Δt² Δt = t_4 - t_3",
    "divided by Δt ≠ 0: Δt = 2 (v_x,3 tan β + v_y,3) / g = 2 (1.8044 tan 25° + 2.5552) / 9.81 = 0.6925 s",
    "(10): x_4 = v_x,3 Δt = 1.804 · 0.6925 = 1.249 m",
])  # fmt: skip
def test_the_time_of_a_flight_comes_before_its_places(said: str) -> None:
    assert said in page_of_file("ball-on-a-rough-slope")
