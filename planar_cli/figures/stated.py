"""Which numbers the text of a problem gives: others only place what is drawn, and are no dimensions for a reader."""

from __future__ import annotations

import re
from decimal import Decimal

from planar_cli.problem.language.expression import Number, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Problem

NUMBER = re.compile(
    r"(?<![\w.])(\d+(?:\.\d+)?)(?!\.?\d)(?!\s*[a-z]+/)(?!\s*-?(?:rad|deg|rev|rpm|t|k?g|k?N|k?J|k?W|m?s|min|h|lb|lbf|k?Hz|%)\b)"
)
"""In a text, but not the size of something else than a length."""
UNITS = r"[\s-]+(?:[ckm]?m|ft|in|met(?:re|er)s?|(?:centi|milli|kilo)met(?:re|er)s?|foot|feet|inch(?:es)?|miles?)\b"
"""Behind a number in words: two weights tell no length."""
WORDS = ("one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")


def is_stated(problem: Problem, side: Side) -> bool:
    """Does the text give the lengths in numbers of a formula, in whatever unit? A file without a text gives them
    itself.
    """
    text = problem.text or ""
    lengths = [n for n in walk(side) if isinstance(n, Number) and n.unit and n.value != 0]
    if not text.strip() or not lengths:
        return True
    told = {_digits(Decimal(n)) for n in NUMBER.findall(text)}
    told |= {
        _digits(Decimal(i)) for i, word in enumerate(WORDS, 1) if re.search(rf"\b{word}{UNITS}", text, re.IGNORECASE)
    }
    return all(_digits(Decimal(n.value.numerator) / Decimal(n.value.denominator)) in told for n in lengths)


def _digits(number: Decimal) -> tuple[int, ...]:
    """Those of a number, wherever its decimal point is, as a unit may move it."""
    return number.normalize().as_tuple().digits
