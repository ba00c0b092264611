"""What picks a state is a line of the page, and a root is left out by a condition that it does not meet."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(("stem", "lines"), [
    ("swing-from-which-the-cord-just-holds", "At 1, the tension in cord = T_max: m (g + l φ̇_1²) = T_max φ̇_1 = "),
    ("block-down-a-free-wedge", "At 2, y_block = 0: h + s_P,2 sin β = 0 s_P,2 = -h/sin β"),
])  # fmt: skip
def test_the_condition_of_a_state(stem: str, lines: str) -> None:
    """Before what follows from it."""
    assert lines in page_of_file(stem)


def test_a_letter_of_a_state_and_its_constant() -> None:
    """Both have one name in print: nothing is said of that."""
    assert "φ_0 = φ_0" not in page_of_file("swing-from-which-the-cord-just-holds")


@pytest.mark.parametrize(("stem", "lines"), [
    ("ball-in-a-forked-slot", ("-2.5 rad/s (given: ω_fork > 0)", "-12.5 rad/s² (given: α_fork > 0)")),
    ("block-on-turntable", ("7.848 N (with it the other equations have no solution)", "-2.557 rad/s (given: w > 0)")),
])  # fmt: skip
def test_why_a_root_is_left_out(stem: str, lines: tuple[str, ...]) -> None:
    """By the condition that this root does not meet, in the notation of the page."""
    assert all(words in page_of_file(stem) for words in lines)
