"""Forces that redundant constraints share: is there a share with which all conditions of a regime hold?

Multipliers z that together do nothing, W z = 0, may be added to those by which the motion was found; the conditions,
linear in the forces, become v + S z. Of all shares the one is taken with which the least of the conditions, in parts
of its scale, is largest: it is below zero only where none serves, and it goes there continuously. So what sticks slides
only where no distribution of its forces holds it (C. Glocker, Set-Valued Force Laws, 2001).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import combinations

from planar_cli.motion.regime.guards import Measured
from planar_cli.motion.regime.held import Held
from planar_cli.motion.terms.complementarity import solved
from planar_cli.motion.terms.dense import null_space
from planar_cli.motion.terms.layout import Column, Layout
from planar_cli.motion.terms.source import Code, compiled
from planar_cli.motion.terms.terms import Term
from planar_cli.records import record

NONE = 1e-9
"""A condition that changes by less than this part of the most that others do does not depend on the share."""
ENOUGH = 1.0
"""It is of no use to make the least condition larger than this, in parts of its scale."""
LEFT = 1e-10
"""So much may a condition be missed by rounding."""
MOST = 20_000
"""So many combinations of conditions that bound a share are looked at."""


@record
class Sharing:
    """The shares of one regime, at any state."""

    code: Code
    """The entries of W, constraint by constraint, then the slopes of the conditions, condition by condition."""
    columns: tuple[tuple[int, ...], ...]
    """Of every constraint the coordinates on which it acts."""
    count: int
    """Of coordinates."""
    conditions: tuple[int, ...]
    """The numbers of the guards that forces decide."""
    scales: tuple[float, ...]
    """Their usual sizes."""

    def best(self, t: float, y: Sequence[float], values: Sequence[float]) -> list[float]:
        """The guards with the best share, from those with another one."""
        found = list(values)
        if all(found[i] >= 0.0 for i in self.conditions):
            return found
        slopes = self._slopes(t, y)
        now = [found[i] / s for i, s in zip(self.conditions, self.scales, strict=True)]
        share = best_share(now, slopes)
        if share is None:
            return found
        for i, size, row in zip(self.conditions, self.scales, slopes, strict=True):
            found[i] += size * math.fsum(s * z for s, z in zip(row, share, strict=True))
        return found

    def _slopes(self, t: float, y: Sequence[float]) -> list[list[float]]:
        """How every condition changes with each share, in parts of its scale."""
        numbers = iter(self.code.function(t, y))
        acting = [[0.0] * len(self.columns) for _ in range(self.count)]
        for k, column in enumerate(self.columns):
            for i in column:
                acting[i][k] = next(numbers)
        rows = [[next(numbers) / size for _ in self.columns] for size in self.scales]
        shares = null_space(acting, len(self.columns))
        return [[math.fsum(a * b for a, b in zip(row, z, strict=True)) for z in shares] for row in rows]


def sharing(
    layout: Layout, held: Sequence[Held], driving: Sequence[Column], measured: Sequence[Measured], reach: float
) -> Sharing | None:
    """The shares of a regime; None: forces decide no condition, or one in which they stand at right angles. `driving`:
    the generalized force of a unit of each multiplier, those of the joints first; `reach`: see `Held.exerted`.
    """
    decided = [m for m in measured if m.needs_forces]
    if not decided or any(m.within for m in decided):
        return None
    pushes = _pushes(layout, held, reach)
    pushes += [{} for _ in driving[len(pushes) :]]
    zero = layout.graph.number(0.0)
    terms = [t for column in driving for t in column.values()]
    for m in decided:
        for own in pushes:
            total = zero
            for name, factor in m.forces:
                total = total + factor * own[name] if name in own else total
            terms.append(total)
    return Sharing(
        compiled(terms, layout.state, layout.time),
        tuple(tuple(column) for column in driving),
        layout.count,
        tuple(m.guard.index for m in decided),
        tuple(m.guard.scale for m in decided),
    )


def _pushes(layout: Layout, held: Sequence[Held], reach: float) -> list[dict[str, Term]]:
    """What a unit of each multiplier of the joints exerts, but for what has a size of its own."""
    found = []
    for joint in held:
        for k in range(len(joint.constraints)):
            units = [layout.graph.number(float(i == k)) for i in range(len(joint.constraints))]
            fixed = {name for name, (_, of) in joint.followers.items() if of is None}
            exerted = joint.exerted(layout, units, reach)
            found.append({name: push for name, push in exerted.items() if name not in fixed})
    return found


def best_share(values: Sequence[float], slopes: Sequence[Sequence[float]]) -> list[float] | None:
    """The z with which the least of values + slopes · z is largest, of the rows that depend on z; None: none does, or
    there are too many.
    """
    most = max((abs(s) for row in slopes for s in row), default=0.0)
    bounding = [i for i, row in enumerate(slopes) if any(abs(s) > NONE * most for s in row)]
    directions = _independent([[slopes[i][d] for i in bounding] for d in range(len(slopes[0]))]) if bounding else []
    if not directions or math.comb(len(bounding) + 1, len(directions) + 1) > MOST:
        return None
    # v + s z - least >= 0, and ENOUGH - least >= 0.
    rows = [([*(slopes[i][d] for d in directions), -1.0], values[i]) for i in bounding]
    rows.append(([*(0.0 for _ in directions), -1.0], ENOUGH))
    best: list[float] | None = None
    for tight in combinations(rows, len(directions) + 1):
        found = solved([row for row, _ in tight], [-value for _, value in tight])
        if found is None or (best is not None and found[-1] <= best[-1]):
            continue
        if all(value + math.fsum(a * b for a, b in zip(row, found, strict=True)) >= -LEFT for row, value in rows):
            best = found
    if best is None:
        return None
    share = [0.0] * len(slopes[0])
    for d, z in zip(directions, best, strict=False):
        share[d] = z
    return share


def _independent(vectors: Sequence[Sequence[float]]) -> list[int]:
    """The numbers of vectors that do not depend on those before."""
    basis: list[list[float]] = []
    kept = []
    for number, vector in enumerate(vectors):
        size, left = math.hypot(*vector), list(vector)
        for other in basis:
            part = math.fsum(a * b for a, b in zip(left, other, strict=True))
            left = [a - part * b for a, b in zip(left, other, strict=True)]
        rest = math.hypot(*left)
        if rest > NONE * size:
            basis.append([a / rest for a in left])
            kept.append(number)
    return kept
