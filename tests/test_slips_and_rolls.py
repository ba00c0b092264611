"""What slips from the start of a motion, and what rolls at a state, is told by the velocity at the contact."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(("stem", "said"), [
    # After a blow, by the velocity that it makes; from the start by what is given.
    ("billiard-ball", "Motion the ball slips at C: at 2, v_C = v_G,2 - R ω_2 = J/m to the right"),
    ("spinning-wheel-set-down", "Motion the wheel slips at C: at 1, v_C = -R w to the left"),
    ("ball-with-backspin", "Motion the ball slips at C: at 1, v_C = v_0 + r w = 4 + 0.1 · 120 = 16 m/s to the right"),
    ("billiard-ball", "At 2, the ball rolls without slipping: (2) v_G,2 = R ω_2"),
    ("spinning-wheel-set-down", "At 2, the wheel rolls without slipping: (4) v_G,2 = -R ω_2"),
])  # fmt: skip
def test_the_velocity_at_the_contact_is_told(stem: str, said: str) -> None:
    assert said in page_of_file(stem)


def test_what_is_found_later_is_no_reason() -> None:
    """The backspin that stops the ball is sought: that it slips is assumed."""
    page = page_of_file("ball-with-backspin")
    assert "Assume ball at C slips" in page[page.index("CASE stopping") :]
