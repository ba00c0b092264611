"""The fewest equations for one target, from one exact linear solve.

Stack all rows of single bodies and all relations of motion as C; multipliers y with yᵀ C = e_target combine them into
one equation for the target. Restricted to a body, y is a virtual twist: bodies of equal twist that touch are the group
to draw, the twist's centre is the moment centre, a pure translation is a force direction.
"""

from __future__ import annotations

from collections.abc import Iterable
from decimal import Decimal

import sympy as sp

from planar_cli.equation.system.kinetics import body_residuals
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import CERTAIN, ONE, ZERO
from planar_cli.principles.base import Single
from planar_cli.problem.scene.geometry import Vec
from planar_cli.solve.instant.candidates import (
    CONSTRUCTED,
    FAR,
    NAMED_SLANT,
    VIRTUAL_MOTION,
    Candidate,
    Choice,
    combine,
    mask_of,
    priced,
)
from planar_cli.solve.instant.offers import Offers
from planar_cli.solve.instant.virtual_power import power_in_letters
from planar_cli.solve.multibody.linear import Row, eliminate

CLOSE = Decimal("1e-25")
POWER = "virtual power of all bodies, moved as the joints allow; no reaction takes part"


def adjoint_candidates(offers: Offers, targets: list[int]) -> tuple[list[Candidate], int]:
    """The group equations that the adjoint solution of each target names; and, as bits, all unknowns of these equations
    and of the loops that take part: a set that determines the targets.
    """
    system, numbers = offers.system, offers.numbers
    bodies = offers.bodies
    single = {b: offers.body_rows(b) for b in bodies}
    rows = offers.base_rows()
    found: list[Candidate] = []
    inside = 0
    for y in _multipliers(rows, len(numbers.unknowns), targets):
        twists = {b: (y[3 * i], y[3 * i + 1], y[3 * i + 2]) for i, b in enumerate(bodies)}
        named = _groups(offers, system, twists, single)
        found += named
        inside |= sum_masks(c.mask for c in named)
        size = max(abs(v) for v in y)
        inside |= sum_masks(mask_of(rows[i]) for i in range(3 * len(bodies), len(rows)) if abs(y[i]) > CLOSE * size)
    return found, inside


def power_candidates(offers: Offers, targets: list[int]) -> list[Candidate]:
    """For each target the virtual power of all bodies in a motion that every joint allows: no reaction takes part, also
    where the reactions themselves are not unique. Numbers of one draw tell no ratio between letters.
    """
    system, numbers = offers.system, offers.numbers
    if system.scene.ledger.symbolic:
        return power_in_letters(offers, targets, POWER)
    moving = set(system.tree.acceleration_unknowns())
    idle = {x: sp.S.Zero for x in numbers.unknowns if x not in moving}
    resting = dict.fromkeys(moving, sp.S.Zero)
    found = []
    for y in _multipliers(offers.base_rows(), len(numbers.unknowns), targets):
        twists = {b: (y[3 * i], y[3 * i + 1], y[3 * i + 2]) for i, b in enumerate(offers.bodies)}
        size = max((abs(p) for t in twists.values() for p in t), default=ZERO)
        if not size:
            continue
        # The first body that turns has the virtual rotation 1.
        unit = next((m for _, _, m in twists.values() if abs(m) > CLOSE * size), size)
        terms = [
            _rational(rate / unit) * residual.xreplace(idle)
            for body, twist in twists.items()
            for rate, residual in zip(twist, body_residuals(system, body), strict=True)
        ]
        power = sp.expand(sp.Add(*terms))
        loads = power.xreplace(resting)
        single = Single(loads - power, loads, POWER, "", FAR)
        row = _cleaned(numbers.row(single.left - single.right))
        found.append(priced((), None, None, row, FAR, single))
    return [c for c in found if c is not None]


def sum_masks(masks: Iterable[int]) -> int:
    """All bits that occur."""
    total = 0
    for mask in masks:
        total |= mask
    return total


