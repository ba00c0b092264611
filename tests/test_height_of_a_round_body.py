"""The centre of what slides on a rim is its radius away from it, in letters: the path of the centre is a circle."""

from __future__ import annotations

from worked import page_of_file


def test_the_centre_of_a_cylinder_that_slips_on_a_drum() -> None:
    page = page_of_file("cylinder-that-rolls-slips-and-leaves-a-drum")
    assert "m v_G² / (R + r) ↙ at G" in page
    assert "N_c - m g sin φ_G = -m v_G² / (R + r)" in page
    assert "sin² 85°" not in page
