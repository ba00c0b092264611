"""Where watched values change sign, or only just touch zero, within one step of an integration.

A value that dips below zero and comes back within a step has the same sign at both ends: it is found by its minimum.
Where the values and slopes at both ends leave no room for that, nothing within the step is looked at; else the step is
divided, and every part is searched, the first in time first.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

from planar_cli.integrators.base import EPSILON, Step, Vector
from planar_cli.records import record

BAND = 1e-12
"""A watched value below this part of its scale is zero."""
WIDEST_BAND = 1e-4
"""A guard beyond this part of its scale below zero has fallen, at any tolerance."""
PARTS = 8
"""Into so many parts a step is divided that may hide a crossing."""
ROOM = 0.25
"""A value whose estimated minimum stays above this part of its change within the step has no zero there."""
NUDGE = 1e-6
"""The part of a step over which slopes are taken."""
TOGETHER = 1e-9
"""Values that are zero to this part of their scales at the instant of a crossing cross at the same time."""

Values = Callable[[float, Vector], Sequence[float]]


@record
class Watch:
    """Values along a motion, all given by one function."""

    values: Values
    scales: Sequence[float]
    """The size of each value."""
    falling: Sequence[bool] = ()
    """Which values hold a regime together: only their fall below zero counts, and a touch. Left out: all of them do."""

    def falls(self, index: int) -> bool:
        """Is it a guard, of which only falling counts?"""
        return not self.falling or self.falling[index]


@record
class Crossing:
    """A watched value reaches zero."""

    index: int
    """Which value."""
    t: float
    y: Vector
    """The state there, on the dense output."""
    way: str
    """`falls`, `rises`, or `grazes`: touches zero with its smallest size and leaves to the same side again."""


@record
class _Node:
    """An instant of a step at which the values are known."""

    t: float
    values: Sequence[float]
    slopes: Sequence[float]


class Sentinel:
    """Follows the watched values from step to step of one run and says what they reach first.

    A value may start at zero (a contact that has just opened): then its first sign is that which it takes next.
    """

    def __init__(self, watch: Watch, band: float = BAND) -> None:
        self.watch = watch
        self.bands = [band * s for s in watch.scales]
        self.signs: list[int] = []
        """The last sign of each value, 0 as long as it has had none."""
        self._end: _Node | None = None

    def at_start(self, t: float, y: Vector) -> list[Crossing]:
        """The guards that are already broken at the start."""
        values = self.watch.values(t, y)
        self.signs = [self._sign(i, v) for i, v in enumerate(values)]
        return [Crossing(i, t, y, "falls") for i, s in enumerate(self.signs) if s < 0 and self.watch.falls(i)]

    def within(self, step: Step) -> list[Crossing]:
        """What is reached first in the step: one crossing, or several at the same time; [] if nothing is."""
        start = self._end or self._node(step, step.t0, 1.0)
        end = self._node(step, step.t1, -1.0)
        self._end = end
        suspects = [i for i in range(len(end.values)) if self._suspect(i, start, end)]
        if suspects:
            nodes = [start, *self._nodes(step), end]
            for a, b in pairwise(nodes):
                found = [c for i in suspects for c in self._between(step, i, a, b)]
                if found:
                    return self._first(step, found)
        for i, value in enumerate(end.values):
            self.signs[i] = self._sign(i, value) or self.signs[i]
        return []

    def _first(self, step: Step, found: list[Crossing]) -> list[Crossing]:
        """The earliest, and those that cross at the same time."""
        earliest = min(found, key=lambda c: c.t)
        values = self.watch.values(earliest.t, step.at(earliest.t))
        near = [c for c in found if abs(values[c.index]) <= TOGETHER * self.watch.scales[c.index]]
        return [earliest, *(Crossing(c.index, earliest.t, earliest.y, c.way) for c in near if c is not earliest)]

    def _sign(self, index: int, value: float) -> int:
        return 0 if abs(value) <= self.bands[index] else (1 if value > 0 else -1)

    def _node(self, step: Step, t: float, side: float) -> _Node:
        """Values and slopes at a time in the step; slopes are taken on the later side (1) or the earlier one (-1)."""
        small = side * NUDGE * (step.t1 - step.t0)
        y = step.at(t)
        values = self.watch.values(t, y)
        if t in (step.t0, step.t1):
            rates = step.r0 if t == step.t0 else step.r1
            beside = [a + small * r for a, r in zip(y, rates, strict=True)]
        else:
            beside = step.at(t + small)
        return _Node(
            t, values, [(b - a) / small for a, b in zip(values, self.watch.values(t + small, beside), strict=True)]
        )

    def _nodes(self, step: Step) -> list[_Node]:
        h = step.t1 - step.t0
        return [self._node(step, step.t0 + h * k / PARTS, 1.0) for k in range(1, PARTS)]

    def _suspect(self, i: int, start: _Node, end: _Node) -> bool:
        """May the value reach zero within the step, as far as its ends tell?"""
        a, b, h = start.values[i], end.values[i], end.t - start.t
        sign = self.signs[i] or self._sign(i, b)
        if sign == 0:
            return start.slopes[i] != 0.0 or end.slopes[i] != 0.0
        if self._sign(i, a) == 0 or self._sign(i, b) != sign:
            return True
        p, q = sign * start.slopes[i] * h, sign * end.slopes[i] * h
        change = abs(p) + abs(q) + abs(b - a)
        return _lowest(abs(a), p, abs(b), q) < ROOM * change

    def _between(self, step: Step, i: int, a: _Node, b: _Node) -> list[Crossing]:
        """The first thing that value i does between two neighbouring instants."""
        sign, after = self.signs[i], self._sign(i, b.values[i])
        before = self._sign(i, a.values[i])
        if sign == 0:
            return self._leaving(step, i, a, b)
        guard = self.watch.falls(i)
        if sign < 0 and guard:
            self.signs[i] = after or sign
            return []
        if after == -sign:
            near = a.t if before == sign else self._last_with(step, i, sign, a, b)
            return [self._crossing(step, i, near, b.t, sign)]
        h = b.t - a.t
        if sign * a.slopes[i] * h < 0.0 < sign * b.slopes[i] * h:
            t, value = _minimum(lambda t: sign * self._value(step, i, t), a.t, b.t, -self.bands[i])
            if value < -self.bands[i]:
                return [self._crossing(step, i, a.t, t, sign)]
            # Of an event more than rounding separates a touch from a miss: what the integration leaves.
            if value <= (self.bands[i] if guard else TOGETHER * self.watch.scales[i]) and sign in (before, after):
                return [Crossing(i, t, step.at(t), "grazes")]
        if before == 0 and after == sign:
            # Zero was reached exactly at this instant, and is left to the same side again.
            return [Crossing(i, a.t, step.at(a.t), "grazes")]
        return []

    def _leaving(self, step: Step, i: int, a: _Node, b: _Node) -> list[Crossing]:
        """A value that has been zero so far takes its first sign, which for a guard may not be negative."""
        after, slope = self._sign(i, b.values[i]), self._slope_sign(i, a, b.t - a.t)
        guard = self.watch.falls(i)
        if slope and after == -slope and (slope > 0 or not guard):
            # It left to the other side first, and was there for less than the time between the two instants.
            away = self._last_with(step, i, slope, a, b)
            if away > a.t:
                return [self._crossing(step, i, away, b.t, slope)]
        if guard and (after < 0 or (slope < 0 and self._dips(step, i, a, b))):
            return [Crossing(i, a.t, step.at(a.t), "falls")]
        self.signs[i] = after
        return []

    def _dips(self, step: Step, i: int, a: _Node, b: _Node) -> bool:
        """Does the value fall below zero between two instants?"""
        return _minimum(lambda t: self._value(step, i, t), a.t, b.t, -self.bands[i])[1] < -self.bands[i]

    def _slope_sign(self, i: int, a: _Node, h: float) -> int:
        """Which way a value at zero goes, if its change over the interval can be told from rounding."""
        change = a.slopes[i] * h
        return 0 if abs(change) <= self.bands[i] else (1 if change > 0 else -1)

    def _last_with(self, step: Step, i: int, sign: int, a: _Node, b: _Node) -> float:
        """A time soon after a at which the value has this sign; a itself if there is none."""
        h = b.t - a.t
        for _ in range(50):
            h *= 0.5
            if self._sign(i, self._value(step, i, a.t + h)) == sign:
                return a.t + h
        return a.t

    def _crossing(self, step: Step, i: int, before: float, after: float, sign: int) -> Crossing:
        t = root(lambda t: self._value(step, i, t), before, after)
        return Crossing(i, t, step.at(t), "falls" if sign > 0 else "rises")

    def _value(self, step: Step, i: int, t: float) -> float:
        return self.watch.values(t, step.at(t))[i]


def _lowest(a: float, p: float, b: float, q: float) -> float:
    """The least value within [0, 1] of the cubic with values a, b and slopes p, q at its ends."""
    low = min(a, b)
    c3, c2 = p + q + 2.0 * (a - b), 3.0 * (b - a) - 2.0 * p - q
    # The slope 3 c3 x² + 2 c2 x + p vanishes.
    spread = c2 * c2 - 3.0 * c3 * p
    if spread < 0.0:
        return low
    pivot = -(c2 + (spread**0.5 if c2 >= 0.0 else -(spread**0.5)))
    for x in (pivot / (3.0 * c3) if c3 else -1.0, p / pivot if pivot else -1.0):
        if 0.0 < x < 1.0:
            low = min(low, a + x * (p + x * (c2 + x * c3)))
    return low


def root(f: Callable[[float], float], a: float, b: float) -> float:
    """A zero between two times at which the signs differ, to the last digits (Chandrupatla's method)."""
    fa, fb = f(a), f(b)
    if fa == 0.0 or (fa > 0.0) == (fb > 0.0):
        return a if abs(fa) <= abs(fb) else b
    c, fc, share = a, fa, 0.5
    for _ in range(200):
        t = a + share * (b - a)
        ft = f(t)
        if (ft > 0.0) == (fa > 0.0):
            c, fc = a, fa
        else:
            c, b, fc, fb = b, a, fb, fa
        a, fa = t, ft
        best, least = (a, fa) if abs(fa) < abs(fb) else (b, fb)
        room = 2.0 * EPSILON * abs(best) / abs(b - a) if b != a else 1.0
        if least == 0.0 or room > 0.5:
            return best
        xi, phi = (a - b) / (c - b), (fa - fb) / (fc - fb)
        if phi * phi < xi and (1.0 - phi) ** 2 < 1.0 - xi:
            share = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
        else:
            share = 0.5
        share = min(1.0 - room, max(room, share))
    return best


def _minimum(f: Callable[[float], float], a: float, b: float, enough: float) -> tuple[float, float]:
    """The time and size of a minimum between two times (golden section, parabolas); one below `enough` will do."""
    golden = 0.381966011250105
    x = w = v = a + golden * (b - a)
    fx = fw = fv = f(x)
    d = e = 0.0
    a, b = min(a, b), max(a, b)
    close = 1e-8 * (b - a) + 4.0 * EPSILON * abs(x)
    for _ in range(100):
        middle = 0.5 * (a + b)
        if fx < enough or abs(x - middle) <= 2.0 * close - 0.5 * (b - a):
            break
        r, q = (x - w) * (fx - fv), (x - v) * (fx - fw)
        p, q = (x - v) * q - (x - w) * r, 2.0 * (q - r)
        p, q = (-p if q > 0.0 else p), abs(q)
        if abs(e) > close and abs(p) < abs(0.5 * q * e) and q * (a - x) < p < q * (b - x):
            d, e = p / q, d
        else:
            e = (a if x >= middle else b) - x
            d = golden * e
        u = x + (d if abs(d) >= close else (close if d > 0.0 else -close))
        fu = f(u)
        if fu <= fx:
            a, b = (x, b) if u >= x else (a, x)
            v, fv, w, fw, x, fx = w, fw, x, fx, u, fu
        else:
            a, b = (u, b) if u < x else (a, u)
            if fu <= fw or w == x:
                v, fv, w, fw = w, fw, u, fu
            elif fu <= fv or v in (x, w):
                v, fv = u, fu
    return x, fx


def band_at(values: Sequence[float], scales: Sequence[float]) -> float:
    """What counts as zero: more than rounding where a guard that is about to grow begins a little below zero."""
    below = max((-v / s for v, s in zip(values, scales, strict=True)), default=0.0)
    return max(BAND, min(1.5 * below, WIDEST_BAND))
