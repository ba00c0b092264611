"""Both components of a pin force come from sums of forces on the same bodies; the pins of a chain have x and y."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize("line", [
    "A_x ← at A, A_y ↓ at A",
    "OA, AB, BC, CD, DE: (16) → ΣF_x: O_x = m_1 a_G,DE,x + m_1 a_G,OA,x + m_2 a_G,AB,x",
    "(17) ↑ ΣF_y: O_y - (2 m_1 + 2 m_2 + m_3) g = m_1 a_G,DE,y + m_1 a_G,OA,y",
    "DE: (16) → ΣF_x: D_x = m_1 a_G,DE,x (17) ↑ ΣF_y: D_y - m_1 g = m_1 a_G,DE,y",
    "CD: (18) → ΣF_x: C_x - D_x = m_2 a_G,CD,x (19) ↑ ΣF_y: C_y - m_2 g - D_y = m_2 a_G,CD,y",
    "Likewise BC (B, C, m_3), AB (A, B): (20) to (23).",
    "(19): C_y = m_2 g + m_2 a_G,CD,y + D_y = 1.5 · 9.81 + 1.5 (-8.8002) - 0.6194",
])  # fmt: skip
def test_a_chain_from_its_free_end(line: str) -> None:
    assert line in page_of_file("chain-5")


def test_a_pin_of_two_rods() -> None:
    page = page_of_file("two-rods-falling-flat")
    assert "AB, BC: (7) → ΣF_x: A_x = -2 m l ω_AB² (8) ↑ ΣF_y: N_C + A_y - 2 m g = m l α_AB" in page
