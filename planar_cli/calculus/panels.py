"""A smooth function of time cut into panels, on each of which a polynomial of degree 12 stands for it.

A panel counts as resolved when the polynomial through 13 of its values predicts three more, at places with no
regular spacing, to ten digits of the largest value there. Narrow features announce themselves in their neighbourhood
and make the panels small; a pulse that is exactly nothing outside itself does not, and its times must be given as ends.
Where the function is rounding noise, or has a kink or a jump, the panel says so instead of being resolved.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from itertools import pairwise

from planar_cli.records import record

DEGREE = 12
TOLERANCE = 1e-10
EPS = 2.0**-52
CHECKS = (0.0419, 0.4637, 0.8911)
SPLIT = 0.487
DEPTH = 24
FOREVER = 1e15
"""A search without an end stops after so many times its first width."""


@record
class Panel:
    """One stretch of time: `times` and `values` are samples, ends included; `bernstein` the polynomial on it.

    `size` is the largest sampled |g|, `noise` what cannot be told from zero. Without a polynomial the stretch is a few
    floats wide and holds a kink, a jump, or (`hole`) leaves the domain of g.
    """

    lo: float
    hi: float
    times: tuple[float, ...]
    values: tuple[float, ...]
    bernstein: tuple[float, ...]
    size: float
    noise: float
    hole: bool = False

    def at(self, t: float) -> float:
        """The polynomial at a time."""
        return casteljau(self.bernstein, (t - self.lo) / (self.hi - self.lo))

    def critical(self) -> list[float]:
        """The times inside at which the polynomial is stationary, in order."""
        span = self.hi - self.lo
        return [self.lo + span * x for x in stationary(self.bernstein)]


@lru_cache(maxsize=1)
def places() -> tuple[float, ...]:
    """The Chebyshev points on [0, 1]."""
    return tuple(math.sin(math.pi * j / (2 * DEGREE)) ** 2 for j in range(DEGREE + 1))


@lru_cache(maxsize=1)
def _from_samples() -> tuple[tuple[tuple[float, ...], ...], tuple[tuple[float, ...], ...]]:
    """Rows that turn 13 samples into Bernstein coefficients, and into the values at the check points."""
    n = DEGREE
    chebyshev = [[_dct(k, j) for j in range(n + 1)] for k in range(n + 1)]
    degree = [[_bernstein_of_chebyshev(k, i) for k in range(n + 1)] for i in range(n + 1)]
    rows = tuple(
        tuple(math.fsum(degree[i][k] * chebyshev[k][j] for k in range(n + 1)) for j in range(n + 1))
        for i in range(n + 1)
    )
    checks = []
    for x in CHECKS:
        angle = math.acos(2 * x - 1)
        checks.append(
            tuple(math.fsum(math.cos(k * angle) * c[j] for k, c in enumerate(chebyshev)) for j in range(n + 1))
        )
    return rows, tuple(checks)


def _dct(k: int, j: int) -> float:
    """The weight of sample j (from x = -1 upwards) in the Chebyshev coefficient k."""
    n = DEGREE
    weight: float = (1.0 if k in {0, n} else 2.0) * (0.5 if j in {0, n} else 1.0) / n
    return weight * math.cos(math.pi * k * (n - j) / n)


def _bernstein_of_chebyshev(k: int, i: int) -> float:
    """Coefficient i, in the Bernstein basis of degree 12, of the Chebyshev polynomial T_k."""
    n = DEGREE
    total = sum(
        (-1.0) ** (k - m) * math.comb(2 * k, 2 * m) * math.comb(n - k, i - m)
        for m in range(max(0, i - n + k), min(k, i) + 1)
    )
    return float(total / math.comb(n, i))


def casteljau(b: Sequence[float], x: float) -> float:
    """The value at x in [0, 1] of a polynomial in the Bernstein basis."""
    work = list(b)
    y = 1 - x
    while len(work) > 1:
        work = [y * p + x * q for p, q in pairwise(work)]
    return work[0]


def _halves(b: Sequence[float], x: float) -> tuple[list[float], list[float]]:
    work, left, right = list(b), [b[0]], [b[-1]]
    y = 1 - x
    while len(work) > 1:
        work = [y * p + x * q for p, q in pairwise(work)]
        left.append(work[0])
        right.append(work[-1])
    return left, right[::-1]


def stationary(b: Sequence[float]) -> list[float]:
    """Where in (0, 1) the derivative of a Bernstein polynomial vanishes: Descartes' rule on ever smaller pieces."""
    d = [len(b) * (q - p) for p, q in pairwise(b)]
    steepest = max(map(abs, d), default=0.0)
    if steepest <= TOLERANCE / 10 * max(map(abs, b)):
        return []
    found: list[float] = []
    stack = [(d, 0.0, 1.0, 0)]
    while stack:
        piece, lo, hi, depth = stack.pop()
        signs = [v > 0 for v in piece if v]
        changes = sum(p != q for p, q in pairwise(signs))
        if changes == 0:
            continue
        if changes == 1 and piece[0] * piece[-1] < 0:
            found.append(lo + (hi - lo) * _single(piece))
        elif depth >= DEPTH:
            found.append((lo + hi) / 2)
        else:
            left, right = _halves(piece, SPLIT)
            middle = lo + SPLIT * (hi - lo)
            stack.append((right, middle, hi, depth + 1))
            stack.append((left, lo, middle, depth + 1))
    return sorted(found)


