"""What is asked of forces at one state alone, in letters, stands on the page at that state: no sine of any angle."""

from __future__ import annotations

import unicodedata

import pytest
from worked import page_of_file


@pytest.mark.parametrize(
    "words",
    [
        "Accelerations at 2, θ = 0: By (2), (3), ω_BC = -ω_AB at all times",
        "a⃗_B = α_AB × r⃗_B/A - ω_AB² r⃗_B/A = [-l ω_AB², l α_AB] r⃗_B/A = [l, 0]",
        "(4) α_BC = -α_AB",
        "free-body diagram = kinetic diagram At 2, θ = 0: BC: m g ↓ at G_BC",
        "1/2 m l α_AB ↑ at G_AB, 1/2 m l ω_AB² ← at G_AB",
        "(6) ↺ ΣM_A: 2 N_C l - 2 m g l = 1/2 m l α_AB · l/2 + 1/2 m l α_AB · 3 l/2",
        "(5) in (6): α_AB = -3 g/(2 l)",
    ],
)
def test_two_rods_that_fall_flat(words: str) -> None:
    page = unicodedata.normalize("NFC", page_of_file("two-rods-falling-flat"))
    plain = page.replace("\u20d7", "")
    assert words.replace("\u20d7", "") in plain
    assert "sin θ" not in plain.partition("Accelerations")[2]


def test_what_rests_on_the_general_position_keeps_it() -> None:
    """The motion of a pendulum is integrated: its equation holds for every angle."""
    assert "θ̈ = -g sin θ / l" in unicodedata.normalize("NFC", page_of_file("simple-pendulum"))
