"""What is off by a power of ten: which powers are looked at, and how that is told."""

from __future__ import annotations

POWER_OF_TEN, POWERS = "power-of-ten", (-3, -2, -1, 1, 2, 3)
OFF_BY_TEN = "the number is off by a power of ten: look at prefixes such as k and m, and at the decimal point"
LOOK = "look at its unit and its decimal point"
"""How a value that is off by a power of ten is told, whichever it is."""


def is_of_a_datum(feedback: str) -> bool:
    """Does what a student is told speak of a given value with its decimal point elsewhere?"""
    return feedback.endswith(LOOK)
