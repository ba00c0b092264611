"""Is a number right? Within a relative tolerance and a share of the scale of the problem, or by significant figures."""

from __future__ import annotations

import math
from collections.abc import Sequence

from planar_cli.homework.sets.paper import Expected
from planar_cli.homework.sets.rules import Rules
from planar_cli.units import parse_unit

FLOOR = 1e-3
"""Share of tolerance times scale that is allowed on top: a true zero has no relative error."""
SLACK = 0.51
"""Of a unit in the last place that is asked for: half of it, and a little for what was rounded twice."""


def within(expected: Expected, values: Sequence[float], rules: Rules, due: Sequence[float] | None = None) -> bool:
    """Is it right within the tolerance? A vector is judged by the size of what it is off. `due`: other numbers than
    those of the key, as own earlier values give them.
    """
    due = expected.values if due is None else due
    if len(values) != len(due):
        return False
    if expected.kind == "list":
        return all(_close(a, b, expected, rules) for a, b in zip(sorted(values), sorted(due), strict=True))
    if expected.kind == "vector":
        size = math.hypot(*due)
        off = math.hypot(*(a - b for a, b in zip(values, due, strict=True)))
        return off <= _allowed(size, expected, rules)
    return _close(values[0], due[0], expected, rules)


def _close(value: float, due: float, expected: Expected, rules: Rules) -> bool:
    off = abs(value - due)
    if expected.direction:
        turn = 2 * math.pi / (float(parse_unit(expected.unit).factor) * math.pi ** parse_unit(expected.unit).pi_power)
        off = abs(math.remainder(value - due, turn))
    return off <= _allowed(abs(due), expected, rules)


def relative(expected: Expected, rules: Rules) -> float:
    """So much a number may be off, as a part of its size."""
    size = math.hypot(*expected.values)
    return _allowed(size, expected, rules) / size if size else 0.0


def _allowed(size: float, expected: Expected, rules: Rules) -> float:
    relative = expected.tolerance if rules.tolerance is None else rules.tolerance
    if rules.mode == "sigfig":
        places = rules.figures - 1 - (math.floor(math.log10(size)) if size else 0)
        return SLACK * 10.0**-places
    return relative * size + FLOOR * relative * expected.scale
