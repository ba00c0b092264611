"""What is printed as worked out comes to what is printed behind it: `0.2 · 79.71 = 15.94 N` on every page that is kept.

The pages are those in tests/golden, which other tests compare with what is printed now.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from itertools import pairwise

import pytest
from worked import GOLDEN

PAGES = sorted(GOLDEN.glob("*.solution.txt"))
VALUE = re.compile(r"(-?\d+(?:\.\d+)?)(?: · 10([⁻⁰¹²³⁴-⁹]+))?(?: [a-zA-Zµ°·/²³⁴⁻¹%]+)?")
RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
FUNCTIONS: dict[str, Callable[[float], float]] = {
    "sqrt": math.sqrt,
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "arcsin": math.asin,
    "arccos": math.acos,
    "arctan": math.atan,
    "ln": math.log,
}
NAMES = {**FUNCTIONS, "pi": math.pi, "abs": abs, "__builtins__": {}}
OPENS = r"(?=\(|sqrt|sin|cos|tan|arc|ln|pi)"
UNITS = (1, 1e3, 1e-3, 1e6, 180 / math.pi, 30 / math.pi, 3.6, 100)
"""What a value is in its own unit: mm, kN, mm², degrees, revolutions per minute, km/h, per cent."""
ROUNDED = 6e-3
"""The numbers put in have four figures, also where they are subtracted from each other."""


def read(text: str) -> str | None:
    """A side that holds numbers alone as Python reads it; None: it holds a letter, or a unit."""
    told = re.sub(r"(\d+(?:\.\d+)?)°", r"(\1*pi/180)", text.replace(" rad", ""))
    told = re.sub(r"(sin|cos|tan|arctan|arcsin|arccos|ln|√) ?(\d+(?:\.\d+)?)", r"\1(\2)", told)
    for sign, word in {"√": "sqrt", "²": "**2", "³": "**3", "⁴": "**4", "·": "*", "π": "pi"}.items():
        told = told.replace(sign, word)
    told = re.sub(rf"(\d|\)|pi)(?: +(?=\d)| *{OPENS})", r"\1*", told)
    bare = re.sub("|".join([*FUNCTIONS, "pi"]), "", told)
    return told if re.search(r"\d", told) and not re.search(r"[^\d\s.+*/()-]", bare) else None


def size_of(side: str) -> tuple[float, float] | None:
    """The number of a side, and how large its terms are."""
    told = read(side)
    if told is None:
        return None
    try:
        return float(eval(told, NAMES)), float(eval(told.replace("-", "+"), NAMES))
    except (SyntaxError, ValueError, TypeError, ZeroDivisionError):
        return None


def chains(page: str) -> Iterator[list[str]]:
    """The sides of each chain of equations, with the rows in which it goes on."""
    rows: list[str] = []
    for row in page.split("\n"):
        goes_on = re.match(r"\s+(?:[=/+·-] |\((?!\d+\) ))", row)
        if goes_on and rows:
            rows[-1] += " " + row.strip()
        else:
            rows.append(row)
    for row in rows:
        for part in re.split(r"[;,] |: |   +", row):
            yield re.split(r" = | [<>≤≥] ", part)


def worked_out(page: str) -> Iterator[tuple[str, str, bool]]:
    """Each side of numbers with the value behind it, and whether that is what it comes to."""
    for sides in chains(page):
        for side, shown in pairwise(sides):
            value = VALUE.fullmatch(shown.strip())
            if value is None or VALUE.fullmatch(side.strip()) or (found := size_of(side)) is None:
                continue
            number, terms = found
            said = float(value[1]) * 10.0 ** int((value[2] or "0").translate(RAISED))
            near = (abs(number * k - said) <= ROUNDED * max(abs(said), abs(number * k)) for k in UNITS)
            yield side.strip(), shown.strip(), any(near) or (said == 0 and abs(number) <= ROUNDED * terms)


@pytest.mark.parametrize(("side", "shown", "holds"), [
    ("0.2 · 65.83", "15.94 N", False),
    ("0.2 · 79.71", "15.94 N", True),
    ("5 (9.81 + 2 sin 30°)", "54.05 N", True),
    ("√((2 + 3²) 4) / 2", "3.317 m/s", True),
    ("80 - 70.97 - 9.026", "0 N", True),
])  # fmt: skip
def test_a_side_of_numbers_is_worked_out(side: str, shown: str, holds: bool) -> None:
    assert list(worked_out(f"x = {side} = {shown}")) == [(side, shown, holds)]


def test_what_is_printed_as_worked_out_is() -> None:
    found = [(page.name, *told) for page in PAGES for told in worked_out(page.read_text(encoding="utf-8"))]
    assert len(found) > 2500
    assert not [told for told in found if not told[-1]]
