"""A ball that bounces again: times by velocities that are told, and heights by the ratio that was found."""

from __future__ import annotations

import sympy as sp
from worked import page_of_file

from planar_cli.report.notation.by_ratio import by_ratio

E, H, D = sp.symbols("e h d", positive=True)


def test_a_time_by_the_velocity_that_is_told_before() -> None:
    page = page_of_file("ball-bouncing-twice")
    assert "v_4 = v_2 - g (t_4 - t_1) (8): t_4 = (v_2 - v_4)/g + t_1" in page
    assert "t_1 = √(2 h_0/g)" in page, "a square root of the data is as plain"


def test_a_height_by_the_ratio_that_was_found() -> None:
    assert "y_6 = v_5²/(2 g) = e² h_1 = h_1²/h_0 = 1.3²/2 = 0.845 m" in page_of_file("ball-bouncing-twice")


def test_powers_of_a_ratio() -> None:
    ratio = [(E, sp.sqrt(H / D))]
    assert by_ratio(H**2 / D, ratio) == E**2 * H
    assert by_ratio(H**3 / D**2, ratio) == E**4 * H
    assert by_ratio(H + D, ratio) is None
    assert by_ratio(H**2 / D, []) is None
