"""Two pulls on a body that are equal by symmetry: → ΣF_x says so, and ↑ ΣF_y gives both, where the sum of forces across
one of them would give the other.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import permutations

from planar_cli.equation.values.exact import CERTAIN
from planar_cli.solve.instant.candidates import Candidate
from planar_cli.solve.instant.partners import axis_of
from planar_cli.solve.instant.plan import Block, Plan, bits

Sums = Callable[[tuple[str, ...]], list[Candidate | None]]
"""The sums of forces on bodies along x and y."""


def with_symmetric_pulls(plan: Plan, sums: Sums) -> Plan:
    """The plan with such sums; as it is where there are no two pulls of which nothing else is known."""
    known = 0
    for block in plan.blocks:
        if len(block.unknowns) == 1 and axis_of(block.equations[0]) == "":
            pair = _pair(block, sums, known)
            if pair is not None and (found := _put(plan, block, pair)) is not None:
                return found
        known |= sum(1 << j for j in block.unknowns)
    return plan


def _pair(block: Block, sums: Sums, known: int) -> tuple[Candidate, Candidate, int] | None:
    """The sums along both axes, the one first that says that two pulls are equal, and the other pull."""
    (own,), (j,) = block.equations, block.unknowns
    along = sums(own.bodies) if len(own.bodies) == 1 else []
    for equal, whole in permutations(along, 2):
        if equal is None or whole is None:
            continue
        others = [i for i in bits(equal.mask) if i != j]
        if len(others) != 1 or not equal.mask & (1 << j) or abs(equal.row[-1]) > CERTAIN:
            continue
        (i,) = others
        alike = abs(equal.row[j] + equal.row[i]) <= CERTAIN and abs(whole.row[j] - whole.row[i]) <= CERTAIN
        if alike and whole.mask & (1 << j) and not whole.mask & ~(known | 1 << i | 1 << j):
            return equal, whole, i
    return None


def _put(plan: Plan, block: Block, pair: tuple[Candidate, Candidate, int]) -> Plan | None:
    """The plan with both sums in place of the block, and of the one that gave the other pull; None: that came from
    several equations.
    """
    equal, whole, i = pair
    (j,) = block.unknowns
    giving = [b for b in plan.blocks if i in b.unknowns]
    if any(len(b.unknowns) > 1 for b in giving):
        return None
    both = Block((equal, whole), (i, j), (j,))
    return Plan(tuple(both if b is block else b for b in plan.blocks if b not in giving))
