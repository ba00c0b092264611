"""Where the numbers of a page come from: each that enters a line was given, or a line before it worked it out."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field

from page_digits import NUMBERS, SUPER, last_place
from page_rules import Page, Row, is_numbers, symbols, value_of

FEW = 3
"""Numbers of fewer figures are taken as they are: 1/2, 30° and what a file gives in round numbers."""
TIMES = tuple(10.0**k for k in range(-6, 7))
FACTORS = (*TIMES, 57.29577951308232, 0.017453292519943295, 9.549296585513721, 0.10471975511965977)
"""By what a number in one unit becomes one in another: powers of ten, degrees and radians, rpm and rad/s."""


def figures(number: str) -> int:
    """How many figures a printed number has."""
    digits = number.partition("×10")[0].replace(".", "").lstrip("0")
    return len(digits.rstrip("0") if "." not in number else digits)


def size(number: str) -> float:
    """A printed number."""
    digits, _, exponent = number.partition("×10")
    return float(digits) * 10.0 ** int(exponent.translate(SUPER) or 0)


@dataclass
class Known:
    """Numbers that stand on a page so far, each with half of its last place in parts of itself."""

    found: list[tuple[float, float]] = field(default_factory=list)

    def add(self, text: str) -> None:
        self.found += [(x, _half(n) / x) for n in re.findall(NUMBERS, text) if (x := size(n))]

    def holds(self, number: str) -> bool:
        """Is it one of them, as exactly as the coarser of the two is printed?"""
        x, off = size(number), _half(number) / size(number)
        return any(abs(x / (f * y) - 1) <= max(off, other) for y, other in self.found for f in FACTORS)


def _half(number: str) -> float:
    """Half of its last place; a whole number of few figures is exact, and 1053 may be 1052.5."""
    whole = "." not in number and figures(number) <= FEW
    return 1e-12 * size(number) if whole else 0.5001 * last_place(number)


def without_source(page: Page) -> Iterator[str]:
    """Numbers of a line that nothing before it gives or works out; components of a vector that no formula leads to."""
    known = Known()
    for r in page.rows:
        # What is collected is worked out of the line before.
        if r.kind == "equation" and "collected" not in r.lead:
            yield from _of_line(r, known)
        known.add(r.text)


def _of_line(r: Row, known: Known) -> Iterator[str]:
    here = Known(list(known.found))
    for i, side in enumerate(r.sides[1:]):
        vector = re.match(r"-?\[", side)
        if is_numbers(side) or (r.numeric and value_of(side) is None) or vector:
            missing = [n for n in re.findall(NUMBERS, side) if figures(n) >= FEW and not here.holds(n)]
            result = i and (value_of(side) or _follows(r.sides[i], vector is not None))
            if missing and not result:
                yield f"{r.text}   [{', '.join(missing)}]"
        here.add(side)


def _follows(before: str, vector: bool) -> bool:
    """Does a formula in letters lead to numbers beside unknowns, or a pair of numbers to a vector?"""
    return "," in before if vector else bool(symbols(before)) and re.search(r"\d\.\d", before) is None
