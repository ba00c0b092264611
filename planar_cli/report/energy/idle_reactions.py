"""Which reactions do no work, and why, in the heading of a balance of energies."""

from __future__ import annotations

from typing import Any

import sympy as sp

from planar_cli.principles.base import Idle
from planar_cli.report.document.blocks import Math

MOST_NAMED = 8
MOST_INTERNAL, FEW = 3, 3
"""More forces are not listed by name; so many internal ones are; and so many a second time."""


def idle_reactions(reactions: tuple[Idle, ...], internal: tuple[sp.Symbol, ...]) -> list[Any]:
    """Which reactions do no work, and why; and which none in all."""
    if len(reactions) + len(internal) > MOST_NAMED:
        return ["; the reactions of the ideal joints do no net work"]
    alone: list[Any] = []
    for why in dict.fromkeys(r.why for r in reactions):
        alone += [", "] if alone else []
        alone += [*_listed(tuple(r.force for r in reactions if r.why == why)), f" ({why})" if why else ""]
    alone += [" do no work" if len(reactions) > 1 else " does no work"] if reactions else []
    if not internal:
        return ["; ", *alone] if alone else []
    several = len(internal) > 1
    together = [
        f"the internal force{'s' if several else ''} ",
        *(_listed(internal) if len(internal) <= MOST_INTERNAL else ["between the bodies"]),
        "" if alone else " do" if several else " does",
        " no net work",
    ]
    return ["; ", *alone, *([", "] if alone else []), *together]


def idle_again(reactions: tuple[Idle, ...], internal: tuple[sp.Symbol, ...]) -> list[Any]:
    """The same where an earlier balance has told why."""
    if not reactions and not internal:
        return []
    if internal or len(reactions) > FEW:
        return ["; the same forces do no work"]
    return ["; ", *_listed(tuple(r.force for r in reactions)), " do no work" if len(reactions) > 1 else " does no work"]


def _listed(symbols: tuple[sp.Symbol, ...]) -> list[Any]:
    return [part for i, s in enumerate(symbols) for part in ((", ", Math(s)) if i else (Math(s),))]
