"""In a long sum in numbers products that differ by their first number alone are gathered."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(
    "told", ["- (1.5 + 2) · 12.51² · 0.1299 - 1.2 · 12.51² · 0.06495", "= (1.2 + 2) · 12.51² · 0.02151"]
)
def test_masses_on_one_arm(told: str) -> None:
    assert told in page_of_file("slider-crank-with-a-spring")
