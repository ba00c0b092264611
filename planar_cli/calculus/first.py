"""The instants at which a function of time vanishes.

A root counts strictly after the beginning: where the function vanishes at `after` itself (to rounding, that is 1e-12
of its scale), the next zero is sought. A function that is zero all along from `after` on has its root there ("stays").
An extreme that reaches zero without crossing it is a root ("touch") if it misses by no more than 1e-9 of the scale, the
largest value nearby; one that goes through by more than 1e-12 makes two crossings. `polish` decides in many digits.
A change of sign across a jump or a pole is no root.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from planar_cli.calculus.panels import EPS, Panel, Scan, period_of
from planar_cli.errors import NotReached
from planar_cli.records import record

MISS = 1e-9
THROUGH = 1e-12
FEW, MOST = 20_000, 400_000
"""Evaluations spent without an end, and with one: beyond these the question is refused."""

Function = Callable[[float], float]


@record
class Root:
    """A root and a bracket about it.

    `kind`: "crossing"; "touch", where `miss` is the value of the extreme; "edge", where the function reaches zero at
    the last instant of its domain; "stays", where it is zero from there to `high`. `sense`: the sign of g after
    a crossing, the sign of g about a touch.
    """

    value: float
    low: float
    high: float
    kind: str = "crossing"
    sense: int = 0
    miss: float = 0.0


def all_roots(g: Function, after: float, until: float, limit: int = 200) -> list[Root]:
    """All roots in (after, until], the first `limit` of them."""
    found: list[Root] = []
    for root in roots(g, after, until):
        found.append(root)
        if len(found) >= limit:
            break
    return found


def roots(
    g: Function,
    after: float,
    horizon: float | None = None,
    scale: float | None = None,
    size: float = 0.0,
    evaluations: int | None = None,
) -> Iterator[Root]:
    """The roots after `after`, one by one, until `horizon` (a time) or, without one, for as long as `evaluations` last
    (20,000 if not given).

    Without a horizon they end after 20,000 evaluations (over a thousand periods of a swinging motion), or where g goes
    away, dies out, or repeats itself without a root. ArithmeticError: a horizon could not be reached.
    """
    if horizon is not None and not horizon > after:
        return
    scan = Scan(g, after, horizon, scale, size, evaluations or (FEW if horizon is None else MOST))
    if scan.first[1] <= 4 * scan.noise + 1e-300 and (panel := scan.fit(after, after + scan.first[0])[0]) is not None:
        yield Root(after, after, panel.hi, "stays")
        return
    walk = _Walk(scan)
    for panel in scan.panels():
        yield from walk.through(panel)
        if horizon is None and walk.repeats():
            return
    yield from walk.finish()
    if not walk.clear and not walk.holes:
        raise NotReached("the values of the function are rounding noise: the size of its terms is needed")
    if scan.exhausted and horizon is not None:
        raise NotReached(f"the function changes too fast: not searched beyond {walk.reached}")


class _Walk:
    """Goes through the panels from one clearly non-zero point to the next."""

    def __init__(self, scan: Scan) -> None:
        self.scan = scan
        self.before: tuple[float, float] | None = None
        self.touch: Root | None = None
        self.near_end: Root | None = None
        self.last: Panel | None = None
        self.reached = scan.after
        self.size = 0.0
        self.clear, self.holes = False, False
        self.extremes: list[tuple[float, float]] = []

    def through(self, panel: Panel) -> Iterator[Root]:
        self.near_end = None
        if panel.hole:
            yield from self._edge()
            self.before, self.touch, self.last, self.reached, self.holes = None, None, None, panel.hi, True
            return
        self.size = max(panel.size, self.size / 2)
        start = panel.lo == self.scan.after
        size = max(self.size, self.scan.first[1]) if start else self.size
        for t, v, stationary in self._points(panel):
            if stationary:
                self.extremes.append((t, v))
            if t == self.scan.after and abs(v) <= max(THROUGH * size, 4 * panel.noise):
                continue
            yield from self._point(panel, t, v, stationary)
        self.last, self.reached = panel, panel.hi

    def _points(self, panel: Panel) -> list[tuple[float, float, bool]]:
        """The ends and the stationary points, the latter refined where they come near zero."""
        points = [(panel.lo, panel.values[0], False)] if self.last is None else []
        if not panel.bernstein:
            low = min(range(len(panel.times)), key=lambda i: abs(panel.values[i]))
            points += [(t, v, i == low) for i, (t, v) in enumerate(zip(panel.times, panel.values, strict=True)) if i]
            return points
        for t in panel.critical():
            v = panel.at(t)
            points.append((*self.scan.refined(panel, t), True) if abs(v) <= 1e-5 * self.size else (t, v, True))
        points.append((panel.hi, panel.values[-1], False))
        return points

    def _point(self, panel: Panel, t: float, v: float, stationary: bool) -> Iterator[Root]:
        zero = 4 * panel.noise
        before = self.before
        same = before is None or (v > 0) == (before[1] > 0)
        miss = MISS if same and before is not None else THROUGH
        closeness = max(zero, miss * self.size) if stationary else zero
        if abs(v) <= closeness:
            if stationary and before is not None and self.touch is None and self.size > 10 * zero:
                reach = min((panel.hi - panel.lo) / 8, (t - before[0]) / 2)
                sense = 1 if before[1] > 0 else -1
                self.touch = Root(t, t - reach, t + reach, "touch", sense, v)
            elif t == self.scan.end and before is not None:
                self.near_end = Root(t, t - 64 * EPS * abs(t), t)
            return
        if before is not None and not same:
            root = self._crossing(before, (t, v), panel)
            self.touch = None
            if root is not None:
                yield root
        elif self.touch is not None and abs(v) > 100 * (abs(self.touch.miss) + zero + EPS * self.scan.largest):
            yield self.touch
            self.touch = None
        self.before, self.clear = (t, v), True

    def _crossing(self, a: tuple[float, float], b: tuple[float, float], panel: Panel) -> Root | None:
        """The root between two points of opposite sign; None: a jump or a pole."""
        closed = _closed_in(self.scan.value, a, b)
        if closed is None:
            return None
        lo, hi = closed
        value = lo[0] if abs(lo[1]) <= abs(hi[1]) else hi[0]
        size = max(abs(a[1]), abs(b[1]), self.size)
        if min(abs(lo[1]), abs(hi[1])) > 0 and max(abs(lo[1]), abs(hi[1])) > 1e-6 * size:
            return None
        low, high = self._bracket(value, a[0], b[0], 1 if b[1] > 0 else -1, panel)
        return Root(value, low, high, "crossing", 1 if b[1] > 0 else -1)

    def _bracket(self, root: float, least: float, most: float, sense: int, panel: Panel) -> tuple[float, float]:
        """How far to either side g is clearly not zero: there the sign is certain whatever the rounding."""
        size = self.scan.first[1] if root - self.scan.after < self.scan.unit else 0.0
        clear = 16 * max(panel.noise, EPS * self.size, EPS * size)
        ends = []
        for side, limit in ((-1, least), (1, most)):
            step = 4 * EPS * max(abs(root), abs(self.scan.after))
            while (t := root + side * step) * side < limit * side:
                v = self.scan.value(t)
                if v is not None and v * side * sense >= clear:
                    break
                step *= 4
            ends.append(t if t * side < limit * side else limit)
        return ends[0], ends[1]

    def _edge(self) -> Iterator[Root]:
        """Does g run into zero at the very edge of its domain, as a square root does?"""
        if self.last is None or self.before is None:
            return
        edge = self.scan.edge(self.reached)
        if edge is None:
            return
        inside, outside = edge
        step = 1e4 * max(outside - inside, EPS * abs(inside))
        here, back = self.scan.value(inside), self.scan.value(inside - step)
        if here is not None and back is not None and abs(here) <= min(0.05 * abs(back), 1e-6 * self.size):
            yield Root(inside, inside - step, inside, "edge", 0, here)

    def finish(self) -> Iterator[Root]:
        """A touch or zero at the very end."""
        if self.touch is not None and self.scan.until is not None and self.touch.value <= self.scan.until:
            yield self.touch
        elif self.near_end is not None:
            yield self.near_end

    def repeats(self) -> bool:
        """Have the extremes so far repeated themselves without coming near zero?"""
        return (
            period_of(self.extremes, self.size) is not None
            and min(abs(v) for _, v in self.extremes[-13:]) > 1e-5 * self.size
        )


def _closed_in(
    g: Callable[[float], float | None], a: tuple[float, float], b: tuple[float, float]
) -> tuple[tuple[float, float], tuple[float, float]] | None:
    """The bracket shrunk to neighbouring floats: inverse quadratic steps or halving, after Chandrupatla (1997).

    None: no value in between, a pole.
    """
    (xa, fa), (xb, fb) = a, b
    x = (xa + xb) / 2
    for _ in range(200):
        f = g(x)
        if f is None:
            return None
        if f == 0:
            return (x, 0.0), (x, 0.0)
        if (f > 0) == (fa > 0):
            xc, fc, xa, fa = xa, fa, x, f
        else:
            xc, fc, xb, fb, xa, fa = xb, fb, xa, fa, x, f
        width = abs(xb - xa)
        if width <= 2 * EPS * max(abs(xa), abs(xb)) or (xa + xb) / 2 in {xa, xb}:
            break
        xi, phi = (xa - xb) / (xc - xb), (fa - fb) / (fc - fb)
        share = 0.5
        if phi**2 < xi and (1 - phi) ** 2 < 1 - xi:
            share = fa / (fb - fa) * fc / (fb - fc) + (xc - xa) / (xb - xa) * fa / (fc - fa) * fb / (fc - fb)
        least = EPS * max(abs(xa), abs(xb)) / width
        x = xa + min(max(share, least), 1 - least) * (xb - xa)
    pair = sorted([(xa, fa), (xb, fb)])
    return pair[0], pair[1]
