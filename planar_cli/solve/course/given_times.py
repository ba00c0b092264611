"""The times at which the file puts states."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.exact import Valuation
from planar_cli.solve.course.mode_sequence import fixed_time
from planar_cli.solve.course.stated_motion import StatedMotion


def latest_given(course: StatedMotion, value: Valuation) -> Decimal | None:
    """The latest time that a state is given at, in s; None: not all of them have one, or it is infinite."""
    times = []
    for state in course.states:
        unending = any(d.kind == "limit" for d in course.demands[state.name])
        if unending or fixed_time(state.relations) is None:
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
