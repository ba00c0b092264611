"""Bodies that rock on a round end: the arm of their weight, I about the contact, and why they are stable."""

from __future__ import annotations

from pathlib import Path

from worked import page_of_file, page_of_text


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


WHEEL = """
title: Wheel out of balance rocking
plane: vertical
given: {m: 6 kg, R: 0.3 m, e: 0.1 m, k: 0.2 m}
coordinates: {theta: rad}
points:
  C: [-R*theta, 0]
  O: [-R*theta, R]
  S: [-R*theta + e*sin(theta), R - e*cos(theta)]
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {wheel: {disk: O, radius: R, mass: m, center: S, inertia: m*k^2}}
joints:
  - rolling: {between: [wheel, floor], at: C}
states:
  level: [theta = 0, equilibrium]
find: {T: period(level)}
"""


def test_the_mass_centre_has_its_own_name(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, WHEEL)
    assert "S lies below O, in line with C; turned by δ it is e sin δ ≈ e δ to the right of C" in page
    assert "G lies" not in page
