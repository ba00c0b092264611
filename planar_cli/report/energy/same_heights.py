"""Weights of mass centres that are at one height in both states of a balance told as one, whichever place each has:

y_G,crank,2 = y_G,AB,2 = 1/2 r_c sin θ_crank,2
U of the weights of crank, AB = (m_c + m_r) g (y_G,crank,1 - y_G,crank,2)
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.plain import simplified
from planar_cli.principles.base import Storage
from planar_cli.report.energy.alike import WEIGHT, WEIGHTS
from planar_cli.report.energy.common_centre import common_centre
from planar_cli.report.energy.energy_pieces import EnergyPieces
from planar_cli.solve.between.trace.trace import BalanceTrace


def with_same_heights(pieces: EnergyPieces) -> BalanceTrace:
    """The balance of `pieces` with such weights in one; those that bring the same are told of each."""
    b = pieces.balance
    storages = b.parts.storages if b.parts is not None else ()
    weights = [s for s in storages if s.power == 1 and s.words.startswith(WEIGHT)]
    groups: list[list[Storage]] = []
    for s in weights if len(weights) > 1 else ():
        own = next((group for group in groups if _are_as_high(group[0], s, pieces)), None)
        if own is None:
            groups.append([s])
        else:
            own.append(s)
    groups = [group for group in groups if len({pieces.put(s.brought) for s in group}) > 1]
    if not groups or common_centre(pieces, [(words, pieces.put(e)) for words, e in b.brought]) is not None:
        return b
    for group in groups:
        b = _with_one(b, group)
    return b


def _with_one(b: BalanceTrace, group: Sequence[Storage]) -> BalanceTrace:
    """With one source in the place of the first of a group, by the heights that are the shortest to tell."""
    assert b.parts is not None
    names = [s.words for s in group]
    told = min(group, key=lambda s: operations(s.first) + operations(s.last))
    whole = replace(
        told,
        words=WEIGHTS + ", ".join(name.removeprefix(WEIGHT) for name in names),
        factor=sp.Add(*(s.factor for s in group)),
        alike=tuple(s.letter for s in group if s is not told),
    )
    storages = tuple(whole if s is group[0] else s for s in b.parts.storages if s not in group[1:])
    works = ((whole.words, whole.brought) if words == names[0] else (words, e) for words, e in b.brought)
    brought = tuple((words, e) for words, e in works if words not in names[1:])
    return replace(b, brought=brought, parts=replace(b.parts, storages=storages))


def _are_as_high(one: Storage, other: Storage, pieces: EnergyPieces) -> bool:
    """Are two at one height at the beginning and at the end, in one of these by the same formula?"""
    ends = [(pieces.height(a), pieces.height(b)) for a, b in ((one.first, other.first), (one.last, other.last))]
    return any(a == b for a, b in ends) and all(_are_equal(a, b, pieces) for a, b in ends)


def _are_equal(one: sp.Expr, other: sp.Expr, pieces: EnergyPieces) -> bool:
    """What is sought as a formula, all else as a number."""
    if one == other:
        return True
    if any(e.free_symbols & set(pieces.unknowns) for e in (one, other)):
        return bool(simplified(one - other) == 0)
    return pieces.phrases.value.is_zero(one - other)
