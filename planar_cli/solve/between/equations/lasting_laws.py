"""A constant velocity that goes on unchanged while something else begins: one law from its own start, x_A = ẋ_A t, and
not one for each of the stretches between the states of another body.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.law import Law
from planar_cli.solve.regimes.equations import Equation, law_equations


def lasting_equations(motion: StatedMotion, i: int, since: int) -> Iterator[Equation]:
    """What constant velocities say of state `i` from an earlier start than state `since`, where the stretch begins."""
    if not since or motion.blows:
        return
    regime, stop = motion.readers[motion.states[i].name].regime, motion.stops[motion.states[i].name]
    for law in motion.laws[i - 1].laws:
        if law.order != 1 or law.f.free_symbols & set(regime.letters):
            continue
        begin = since
        while begin and any(_is_same(law, other) for other in motion.laws[begin - 1].laws):
            begin -= 1
        if begin < since:
            start, alone = motion.stops[motion.states[begin].name], replace(motion.laws[i - 1], laws=(law,), links=())
            yield from law_equations(alone, start, stop, regime, regime.general.value.extended(motion.settled()))


def _is_same(law: Law, other: Law) -> bool:
    return other.coordinate.symbol == law.coordinate.symbol and (other.order, other.f) == (law.order, law.f)
