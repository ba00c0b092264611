"""Equations of a state that are put into one of them, so that the time follows, and all else from it."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(("stem", "lines"), [
    ("ex-1-11", "(2), (4) in (5): v_y,launch t_B - 1/2 g t_B² = -3/4 v_x,launch t_B divided by t_B ≠ 0: t_B = "),
    ("ex-1-11", "(2): x_B = v_x,launch t_B = "),
    ("thrown-and-dropped", "(3): t_meet = H/v0"),
    ("bolt-that-drops-in-a-lift", "(2), (3) in (1): H + v_0 t_2 - 1/2 g t_2² = v_0 t_2 + 1/2 a t_2² t_2 = √(2 H"),
])  # fmt: skip
def test_the_time_comes_first(stem: str, lines: str) -> None:
    assert lines in page_of_file(stem)


@pytest.mark.parametrize(("stem", "lines"), [
    ("two-angles-to-a-target", "(1), (2) in (3), (4): x_hit = v_0 t_hit cos β"),
    ("ship-interception", "together: β = 73.43° t_meet = 3281 s"),
])  # fmt: skip
def test_two_equations_that_are_left(stem: str, lines: str) -> None:
    """An angle and a time follow from two equations, with all else put into them."""
    assert lines in page_of_file(stem)


def test_what_nobody_asks_for_has_no_line() -> None:
    """The impulses at the axles of the bicycle follow from the equations, and nothing rests on them."""
    assert "J_OBx = -I_f" not in page_of_file("ex-4-18")


def test_a_square_with_a_factor() -> None:
    assert "loss = (1 - e²) m_1 m_2 (v_1 - v_2)² / (2 (m_1 + m_2))" in page_of_file("central-impact-in-letters")


@pytest.mark.parametrize(("stem", "line"), [
    ("ball-in-a-rotating-tube-in-letters", "v_r = v_P,tube,exit = w √(l² - r_0²)"),
    ("toppling-pole-that-stops-pressing", "Q = 1/4 m g cos θ_2 = 1/5 m g"),
])  # fmt: skip
def test_a_size_whose_sign_is_known(stem: str, line: str) -> None:
    assert line in page_of_file(stem)
