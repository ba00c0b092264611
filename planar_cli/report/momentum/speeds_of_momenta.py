"""How bodies turn and go at the end of a time, as one line before their momenta: ω_rear,2 = ω_front,2 = v/r."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.report.document.blocks import Block, Equation, Math, Paragraph, Text, line
from planar_cli.report.momentum.momenta import MomentumTelling
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import BalanceTrace

ROLLS = " rolls without slipping"


def speeds_first(
    own: Sequence[BalanceTrace], plain: Mapping[sp.Symbol, sp.Expr], phrases: Phrases, told: set[sp.Symbol]
) -> Iterator[Block]:
    """What the balances count by the speed of another body, the same speeds as one chain; `told`: what was told, which
    grows.
    """
    chains: dict[sp.Expr, list[Equation]] = {}
    for balance in own:
        for told_line in MomentumTelling(balance, (), phrases, plain, told).speeds():
            made = told_line.sides[-1]
            if isinstance(made, Math):
                chains.setdefault(made.expr, []).append(told_line)
    if chains:
        yield Paragraph(line(f"Kinematics, at {own[0].stop}:"))
    for lines in chains.values():
        sides = (*(side for e in lines for side in e.sides[:-1]), lines[-1].sides[-1])
        whys = list(dict.fromkeys("".join(p.text for p in e.note if isinstance(p, Text)) for e in lines))
        yield replace(lines[0], sides=sides, note=line(_together(whys)))


def _together(whys: Sequence[str]) -> str:
    """rear and front roll without slipping."""
    if len(whys) > 1 and all(why.endswith(ROLLS) for why in whys):
        *others, last = (why.removesuffix(ROLLS) for why in whys)
        return f"{', '.join(others)} and {last} roll without slipping"
    return "; ".join(whys)
