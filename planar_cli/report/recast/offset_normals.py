"""Equations in which a normal force acts at a distance beside the middle of its face, where the equations of the system
have a couple there: N x for M, as a student draws it.

(1)   x = b/2                                  at the edge, about to tip
(3)   ↺ ΣM_C:   N x - P y = 0
"""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.report.friction.offsets import Offset, offsets
from planar_cli.solve.instant.algebra import Line, SolvedBlock
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Written
from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.units import parse_unit


def with_offset_normals(part: PartSolution) -> PartSolution:
    """The part of one instant with such equations; the same where it has no such couple, or is a motion."""
    if part.motion is not None:
        return part
    instants = tuple(_instant(instant) for instant in part.instants)
    return part if instants == part.instants else replace(part, instants=instants)


def _instant(instant: InstantSolution) -> InstantSolution:
    if not instant.stages:
        return instant
    *first, last = instant.stages
    used = {s for b in last.blocks for w in b.equations for s in w.residual.free_symbols}
    found = [o for o in offsets(instant.trial, instant.value) if o.couple in used]
    if not found:
        return instant
    units = instant.instant.scene.ledger.units
    units.update({o.letter: parse_unit("m") for o in found})
    numbers = {o.letter: o.value for o in found if o.value is not None}
    return replace(instant, stages=(*first, _stage(last, found)), value=instant.value.extended(numbers))


def _stage(stage: Stage, found: Sequence[Offset]) -> Stage:
    letters = {o.couple: o.letter for o in found}
    algebra = copy(stage.algebra)
    algebra.unknowns = frozenset(letters.get(s, s) for s in algebra.unknowns)
    algebra.formulas = {letters.get(s, s): _formula(s, expr, found) for s, expr in algebra.formulas.items()}
    algebra.value = algebra.value.extended({o.letter: o.value for o in found if o.value is not None})
    return replace(stage, blocks=tuple(_block(b, found, letters) for b in stage.blocks), algebra=algebra)


def _block(block: SolvedBlock, found: Sequence[Offset], letters: dict[sp.Symbol, sp.Symbol]) -> SolvedBlock:
    return replace(
        block,
        equations=tuple(_equation(w, found) for w in block.equations),
        unknowns=tuple(letters.get(s, s) for s in block.unknowns),
        letters=tuple(letters.get(s, s) for s in block.letters),
        lines=tuple(_line(x, found) for x in block.lines),
    )


def _equation(w: Written, found: Sequence[Offset]) -> Written:
    left, right = (_put(side, found) for side in (w.left, w.right))
    own = next((o for o in found if o.couple in w.residual.free_symbols), None)
    if own is not None and w.source == "limit":
        # At the edge: M = N b/2 is x = b/2.
        divisor = own.sense * own.normal
        left, right = (simplified(side / divisor) for side in (left, right))
    return replace(w, left=left, right=right)


def _line(x: Line, found: Sequence[Offset]) -> Line:
    own = next((o for o in found if o.couple == x.symbol), None)
    formula = _formula(x.symbol, x.formula, found)
    letters = tuple(next((o.letter for o in found if o.couple == s), s) for s in x.letters)
    if own is None:
        return replace(x, formula=formula, letters=letters)
    return replace(x, symbol=own.letter, formula=formula, value=own.value, letters=letters)


def _formula(symbol: sp.Symbol, expr: sp.Expr, found: Sequence[Offset]) -> sp.Expr:
    """The formula of an unknown, or of the distance for its couple."""
    own = next((o for o in found if o.couple == symbol), None)
    formula = _put(expr, found)
    return formula if own is None else simplified(own.sense * formula / own.normal)


def _put(expr: sp.Expr, found: Sequence[Offset]) -> sp.Expr:
    return sp.sympify(expr).xreplace({o.couple: o.moment for o in found})
