"""An angle to the vertical is told as its exercise tells it; along a path the letter of the equations is the answer."""

from __future__ import annotations

import pytest
from worked import page_of_file


def test_the_angle_of_the_text_is_that_of_the_page() -> None:
    page = page_of_file("car-over-hump")
    assert "OP = R at 90° - 10°" in page
    assert "N_P = m (g cos 10° - v_P²/R) = 1200 (9.81 cos 10° - 15²/40) = 4843 N" in page
    assert "80°" not in page
    assert "φ̇_burnout = v_0 cos 8° / r_burnout" in page_of_file("satellite-launched-at-a-slant")


@pytest.mark.parametrize("name", ["hinged-bar-on-a-stop", "chain-5", "rod-falling-on-a-smooth-floor"])
def test_an_angle_that_the_text_does_not_tell_otherwise_stays(name: str) -> None:
    assert "90° - " not in page_of_file(name)


def test_along_the_path_the_letter_is_the_answer() -> None:
    page = page_of_file("car-over-hump")
    assert "a_t = a_Pt = 1.703 m/s² in the direction of motion" in page
    assert "e_n" not in page
    assert "that is 4.905 m/s² against the direction of motion" in page_of_file("pendulum-tension")
    assert "contact is lost where N_P = 0" in page
