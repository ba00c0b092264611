"""Back onto the constraints: the smallest change of places and velocities, weighed by masses, after which they hold.

    W Δq + Jᵀ ν = 0,  J Δq = -φ          W Δv + Jᵀ ν = 0,  J Δv = -φ̇

One elimination serves both. It is repeated until nothing is left to correct but rounding.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from planar_cli.motion.terms.constraints import Constraint
from planar_cli.motion.terms.dense import DEPENDENT
from planar_cli.motion.terms.layout import Layout
from planar_cli.motion.terms.routine import Routine, System, Unknowns
from planar_cli.motion.terms.scales import Scales
from planar_cli.motion.terms.source import Code, Singular, compiled
from planar_cli.motion.terms.terms import Term

ROUNDING = 2e-15
"""A residual below this part of its scale is rounding."""
MOST_ROUNDS = 12
"""So often the correction is repeated."""
MOST_IDLE = 2
"""So many corrections that do not halve what is left are made."""
SMALL_PIVOT = 1e-8
"""A pivot below this part of its parts does not serve here: errors are small beside the way to a singular position."""
BENT = 10.0
"""By how much the slope of a constraint must exceed the square root of its residual, so that it can be mended."""
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
        self._placed = sum(c.place is not None for c in constraints)
        lengths = [scales.length if slot.kind in ("x", "y") else 1.0 for slot in layout.slots]
        self._scale = [*lengths, *(size / scales.time for size in lengths)]
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
        correction = self._correction()

        def correct(t: float, y: Sequence[float], left: float) -> list[float]:
            try:
                return correction.regular(t, y)
            except Singular:
                # Directions in which the constraints bend more than they slope are left as they are.
                change = correction.by_rank(t, y, max(DEPENDENT, BENT * math.sqrt(left)))
                return change if self._moved(change, y) <= math.sqrt(left) else [0.0] * len(change)

        return self._projected(t, y, correct)

    def regular(self, t: float, y: Sequence[float]) -> list[float]:
        """The same; raises Singular near a singular position, and where nothing near fulfils the constraints."""
        correction = self._correction()
        found = self._projected(t, y, lambda t, y, left: correction.regular(t, y))
        if self._largest(self.residuals(t, found), found) > 1e3 * ROUNDING:
            raise Singular
        return found

    def _projected(
        self, t: float, y: Sequence[float], correct: Callable[[float, Sequence[float], float], list[float]]
    ) -> list[float]:
        found = list(y)
        if not self.kept:
            return found
        left, idle = self._largest(self.residuals(t, found), found), 0
        best, best_left = found, left
        for _ in range(MOST_ROUNDS):
            if left <= ROUNDING or idle > MOST_IDLE:
                break
            found = [a + d for a, d in zip(found, correct(t, found, left), strict=True)]
            left = self._largest(self.residuals(t, found), found)
            idle = 0 if left < best_left / 2 else idle + 1
            if left < best_left:
                best, best_left = found, left
        return best

    def _correction(self) -> Routine:
        if self._correct is None:
            self._correct = self._routine()
        return self._correct

    def _largest(self, residuals: Sequence[float], y: Sequence[float]) -> float:
        """The largest residual: places on the scale of the scene and of where it is, velocities on that of theirs."""
        places, rates = residuals[: self._placed], residuals[self._placed :]
        far = max([abs(r) for r in places], default=0.0)
        fast = max([abs(r) for r in rates], default=0.0)
        if far <= ROUNDING and fast <= ROUNDING:
            return max(far, fast)
        farthest, fastest = self._extent(y)
        return max(far / max(farthest, 1.0), fast / max(fastest, 1.0))

    def _moved(self, change: Sequence[float], y: Sequence[float]) -> float:
        """How large a correction is, on the same scales."""
        (far, fast), (farthest, fastest) = self._extent(change), self._extent(y)
        return max(far / max(farthest, 1.0), fast / max(fastest, 1.0))

    def _extent(self, y: Sequence[float]) -> tuple[float, float]:
        """The largest place and the largest speed, in parts of their scales."""
        parts = [abs(v) / size for v, size in zip(y, self._scale, strict=True)]
        half = self.layout.count
        return max(parts[:half], default=0.0), max(parts[half:], default=0.0)

    def _routine(self) -> Routine:
        """The corrections of all coordinates, then of all rates."""
        layout, graph, count = self.layout, self.layout.graph, self.layout.count
        rows: list[dict[int, Term]] = [{i: w} for i, w in enumerate(self._weights())]
        kept = [self.constraints[number] for number in self.kept]
        for k, constraint in enumerate(kept):
            rows.append(dict(constraint.row))
            for i, term in constraint.row.items():
                rows[i][count + k] = term
        zero = graph.number(0.0)

        def places(before: Unknowns) -> list[Term]:
            return [*[zero] * count, *(zero if c.place is None else -c.place for c in kept)]

        def rates(before: Unknowns) -> list[Term]:
            # The rates as they will be after the places have changed.
            changes = dict(zip(layout.coordinates, before[0], strict=False))
            return [
                *[zero] * count,
                *(zero if c.rate is None else -(c.rate + graph.rate(c.rate, changes)) for c in kept),
            ]

        system = System(layout, rows, [places, rates], self.values, SMALL_PIVOT)
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
