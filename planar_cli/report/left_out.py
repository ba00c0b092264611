"""Roots of a motion that were not taken, each with the condition that rules it out: a time that is not after the state
before, a motion in the other sense, a place on the other side of the start.
"""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.ledger import Kind
from planar_cli.report.blocks import Line, Math, Name, line
from planar_cli.solve.between.trace import MotionTrace, Result

SENSES = {
    "omega": ("it turns counterclockwise there", "it turns clockwise there"),
    "x": ("it moves to the right there", "it moves to the left there"),
    "y": ("it moves upward there", "it moves downward there"),
}


def reason(found: MotionTrace, r: Result, others: list[Decimal]) -> Line:
    """Why the other roots of a letter are left out."""
    general = found.general[r.unknown]
    kind, stop = found.ledger.roles[general].kind, found.ledger.roles[r.unknown].at or ""
    if kind is Kind.TIME:
        return _later(found, r, stop, others)
    if kind is Kind.SPEED and all(v * r.value < 0 for v in others):
        return _sense(general.name, r.value > 0)
    if kind is Kind.COORDINATE:
        return _side(found, r, stop, others)
    return line(_by_sign(r.value, others))


def _later(found: MotionTrace, r: Result, stop: str, others: list[Decimal]) -> Line:
    """Of times the first one after the state before."""
    earlier = _before(found, r.unknown, stop)
    bound = sp.S.Zero if earlier is None or found.value.is_zero(earlier) else earlier
    after = line(Math(r.unknown), " > ", Math(bound))
    return after if all(v < r.value for v in others) else line("the smallest root with ", *after, " is meant")


def _before(found: MotionTrace, unknown: sp.Symbol, stop: str) -> sp.Symbol | None:
    """The same letter in the state before, where it has a value."""
    if stop not in found.states[1:]:
        return None
    since = found.states[found.states.index(stop) - 1]
    general = found.general[unknown]
    own = (s for s, g in found.general.items() if g == general and found.ledger.roles[s].at == since)
    return next((s for s in own if found.value.known(s) is not None), None)


def _sense(name: str, positive: bool) -> Line:
    """In which sense something moves; by the letter of its speed where that tells the axis."""
    stem, *pieces = name.split("_")
    if pieces[-1:] == ["dot"]:
        return line(Name(name.removesuffix("_dot")), " grows there" if positive else " decreases there")
    key = "omega" if stem == "omega" else pieces[-1][-1:] if stem == "v" and pieces else ""
    if key in SENSES:
        return line(SENSES[key][0 if positive else 1])
    return line(f"it moves in the {'positive' if positive else 'negative'} sense there")


def _side(found: MotionTrace, r: Result, stop: str, others: list[Decimal]) -> Line:
    """A place is on the side to which the motion goes from the state before."""
    earlier = _before(found, r.unknown, stop)
    start = found.value.known(earlier) if earlier is not None else None
    if earlier is None or start is None or start == r.value:
        return line(_by_sign(r.value, others))
    grows = r.value > start
    if all((v - start) * (r.value - start) <= 0 or _close(v, start) for v in others):
        return line(Math(r.unknown), " > " if grows else " < ", Math(earlier))
    if all(abs(v - start) > abs(r.value - start) for v in others):
        return line(Math(r.unknown), " is reached first")
    return line(_by_sign(r.value, others))


def _close(a: Decimal, b: Decimal) -> bool:
    return abs(a - b) <= (abs(a) + abs(b)) * Decimal("1e-9")


def _by_sign(value: Decimal, others: list[Decimal]) -> str:
    """Which root is taken, by its sign or size."""
    several = len(others) > 1
    if all(v * value < 0 for v in others):
        return f"the {'positive' if value > 0 else 'negative'} root is taken"
    if all(v < value for v in others):
        return f"the {'largest' if several else 'larger'} root is taken"
    if all(v > value for v in others):
        return f"the {'smallest' if several else 'smaller'} root is taken"
    return "these lie on other branches"
