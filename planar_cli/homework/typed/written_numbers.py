"""Numbers as they are written: their significant figures, and how exact they are."""

from __future__ import annotations

import re


def significant(number: str) -> int:
    """Significant figures of a written number; of 1200 as few as two are certain, and four are counted."""
    digits = re.split("[eE]", number.lstrip("+-"))[0]
    if "." in digits:
        return max(len(digits.replace(".", "").lstrip("0")), 1)
    return max(len(digits.lstrip("0")), 1)


def last_place(number: str) -> float:
    """A unit in the last place of a written number."""
    digits, _, exponent = number.lower().partition("e")
    return float(10.0 ** (int(exponent or 0) - len(digits.partition(".")[2])))
