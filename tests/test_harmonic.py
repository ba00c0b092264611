"""A simple harmonic motion is written out before its time is found; a place at that time follows by its cosine."""

from __future__ import annotations

import unicodedata

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate


def _page(name: str) -> str:
    page = Terminal(200).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))
    return " ".join(unicodedata.normalize("NFC", page).split())


@pytest.mark.parametrize(
    "words",
    [
        "x = A cos(ω_0 t) + B sin(ω_0 t) at t = 0: x = A = l, ẋ = B ω_0 = 0 x = l cos(ω_0 t), ẋ = -l ω_0 sin(ω_0 t)",
        "(2) l cos(ω_0 t_middle) = 0 ω_0 t_middle = π/2",
        "(3) ẋ_middle = -l ω_0 sin(ω_0 t_middle) = -l ω_0 sin(π/2) = -l √(k/m)",
        "(4) -l ω_0 sin(ω_0 t_stop) = 0 ω_0 t_stop = π the first such time after the start (4): t_stop = π √(m/k)",
        "(5) x_stop = l cos(ω_0 t_stop) = l cos π = -l",
        "Answer eom: ẍ = -k x/m",
        "work and energy: U = 1/2 k l²; T_middle = 1/2 m ẋ_middle² = 1/2 k l²",
    ],
)
def test_a_block_on_a_spring(words: str) -> None:
    assert words in _page("textbook/ex-1-07")


def test_a_vibration_in_its_own_letters_stays_as_it_is() -> None:
    assert "cos(ω_0 t)," not in _page("motion/block-runs-into-a-spring")


def test_a_speed_is_the_derivative_of_a_place_that_is_told() -> None:
    page = _page("energy/crate-on-a-floor-that-gets-rougher")
    place = "x_P = v_0 sin(ω_n t)/ω_n + x_P,eq - x_P,eq cos(ω_n t)"
    assert f"{place} ẋ_P = v_0 cos(ω_n t) + x_P,eq ω_n sin(ω_n t)" in page


def test_a_remark_with_which_the_sentence_above_ends_is_not_said_again() -> None:
    assert _page("oscillations/weight-on-a-cord-held-by-a-spring").count("x_1 = x_eq") == 1
