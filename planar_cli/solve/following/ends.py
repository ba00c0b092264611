"""Where an assumption of a stretch ends before its state: other modes follow, or something goes the other way."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.scales import Sizes, measured
from planar_cli.records import changing
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.between.roots.events import FollowedSegment
from planar_cli.solve.between.roots.followed import Ends
from planar_cli.solve.following.traced import SOON, Traced
from planar_cli.solve.regimes.kept_radius import with_kept_radius
from planar_cli.solve.regimes.mode_dates import is_dated_by_mode
from planar_cli.solve.regimes.regime import Regime, number_function
from planar_cli.solve.regimes.regime_sequence import RegimeSequence

TOGETHER = 1e-6
"""So near to a state, in parts of the time up to it, what ends may end in it."""
VANISHES = 1e-4
"""What ends an assumption is below this part of its size."""
HALVINGS = 60
SQUARED = ", F_x² + F_y² ≤ (μ N)² with x² + y² constant"
"""Behind the words of a limit of two components whose point goes round."""


def is_put_in(course: RegimeSequence, i: int) -> bool:
    """Is state i one that no file speaks of, where the modes change or something turns round?"""
    state = course.states[i]
    return state.name in course.modes.turnings and not state.relations


@changing
class EndSearch:
    """Looks for what ends along one motion."""

    course: StatedMotion
    motion: Traced
    value: Valuation
    """Numbers of everything that does not vary."""
    lost: str = ""
    """Why that can not be told; "" where it can."""
    struck: tuple[int, float, str] | None = None
    """A stretch on which something strikes that no state of the file speaks of, when [s], and what."""

    def find(self, i: int, segment: FollowedSegment, until: float, sizes: Sizes) -> Ends | None:
        """The first assumption that ends on stretch i before `until`. `sizes`: of what the motion has shown so far."""
        since = segment.t0
        state = next(s for k, s in enumerate(self.course.states) if k > i and not is_put_in(self.course, k))
        dated = is_dated_by_mode(state) and state.name not in self.course.modes.turnings
        slack = TOGETHER * (until - since) if math.isfinite(until) else 0.0
        limit = until + slack if dated else until - slack
        changed = self._changed(i, segment, limit)
        if changed is None and dated and math.isfinite(until):
            changed = self._begins(i, until)
        time = limit if changed is None else changed[0]
        struck = until - slack if changed is None else min(time, until - slack)
        for x in self.motion.transitions(since + SOON * self.course.scales.time, struck):
            if x.kind in ("impact", "rest"):
                self.struck = i, x.t, x.words
                return None
        turned = self._turned(i, segment, min(time, self.motion.end))
        if turned is not None or changed is None:
            return turned
        return self._ended(i, segment, *changed, sizes)

    def _changed(self, i: int, segment: FollowedSegment, limit: float) -> tuple[float, tuple[int, ...]] | None:
        """When other modes follow, and which."""
        stretch = self.course.modes.stretch(i)
        for piece in segment.pieces:
            if piece.t0 > segment.t0 and piece.t0 <= limit:
                choice = self.motion.choice(self.course.workshop, stretch, self.motion.modes(piece))
                if choice != stretch.choice:
                    return piece.t0, choice
        return None

    def _begins(self, i: int, t: float) -> tuple[float, tuple[int, ...]] | None:
        """The modes that begin at a time, if they are others than those of a stretch."""
        stretch, begins = self.course.modes.stretch(i), self.motion.begins(t, self.course.scales.time)
        choice = stretch.choice if begins is None else self.motion.choice(self.course.workshop, stretch, begins[0])
        return None if choice == stretch.choice else (t, choice)

    def _ended(
        self, i: int, segment: FollowedSegment, time: float, choice: tuple[int, ...], sizes: Sizes
    ) -> Ends | None:
        """What vanishes where other modes follow."""
        regime = segment.regime
        watched = [(w.expr, w.test.words) for w in regime.watches]
        watched += [(s, "it stops sliding") for s in regime.slips]
        found = []
        here = segment.at(time)
        letters, units = {s: here[s] for s in regime.letters}, self.course.ledger.units
        # From rest, the way to here is the first that shows how fast things move.
        by_letter = sizes.passing(letters, units, segment.length).by_letter(regime.letters, units)
        # What slides in a plane along one line stops where its speed along that vanishes.
        for expr, words in watched or _sides(regime):
            if expr.free_symbols & set(regime.letters):
                number, size = measured([expr], letters, by_letter, self.value)[0]
                found.append((abs(number) / size if size else 0.0, Ends(i, time, expr, words, choice)))
        off, ends = min(found, key=lambda pair: pair[0], default=(math.inf, None))
        if off > VANISHES:
            self.lost = f"nothing tells why other modes follow at t = {time:.9g} s"
            return None
        if ends is None or (expr := self._carried_round(ends.expr, regime, segment)) == ends.expr:
            return ends
        return replace(ends, expr=expr, words=f"{ends.words}{SQUARED}")

    def _carried_round(self, expr: sp.Expr, regime: Regime, segment: FollowedSegment) -> sp.Expr:
        """With the distances from the origin that stay what they are drawn in place of both coordinates."""
        here = segment.at(segment.t0)
        drawn = {c.symbol: sp.sympify(c.drawn) for c in regime.coordinates if c.drawn is not None}

        def stays(x: sp.Symbol, y: sp.Symbol) -> bool:
            square = self.value.known(drawn[x] ** 2 + drawn[y] ** 2)
            now = here[x] ** 2 + here[y] ** 2
            return square is not None and math.isclose(float(square), now, rel_tol=VANISHES)

        found = with_kept_radius(expr, drawn, regime.rates, stays)
        if found == expr:
            return expr
        return sp.Mul(*(f for f in sp.Mul.make_args(found) if f.is_number or not f.is_positive))

    def _turned(self, i: int, segment: FollowedSegment, limit: float) -> Ends | None:
        """The first speed that changes its sign, or place that comes to the other side, where a law asks for it."""
        regime = segment.regime
        watched = [(sign * u, "it turns round") for u, sign in regime.going().items()]
        watched += _sides(regime)
        best: Ends | None = None
        for expr, words in watched:
            if not expr.free_symbols & set(regime.letters):
                continue
            time = self._falls(expr, segment, limit if best is None else best.time)
            if time is not None:
                best = Ends(i, time, expr, words)
        return best

    def _falls(self, expr: sp.Expr, segment: FollowedSegment, limit: float) -> float | None:
        """When a formula first becomes negative after the beginning."""
        f = number_function([expr], segment.regime.letters, self.value)

        def g(t: float) -> float:
            here = segment.at(t)
            return f(*(here[s] for s in segment.regime.letters))[0]

        positive: float | None = None
        for t in segment.looks(limit):
            v = g(t)
            if v > 0:
                positive = t
            elif v < 0 and positive is not None:
                return bisected(g, positive, t)
        return None


def _sides(regime: Regime) -> list[tuple[sp.Expr, str]]:
    """What stays positive as long as places stay on their sides, and what slides goes on in its sense."""
    ways = [(e, e.free_symbols & set(regime.accelerations)) for _, e in regime.sided.values()]
    return [(e, "it stops sliding" if speeds else "it comes to the other side") for e, speeds in ways]


def bisected(g: Callable[[float], float], low: float, high: float) -> float:
    """Where a function that is positive at `low` and negative at `high` vanishes between them."""
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        if g(middle) > 0:
            low = middle
        else:
            high = middle
    return (low + high) / 2
