"""A place by its formula: what holds along the path is not a division by a sine that may be zero."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("bead-on-a-turning-hoop", "differentiated twice, along the path as seen from hoop: (3) a_P,hoop,t = R φ̈"),
        ("disk-rolling-in-a-trough", "y_G = -(R - r) cos φ differentiated, along the path: (1) -r ω = (R - r) φ̇"),
    ],
)
def test_a_point_on_its_path(name: str, told: str) -> None:
    page = page_of_file(name)
    assert told[:54] in page
    assert "divided by sin" not in page
    assert "divided by cos" not in page
