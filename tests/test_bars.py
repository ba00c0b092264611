"""A vector and its size have two names: v_B = ω × r_B/O, and |v_B| = R ω."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(
    ("stem", "vector", "size"),
    [
        ("four-bar", "v_C = v_B + ω_BC × r_C/B", "|v_C| = √(1.156² + 0.1535²) = 1.166 m/s"),
    ],
)
def test_a_size_has_bars(stem: str, vector: str, size: str) -> None:
    page = page_of_file(stem)
    assert page.index(vector) < page.index(size)


def test_a_component_has_none() -> None:
    """Of a body that moves along a line a_G is what it is along that line."""
    assert "a_G = -R α" in page_of_file("ex-4-05") or "a_G = R α" in page_of_file("ex-4-05")
