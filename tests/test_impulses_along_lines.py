"""The components of an impulse along and across a slope are those of the blow, not made of its parts along x and y."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(
    ("stem", "told"),
    [
        ("ball-on-a-rough-slope", "J_t = -μ J_N = -0.2 · 0.3738"),
        ("ball-bouncing-down-a-slope", "J = J_N,bounce,2 = 1.869 N·s"),
    ],
)
def test_impulses_along_the_lines_of_a_blow(stem: str, told: str) -> None:
    page = page_of_file(stem)
    assert told in page
    assert "in the blow from" not in page
