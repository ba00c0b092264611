"""The order in which a page answers: state by state, as the motion goes; at one state as the file asks.

What is asked of two states of one throw, where it strikes and then where it is parallel to a slope, follows from the
same functions of the time since its start, so that either can come first: there too the file has its order.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

import sympy as sp

from planar_cli.solve.between.equations.asked_finds import AskedFind
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.law import Law


def in_order(course: StatedMotion, finds: Sequence[AskedFind], targets: Collection[sp.Symbol]) -> list[sp.Symbol]:
    """The letters of states that are asked for; what is sought comes first."""
    names = [s.name for s in course.states]
    place = {own: names.index(stop.name) + 1 for stop in course.stops.values() if stop.name in names
             for own in stop.letters.values()}  # fmt: skip
    asked: dict[sp.Symbol, int] = {}
    for i, find in enumerate(finds):
        for s in sorted({s for p in find.parts() for s in p.free_symbols}, key=lambda s: s.name):
            asked.setdefault(s, i)
    throw = [0, *_throws(course)]
    first = {i: min(n for s, n in asked.items() if place.get(s) == i) for i in {place[s] for s in asked if s in place}}

    def key(s: sp.Symbol) -> tuple[int, int, int, int, str]:
        i, own = place.get(s, 0), asked.get(s, len(finds))
        return throw[i], first.get(i, len(finds)) if i else 0, i, own, s.name

    return sorted(targets, key=key)


def _throws(course: StatedMotion) -> list[int]:
    """For each state a number, the same one for the states after the start of one throw."""
    found = [1]
    for k, (law, regime) in enumerate(zip(course.laws, course.regimes, strict=False)):
        on = k > 0 and found[-1] > 1 and regime is course.regimes[k - 1] and not {k, k - 1} & set(course.blows)
        found.append(found[-1] if on and _is_throw(law.laws) else found[-1] + 1)
    return found


def _is_throw(laws: Sequence[Law]) -> bool:
    """Constant accelerations along x and y, one of which need not be zero."""
    axes = {law.coordinate.words.partition(" of ")[0] for law in laws}
    steady = all(law.order == 2 and law.steady for law in laws)
    return steady and axes == {"x", "y"} and any(law.f != 0 for law in laws)
