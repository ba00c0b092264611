"""Components of vectors that are asked have the letters of their point, not the name in the file."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(("stem", "lines"), [
    ("ex-1-09", ["x_B,2 = R cos θ_2 = ", "v_By,2 = 0.2 sin 128.2° = ", "|v_B,2| = R ω = ", "r_B,2 = [0.4715"]),
    ("ex-1-10", ["a_Bx,2 = -a_t sin θ_2 - a_n cos θ_2", "a_B = [-0.2282, -0.1704] m/s²"]),
])  # fmt: skip
def test_letters_of_components(stem: str, lines: list[str]) -> None:
    page = page_of_file(stem)
    assert not [line for line in lines if line not in page]
    assert ", x = " not in page
