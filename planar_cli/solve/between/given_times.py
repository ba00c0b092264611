"""The times at which the file puts states."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.exact import Valuation
from planar_cli.solve.between.stated_motion import StatedMotion
from planar_cli.solve.regimes.mode_sequence import fixed_time


def latest_given(course: StatedMotion, value: Valuation) -> Decimal | None:
    """The latest time that a state is given at, in s; None: not all of them have one, or it is infinite."""
    times = []
    for k, state in enumerate(course.states):
        if without_end(course, k) or fixed_time(state.relations) is None:
            return None
        times.append(given_time(course, value, state.name))
    return Decimal(repr(max(times)))


def given_time(course: StatedMotion, value: Valuation, name: str) -> float:
    """The time that a state is given at, in s."""
    stop = course.stops[name]
    stated = fixed_time(stop.relations)
    assert stated is not None
    own = next(d for d in course.demands[name] if d.kind == "equation" and d.text == stated.text)
    return float(value(sp.solve(own.residual, stop.t)[0]))


def without_end(course: StatedMotion, k: int) -> bool:
    """Is state k at t = infinity?"""
    return any(d.kind == "limit" for d in course.demands[course.states[k].name])


def asked_without_end(course: StatedMotion, k: int) -> list[int]:
    """State k and what its relations speak of, as far as that is at t = infinity and not before it in the file."""
    spoken = {s for d in course.demands[course.states[k].name] for s in d.residual.free_symbols}
    later = [n for n in range(k, len(course.states)) if without_end(course, n)]
    return [n for n in later if n == k or spoken & set(course.stops[course.states[n].name].letters.values())]
