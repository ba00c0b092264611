"""The weights of several equal bodies told by their common mass centre, where that goes a plain part of the way that is
sought: the four rods of a rhombus fall by half of what its lowest corner falls.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.principles.base import Storage
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Math, Name, Paragraph, line
from planar_cli.report.energy.alike import WEIGHT
from planar_cli.report.energy.energy_pieces import STATE, EnergyPieces

LEAST = 3
"""The weights of fewer bodies are told one by one."""


@record
class CommonCentre:
    """`indices`: of the sources that are these weights; `storages`: what they are made of."""

    indices: tuple[int, ...]
    storages: tuple[Storage, ...]
    way: sp.Expr
    """How far the common mass centre goes down [m]."""

    def place(self, pieces: EnergyPieces) -> Paragraph:
        """What G is, and between which points it lies."""
        own = tuple(s.words.removeprefix(WEIGHT) for s in self.storages)
        parts = pieces.balance.parts.midway if pieces.balance.parts is not None else ()
        place = next((f", {words}" for group, words in parts if {*group} == {*own}), "")
        return Paragraph(line(f"G is the common mass centre of {', '.join(own)}{place}."))

    def lines(self, pieces: EnergyPieces) -> Iterator[Block]:
        """y_G,1 - y_G,2 = x/2, and U = n m g (y_G,1 - y_G,2) = formula."""
        b, phrases = pieces.balance, pieces.phrases
        letter = phrases.ledger.apart("y_G")
        one, two = (sp.Symbol(f"{letter}{STATE}{state}", real=True) for state in (b.since, b.stop))
        fall = sp.Add(one, -two, evaluate=False)
        bodies = ", ".join(s.words.removeprefix(WEIGHT) for s in self.storages)
        yield Equation((Math(fall), phrases.math(self.way)))
        whole = len(self.storages) * self.storages[0].factor
        told = Math(sp.Mul(phrases.neat(whole), fall, evaluate=False))
        yield Equation((line(Name(b.law.bring), f" of the weights of {bodies}"), told, phrases.math(whole * self.way)))


def common_centre(pieces: EnergyPieces, sources: Sequence[tuple[str, sp.Expr]]) -> CommonCentre | None:
    """Of the weights among what does work; None: they are few, or not equal, or each brings the same; or their common
    mass centre goes no such way.
    """
    storages = pieces.balance.parts.storages if pieces.balance.parts is not None else ()
    weights = {s.words: s for s in storages if s.power == 1 and s.words.startswith(WEIGHT)}
    for factor in dict.fromkeys(s.factor for s in weights.values()):
        own = [
            (i, put) for i, (words, put) in enumerate(sources) if words in weights and weights[words].factor == factor
        ]
        if len(own) < LEAST or len({put for _, put in own}) == 1:
            continue
        way = simplified(sp.Add(*(put for _, put in own)) / factor / len(own))
        sought = way.as_coeff_Mul()[1]
        if sought.is_Symbol and sought in pieces.unknowns and pieces.is_neat(factor):
            return CommonCentre(tuple(i for i, _ in own), tuple(weights[sources[i][0]] for i, _ in own), way)
    return None
