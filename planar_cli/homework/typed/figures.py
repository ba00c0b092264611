"""Were as many significant figures typed as are asked for? A value that is exact loses nothing: 3.00 may be typed as 3.

Of a component, and of a direction, it matters how exact the vector is by it: beside 74.4 N a component is exact to
0.1 N, and a direction to 0.5° where three figures are asked.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence

from planar_cli.homework.sets.paper import Expected
from planar_cli.homework.typed.typed import Typed
from planar_cli.homework.typed.written_numbers import significant

EXACT = 1e-9
"""Relative: what is left by rounding of machine numbers."""
_DECIMAL = re.compile(r"(?<![\w.])(?:[0-9]+\.[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")


def too_few(values: Sequence[float], answer: Typed, expected: Expected, asked: int) -> str:
    """What to say of a right answer with too few figures; "" of one with enough. `values`: in the unit of the find."""
    if expected.kind == "vector" and answer.polar:
        return _of_polar(values, answer, expected, asked)
    size = math.hypot(*expected.values)
    coarse = [
        figures < asked and abs(value - due) > EXACT * (size if expected.kind == "vector" else abs(due))
        for figures, value, due in zip(answer.figures, values, expected.values, strict=False)
    ]
    if expected.kind == "vector":
        places = (_last_place(v, f) for v, f in zip(answer.values, answer.figures, strict=True))
        least = _last_place(math.hypot(*answer.values), asked) * (1 + EXACT)
        coarse = [c and place > least for c, place in zip(coarse, places, strict=True)]
    return _sentence(asked) if any(coarse) else ""


def _of_polar(values: Sequence[float], answer: Typed, expected: Expected, asked: int) -> str:
    """Of magnitude and direction. A direction that is right but for signs has its figures too."""
    size, due = math.hypot(*values), math.hypot(*expected.values)
    if answer.figures[0] < asked and abs(size - due) > EXACT * due:
        return _sentence(asked)
    same = due and all(abs(abs(v) / size - abs(d) / due) <= EXACT for v, d in zip(values, expected.values, strict=True))
    # Half a unit in the last place turns the vector by as much as half a unit in its last figure changes it.
    if same or answer.angle_place <= 10.0 ** (1 - asked):
        return ""
    places = max(math.ceil(-math.log10(math.degrees(10.0 ** (1 - asked)))), 0)
    return f"write the angle to {10.0**-places:.{places}f}°"


def too_few_in_formula(text: str, asked: int) -> str:
    """The same of a right formula with a rounded number in it, as 0.53 for 8/15: the most exact one counts, others may
    be given so.
    """
    written = [significant(number) for number in _DECIMAL.findall(text)]
    return _sentence(asked) if written and max(written) < asked else ""


def _sentence(asked: int) -> str:
    return f"write {asked} significant figures"


def _last_place(value: float, figures: int) -> float:
    """A unit in the last of so many figures of a number; of a zero it is not known, and large."""
    return 10.0 ** (math.floor(math.log10(abs(value))) - figures + 1) if value else math.inf