def _multipliers(rows: list[Row], width: int, targets: list[int]) -> list[list[Decimal]]:
    """For each target y with Σ y_i rows[i] = e_target in the unknown columns; targets that are not determined are left
    out.
    """
    count = len(rows)
    scales = [max((abs(c) for c in row[:-1]), default=ZERO) or ONE for row in rows]
    transposed = [
        [*(rows[i][j] / scales[i] for i in range(count)), *(-(ONE if j == target else ZERO) for target in targets)]
        for j in range(width)
    ]
    pivots, left = eliminate(transposed, count)
    found = []
    for right in range(count, count + len(targets)):
        if any(row[right] for row in left):
            continue
        y = [ZERO] * count
        for column, row in pivots:
            y[column] = -row[right]
        found.append([v / s for v, s in zip(y, scales, strict=True)])
    return found


def _groups(
    offers: Offers,
    system: System,
    twists: dict[str, tuple[Decimal, Decimal, Decimal]],
    single: dict[str, tuple[Row, Row, Row]],
) -> list[Candidate]:
    neighbours = offers.neighbours()
    size = max((abs(p) for t in twists.values() for p in t), default=ZERO)
    if not size:
        return []
    left = {b for b, t in twists.items() if any(abs(p) > CLOSE * size for p in t)}
    found: list[Candidate] = []
    while left:
        group = _flood(left, twists, neighbours, size)
        left -= group
        bodies = tuple(b for b in system.scene.bodies if b in group)
        rows = [combine([single[b][i] for b in bodies], [ONE] * len(bodies)) for i in range(3)]
        candidate = _candidate(system, offers, bodies, rows, twists[bodies[0]], size)
        if candidate is not None:
            found.append(candidate)
    return found


def _flood(
    left: set[str], twists: dict[str, tuple[Decimal, Decimal, Decimal]], neighbours: dict[str, set[str]], size: Decimal
) -> set[str]:
    """Connected bodies of equal twist."""
    start = next(iter(sorted(left)))
    group, front = {start}, [start]
    while front:
        body = front.pop()
        for other in neighbours[body] & left - group:
            if all(abs(a - b) <= CLOSE * size for a, b in zip(twists[body], twists[other], strict=True)):
                group.add(other)
                front.append(other)
    return group


def _candidate(
    system: System,
    offers: Offers,
    bodies: tuple[str, ...],
    rows: list[Row],
    twist: tuple[Decimal, Decimal, Decimal],
    size: Decimal,
) -> Candidate | None:
    fx, fy, m = twist
    turning = any(system.scene.rigid(b) for b in bodies)
    if abs(m) <= CLOSE * size or not turning:
        length = (fx * fx + fy * fy).sqrt()
        if not length or (system.scene.ledger.symbolic and min(abs(fx), abs(fy)) > CLOSE * length):
            # Numbers of one draw tell a direction only along an axis.
            return None
        direction = Vec(_rational(fx / length), _rational(fy / length))
        row = _cleaned(combine(rows[:2], (fx / length, fy / length)))
        # Of several bodies nobody sums forces along a slant that leaves out what is not drawn along one line.
        form = NAMED_SLANT if len(bodies) == 1 or 0 in (direction.x, direction.y) else FAR
        return priced(bodies, None, Choice(False, direction, VIRTUAL_MOTION), row, form)
    x, y = -fy / m, fx / m
    if system.scene.ledger.symbolic:
        return None
    row = _cleaned(combine(rows, (y, -x, ONE)))
    return priced(
        bodies,
        None,
        Choice(True, Vec(_rational(x), _rational(y)), "the centre of the common virtual rotation"),
        row,
        CONSTRUCTED,
    )


def _cleaned(row: Row) -> Row:
    """What the adjoint solution cancels is zero to its own accuracy, not to sixty digits."""
    size = max((abs(c) for c in row), default=ZERO)
    return [c if abs(c) > CLOSE * size else ZERO for c in row]


def _rational(x: Decimal) -> sp.Expr:
    return sp.Rational(str(x)) if abs(x) > CERTAIN else sp.S.Zero