def _single(piece: Sequence[float]) -> float:
    """The one root of a piece that changes sign once: regula falsi with the Illinois weight."""
    a, fa, b, fb, side = 0.0, piece[0], 1.0, piece[-1], 0
    small = 1e-16 * max(map(abs, piece))
    for _ in range(60):
        x = (a * fb - b * fa) / (fb - fa)
        f = casteljau(piece, x)
        if abs(f) <= small or b - a < 1e-15:
            return x
        if (f > 0) == (fb > 0):
            b, fb = x, f
            fa, side = (fa / 2 if side < 0 else fa), -1
        else:
            a, fa = x, f
            fb, side = (fb / 2 if side > 0 else fb), 1
    return (a + b) / 2


def period_of(extremes: list[tuple[float, float]], size: float) -> float | None:
    """The period, if the last extremes repeat earlier ones in value and spacing four times over."""
    for n in (2, 4, 6, 8, 12):
        if len(extremes) < 5 * n:
            break
        tail = extremes[-5 * n :]
        period = (tail[-1][0] - tail[n - 1][0]) / 4
        pairs = list(zip(tail, tail[n:], strict=False))
        if all(abs(b[1] - a[1]) <= 1e-9 * size and abs(b[0] - a[0] - period) <= 1e-6 * period for a, b in pairs):
            return period
    return None


