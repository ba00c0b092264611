"""Where the mass centre of a body of several parts comes from: its masses, then Σ m_i x_i/m, then the parallel axes."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(("stem", "lines"), [
    ("plate-with-a-hole", (
        "mass of plate: m = m_plate,1 + m_plate,2 = 18.84 - 2.774 = 16.07 kg",
        "x_G = Σ m_i x_i/m = (18.84 · 0.2 - 2.7744 · 0.25)/16.066 = 0.1914 m",
        "d_plate,2 = 0.25 - 0.19137 = 0.05863 m",
        "I = m_plate,1 d_plate,1²",
    )),
    ("rod-and-disk-pendulum", (
        "mass of pendulum: m = ",
        "y_G = Σ m_i y_i/m = (2 (-0.2) + 4 (-0.45))/6 = -0.3667 m",
        "d_pendulum,1 = √((0.34641 - 0.63509)² + (-0.2 - (-0.36667))²) = 0.3333 m",
        "I = m_pendulum,1 d_pendulum,1²",
    )),
    ("unbalanced-wheel", ("mass of wheel: m = m_P + m_w", "x_G = e m_P/m = 0.2 · 2 / 10 = 0.04 m", "d_wheel,1 = ")),
])  # fmt: skip
def test_what_a_mass_centre_is_made_of_stands_before_it(stem: str, lines: tuple[str, ...]) -> None:
    page = page_of_file(stem)
    places = [page.index(text) for text in lines]
    assert places == sorted(places)
