"""The right side of a sum of moments as it is put together, where the equation has its terms collected.

↺ ΣM_B:  N_C l - 1/2 m g l = I_BC α_BC + 1/2 m l α_BC · l/2 + m l α_AB · l/2 = 1/6 m l² α_AB
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from planar_cli.report.document.blocks import Line, Math, Text, line
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.written import Written

PLUS, MINUS = " + ", " - "
MOST = 8
"""A sum of more terms is not told before it is collected."""


def with_raw_moments(w: Written, turn: int, sides: tuple[Any, ...], phrases: Phrases) -> tuple[Any, ...]:
    """The sides of a sum of moments, with what the right one is collected from before it. `turn`: the sense in which
    moments count.
    """
    parts = [p for force, arm in w.moments if phrases.math(arm).expr != 0 for p in _terms(force, arm)]
    collected = sp.Add.make_args(sp.expand(w.right))
    if len(sides) != 2 or w.right == 0 or not 1 < len(parts) <= MOST or len(collected) >= len(parts):
        return sides
    return sides[0], _raw(parts, turn, phrases), sides[1]


def _terms(force: sp.Expr, arm: sp.Expr) -> list[tuple[sp.Expr, sp.Expr]]:
    """A force with its arm, each of several forces with it."""
    return [(f, arm) for f in sp.Add.make_args(sp.expand(force))]


def _raw(parts: list[tuple[sp.Expr, sp.Expr]], turn: int, phrases: Phrases) -> Line:
    told: list[Any] = []
    for force, arm in parts:
        negative = (force.could_extract_minus_sign() != arm.could_extract_minus_sign()) != (turn < 0)
        told += [MINUS if negative and told else "-" if negative else PLUS if told else ""]
        told.append(phrases.math(-force if force.could_extract_minus_sign() else force))
        size = -arm if arm.could_extract_minus_sign() else arm
        if size != 1:
            told += [" · (", phrases.math(size), ")"] if size.is_Add else [" · ", phrases.math(size)]
    return line(*(t for t in told if t != ""))


def without_nothing(side: Line) -> Line:
    """Such a side without the products that became zero at a place."""
    terms: list[list[Any]] = [[]]
    for piece in side:
        if isinstance(piece, Text) and piece.text in (PLUS, MINUS):
            terms.append([])
        terms[-1].append(piece)
    kept = [t for t in terms if not any(isinstance(p, Math) and p.expr == 0 for p in t)]
    (first, *rest), *others = kept or terms
    # The first one that is left has no plus before it, and a minus without a space.
    signed = isinstance(first, Text) and first.text in (PLUS, MINUS)
    head = [Text("-")] if signed and first.text == MINUS else [] if signed else [first]
    return (*head, *rest, *(p for t in others for p in t))
