"""Where the mass centre of a body of several parts comes from: its masses, then Σ m_i x_i/m, then the parallel axes."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(("stem", "lines"), [
    ("plate-with-a-hole", (
        "mass of the rectangle: m_1 = ρ b h s",
        "mass of the hole: m_2 = -π/4 ρ d² s",
        "mass of plate: m = m_1 + m_2 = 18.84 - 2.774 = 16.07 kg",
        "x_G = Σ m_i x_i/m = (18.84 · 0.2 - 2.7744 · 0.25)/16.066 = 0.1914 m",
        "d_2 = 0.25 - 0.19137 = 0.05863 m",
        "I = m_1 d_1²",
    )),
    ("rod-and-disk-pendulum", (
        "mass of pendulum: m = ",
        "d_2 = 0.9 m",
        "OG = (m_1 d_1 + m_2 d_2)/m = (2 · 0.4 + 4 · 0.9)/6 = 0.7333 m",
        "I_O = m_2 d_2² + I_1 + I_2",
        "I = I_O - m OG²",
    )),
    ("unbalanced-wheel", ("mass of wheel: m = m_P + m_w", "x_G = e m_P/m = 0.2 · 2 / 10 = 0.04 m", "d_1 = ")),
])  # fmt: skip
def test_what_a_mass_centre_is_made_of_stands_before_it(stem: str, lines: tuple[str, ...]) -> None:
    page = page_of_file(stem)
    places = [page.index(text) for text in lines]
    assert places == sorted(places)


def test_a_part_has_letters_for_its_place_and_its_inertia() -> None:
    page = page_of_file("toy-on-a-round-end")
    assert "y of the mass centre of the half disk: y_1 = r - 4 r/(3 π)" in page
    assert "y_G = (m_1 y_1 + m_2 y_2)/m" in page
    assert "I = m_1 (y_G - y_1)² + m_2 (y_2 - y_G)² + I_1 + I_2" in page
    assert "part 1" not in page


def test_the_parts_of_one_shape_have_numbers() -> None:
    assert "mass of part 3 of wheel: m_3 = -m_h" in page_of_file("flywheel-with-four-holes")
