"""An equation that an earlier part of a motion has solved stands as its result in a later one."""

from __future__ import annotations

from worked import page_of_file


def test_the_normal_force_of_the_way_up_is_that_of_the_way_down() -> None:
    page = page_of_file("body-block-sent-up-a-slope")
    assert page.count("N_P = m g cos β = 5 · 9.81 cos 30° = 42.48 N") == 1
    assert "(5) ↖ ΣF: N_P = 42.48 N as (1)" in page


def test_one_that_rests_on_another_letter_stays() -> None:
    """The tension is not the same on the way, though its equation is."""
    page = page_of_file("ball-on-a-string-hits-a-block")
    assert page.count("ΣF: m_ball g sin φ_ball + T_string = m_ball v_ball²/l") == 2
