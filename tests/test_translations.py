"""A body that its linkage keeps from turning is said to translate, before the points on it move."""

from __future__ import annotations

from worked import page_of_file


def test_the_coupler_of_a_parallelogram_translates() -> None:
    page = page_of_file("parallelogram-3-cranks")
    assert page.index("The coupler translates: ω_coupler = 0, α_coupler = 0") < page.index("(1) α_crank,2 sin β")
