"""Equations that are put into another at once, (1) to (3) in (4): no line tells before what each of them carries; and
one whose numbers a later line tells has no line of its own.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.report.document.blocks import Block, Equation, Math, Text
from planar_cli.report.equations.solved_already import is_written
from planar_cli.report.notation.notation import plain
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.algebra import Line, SolvedBlock

IN_NUMBERS, PUT_INTO = " in numbers", re.compile(r" in (\(\d+\)):$")
MOST, LONGEST = 3, 14
"""No more lines are left out, and none before a result of more operations: there a reader would lose the way."""


def put_at_once(
    block: SolvedBlock,
    lines: Sequence[Line],
    phrases: Phrases,
    stands: Callable[[Line], bool],
    valued: Callable[[sp.Symbol], bool],
) -> dict[sp.Symbol, tuple[int, ...]]:
    """The one letter that is carried, with the numbers of the equations that are put into its own; empty: lines in
    letters come first. `lines`: those of the block that are told; `stands`: does a line stand as its equation?
    `valued`: has a letter a number on a page of letters?
    """
    result = next((x for x in block.lines if x.symbol in block.letters and not x.letters), None)
    carried = [x for x in block.lines if x.letters]
    if result is None or not carried:
        return {}
    numbers = _as_equations(block, carried, phrases)
    if not numbers and (valued(result.symbol) or not phrases.symbolic):
        numbers = _told_again(block, lines, result, stands)
    return {result.symbol: numbers} if numbers else {}


def _as_equations(block: SolvedBlock, carried: Sequence[Line], phrases: Phrases) -> tuple[int, ...]:
    """The equations as which all lines in letters stand already, so that they are put into the last ones."""
    written = {w.number: w for w in block.equations}
    own = [written[x.equations[0]] for x in carried if x.equations and x.equations[0] in written]
    if len(own) < len(carried) or not all(is_written(w, x, phrases) for w, x in zip(own, carried, strict=True)):
        return ()
    return tuple(w.number for w in own)


def _told_again(
    block: SolvedBlock, lines: Sequence[Line], result: Line, stands: Callable[[Line], bool]
) -> tuple[int, ...]:
    """The equations of the few lines in letters, where each is told again below by another formula, which its equation
    gives as well, and the result is short.
    """
    put = [x for x in lines if x.letters]
    again = {x.symbol: x.formula for x in lines if not x.letters}
    told = [x for x in put if not stands(x)]
    if len(block.letters) > 1 or len(told) > MOST or longer(result.formula, LONGEST):
        return ()
    if not all(again.get(x.symbol, x.formula) != x.formula for x in told):
        return ()
    numbers = tuple(dict.fromkeys(n for x in put for n in x.equations))
    return () if {*numbers} & {*result.equations} else numbers


def without_repeated(blocks: Sequence[Block], later: Sequence[Block]) -> list[Block]:
    """Equations in numbers without those of which a later line tells the same: F_C = -416 α; or which that solves
    for one of its unknowns by the others: (11) in numbers: a - 0.2 α = 0 beside (11): a = 0.2 α; or into which all but
    one of its unknowns are put at once, (7), (8) in (9): O_y = 0.6 α - 80.
    """
    told = [b for b in later if isinstance(b, Equation)]
    said = {_spelled(b) for b in told}
    solved = {(_numbered(b), _unknowns(b)) for b in told}
    put = {number for b in told if (number := _put_into(b))}
    return [
        b
        for b in blocks
        if not isinstance(b, Equation)
        or (_spelled(b) not in said and (_numbered(b), _unknowns(b)) not in solved and _numbered(b) not in put)
    ]


def _put_into(equation: Equation) -> str:
    """(9) of `(7), (8) in (9): O_y = 0.6 α - 80`; empty: nothing is put into it, or it gives no unknown by another."""
    first, lead = equation.sides[0], equation.lead[0] if len(equation.lead) == 1 else None
    found = PUT_INTO.search(lead.text) if isinstance(lead, Text) else None
    by_another = isinstance(first, Math) and first.expr.is_Symbol and len(_unknowns(equation)) > 1
    return found[1] if found is not None and by_another else ""


def _numbered(equation: Equation) -> str:
    """(7) of `(7) in numbers:`, or of `(7):`."""
    lead = equation.lead[0] if len(equation.lead) == 1 else None
    return lead.text.removesuffix(":").removesuffix(IN_NUMBERS) if isinstance(lead, Text) else ""


def _unknowns(equation: Equation) -> frozenset[sp.Symbol]:
    """The letters for which no numbers stand."""
    told = [side for side in equation.sides if isinstance(side, Math)]
    return frozenset(s for side in told for s in side.expr.free_symbols - set(side.values or ()))


def _spelled(equation: Equation) -> str:
    sides = (plain(x.expr, x.values) if isinstance(x, Math) else repr(x) for x in equation.sides)
    return f"{' = '.join(sides)} {equation.note!r}"
