"""What happens along one stretch of a motion that is followed in numbers: the instants at which a function vanishes."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.calculus.first import Root, roots
from planar_cli.calculus.flow import Flow
from planar_cli.equation.exact import Valuation
from planar_cli.equation.plain import parts_of
from planar_cli.equation.scales import SLACK
from planar_cli.errors import NoValue
from planar_cli.records import record
from planar_cli.solve.regimes.regime import Regime, number_function
from planar_cli.units import RATE

NOTICEABLE = 0.1
WINDOWS = (20, 50, 100, 200, 500, 1000, 2000)
SLOW_WINDOWS = (1, 3, 10, 30, 100)
"""How far a state is looked for, in characteristic times; the motion is never followed much beyond what is found."""
LOOKS, NEARBY, DEAD = 8, 0.01, 1e-12
"""A function is looked at so often before a zero, and so near to it; below this part of its size it has died out."""
NEAR = 1e-7
"""A relation counts as fulfilled below this part of what it was nearby."""
State = dict[sp.Symbol, float]


@record
class FollowedSegment:
    """One stretch in numbers: from t0 to t1 [s]."""

    regime: Regime
    flow: Flow | None
    """The letters of the regime, integrated; None: nothing varies."""
    t0: float
    t1: float
    start: State
    swing: float = math.inf
    """A time in which its laws themselves change [s]."""
    length: float = 1.0
    """What counts as a large length in it [m]."""
    pace: float = 1.0
    """An ordinary time of the scene [s]."""

    def at(self, t: float) -> State:
        """All letters at a time."""
        if self.flow is None:
            return {**self.start, self.regime.time: t}
        letters = self.regime.letters[1:]
        return {**self.start, self.regime.time: t, **dict(zip(letters, map(float, self.flow.at(t)), strict=True))}


def scale_of(segment: FollowedSegment) -> float:
    """A time in which something moves noticeably: by a radian, or by the largest length in sight."""
    if segment.flow is None:
        return min(segment.pace, segment.swing)
    regime = segment.regime
    rates = [abs(float(r)) for r in segment.flow.rates(segment.t0)]
    sizes = [segment.length if c.unit != "rad" else 1.0 for c in regime.coordinates]
    times = [size / r for size, r in zip(sizes, rates, strict=False) if r]
    turning = angular_speeds(regime)
    for u, a in zip(regime.free, rates[len(regime.coordinates) :], strict=True):
        size = 1.0 if u in turning else segment.length
        if a:
            times.append(math.sqrt(size / a))
    shortest = min([*times, segment.swing])
    return shortest if math.isfinite(shortest) else segment.pace


def angular_speeds(regime: Regime) -> set[sp.Symbol]:
    """The free speeds that are angular: also a point on a circle may have a speed in m/s."""
    units = regime.general.instant.scene.ledger.units
    return {u for u in regime.free if units[u].dimension == RATE}


def windows(segment: FollowedSegment, scale: float) -> Iterator[float]:
    """How far a state is looked for: so many characteristic times, and as long as the speeds change slowly."""
    yield from (count * scale for count in WINDOWS)
    if segment.flow is None:
        return
    rates = [abs(float(r)) for r in segment.flow.rates(segment.t0)][len(segment.regime.coordinates) :]
    slow = max((abs(segment.start[u]) / a for u, a in zip(segment.regime.free, rates, strict=True) if a), default=0.0)
    yield from (count * slow for count in SLOW_WINDOWS if count * slow > WINDOWS[-1] * scale)


def length_of(regime: Regime, state: State, rates: Sequence[float], value: Valuation, ordinary: float) -> float:
    """The largest length in sight: of a coordinate, else of the drawing, else a noticeable part of the way on which
    a speed changes by its own size, else an `ordinary` one. `rates`: of the coordinates and the free speeds.
    """
    straight = [c for c in regime.coordinates if c.unit != "rad"]
    drawn = _drawn(regime, state, value)
    largest = max((abs(state[c.symbol]) for c in straight), default=0.0)
    if largest > SLACK * drawn:
        return largest
    if drawn:
        return drawn
    turning = angular_speeds(regime)
    speeds = [abs(r) for c, r in zip(regime.coordinates, rates, strict=False) if c.unit != "rad"]
    changes = [abs(a) for u, a in zip(regime.free, rates[len(regime.coordinates) :], strict=True) if u not in turning]
    speed, change = max(speeds, default=0.0), max(changes, default=0.0)
    way = speed * speed / change if change else 0.0
    return NOTICEABLE * way or ordinary


def _drawn(regime: Regime, state: State, value: Valuation) -> float:
    """The largest distance of a named point from the origin."""
    here = value.extended({s: Decimal(repr(v)) for s, v in state.items()})
    found = [0.0]
    for place in regime.general.instant.scene.points.values():
        for part in (place.x, place.y):
            number = here.known(part)
            if number is not None:
                found.append(abs(float(number)))
    return max(found)


def swing_of(regime: Regime, state: State, value: Valuation) -> float:
    """The shortest time in which a sine or an exponential of time in the laws of a regime changes."""
    exprs = [*regime.rates.values(), *regime.accelerations.values()]
    known = (sp.sin, sp.cos, sp.tan, sp.exp)
    waves = {a.args[0] for a in parts_of(exprs) if isinstance(a, known) and regime.time in a.free_symbols}
    paces = [sp.diff(w, regime.time) for w in waves]
    numbers = number_function(paces, regime.letters, value)(*(state[s] for s in regime.letters)) if paces else []
    return min((1 / abs(n) for n in numbers if n), default=math.inf)


def events(g: Callable[[float], float], segment: FollowedSegment, until: float | None = None) -> Iterator[Root]:
    """Roots along a segment in order, window by window."""
    scale, begin = scale_of(segment), segment.t0
    for reach in windows(segment, scale):
        if begin > segment.t0 and _came_to_rest(segment, begin):
            return
        end = segment.t0 + reach
        if until is not None:
            end = min(end, until)
        try:
            for root in roots(g, begin, end, scale):
                if root.value > segment.t0 and not _died_out(g, root.value, segment):
                    yield root
        except NoValue:
            return
        if until is not None and end >= until:
            return
        begin = end


def far_along(segment: FollowedSegment) -> State:
    """The letters of a segment as late as its motion is looked at, or once nothing changes any more."""
    found = segment.start
    for reach in windows(segment, scale_of(segment)):
        try:
            found = segment.at(segment.t0 + reach)
        except NoValue:
            break
        if _came_to_rest(segment, segment.t0 + reach):
            break
    return found


def _came_to_rest(segment: FollowedSegment, t: float) -> bool:
    """Does nothing change any more, as far as machine numbers tell, or can they not tell it?"""
    regime = segment.regime
    laws = [*regime.rates.values(), *regime.accelerations.values()]
    if segment.flow is None or any(regime.time in e.free_symbols for e in laws):
        return False
    try:
        first, now = segment.flow.rates(segment.t0), segment.flow.rates(t)
    except NoValue:
        return True
    return max(abs(float(r)) for r in now) <= DEAD * max(abs(float(r)) for r in first)


def _died_out(g: Callable[[float], float], t: float, segment: FollowedSegment) -> bool:
    """Has a function sunk below what machine numbers tell of it, so that its zeros mean nothing?"""
    run = t - segment.t0
    largest = max(abs(g(segment.t0 + run * k / LOOKS)) for k in range(LOOKS))
    near = max(abs(g(t - NEARBY * run)), abs(g(t + NEARBY * run)))
    return near <= DEAD * largest


def vanishes_throughout(g: Callable[[float], float], segment: FollowedSegment, size: float) -> bool:
    """Does a function vanish from the beginning on? `size`: what it is measured by."""
    run = scale_of(segment)
    return all(abs(g(segment.t0 + run * k / LOOKS)) <= SLACK * size for k in range(LOOKS))


def is_zero(g: Callable[[float], float], t: float, segment: FollowedSegment, size: float) -> bool:
    """Does a function vanish at a time, as far as machine numbers tell? `size`: what it is measured by."""
    nearby = max(abs(g(segment.t0)), abs(g(t - (t - segment.t0) / 3)))
    return abs(g(t)) <= max(NEAR * nearby, SLACK * size)
