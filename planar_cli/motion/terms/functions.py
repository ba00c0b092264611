"""What terms may call: common functions, values given by a table, and angles that go on over many turns."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Callable
from dataclasses import field
from itertools import pairwise

from planar_cli.records import changing, record

EXACT = 4e-16
"""The part of two plain numbers below which their sum is nothing but the rounding of them."""
FUNCTIONS: dict[str, Callable[..., float]] = {
    "sqrt": math.sqrt,
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "asin": math.asin,
    "acos": math.acos,
    "atan": math.atan,
    "atan2": math.atan2,
    "exp": math.exp,
    "log": math.log,
    "abs": abs,
    "sign": lambda x: math.copysign(1.0, x) if x else 0.0,
    "step": lambda x: 1.0 if x >= 0 else 0.0,
}
"""What a term may call, by the name that it has in the code too."""


@changing
class Turning:
    """An angle that goes on over many turns: the direction of (x, y) that is nearest to the last one noted.

    Whoever follows a motion notes the angle at the end of every step, which turns it by less than half a turn. An angle
    that the steps do not follow, as no equation of motion holds it, may turn further in one of them: it is asked for
    with the time, and noted all along the way.
    """

    start: float
    """In the reference configuration [rad]."""
    last: float
    """As last noted [rad]."""
    times: list[float] = field(default_factory=list)
    """When it was noted along the way [s], ascending."""
    angles: list[float] = field(default_factory=list)
    """What it was then [rad]."""

    def at(self, y: float, x: float, t: float | None = None) -> float:
        """The angle [rad], at a time of the way [s]."""
        found, near = math.atan2(y, x), self.last if t is None else self._near(t)
        return found + math.tau * round((near - found) / math.tau)

    def note(self, t: float, angle: float) -> None:
        """It has come to this."""
        self.last = angle
        if not self.times or t > self.times[-1]:
            self.times.append(t)
            self.angles.append(angle)

    def recall(self, t: float) -> None:
        """What was noted last before a time of the way [s]."""
        if self.times:
            self.last = self._near(t)

    def begin(self) -> None:
        """Nothing has been noted yet."""
        self.last = self.start
        self.times.clear()
        self.angles.clear()

    def _near(self, t: float) -> float:
        """About what it is at a time: straight between and beyond the times that were noted."""
        times, angles = self.times, self.angles
        if len(times) < 2:
            return angles[0] if times else self.last
        k = min(max(bisect_right(times, t), 1), len(times) - 1)
        share = (t - times[k - 1]) / (times[k] - times[k - 1])
        return angles[k - 1] + share * (angles[k] - angles[k - 1])


@changing
class Sliding:
    """The direction of a sliding that may come to rest: it stays the one last noted until it is noted anew.

    So a motion goes smoothly through the instant at which the speed vanishes, where it becomes negative.
    """

    x: float = 0.0
    y: float = 0.0
    """The unit vector last noted; zero: there was none."""
    least: float = 0.0
    """A speed up to this is rounding, and has no direction of its own [m/s]."""

    def along_x(self, vx: float, vy: float) -> float:
        """The x part of the direction."""
        speed = self.speed(vx, vy)
        return vx / speed if abs(speed) > self.least else self.x

    def along_y(self, vx: float, vy: float) -> float:
        """The y part of the direction."""
        speed = self.speed(vx, vy)
        return vy / speed if abs(speed) > self.least else self.y

    def speed(self, vx: float, vy: float) -> float:
        """The speed in that direction [m/s]."""
        return math.copysign(math.hypot(vx, vy), vx * self.x + vy * self.y)

    def note(self, vx: float, vy: float) -> bool:
        """From now on the direction of this vector counts, unless it is too small to have one; has it?"""
        size = math.hypot(vx, vy)
        if size > self.least:
            self.x, self.y = vx / size, vy / size
        return size > self.least


@record
class Table:
    """Values over an argument, in ascending order: straight in between (or steps), constant before and after."""

    points: tuple[tuple[float, float], ...]
    steps: bool = False
    """Constant from each point to the next; zero before the first."""

    def at(self, x: float) -> float:
        """The value at x."""
        points = self.points
        if self.steps:
            return next((y for a, y in reversed(points) if a <= x), 0.0)
        if x <= points[0][0]:
            return points[0][1]
        for (a, y), (b, z) in pairwise(points):
            if x < b:
                return y + (z - y) * (x - a) / (b - a)
        return points[-1][1]

    def slopes(self) -> Table:
        """Its derivative."""
        rises = [(a, (z - y) / (b - a)) for (a, y), (b, z) in pairwise(self.points)]
        return Table((*rises, (self.points[-1][0], 0.0)), steps=True)


def summed(a: float, b: float) -> float:
    """a + b; zero where they differ by rounding only."""
    total = a + b
    return 0.0 if abs(total) <= EXACT * max(abs(a), abs(b)) else total


def real_power(base: float, exponent: float) -> float:
    """base^exponent. ValueError: it is not real, as v^(3/2) where a step tries a negative v."""
    found: float | complex = base**exponent
    if isinstance(found, complex):
        raise ValueError("a power that is not real")
    return found


def safely(function: Callable[..., float], *values: float) -> float:
    """The value, or nan outside the domain: only what is evaluated there must have one."""
    try:
        found = function(*values)
    except (ValueError, ZeroDivisionError, OverflowError):
        return math.nan
    return found if isinstance(found, int | float) else math.nan


NODES = ((0.1488743389816312, 0.29552422471475287), (0.4333953941292472, 0.26926671930999635),
         (0.6794095682990244, 0.21908636251598204), (0.8650633666889845, 0.1494513491505806),
         (0.9739065285171717, 0.06667134430868814))  # fmt: skip
"""Gauss's quadrature of order 20 on (-1, 1): nodes of one half with their weights."""


@changing
class Integral:
    """An antiderivative by quadrature over panels of a fixed width; what was computed of whole panels is kept."""

    of: Callable[[float], float]
    """The integrand."""
    start: float
    """Where it is zero."""
    panel: float
    """The width of a panel."""
    _whole: dict[int, float] = field(default_factory=lambda: {0: 0.0})

    def at(self, x: float) -> float:
        """From the start to x."""
        number = int((x - self.start) / self.panel)
        edge = self.start + number * self.panel
        return self._panels(number) + self._over(edge, x)

    def _panels(self, number: int) -> float:
        """Over so many panels; negative: to the left."""
        step = 1 if number > 0 else -1
        done = number
        while done not in self._whole:
            done -= step
        while done != number:
            edge = self.start + done * self.panel
            self._whole[done + step] = self._whole[done] + self._over(edge, edge + step * self.panel)
            done += step
        return self._whole[number]

    def _over(self, a: float, b: float) -> float:
        middle, half = (a + b) / 2, (b - a) / 2
        return half * sum(w * (self.of(middle - half * x) + self.of(middle + half * x)) for x, w in NODES)


def own_size(name: str, size: float, *_: float) -> float:
    """How large the rounding scale of a function's value is at least, by that of its argument."""
    if name in ("sin", "cos", "sign", "step"):
        # They round on the scale of 1.
        return 1.0
    if name == "sqrt":
        return math.sqrt(size) if size < math.inf else math.inf
    return size if name == "abs" else 0.0
