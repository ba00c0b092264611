"""What is asked of one instant and is a letter of its equations: its formula in the letters of the file."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from planar_cli.equation.plain import longer
from planar_cli.report.blocks import Block, Equation, Math
from planar_cli.report.inertias import is_sought
from planar_cli.report.words import Phrases
from planar_cli.solve.solution import Found, InstantSolution

LONGEST = 40
"""A formula of more operations is not told."""


def closed_letter(answer: Found, instant: InstantSolution, phrases: Phrases) -> Iterator[Block]:
    """Of letters, the formula of an unknown in the letters of the file, where its last line has others; with numbers
    where what has none cancels. A moment of inertia is told with the size that has been found.
    """
    symbol, ledger = answer.asked[0], instant.instant.scene.ledger
    if symbol in ledger.definitions:
        if is_sought(symbol, ledger) and phrases.has_numbers(symbol):
            yield _with_numbers(answer, ledger.definitions[symbol], phrases)
        return
    formulas: dict[sp.Symbol, sp.Expr] = {}
    for stage in instant.stages:
        formulas |= stage.algebra.formulas
    closed = (answer.expressions or (symbol,))[0]
    if formulas.get(symbol, closed) == closed or longer(closed, LONGEST):
        return
    if answer.values is None:
        yield Equation((Math(symbol), phrases.math(closed)))
    elif phrases.symbolic:
        yield _with_numbers(answer, closed, replace(phrases, symbolic=False, lettered=frozenset(ledger.letters)))


def _with_numbers(answer: Found, formula: sp.Expr, phrases: Phrases) -> Equation:
    """letter = formula = numbers = value."""
    assert answer.values is not None
    values = phrases.in_units(answer.values[0], answer.unit, answer.energy)
    numbers = phrases.substituted(formula, values[0])
    return Equation((Math(answer.asked[0]), phrases.math(formula), *numbers, *values))
