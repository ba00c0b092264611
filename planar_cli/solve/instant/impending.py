"""The sense of friction at a contact that is about to slip: it is known once the limit is, and drawn so.

At the largest or smallest of what is sought the friction is μ N against the motion that is about to begin. Where a
contact counts it the other way, it is reversed, and the branch is worked out again: F = μ N stands on the page, not
F = -μ N.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.system.system import System
from planar_cli.solve.instant.instant import Instant
from planar_cli.solve.instant.seeker import Seeker, Sought

SAME = Decimal("1e-25")
"""Two values of what is extreme that differ by less, as a part of them, are one."""


def drawn_against_the_slip(
    instant: Instant, found: Sought, rejected: list[Sought], targets_of: Callable[[System], set[sp.Symbol]]
) -> Sought:
    """The same branch with every friction at its limit counted in the sense in which it acts; with `rejected` that of
    the same plan is exchanged. `targets_of(system)`: the symbols that the finds need.
    """
    names = _backward(found, targets_of(found.trial.system))
    if not names or found.seeker is None:
        return found
    before = instant.turned
    instant.turned = before ^ frozenset(names)
    seeker = Seeker(instant, found.trial.choice)
    turned = {seeker.system.symbols[name]: -seeker.system.symbols[name] for name in names}
    wanted = [c.residual.xreplace(turned) for c in found.limits if isinstance(c.residual, sp.Expr)]
    limits = tuple(c for c in seeker.limit_conditions() if c.residual in wanted)
    quantities = seeker.system.quantities()
    sides = (quantities.evaluator.value(extreme.side) for extreme in instant.statements.extremes)
    targets = targets_of(seeker.system) | seeker.compared()
    targets |= {s for side in sides for s in side.free_symbols if s in seeker.unknowns}
    if len(limits) == len(found.limits) and not seeker.conflict:
        branches = list(seeker.branches(targets, limits))
        held = [s for s in branches if not s.objection]
        same = next((s for s in held if _same(s, found)), None)
        if same is not None:
            apart = [s for s in rejected if s.seeker is not found.seeker or s.limits != found.limits]
            rejected[:] = [*(s for s in branches if s.objection), *apart]
            return replace(same, objective=found.objective, others=[s for s in held if s is not same])
    instant.turned = before
    return found


def _backward(found: Sought, asked: Collection[sp.Symbol]) -> list[str]:
    """Friction at its limit, and couples of normal forces on a face at theirs, that are negative as they count; and
    friction below its limit that nobody asks for.
    """
    system, solved = found.trial.system, found.branch.algebra.value.values
    told = {law.push for law in system.laws}
    at_limit = set().union(*(sp.sympify(e).free_symbols for c in found.limits for e in c.rows()))
    beside = found.trial.outcomes[:1]
    names = []
    for push in (p for p in system.pushes if p.kind in ("friction", "couple") and p.name not in told):
        symbol = system.symbols[push.name]
        limited = symbol in at_limit
        values = [solved.get(symbol), *(None if limited else outcome.push(push.name) for outcome in beside)]
        negative = next((v < 0 for v in values if v is not None), False)
        if negative and (limited or (push.kind == "friction" and symbol not in asked)):
            names.append(push.name)
    return names


def _same(one: Sought, other: Sought) -> bool:
    """Have they the same constants?"""
    ledger = one.trial.system.scene.ledger
    a, b = one.branch.algebra.value.values, other.branch.algebra.value.values
    pairs = [(a[s], b[s]) for s in ledger.sought if s in a and s in b]
    return all(abs(x - y) <= SAME * max(abs(x), abs(y), SAME) for x, y in pairs)
