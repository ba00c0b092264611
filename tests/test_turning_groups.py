"""Bodies that turn together while some slide along others: the moments of inertia before the balance of momenta."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(
    ("stem", "lines"),
    [
        (
            "spheres-that-slide-out-to-stops",
            [
                "I_O,1 = 2 m_A d_A,1² + I_0 + 2 I_A = 2 · 0.06211 · 0.4167² + 0.25 + 2 · 0.001553 = 0.2747",
                "T_1 = 1/2 I_O,1 w_0² = 1/2 · 0.27467 · 6² = 4.944 lbf·ft",
                "A and B each have the momentum m_A d ω across the line to O and m_A v_rel along it",
                "(1) ↺ H_O: 2 m_A d_A,1² w_0 + (I_0 + 2 I_A) w_0 = 2 m_A d_A,2² ω_rod,2 + (I_0 + 2 I_A) ω_rod,2",
                "collected: I_O,1 w_0 = I_O,2 ω_rod,2 (1) in numbers: 1.648 = 0.7923 ω_rod,2",
                "Hence: T_3 = 1/2 I_O,2 ω_rod,3²",
            ],
        ),
        ("two-balls-in-a-turning-tube", ["I_O,end = 2 m_P d_P,end² + I_tube = 2 · 0.5 · 0.8² + 0.8533 = 1.493 kg·m²"]),
        ("collar-in-a-turning-tube", ["I_O,2 = m d_P,2² + m_rod d_rod,2² + I_rod = 0.6 · 0.8² + 1.5 · 0.5² + 0.125"]),
    ],
)
def test_the_moment_of_inertia_of_the_group(stem: str, lines: list[str]) -> None:
    page = page_of_file(stem)
    assert [told for told in lines if told not in page] == []
    assert page.count("d: distance from O") == 1
