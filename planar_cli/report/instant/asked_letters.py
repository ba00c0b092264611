"""What is asked of one instant and is a letter of its equations: its formula in the letters of the file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.equation.values.ledger import Ledger
from planar_cli.problem.language.expression import Name, Quantity
from planar_cli.report.document.blocks import Block, Equation, Line, Math, line
from planar_cli.report.kinetics.inertias import is_sought
from planar_cli.report.words.words import Phrases
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
        yield Equation(
            (Math(symbol), phrases.math(closed)), None, _with_given(symbol, closed, formulas, ledger, phrases)
        )
    elif phrases.symbolic:
        yield _with_numbers(answer, closed, replace(phrases, symbolic=False, lettered=frozenset(ledger.letters)))


def is_second_rate(what: object) -> bool:
    """Is the second rate of a coordinate asked, as an equation of motion is?"""
    return isinstance(what, Quantity) and what.word == "ddot" and isinstance(what.argument, Name)


def is_solved(expr: sp.Expr, instant: InstantSolution) -> bool:
    """Is it what an unknown of the equations is in their last lines?"""
    return any(expr == formula for stage in instant.stages for formula in stage.algebra.formulas.values())


def _with_given(
    symbol: sp.Symbol, closed: sp.Expr, formulas: Mapping[sp.Symbol, sp.Expr], ledger: Ledger, phrases: Phrases
) -> Line:
    """`With h = R:` where the file gives a letter of the lines above by a formula, which the last line has put in."""
    held, seen = {symbol}, set[sp.Symbol]()
    while held:
        seen |= held
        held = {s for x in held for s in formulas.get(x, sp.S.Zero).free_symbols} - seen
    gone = sorted((s for s in seen - closed.free_symbols if _is_formula(s, ledger)), key=lambda s: s.name)
    told = [p for s in gone for p in (", ", Math(s), " = ", phrases.math(ledger.values[s]))]
    return line("with ", *told[1:], ":") if told else ()


def _is_formula(symbol: sp.Symbol, ledger: Ledger) -> bool:
    value = ledger.values.get(symbol)
    return value is not None and bool(value.free_symbols)


def _with_numbers(answer: Found, formula: sp.Expr, phrases: Phrases) -> Equation:
    """letter = formula = numbers = value."""
    assert answer.values is not None
    values = phrases.in_units(answer.values[0], answer.unit, answer.energy)
    numbers = phrases.substituted(formula, values[0])
    return Equation((Math(answer.asked[0]), phrases.math(formula), *numbers, *values))
