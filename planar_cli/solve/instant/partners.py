"""Both components of a pin force from sums of forces on the same bodies: where → ΣF_x of a chain gives O_x, ↑ ΣF_y of
it gives O_y, though moments about some other point would hold as few unknowns.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.system.system import System
from planar_cli.solve.instant.candidates import Candidate
from planar_cli.solve.instant.plan import Block, Plan

OTHER = {"x": "y", "y": "x"}


def with_partners(plan: Plan, candidates: Collection[Candidate], unknowns: Sequence[sp.Symbol], system: System) -> Plan:
    """The plan with such sums, the component that is found first leading; as it is where they would not give one
    unknown after the other.
    """
    alone = {b.unknowns[0]: b for b in plan.blocks if len(b.unknowns) == 1 and axis_of(b.equations[0]) is not None}
    pairs, order = _pairs(unknowns, system), list(alone)
    put = {
        j: partner
        for j, b in alone.items()
        if (own := pairs.get(j)) is not None
        and own[0] in order[: order.index(j)]
        and (partner := _partner(b.equations[0], alone[own[0]].equations[0], own[1], candidates, 1 << j)) is not None
    }
    if not put:
        return plan
    left = [replace(b, equations=(put[b.unknowns[0]],)) if _is_put(b, put) else b for b in plan.blocks]
    found: list[Block] = []
    known = 0
    while left:
        ready = next((b for b in left if not _masks(b) & ~(known | _bits(b))), None)
        if ready is None:
            return plan
        found.append(ready)
        left.remove(ready)
        known |= _bits(ready)
    return Plan(tuple(found))


def _is_put(block: Block, put: Collection[int]) -> bool:
    return len(block.unknowns) == 1 and block.unknowns[0] in put


def axis_of(e: Candidate) -> str | None:
    """The axis along which forces are summed, "" of another direction or of moments; None: it is no such sum."""
    if e.choice is None or e.condition is not None:
        return None
    return "" if e.choice.moment else e.choice.name


def _pairs(unknowns: Sequence[sp.Symbol], system: System) -> dict[int, tuple[int, str]]:
    """By the number of a component of a pin force that of the other one, and the axis of this."""
    places = {s: j for j, s in enumerate(unknowns)}
    found = {}
    for push in (p for p in system.pushes if p.kind == "component" and p.name[-1] in OTHER):
        own, other = (system.symbols.get(n) for n in (push.name, push.name[:-1] + OTHER[push.name[-1]]))
        if own in places and other in places:
            found[places[own]] = (places[other], OTHER[push.name[-1]])
    return found


def _partner(
    own: Candidate, other: Candidate, axis: str, candidates: Collection[Candidate], bit: int
) -> Candidate | None:
    """The sum of forces on the bodies of the other component's, along the own axis; None: it is the one already."""
    if axis_of(other) != axis or (axis_of(own) == OTHER[axis] and own.bodies == other.bodies):
        return None
    return next(
        (c for c in candidates if c.bodies == other.bodies and axis_of(c) == OTHER[axis] and c.mask & bit), None
    )


def _bits(block: Block) -> int:
    return sum(1 << j for j in block.unknowns)


def _masks(block: Block) -> int:
    found = 0
    for e in block.equations:
        found |= e.mask
    return found
