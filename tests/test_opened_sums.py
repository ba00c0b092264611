"""In a long sum in numbers products that differ by their first number alone are gathered."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(
    "told", ["- (1.5 + 2) · 12.51² · 0.1299 - 1.2 · 12.51² · 0.06495", "= (1.2 + 2) · 12.51² · 0.02151"]
)
def test_masses_on_one_arm(told: str) -> None:
    assert told in page_of_file("slider-crank-with-a-spring")


@pytest.mark.parametrize(
    ("stem", "equation", "result"),
    [
        (
            "six-bar-class-3",
            "(9) ↺ ΣM_P: 0.5 C_t + 1.5 · 9.81 · 0.15 = 0.125 α_PC in N·m",
            "(9): C_t = (0.125 · 41.82 - 1.5 · 9.81 · 0.15)/0.5 = 6.040 N",
        ),
        (
            "car-with-locked-wheels",
            "(3) ↻ ΣM_A: 1400 · 9.81 · 1.4 - 2.6 N_B = 1400 · 0.55 a_A in N·m",
            "(3): N_B = (1400 · 9.81 · 1.4 - 1400 · 0.55 (-6.867))/2.6 = 9429 N",
        ),
    ],
)
def test_what_an_equation_gives_has_its_very_terms(stem: str, equation: str, result: str) -> None:
    """They are not collected first."""
    page = page_of_file(stem)
    assert result in page
    assert f"{equation} collected:" not in page
    assert equation in page


def test_a_factor_of_one_divides_nothing() -> None:
    assert "(3): α = 24.118 - 3 · 9.81 · 0.5 = 9.403 rad/s²" in page_of_file("bar-let-go-on-a-spring")
