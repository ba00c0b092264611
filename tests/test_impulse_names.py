"""Short letters of impulses, and given velocities in the diagrams of blows."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(("stem", "said"), [
    # The only impulse of a page is J; given velocities stand in the diagram, in the sense in which they are positive.
    ("ex-4-14", "C: m_C u →, J ← = m_C w ←"),
    ("ball-that-grips-a-rough-floor", "ball: m v_x → at G, m v_y ↓ at G, J_N ↑ at C, J_F ← at C (assumed)"),
    ("ex-4-18", "J_OBx → at O_B"),
    # Two joints of one kind keep their names.
    ("row-of-hanging-balls", "J_N,hit,AB,3"),
])  # fmt: skip
def test_impulses_by_short_letters(stem: str, said: str) -> None:
    assert said in page_of_file(stem)


@pytest.mark.parametrize(("stem", "said"), [
    # The opposite of a letter of the file is put in at once.
    ("ex-4-14", "(1) → m_C u = m_AB v_Gx,2 - m_C w (1): v_Gx,2 = m_C (u + w) / (2 m) = 0.5 (10 + 5) / (2 · 2)"),
    ("ball-that-grips-a-rough-floor", "(3) v_Gy,2 = e v_y"),
    # What a find is made up of has its line before it.
    ("ex-4-14", "v_Ax,2 = v_Gx,2 - 1/2 l ω_2 = 1.875 - 1/2 · 0.8 (-4.6875) = 3.75 m/s e = (v_Ax,2 + w)/u"),
])  # fmt: skip
def test_given_velocities_and_those_of_points(stem: str, said: str) -> None:
    assert said in page_of_file(stem)


def test_no_closed_form_that_is_much_longer() -> None:
    assert " e = (v_Ax,2 + w)/u = (3.75 + 5)/10 = 0.875" in page_of_file("ex-4-14")
