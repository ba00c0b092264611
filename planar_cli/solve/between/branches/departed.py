"""Bodies that go their own way on the last stretch, and of which nothing is said or asked there.

What else moves may come to rest at a top, where it is after endless time only: then nothing can be said of where they
are by then, and nothing needs to be.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

import sympy as sp

from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.regimes.regime import Regime


def without_departed(course: MotionEquations, asked: Collection[sp.Symbol]) -> MotionEquations | None:
    """The motion without the equations that tell where these are at the last state; None: there are no such."""
    last = course.states[-1].name
    stop, laws = course.stops[last].letters, [e for e in course.equations if e.stop == last]
    time = course.stops[last].t
    said = {s for d in course.demands[last] for s in d.residual.free_symbols} | set(asked)
    said |= {s for e in laws if e.kind == "given" for s in e.residual.free_symbols}
    departed: set[sp.Symbol] = set()
    for group in apart(course.regimes[len(course.states) - 2]):
        own = {stop[s] for s in group if s in stop}
        departed |= own if not own & said else set()
    if not departed or time in said:
        return None
    kept = tuple(e for e in course.equations if not e.residual.free_symbols & departed)
    times = [e for e in kept if e.stop == last and time in e.residual.free_symbols]
    return replace(course, equations=tuple(e for e in kept if e not in times))


def apart(regime: Regime) -> list[set[sp.Symbol]]:
    """The coordinates and free speeds of a regime in groups whose motions do not rest on each other."""
    groups: list[set[sp.Symbol]] = []
    own = {*(c.symbol for c in regime.coordinates), *regime.free}
    for symbol, rate in {**regime.rates, **regime.accelerations}.items():
        together = {symbol, *(rate.free_symbols & own)}
        met = [g for g in groups if g & together]
        groups = [g for g in groups if g not in met] + [together.union(*met)]
    return groups
