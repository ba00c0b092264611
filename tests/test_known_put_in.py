"""Two equal rods that fold alike: their angular accelerations are one letter in the equations of forces."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize("line", [
    "(5) ↺ ΣM_B: N_C l - 1/2 m g l = 1/2 m l α_AB · l/2 - I_BC α_AB = 1/6 m l² α_AB",
    "· 3 l/2 = m l² α_AB",
    "(5): N_C = 1/2 m g + 1/6 m l α_AB (5) in (6): α_AB = -3 g/(2 l)",
    "By (2), (3), ω_BC = -ω_AB at all times, so that: (4) α_BC = -α_AB a_B =",
    "(5), (6), (8), 3 unknowns: N_C, α_AB, A_y",
    "(5): N_C = 1/4 m g A_x = -2 m l θ̇_2² = -6 m g sin β (8): A_y = 2 m g + m l α_AB - N_C = 1/4 m g",
])  # fmt: skip
def test_what_is_one_letter_but_for_its_sign_is_put_in_after_the_moments_themselves(line: str) -> None:
    assert line in page_of_file("two-rods-falling-flat")


def test_a_moment_of_inertia_alone_stays_a_letter() -> None:
    assert "I α" in page_of_file("ex-4-06")


@pytest.mark.parametrize("line", ["(7): A_x", "(8): A_y = 2 m g + m l α_AB - N_C A"])
def test_what_an_equation_tells_at_once_and_what_a_state_makes_shorter_are_told_once(line: str) -> None:
    assert line not in page_of_file("two-rods-falling-flat")
