"""Answers in letters: the line that gives one has its formula in the letters of the file before the numbers."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.plain import identically_zero, longer
from planar_cli.equation.values.exact import PI
from planar_cli.problem.scene.scene import Problem
from planar_cli.report.answers.answer_letters import asked_symbol
from planar_cli.report.document.blocks import Block, Equation, Inline, Line, Math, Name, Text, Value
from planar_cli.report.laws.antiderivatives import is_between_limits
from planar_cli.report.notation.by_ratio import Ratio, by_ratio
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.hidden_data import hides_data
from planar_cli.report.notation.names import plain_name
from planar_cli.report.notation.notation import plain
from planar_cli.report.words.swallowed import swallowed
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.units import PURE

LONGEST, SHORT, PLAIN = 40, 8, 24
"""A longer formula stands in the answer alone; of a page of numbers, beside the line that gives the answer; the largest
number in such a one.
"""
TWICE, SHARE = 2, 14
"""So many times longer a formula says less than one of few results; the longest one of a share of energies."""


def with_closed_forms(blocks: Sequence[Block], part: PartSolution, phrases: Phrases) -> list[Block]:
    """The blocks of a part, with the formulas of its answers behind the lines that give them in other letters."""
    found = list(blocks)
    if not phrases.letters:
        return _in_data(found, part, phrases)
    for answer in part.found:
        _with_number(found, answer, part, phrases)
        if (
            answer.values is not None
            or answer.word
            or answer.curve is not None
            or answer.kind not in ("number", "vector")
        ):
            continue
        names = _names(answer, part)
        closed = answer.expressions or ()
        for axis, expr in zip(("x", "y") if len(closed) > 1 else ("",), closed, strict=True):
            own = {f"{name}, {axis}" if axis else name for name in names}
            lines = [i for i, block in enumerate(found) if _left(block) in own and not is_between_limits(block)]
            # A numbered line may be an equation that a letter stands in, rather than what gives it.
            given = [i for i in lines if not _is_numbered(found[i])] or lines
            shown = swallowed(expr, answer, phrases.ledger, phrases.figures) or Math(phrases.neat(expr))
            if given and expr != 0 and not longer(expr, LONGEST):
                found[given[-1]] = _ended(found[given[-1]], shown)
    return found


def _with_number(blocks: list[Block], answer: Found, part: PartSolution, phrases: Phrases) -> None:
    """Of letters, the line of an answer that is a number all the same: arccos(3/5) = 53.13°."""
    closed = (answer.expressions or (sp.S.NaN,))[0]
    if answer.kind != "number" or answer.word or answer.values is None or closed.free_symbols or not closed.is_real:
        return
    closed = closed.replace(lambda e: e.is_Add, _complement)
    lines = [i for i, block in enumerate(blocks) if _left(block) in _names(answer, part)]
    block = blocks[lines[-1]] if lines else None
    if not isinstance(block, Equation) or len(block.sides) != 2 or not closed.has(sp.acos, sp.asin, sp.atan):
        return
    values = phrases.in_units(answer.values[0], answer.unit, answer.energy)
    if answer.unit.angle and answer.unit.text == "rad":
        values = [*values, Value(answer.values[0] * 180 / PI, "deg", phrases.figures)]
    head, told = block.sides
    more = values if not isinstance(told, Value) else [told, *(v for v in values if v.unit != told.unit)]
    formulas = (Math(closed),) if isinstance(told, Value) else (told, Math(closed))
    blocks[lines[-1]] = replace(block, sides=(head, *formulas, *more))


def _complement(total: sp.Expr) -> sp.Expr:
    """π/2 - arcsin x is arccos x."""
    inverse = [a for a in total.args if isinstance(-a, sp.asin)]
    return sp.acos((-inverse[0]).args[0]) if len(inverse) == 1 and total == sp.pi / 2 + inverse[0] else total


def _in_data(blocks: list[Block], part: PartSolution, phrases: Phrases) -> list[Block]:
    """The blocks of a page of numbers: where a line gives an answer by other results, its short formula in the data."""
    ratios: dict[int, Ratio] = {}
    for answer in part.found:
        share = any(_is_share(block, answer) for block in blocks)
        closed = _short_formula(answer, phrases, SHARE if share else SHORT)
        own = asked_symbol(answer, part)
        called = plain_name(own.name) if own is not None else plain_name(answer.name)
        if closed is None or (own is None and any(plain_name(s.name) == called for s in phrases.ledger.units)):
            # A letter of that name may be its opposite.
            continue
        lines = [i for i, block in enumerate(blocks) if _left(block) == called]
        block = blocks[lines[-1]] if lines else None
        own_sides = block.sides if isinstance(block, Equation) else ()
        if lines and own is not None and answer.unit.dimension == PURE and not answer.unit.angle:
            ratios[lines[-1]] = own, closed
        if any(isinstance(side, Math) and side.expr == phrases.neat(closed) for side in own_sides):
            continue
        if _by_definitions(own_sides, closed, phrases) or hides_data(_problem(part), answer, closed):
            continue
        if (answer.energy and _is_difference(own_sides, closed)) or _is_told(blocks, own_sides, phrases):
            continue
        if isinstance(block, Equation) and not block.note and (share or _rests_on_results(block, closed)):
            above = [ratio for i, ratio in ratios.items() if i < lines[-1]]
            blocks[lines[-1]] = _lettered(block, closed, phrases, above)
    return blocks


def _lettered(block: Equation, closed: sp.Expr, phrases: Phrases, above: Sequence[Ratio]) -> Equation:
    """letter = formula in results = formula in the data = its numbers = value. `above`: ratios that were found."""
    head, formula, *rest = block.sides
    values = [side for side in rest if isinstance(side, Value)]
    if not values or not isinstance(rest[-1], Value) or any(isinstance(side, tuple) for side in rest):
        return block
    lettered = [side.expr for side in rest if isinstance(side, Math) and not side.values and side.expr.free_symbols]
    if any(operations(e) <= operations(closed) for e in lettered):
        # It is short there by letters that stand above, -l ω_n sin(π/2) = -l ω_n.
        return block
    put = phrases.substituted(closed, values[0])
    shorter = by_ratio(closed, above)
    first = () if shorter is None else (Math(shorter),)
    return replace(block, sides=(head, formula, *first, Math(phrases.neat(closed)), *put, *values))


def _problem(part: PartSolution) -> Problem:
    """The file, or the case, that a part is of."""
    if part.motion is not None:
        return part.motion.problem
    problem: Problem = part.instants[0].instant.scene.problem
    return problem


def _is_share(block: Block, answer: Found) -> bool:
    """Does a line give an answer as a share of energies, 1 - T_2/T_1? What that rests on, only its formula shows."""
    if not isinstance(block, Equation) or _left(block) != plain_name(answer.name) or len(block.sides) < 3:
        return False
    formula = block.sides[1].expr if isinstance(block.sides[1], Math) else sp.S.Zero
    return len(formula.free_symbols) > 1 and all(s.name.startswith("T__") for s in formula.free_symbols)


def _short_formula(answer: Found, phrases: Phrases, most: int) -> sp.Expr | None:
    """The formula of an answer that has a number, in letters that the file gives; None: it is long, or has others.
    `most`: how many operations it has at most.
    """
    closed = (answer.expressions or (None,))[0]
    if answer.kind != "number" or answer.word or answer.values is None or closed is None or answer.curve is not None:
        return None
    given = all(phrases.ledger.values.get(s) is not None for s in closed.free_symbols)
    if not closed.free_symbols or not given or longer(closed, most):
        return None
    plain = all(max(abs(n.p), n.q) <= PLAIN for n in closed.atoms(sp.Rational))
    return closed if plain and is_clean(phrases.ledger, closed, dimension=answer.unit.dimension) else None


def _rests_on_results(block: Block, closed: sp.Expr) -> bool:
    """Does a line give its letter by letters that the closed formula does without, and by no fewer?"""
    if not isinstance(block, Equation) or len(block.sides) < 3:
        return False
    side = block.sides[1]
    formula = side.expr if isinstance(side, Math) else None
    if formula is None or formula.is_number or formula == closed:
        return False
    if {plain_name(x.name.replace("__", "_")) for x in closed.free_symbols} == {
        plain_name(x.name.replace("__", "_")) for x in formula.free_symbols
    }:
        # A letter of a state may have the name of a datum in print.
        return False
    more = formula.free_symbols - closed.free_symbols
    product = formula.is_Mul and not formula.has(sp.Add)
    if len(more) == 1 and product and operations(closed) > operations(formula):
        # R α, with the α just found: what α is made of would only be told again.
        return False
    if operations(closed) > TWICE * operations(formula) and len(closed.atoms(sp.Add)) > 1:
        # Made of few results, it says more by these.
        return False
    return bool(more) and len(closed.free_symbols) <= len(formula.free_symbols) + 1


def _is_told(blocks: Sequence[Block], sides: Sequence[Inline | Line], phrases: Phrases) -> bool:
    """Is it one other letter, S_1 = S_2, whose own line has its formula by letters of data and of what only
    names something?
    """
    letter = sides[1].expr if len(sides) > 1 and isinstance(sides[1], Math) else None
    if letter is None or not letter.is_Symbol:
        return False
    given = {_left(block) for block in blocks} - {plain_name(s.name) for s in phrases.ledger.definitions}
    own = (b for b in blocks if isinstance(b, Equation) and _left(b) == plain_name(letter.name) and len(b.sides) > 3)
    formulas = (b.sides[1].expr for b in own if isinstance(b.sides[1], Math))
    return any(not {plain_name(s.name) for s in e.free_symbols} & given for e in formulas)


def _is_difference(sides: Sequence[Inline | Line], closed: sp.Expr) -> bool:
    """Of a loss of energy nobody sees how the energies before and after become one product."""
    formula = sides[1].expr if len(sides) > 1 and isinstance(sides[1], Math) else sp.S.Zero
    return bool(formula.is_Add and not closed.is_Add)


def _by_definitions(sides: Sequence[Inline | Line], closed: sp.Expr, phrases: Phrases) -> bool:
    """Is the formula of a line the closed one but for letters that only name something, as I_G does m k_G²? The
    fractions of 1/12 m l² go into those of the closed one, which says more.
    """
    formula = sides[1].expr if len(sides) > 2 and isinstance(sides[1], Math) else None
    named = phrases.ledger.definitions
    if formula is None or formula.is_number or not formula.free_symbols & named.keys():
        return False
    inside = {s: named[s] for s in formula.free_symbols if s in named}
    terms = [t for e in inside.values() for t in sp.Add.make_args(sp.expand(e))]
    if any(abs(t.as_coeff_Mul()[0]) != 1 for t in terms):
        return False
    return identically_zero(formula.xreplace(inside) - closed)


def _names(answer: Found, part: PartSolution) -> Collection[str]:
    """What the left side of its line may be called: its own name, or the letter of the solution that it is."""
    symbol = asked_symbol(answer, part)
    return {plain_name(answer.name)} | ({plain_name(symbol.name)} if symbol is not None else set())


def _left(block: Block) -> str:
    """The name that an equation gives; empty where its first side is more than a name."""
    if not isinstance(block, Equation):
        return ""
    side: Inline | Line = block.sides[0]
    pieces = side if isinstance(side, tuple) else (side,)
    if not all(isinstance(p, Name | Text) or (isinstance(p, Math) and p.expr.is_Symbol) for p in pieces):
        return ""
    return "".join(_word(p) for p in pieces)


def _is_numbered(block: Block) -> bool:
    return isinstance(block, Equation) and block.number is not None


def _word(piece: Inline) -> str:
    if isinstance(piece, Math):
        return plain_name(piece.expr.name)
    return plain_name(piece.name) if isinstance(piece, Name) else piece.text if isinstance(piece, Text) else ""


def _ended(block: Block, closed: Math) -> Block:
    """An equation that ends with a formula, once."""
    assert isinstance(block, Equation)
    text = plain(closed.expr, closed.values)
    said = [plain(s.expr, s.values) for s in block.sides if isinstance(s, Math)]
    last = block.sides[-1]
    same = isinstance(last, Math) and not last.values and sp.expand(last.expr - closed.expr) == 0
    return block if same or text in said else replace(block, sides=(*block.sides, closed))
