"""Particles that move together in a balance of energies, as a bullet and the block in which it stays, as one body:
T of block, bullet = (m_B + m_0) v²/2.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.principles.base import EnergyParts, Moving, Storage
from planar_cli.solve.between.trace.trace import BalanceTrace

WEIGHT, WEIGHTS = "weight of ", "weights of "


def as_one_body(b: BalanceTrace) -> BalanceTrace:
    """The same amounts, with those of such particles, and the works of their weights, put together."""
    if b.parts is None or not b.law.letter or len(b.amounts) < 2:
        return b
    for group in _together(b.parts.moving):
        b = _with_one(b, group)
    return b


def _together(moving: Sequence[Moving]) -> list[tuple[str, ...]]:
    """The names of particles that have one velocity, which is not zero."""
    found: dict[tuple[sp.Expr, sp.Expr], list[str]] = {}
    for m in moving:
        if m.inertia == 0 and m.mass != 0 and (m.vx, m.vy) != (0, 0):
            found.setdefault((m.vx, m.vy), []).append(m.body)
    return [tuple(names) for names in found.values() if len(names) > 1]


def _with_one(b: BalanceTrace, group: tuple[str, ...]) -> BalanceTrace:
    assert b.parts is not None
    name = ", ".join(group)
    own = [amount for body, amount in b.amounts if body in group]
    if len(own) < len(group):
        return b
    amounts = [(name, sp.Add(*own)) if body == group[0] else (body, e) for body, e in b.amounts]
    weights, storage = _weights(b.parts.storages, group, name)
    brought, storages = b.brought, b.parts.storages
    if storage is not None:
        brought = tuple(_in_place(b.brought, weights, storage.words))
        storages = tuple(s if s.words != weights[0] else storage for s in storages if s.words not in weights[1:])
    return replace(
        b,
        law=replace(b.law, moving=_moving(b.law.moving, group, name)),
        amounts=tuple((body, e) for body, e in amounts if body not in group[1:]),
        brought=brought,
        parts=EnergyParts(_moving(b.parts.moving, group, name), storages, b.parts.midway),
    )


def _moving(moving: Sequence[Moving], group: tuple[str, ...], name: str) -> tuple[Moving, ...]:
    """With the total mass in the place of the first of them."""
    mass = sp.Add(*(m.mass for m in moving if m.body in group))
    whole = (replace(m, body=name, mass=mass) if m.body == group[0] else m for m in moving)
    return tuple(m for m in whole if m.body not in group[1:])


def _weights(storages: Sequence[Storage], group: tuple[str, ...], name: str) -> tuple[tuple[str, ...], Storage | None]:
    """The words of their weights, and these as one; None: they have none, or sink by different heights."""
    own = [s for s in storages if s.words.removeprefix(WEIGHT) in group and s.power == 1]
    if len(own) < len(group) or len({(s.first, s.last) for s in own}) > 1:
        return (), None
    factor = sp.Add(*(s.factor for s in own))
    return tuple(s.words for s in own), replace(own[0], words=f"{WEIGHTS}{name}", factor=factor)


def _in_place(brought: Sequence[tuple[str, sp.Expr]], weights: Sequence[str], name: str) -> list[tuple[str, sp.Expr]]:
    """The works with that of all these weights in the place of the first one."""
    whole = sp.Add(*(e for words, e in brought if words in weights))
    told = [(name, whole) if words == weights[0] else (words, e) for words, e in brought]
    return [(words, e) for words, e in told if words not in weights[1:]]
