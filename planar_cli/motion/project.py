"""Back onto the constraints: the smallest change of places and velocities, weighed by masses, after which they hold.

    W Δq + Jᵀ ν = 0,  J Δq = -φ          W Δv + Jᵀ ν = 0,  J Δv = -φ̇

One elimination serves both. It is repeated until nothing is left to correct but rounding.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from planar_cli.motion.constraints import Constraint
from planar_cli.motion.layout import Layout
from planar_cli.motion.routine import Routine, System
from planar_cli.motion.scales import Scales
from planar_cli.motion.source import Code, compiled
from planar_cli.motion.terms import Term

ROUNDING = 2e-15
"""A residual below this part of its scale is rounding."""
MOST_ROUNDS = 12
"""So often the correction is repeated."""
LIGHT = 1e-3
"""What has no mass is weighed with this part of the largest mass."""


class Projector:
    """The constraints of one regime."""

    def __init__(
        self,
        layout: Layout,
        constraints: Sequence[Constraint],
        kept: Sequence[int],
        scales: Scales,
        values: dict[Term, float] | None,
    ) -> None:
        """`kept`: the constraints that say something new. `values`: a configuration that is not singular."""
        self.layout, self.scales = layout, scales
        self.constraints = constraints
        self.kept, self.values = kept, values
        self.sizes = [self._size(c) for c in constraints]
        self._left: Code | None = None
        self._correct: Routine | None = None

    def residuals(self, t: float, y: Sequence[float]) -> list[float]:
        """φ of every constraint of places, then φ̇ of every one of velocities, in parts of their scales."""
        if not self.constraints:
            return []
        if self._left is None:
            places = [
                c.place * (1 / s) for c, s in zip(self.constraints, self.sizes, strict=True) if c.place is not None
            ]
            rates = [
                c.rate * (self.scales.time / s)
                for c, s in zip(self.constraints, self.sizes, strict=True)
                if c.rate is not None
            ]
            self._left = compiled([*places, *rates], self.layout.state, self.layout.time)
        return self._left.function(t, y)

    def project(self, t: float, y: Sequence[float]) -> list[float]:
        """The nearest state on the constraints; where they contradict each other, as near to them as it gets."""
        found = list(y)
        if not self.kept:
            return found
        left = self._largest(self.residuals(t, found), found)
        for _ in range(MOST_ROUNDS):
            if left <= ROUNDING:
                break
            if self._correct is None:
                self._correct = self._routine()
            changed = [a + d for a, d in zip(found, self._correct(t, found), strict=True)]
            now = self._largest(self.residuals(t, changed), changed)
            if not now < left:
                break
            found, left = changed, now
        return found

    def _largest(self, residuals: Sequence[float], y: Sequence[float]) -> float:
        """The largest residual: places on the scale of the scene and of where it is, velocities on that of theirs."""
        places = sum(c.place is not None for c in self.constraints)
        half = self.layout.count
        far, fast = 1.0, 1.0
        for slot, q, v in zip(self.layout.slots, y[:half], y[half:], strict=True):
            size = self.scales.length if slot.kind in ("x", "y") else 1.0
            far, fast = max(far, abs(q) / size), max(fast, abs(v) * self.scales.time / size)
        largest = max((abs(r) / far for r in residuals[:places]), default=0.0)
        return max([largest, *(abs(r) / fast for r in residuals[places:])])

    def _routine(self) -> Routine:
        """The corrections of all coordinates, then of all rates."""
        layout, graph, count = self.layout, self.layout.graph, self.layout.count
        rows: list[dict[int, Term]] = [{i: w} for i, w in enumerate(self._weights())]
        places: list[Term] = [graph.number(0.0)] * count
        rates = list(places)
        for k, number in enumerate(self.kept):
            constraint = self.constraints[number]
            rows.append(dict(constraint.row))
            for i, term in constraint.row.items():
                rows[i][count + k] = term
            places.append(-constraint.place if constraint.place is not None else graph.number(0.0))
            rates.append(-constraint.rate if constraint.rate is not None else graph.number(0.0))
        system = System(layout, rows, [places, rates], self.values)
        return Routine(system, lambda unknowns: [*unknowns[0][:count], *unknowns[1][:count]])

    def _weights(self) -> list[Term]:
        """The masses as at the reference; a light one for what has none."""
        graph, found = self.layout.graph, []
        for slot in self.layout.slots:
            least = LIGHT * self.scales.mass * (self.scales.length**2 if slot.kind == "theta" else 1.0)
            mass = slot.mass.value
            found.append(graph.number(mass if mass > 0 and math.isfinite(mass) else least))
        return found

    def _size(self, constraint: Constraint) -> float:
        """The scale of a residual: a length, or 1 for an angle."""
        row = constraint.row
        turns = [i for i in row if self.layout.slots[i].kind == "theta"]
        return 1.0 if row and len(turns) == len(row) else self.scales.length
