"""Places, turning points and greatest speeds are checked by geometry and by what is known of the motion."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(
    ("stem", "words"),
    [
        ("ex-1-02", "law of cosines: √(r² + r² - 2 r r cos 90°) = √2 r = |r_A2/A|"),
        ("ex-1-07", "work and energy: U = 1/2 k l²; T_middle = 1/2 m ẋ_middle² = 1/2 k l²"),
        ("ex-1-09", "OB = √(0.4715² + 0.3710²) = 0.6 m; r_B/O · v_B = "),
        ("ex-1-09", "0.4715 (-0.1237) + 0.3710 · 0.1572 = 0, at right angles"),
        ("ex-1-15", "relative speed √(43.30² + 25²) = 50 m/s, distance at first D: D/(50 m/s) = t_meet"),
    ],
)  # fmt: skip
def test_a_check_by_geometry_or_by_the_motion(stem: str, words: str) -> None:
    assert words in page_of_file(stem)
