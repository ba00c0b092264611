"""What is largest or smallest at one instant, as a function of what is free there, and its derivative.

w_min is smallest, so its derivative with respect to β is zero:
  by (3):   w_min = v_stream,y/sin β
  d/dβ:     -v_stream,y cos β / sin² β = 0

Of a formula that has what is free in one sine or cosine alone, its largest value 1 says it without a derivative.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.form import Nonlinear, linear_form
from planar_cli.equation.algebra.plain import by_name, identically_zero, longer, simplified
from planar_cli.report.document.blocks import Block, Equation, Paragraph, line
from planar_cli.report.equations.results import numbered
from planar_cli.report.instant.across_the_way import across_what_it_makes
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Written
from planar_cli.solve.solution import InstantSolution

LONGEST = 26
"""A longer function, or derivative, is not told."""
SHORT = 2
"""What is extreme is named by its words where it is a longer formula."""
NEAR = Decimal("1e-9")
"""A sine or cosine so near to 1 is 1."""
MOST = 3
"""Of more equations it is no short function."""


def with_rate(
    w: Written,
    stage: Stage,
    instant: InstantSolution,
    phrases: Phrases,
    number: Callable[[Stage, int], int],
    blocks: list[Block],
) -> list[Block]:
    """The blocks of a condition, after its words the function and its derivative; as they are, where either is long or
    more than one letter is free. `number`: tells the printed number of an equation.
    """
    if len(blocks) < 2:
        return blocks
    (extreme, *_) = instant.instant.statements.extremes
    objective = sp.sympify(instant.trial.system.quantities().evaluator.value(extreme.side))
    every = [x for b in stage.blocks for x in b.equations if x.source != "extreme"]
    unknowns = {x for b in stage.blocks for x in b.unknowns} | objective.free_symbols & set(phrases.ledger.sought)
    free = [s for s in by_name(w.residual.free_symbols & unknowns) if s != objective]
    found = _as_function(objective, free[0], unknowns - {*free}, every) if len(free) == 1 else None
    if found is None:
        return blocks
    function, used = found
    rate = factored(simplified(sp.diff(function, free[0])))
    told = [e for e in (function, rate) if longer(e, LONGEST) or not _is_told(e, phrases)]
    if told or identically_zero(rate - w.residual):
        return blocks
    lead = (
        line("as a function of it:") if not used else line(f"by {numbered([number(stage, x.number) for x in used])}:")
    )
    short = not longer(objective, SHORT)
    own = phrases.math(objective) if short else line(extreme.text.rpartition(" is ")[0])
    first = [] if function == objective else [Equation((own, phrases.math(function)), None, lead)]
    if (wave := _alone_in(function, free[0], extreme.sense, phrases)) is not None:
        across = across_what_it_makes(extreme, instant) if extreme.sense < 0 else ()
        words = [Paragraph(line(own, " is smallest where ", *across))] if across else []
        return [*words, *_without_calculus(own, extreme.sense, wave, first, blocks[-1], phrases)]
    second = Equation((phrases.math(rate), phrases.math(sp.S.Zero)), None, line("d/d", phrases.math(free[0]), ":"))
    return [*blocks[:-1], *first, second, blocks[-1]]


def _alone_in(function: sp.Expr, z: sp.Symbol, sense: int, phrases: Phrases) -> sp.Expr | None:
    """The one sine or cosine with the free letter, which a function grows with (sense 1) or is divided by (-1), and
    which is 1 where it is extreme; None: the function holds the letter otherwise.
    """
    waves = [f for f in function.atoms(sp.sin, sp.cos) if f.has(z)]
    if len(waves) != 1 or (function / waves[0] ** sense).has(z):
        return None
    there = phrases.value.known(waves[0])
    return waves[0] if there is not None and abs(there - 1) < NEAR else None


def _without_calculus(
    own: Any, sense: int, wave: sp.Expr, first: Sequence[Block], last: Block, phrases: Phrases
) -> list[Block]:
    """w_min = u/(2 sin β), smallest where sin β is largest, and sin β ≤ 1: sin β = 1."""
    if not isinstance(last, Equation):
        return [*first, last]
    extreme = "largest" if sense > 0 else "smallest"
    own_wave = phrases.math(wave)
    words = line("This is ", extreme, " where ", own_wave, " is largest, and ", own_wave, " ≤ 1:")
    return [*first, Paragraph(words), replace(last, sides=(phrases.math(wave), phrases.math(sp.S.One)))]


def _is_told(expr: sp.Expr, phrases: Phrases) -> bool:
    return phrases.symbolic or is_clean(phrases.ledger, expr)


def _as_function(
    objective: sp.Expr, z: sp.Symbol, others: set[sp.Symbol], every: Sequence[Written]
) -> tuple[sp.Expr, list[Written]] | None:
    """What is extreme by the free letter alone, and the equations that make it so; None: they are not linear in all
    else that is unknown.
    """
    used: list[Written] = []
    letters = objective.free_symbols & others
    while more := [x for x in every if x not in used and x.residual.free_symbols & letters]:
        used.append(more[0])
        letters |= more[0].residual.free_symbols & others
        if len(used) >= len(letters):
            break
    if len(used) != len(letters) or len(used) > MOST:
        return None
    try:
        for x in used:
            linear_form(x.residual, frozenset(letters))
    except Nonlinear:
        return None
    ordered = by_name(letters)
    (solution, *_) = sp.solve([x.residual for x in used], ordered, dict=True) if used else ({},)
    function = simplified(objective.xreplace(solution))
    return None if function.free_symbols & letters or not function.has(z) else (function, used)