class Scan:
    """The panels of g from `after` on; `until` None: for as long as it is worth while.

    `scale`: a time in which g changes noticeably, `size`: the size of the terms of which g is the difference; both
    are found out when not given.
    """

    def __init__(
        self,
        g: Callable[[float], float],
        after: float,
        until: float | None,
        scale: float | None = None,
        size: float = 0.0,
        evaluations: int = 20_000,
    ) -> None:
        self.g, self.after, self.until, self.scale = g, after, until, scale
        self.budget = evaluations
        self.spent = 0
        self.noise = 8 * EPS * size
        self.largest = 0.0
        self.exhausted = False
        self.unit = 1.0
        self.first = self._first_width()
        self.end = until if until is not None else after + FOREVER * self.unit

    def value(self, t: float) -> float | None:
        """The function, or None outside its domain."""
        self.spent += 1
        try:
            v = float(self.g(t))
        except (ArithmeticError, ValueError):
            return None
        return v if math.isfinite(v) else None

    def fit(self, lo: float, hi: float) -> tuple[Panel | None, float]:
        """The polynomial on [lo, hi] and by how much it misses the check points; no panel: outside the domain."""
        span = hi - lo
        times = [lo, *(lo + span * x for x in places()[1:-1]), hi]
        values: list[float] = []
        out = 0
        for t in times:
            v = self.value(t)
            if v is None:
                out += 1
                if values:
                    break
            else:
                values.append(v)
                if out:
                    break
        if out:
            return None, math.inf if values else -math.inf
        rows, checks = _from_samples()
        size = max(map(abs, values))
        miss = 0.0
        for x, row in zip(CHECKS, checks, strict=True):
            v = self.value(lo + span * x)
            if v is None:
                return None, math.inf
            miss = max(miss, abs(v - sum(map(float.__mul__, row, values))))
        swing = max(values) - min(values)
        noise = max(self.noise, 4 * EPS * (size + max(abs(lo), abs(hi)) * swing / span))
        b = tuple(sum(map(float.__mul__, row, values)) for row in rows)
        return Panel(lo, hi, tuple(times), tuple(values), b, size, noise), miss

    def least(self, t: float) -> float:
        """The narrowest panel worth looking at."""
        return 64 * EPS * max(abs(t), abs(self.after), 1e-9 * self.first[0])

    def _first_width(self) -> tuple[float, float]:
        """A first width that is resolved, and the size of g on the stretch that set the scale."""
        limit = math.inf if self.until is None else self.until - self.after
        unit = self.scale if self.scale is not None else 1.0
        width = min(unit, limit)
        panel, tries, direction = None, 0, 0
        while tries < 26:
            panel, miss = self.fit(self.after, self.after + width)
            tries += 1
            if panel is not None and panel.size > 4 * panel.noise and miss <= max(TOLERANCE * panel.size, panel.noise):
                break
            far = self._far(width, limit) if direction >= 0 else 0.0
            noisy = panel is not None and miss <= 1e-13 * far and (direction > 0 or panel.size <= 1e-9 * far)
            if noisy and width < limit:
                self.noise = max(self.noise, 3 * miss)
                direction, width = 1, min(10 * width, limit)
            elif direction > 0 or (panel is not None and panel.size <= 4 * panel.noise):
                break
            else:
                direction, width = -1, width / 8
                if width < 1e3 * EPS * max(abs(self.after), 1e-9 * min(unit, limit)):
                    break
        size = panel.size if panel is not None else 0.0
        self.unit = width
        if panel is not None and abs(panel.values[0]) <= 1e-3 * size:
            width = self._down(width, size)
        return width, size

    def _far(self, width: float, limit: float) -> float:
        found = [self.value(self.after + d) for k in range(1, 13) if (d := width * 10.0**k) <= limit]
        return max((abs(v) for v in found if v is not None), default=0.0)

    def _down(self, width: float, size: float) -> float:
        """Where g begins from zero: as near to the beginning as its values are clean."""
        for _ in range(7):
            smaller = width / 100
            if smaller < 1e5 * EPS * abs(self.after):
                break
            panel, miss = self.fit(self.after, self.after + smaller)
            if panel is None or panel.size <= 1e3 * panel.noise or miss > TOLERANCE * panel.size:
                break
            width = smaller
            if abs(panel.values[0]) > 1e-3 * panel.size or panel.size < 1e-14 * size:
                break
        return width

    def panels(self) -> Iterator[Panel]:
        """Panel after panel. When the evaluations run out, `exhausted` is set."""
        lo, width, held = self.after, self.first[0], False
        quiet, shifts, last_miss = 0, 0, math.inf
        while lo < self.end:
            if self.spent > self.budget:
                self.exhausted = True
                return
            width = max(width, self.least(lo))
            hi = lo + width if lo + 1.02 * width < self.end else self.end
            width = hi - lo
            panel, miss = self.fit(lo, hi)
            narrow = width <= 2 * self.least(lo)
            if panel is None:
                if miss < 0 or narrow:
                    yield Panel(lo, hi, (lo, hi), (), (), 0.0, self.noise, hole=True)
                    lo, width, held = hi, width * (2 if miss < 0 else 1), False
                else:
                    width, held = width / 2, True
                continue
            wanted = max(TOLERANCE * panel.size, panel.noise)
            if miss > wanted and not narrow:
                if miss > last_miss / 4 and self._is_noise(panel, miss):
                    self.noise = max(self.noise, 3 * miss)
                    last_miss = math.inf
                else:
                    last_miss = miss
                    width *= min(0.5, max(0.05, 0.9 * (wanted / miss) ** (1 / (DEGREE + 1))))
                continue
            last_miss = math.inf
            self.largest = max(self.largest, panel.size)
            if self._ends_near_zero(panel) and shifts < 4 and hi < self.end and not narrow:
                shifts, width = shifts + 1, 0.83 * width
                continue
            yield panel if miss <= wanted else Panel(lo, hi, panel.times, panel.values, (), panel.size, panel.noise)
            quiet = quiet + 1 if panel.size <= max(4 * self.noise, 1e-290) else 0
            if self.until is None and quiet >= 6:
                return
            grow = 2.0
            if miss > max(wanted / 1e4, panel.noise):
                grow = min(2.0, max(0.8, 0.9 * (wanted / miss) ** (1 / (DEGREE + 1))))
            lo, shifts = hi, 0
            width = self._capped(width * (1.0 if held else grow), lo)
            held = False

    def _capped(self, width: float, lo: float) -> float:
        run = lo - self.after
        return min(width, max(run, self.first[0])) if self.scale is None else min(width, max(self.scale, run / 4))

    def _ends_near_zero(self, panel: Panel) -> bool:
        return abs(panel.values[-1]) <= max(1e-6 * panel.size, 4 * panel.noise) and panel.size > 8 * panel.noise

    def _is_noise(self, panel: Panel, miss: float) -> bool:
        """Does the error stay the same on pieces a sixteenth as wide, all along the panel? A jump's does not."""
        if miss > 1e-9 * max(self.largest, self.first[1]):
            return False
        piece = (panel.hi - panel.lo) / 16
        if piece < self.least(panel.lo):
            return True
        starts = (panel.lo, panel.lo + 7.3 * piece, panel.hi - piece)
        return sum(self.fit(lo, lo + piece)[1] > miss / 50 for lo in starts) >= 2

    def edge(self, inside: float) -> tuple[float, float] | None:
        """The last instant of the domain just after `inside`, and the first one out of it."""
        outside = inside + 4 * self.least(inside)
        if self.value(outside) is not None:
            return None
        while (middle := (inside + outside) / 2) not in {inside, outside}:
            if self.value(middle) is None:
                outside = middle
            else:
                inside = middle
        return inside, outside

    def refined(self, panel: Panel, t: float) -> tuple[float, float]:
        """A stationary time found anew on a narrow panel about it, to nearly all digits, and the value of g there."""
        quarter = (panel.hi - panel.lo) / 8
        lo, hi = max(self.after, t - quarter), min(self.end, t + quarter)
        near, _ = self.fit(lo, hi) if hi > lo else (None, 0.0)
        found = near.critical() if near is not None else []
        best = min(found, key=lambda x: abs(x - t), default=t)
        if abs(best - t) > 1e-3 * quarter:
            best = t
        value = self.value(best)
        return best, panel.at(best) if value is None else value
