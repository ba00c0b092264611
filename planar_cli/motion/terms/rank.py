"""Which constraints of a regime say something new, and where that can be seen: redundancy, not singular positions.

A redundant constraint follows from the others in all positions that these allow (the third crank of a parallelogram);
in a singular position constraints depend on each other in this position alone. So the rank is taken at the reference
configuration and, where it is not full there, at one a little further along a motion that the constraints allow.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from planar_cli.motion.terms.constraints import Constraint
from planar_cli.motion.terms.dense import least_squares, null_space
from planar_cli.motion.terms.layout import Layout
from planar_cli.motion.terms.scales import Scales
from planar_cli.motion.terms.source import compiled
from planar_cli.motion.terms.terms import Term
from planar_cli.records import record

DEPENDENT = 1e-11
"""What is left of a row below this part of its size says nothing new."""
NEARBY = (0.05, 0.2, 0.4, 0.6)
"""How far other configurations are, in parts of the scales."""
CLEAR = 1e-3
"""Where more than this is left of every row that says something new, the position is far from singular ones."""


@record
class Independent:
    """What the rank tells."""

    kept: tuple[int, ...]
    """Constraints that say something new, by number."""
    values: dict[Term, float] | None
    """A configuration in which the kept ones are independent; None: the reference configuration is one."""
    open: frozenset[int]
    """Constraints whose multipliers are not determined."""
    singular: bool
    """Is the reference configuration a singular position?"""


def independent(layout: Layout, constraints: Sequence[Constraint], scales: Scales) -> Independent:
    """The rank of a set of constraints: those of joints count more than others, those before more than those after."""
    everything = tuple(range(len(constraints)))
    here = _Position(layout, constraints, scales)
    # Relations that are not linear in the velocities have no coefficients at rest.
    drawn = tuple(v.value for v in layout.coordinates)
    values = here.values if any(c.place is None for c in constraints) or drawn != layout.drawn else None
    if not constraints or len(here.kept(everything)) == len(constraints):
        return Independent(everything, values, frozenset(), False)
    there = here.moved_on()
    first = set(here.kept(everything))
    ranked = sorted(everything, key=lambda k: (not constraints[k].joint, k not in first, k))
    kept = there.kept(ranked)
    singular = len(here.kept(kept)) < len(kept)
    return Independent(tuple(sorted(kept)), there.values if singular else values, there.open(), singular)


class _Position:
    """The rows of all constraints at one configuration, in the scales."""

    def __init__(
        self, layout: Layout, constraints: Sequence[Constraint], scales: Scales, state: Sequence[float] | None = None
    ) -> None:
        self.layout, self.constraints, self.scales = layout, constraints, scales
        self.margin = 0.0
        """The smallest part that is left of a row that says something new."""
        self.sizes = [1.0 if s.kind == "theta" else scales.length for s in layout.slots]
        speeds = [math.cos(2.4 * i) * size / scales.time for i, size in enumerate(self.sizes)]
        self.state = list(state) if state is not None else [*layout.drawn, *speeds]
        entries = [t for c in constraints for t in c.row.values()]
        if (
            state is None
            and layout.drawn == tuple(v.value for v in layout.coordinates)
            and all(c.place is not None for c in constraints)
        ):
            numbers = iter([t.value for t in entries])
        else:
            numbers = iter(compiled(entries, layout.state, layout.time).function(layout.time.value, self.state))
        self.rows: list[dict[int, float]] = [{i: next(numbers) * self.sizes[i] for i in c.row} for c in constraints]

    @property
    def values(self) -> dict[Term, float]:
        """The variables here."""
        return self.layout.values(self.layout.time.value, self.state)

    def kept(self, order: Sequence[int]) -> list[int]:
        """Rows that do not follow from those before, in an order of all or some of them."""
        pivots: list[tuple[int, dict[int, float]]] = []
        kept = []
        self.margin = 1.0
        for number in order:
            row = self.rows[number]
            size = max((abs(v) for v in row.values()), default=0.0)
            left = dict(row)
            for column, pivot in pivots:
                factor = left.pop(column, 0.0)
                if factor:
                    for i, v in pivot.items():
                        left[i] = left.get(i, 0.0) - factor * v
                        size = max(size, abs(factor * v))
            best = max(left, key=lambda i: abs(left[i]), default=None)
            if best is None or abs(left[best]) <= DEPENDENT * size:
                continue
            lead = left.pop(best)
            self.margin = min(self.margin, abs(lead) / size)
            scaled = {i: v / lead for i, v in left.items() if v}
            for k, (column, pivot) in enumerate(pivots):
                factor = pivot.pop(best, 0.0)
                if factor:
                    for i, v in scaled.items():
                        pivot[i] = pivot.get(i, 0.0) - factor * v
                    pivots[k] = (column, pivot)
            pivots.append((best, scaled))
            kept.append(number)
        return kept

    def moved_on(self) -> _Position:
        """A little further along a motion that the constraints allow, in every free direction by another amount."""
        count = self.layout.count
        matrix = [[row.get(i, 0.0) for i in range(count)] for row in self.rows]
        free = null_space(matrix, count)
        if not free:
            return self
        best, rank = self, (0, 0.0)
        for attempt, far in enumerate(NEARBY):
            step = [0.0] * count
            for k, vector in enumerate(free):
                top = max(abs(v) for v in vector)
                share = far * math.cos(1.0 + 2.4 * k + attempt) / top
                step = [s + share * v for s, v in zip(step, vector, strict=True)]
            state = [q + s * size for q, s, size in zip(self.state, step, self.sizes, strict=False)]
            try:
                found = _Position(self.layout, self.constraints, self.scales, self._closed(state))
            except ZeroDivisionError:
                # A place in which something has no direction.
                continue
            reached = (len(found.kept(range(len(self.rows)))), found.margin)
            # Near the drawing, if that is clearly not singular; else where it is least so.
            if reached[0] > rank[0] or (reached[0] == rank[0] and rank[1] < CLEAR < reached[1]):
                best, rank = found, reached
        return best

    def _closed(self, places: list[float]) -> list[float]:
        """The nearest places that fulfil the constraints, by Newton's method."""
        layout, speeds = self.layout, self.state[self.layout.count :]
        residuals = [c.place for c in self.constraints if c.place is not None]
        code = compiled(residuals, layout.state, layout.time)
        for _ in range(30):
            left = code.function(layout.time.value, [*places, *speeds])
            if max((abs(r) for r in left), default=0.0) <= 1e-14 * self.scales.length:
                break
            here = _Position(layout, self.constraints, self.scales, [*places, *speeds])
            matrix = [
                [row.get(i, 0.0) for i in range(layout.count)]
                for row, c in zip(here.rows, self.constraints, strict=True)
                if c.place is not None
            ]
            change = least_squares(matrix, [-r for r in left]).unknowns
            places = [q + d * size for q, d, size in zip(places, change, self.sizes, strict=True)]
        return [*places, *speeds]

    def open(self) -> frozenset[int]:
        """Constraints with a share in a combination that is zero."""
        count = self.layout.count
        turned = [[row.get(i, 0.0) for row in self.rows] for i in range(count)]
        found: set[int] = set()
        for vector in null_space(turned, len(self.rows)):
            top = max(abs(v) for v in vector)
            found |= {k for k, v in enumerate(vector) if abs(v) > 1e-7 * top}
        return frozenset(found)
