"""Bodies that rock on a round end: the arm of their weight, I about the contact, and why they are stable."""

from __future__ import annotations

from worked import page_of_file


def test_a_half_disk_in_letters() -> None:
    """I_C = 3/2 m R² - 2 m R · 4 R/(3 π) = (9 π - 16) m R²/(6 π)."""
    text = page_of_file("half-disk-rocking")
    assert "half disk, from O to its mass centre: OG = 4 R/(3 π)" in text
    assert "I = 1/2 m R² - m (4 R/(3 π))² = (1/2 - 16/(9 π²)) m R²" in text
    assert "turned by δ it is 4 R sin δ / (3 π) ≈ 4 R δ/(3 π) to the right of C: the weight turns it back" in text
    assert "I_C = m (R - 4 R/(3 π))² + I = (9 π - 16) m R² / (6 π)" in text
    assert "ΣM_C: -4 m g R δ/(3 π) = I_C α" in text
    assert "is stable, as the coefficient of δ is positive: displaced, it returns" in text


def test_a_toy_with_numbers() -> None:
    text = page_of_file("toy-on-a-round-end")
    assert "it is (r - y_G) sin δ ≈ (r - y_G) δ to the right of C: the weight turns it back" in text
    assert "I_C = m y_G² + I = 1.485 · 0.09405² + 0.007351 = 0.02049 kg·m²" in text
    assert "ΣM_C: -m g (r - y_G) δ = I_C α" in text
    assert "it is (y_G - r) sin δ ≈ (y_G - r) δ to the left of C: the weight turns it further" in text
