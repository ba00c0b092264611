"""What an unknown is in the one letter of its block comes with its working."""

from __future__ import annotations

from worked import page_of_file


def test_each_term_stands_before_the_sum() -> None:
    page = page_of_file("rod-disk-wall")
    assert "N_E = -0.3182 α_rod - 0.1061 α_rod + 0.05303 α_rod = -0.3712 α_rod in N" in page
    assert "O_x = 0.15 α_disk = -0.3182 α_rod in N" in page
