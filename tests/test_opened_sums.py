"""In a long sum in numbers products that differ by their first number alone, or by half an arm, are gathered."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize("told", [
    "30.56 + O_x = -(1.5 + 2/2) · 3.662² · 0.4437 - (1.5 + 2 + 1.2/2) · 12.51² · 0.1299",
    "= (1.2 + 2) · 12.51² · 0.02151",
    "+ (1.5 + 2/4) · 0.2025 α_AB - (1.5 + 2/2) · 12.51² · 0.04302 in N·m",
])  # fmt: skip
def test_masses_on_one_arm_or_on_parts_of_it(told: str) -> None:
    assert told in page_of_file("slider-crank-with-a-spring")
