"""A terminal speed once, speeds of states by it, and one law v(t) for several states."""

from __future__ import annotations

from unicodedata import normalize

from worked import page_of_file


def test_a_speed_that_is_a_multiple_of_the_terminal_speed_is_told_by_it() -> None:
    page = page_of_file("parachutist")
    assert page.count("√(m g/c)") == page.count("0.95 √(m g/c)") + 1
    assert page.index("v_end = √(m g/c)") < page.index("terminal speed: v_t = v_end = 57.18 m/s")
    assert "v_nearly = 0.95 v_t = 0.95 · 57.18 = 54.32 m/s" in page
    assert "t_nearly = v_t artanh(0.95)/g" in page


def test_two_states_rest_on_one_law_of_the_speed() -> None:
    page = page_of_file("parachutist")
    assert page.count("[v_t artanh(v/v_t)/g]") == 1
    assert "v = v_t tanh(g t/v_t) (2) v_after_5 = v_t tanh(g t_after_5/v_t)" in page
    assert "v_nearly = v_t tanh(g t_nearly/v_t) (5) t_nearly" in page


def test_one_state_alone_has_its_own_limits() -> None:
    page = normalize("NFC", page_of_file("ball-up-with-drag"))
    assert "From top to back, dv/a = dt: ∫[0 → ṡ_back] (v_t² / (g (v_t² - ṡ²))) dṡ = ∫[t_up → t_back] dt" in page
