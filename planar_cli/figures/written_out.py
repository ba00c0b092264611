"""The signs of letters of a diagram through what was solved: written out in the data, or in numbers at the states."""

from __future__ import annotations

from collections import ChainMap
from collections.abc import Iterator, Mapping
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.bounds import certain_sign
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Ledger
from planar_cli.report.document.blocks import Forces
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.solution import InstantSolution

DEEP, LONG = 12, 3000
"""So often is a formula put into another, until it has so many operations."""
NOUGHT = Decimal("1e-20")
"""What is smaller in a state is zero."""


def formulas_of(instant: InstantSolution) -> Mapping[sp.Symbol, sp.Expr]:
    """What was solved, and the letters that stand for something."""
    solved = {line.symbol: line.formula for s in instant.stages for b in s.blocks for line in b.lines}
    return ChainMap({e.symbol: e.expression for e in instant.lines}, solved, dict(instant.value.definitions))


def written_out(expr: sp.Expr, formulas: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    """In the letters on which it rests."""
    for _ in range(DEEP):
        deeper = expr.xreplace(dict(formulas))
        if deeper == expr or deeper.count_ops() > LONG:
            break
        expr = deeper
    return expr


def sign_of(expr: sp.Expr, drawn: Valuation, ledger: Ledger) -> Decimal | None:
    """Of a size in letters, where it is the same whatever they are: angles in the quadrant in which they are drawn,
    coefficients of restitution from 0 to 1.
    """
    sign = certain_sign(expr) or certain_sign(_in_quadrants(expr, drawn)) or certain_sign(_below_one(expr, ledger))
    return Decimal(sign) if sign else None


def _below_one(expr: sp.Expr, ledger: Ledger) -> sp.Expr:
    """With coefficients of restitution in a form that is between 0 and 1 whatever its letter is."""
    bounces = {s for s in expr.free_symbols if ledger.coefficients.get(s.name) == "rebound"}
    if not bounces:
        return sp.S.Zero
    return sp.together(expr.xreplace({s: 1 / (1 + sp.Dummy(positive=True)) for s in bounces}))


def _in_quadrants(expr: sp.Expr, drawn: Valuation) -> sp.Expr:
    """Each sine, cosine and tangent of a letter as a size of its sign."""
    told = {}
    for part in expr.atoms(sp.sin, sp.cos, sp.tan):
        number = drawn.known(part) if part.args[0].is_Symbol else None
        if number is not None and abs(number) > NOUGHT:
            told[part] = sp.Dummy(positive=True) * (1 if number > 0 else -1)
    return expr.xreplace(told)


def states_against(size: sp.Expr, row: Forces, motion: MotionTrace) -> tuple[str, ...]:
    """The states in which a size is negative, if it is so in each for which something is asked, or is positive in none:
    of the stretches on which the scene is that of a diagram.
    """
    found: dict[str, Decimal] = {}
    asked = set[str]()
    for regime in (r for r in motion.regimes if r.solution.instant.scene is row.scene):
        found |= dict(_in_states(size, formulas_of(regime.solution), regime.stretches, motion))
        asked |= set(regime.asked)
    told = tuple(state for state, number in found.items() if number < -NOUGHT)
    if asked and asked <= set(told):
        return tuple(state for state in told if state in asked)
    return told if all(number <= NOUGHT for number in found.values()) else ()


def _in_states(
    size: sp.Expr,
    formulas: Mapping[sp.Symbol, sp.Expr],
    stretches: tuple[tuple[str, str], ...],
    motion: MotionTrace,
) -> Iterator[tuple[str, Decimal]]:
    own = {s: e for s, e in formulas.items() if s not in motion.general.values()}
    for state in dict.fromkeys(name for stretch in stretches for name in stretch if name):
        here = {general: x for x, general in motion.general.items() if motion.ledger.roles[x].at == state}
        number = motion.value.known(written_out(size, own).xreplace(here))
        if number is not None:
            yield state, number
