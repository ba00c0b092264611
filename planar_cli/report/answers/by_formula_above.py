"""For which value of a datum something is zero: the formula that was found for it, with that datum open, not a second
solution.

friction = 0:  P (R (R + r)/(R² + k_G²) - 1) = 0
               k_G² = R r
               k_G = √(R r) = √(0.45 · 0.3) = 0.3674 m
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import fields
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.common_factors import together
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import identically_zero, longer, simplified
from planar_cli.problem.language.expression import Name as Named
from planar_cli.problem.language.expression import Number, Quantity, Relation
from planar_cli.problem.scene.scene import Problem
from planar_cli.records import record
from planar_cli.report.document.blocks import (
    Answer,
    Block,
    Check,
    Equation,
    Forces,
    Heading,
    Inline,
    Line,
    Math,
    Name,
    Note,
    Paragraph,
    Result,
    Table,
    Text,
    line,
)
from planar_cli.report.document.blocks import Relation as Stated
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution, Solution

LONGEST = 40
"""A formula of more operations is better found anew."""
OWN = ("given", "unknowns", "find", "instant", "cases", "answers", "title", "text", "note", "tolerance", "source")
"""What a case of this kind has for itself."""
INDEPENDENT = "checked by an independent"


def by_formula_above(
    part: PartSolution, solution: Solution, phrases: Phrases | None, own: list[Block], above: list[Block]
) -> list[Block]:
    """The blocks of a case with its steps told so; as they are where it asks something else. `phrases`: of the case.
    `above`: what the page says before it.
    """
    found = _asked(part, solution)
    told = [] if found is None or phrases is None else _equations(found, phrases, above)
    if found is None or not told:
        return own
    letter = found.letter
    named = line(Name(found.zero.name) if letter is None else Math(letter), " = 0")
    reason = "contact is lost where " if found.presses else ""
    head = Heading("STEP 1", "The formula above, set to zero", line(reason, *named))
    kept = [b for b in own if not isinstance(b, Check | Heading | Paragraph | Equation | Forces | Table | Result)]
    answers = [b for b in kept if isinstance(b, Answer)]
    checks = [b for b in own if isinstance(b, Check) and any(INDEPENDENT in getattr(p, "text", "") for p in b.line)]
    return [*(b for b in kept if b not in answers), head, *told, *answers, *checks]


def without_foretold(blocks: list[Block], part: PartSolution, solution: Solution) -> list[Block]:
    """Without the remark that says beforehand for which value something vanishes that such a case asks for."""
    found = _asked(part, solution)
    if found is None:
        return blocks
    letters = {s.name for s in found.answer.asked[0].free_symbols}
    return [b for b in blocks if not (isinstance(b, Note) and b.kind == "Discussion" and _names(b.line) & letters)]


def _names(words: Line) -> set[str]:
    sides = [side for p in words for side in ((p.left, p.right) if isinstance(p, Stated) else (p,))]
    return {s.name for side in sides if isinstance(side, Math) for s in side.expr.free_symbols}


@record
class _Asked:
    """What is to vanish, as it was found in general, the value that is asked, and what else is asked with that value.
    `general`: the solution in which the first was found.
    """

    zero: Found
    answer: Found
    others: tuple[Found, ...]
    general: PartSolution

    @property
    def letter(self) -> sp.Symbol | None:
        """The letter of what is to vanish; None: it has none of its own."""
        (expr,) = self.zero.asked if len(self.zero.asked) == 1 else (sp.S.Zero,)
        letter = -expr if expr.could_extract_minus_sign() else expr
        return letter if isinstance(letter, sp.Symbol) else None

    @property
    def presses(self) -> bool:
        """Is it a normal force?"""
        what = self.zero.find.found.what if self.zero.find is not None else None
        return isinstance(what, Quantity) and what.word == "N" and not what.parts

    def named(self, expr: sp.Expr) -> sp.Expr:
        """The letter that the general solution has for an expression: a_G for R α; the expression where it has none."""
        stages = (stage for instant in self.general.instants for stage in instant.stages)
        return next((s for stage in stages for s, e in stage.algebra.explicit.items() if e == expr), expr)

    def opened(self, expr: sp.Expr) -> sp.Expr:
        """An expression of the general solution in the letters of the file."""
        formulas: dict[sp.Symbol, sp.Expr] = {}
        for instant in self.general.instants:
            formulas |= instant.instant.scene.ledger.definitions
            for stage in instant.stages:
                formulas |= {**stage.algebra.explicit, **stage.algebra.formulas}
        while inside := expr.free_symbols & formulas.keys():
            expr = expr.xreplace({s: formulas[s] for s in inside})
        return simplified(expr)


def _asked(part: PartSolution, solution: Solution) -> _Asked | None:
    """What is asked, where a case asks for which value of a datum something vanishes; None: it is another case."""
    whole = solution.problem
    case = next((c.problem for c in whole.cases if c.name == part.case), None)
    if case is None or part.motion is not None or not part.found or case.instant is None:
        return None
    answer, *others = part.found
    what = answer.find.found.what if answer.find is not None else None
    new = {u.name for u in case.unknowns} - {u.name for u in whole.unknowns}
    before = {_key(s) for s in whole.instant or ()}
    stated = [s for s in case.instant if _key(s) not in before]
    equal = [s for s in stated if isinstance(s, Relation) and s.operator == "="]
    bounds = [s for s in stated if isinstance(s, Relation) and s.operator != "="]
    if not isinstance(what, Named) or {what.name} != new or len(equal) != 1 or len(equal) + len(bounds) < len(stated):
        return None
    first = next((p for p in solution.parts if not p.case and p.motion is None), None)
    sides = equal[0]
    nought = isinstance(sides.right, Number) and sides.right.value == 0
    if first is None or not nought or not isinstance(sides.left, Quantity) or not _like(case, whole):
        return None
    finds = (f for f in first.found if f.find is not None and _key(f.find.found.what) == _key(sides.left))
    zero = next((f for f in finds if f.kind == "number" and f.expressions), None)
    return None if zero is None else _Asked(zero, answer, tuple(others), first)


def _like(case: Problem, whole: Problem) -> bool:
    """Are bodies, joints and loads the same?"""
    return all(getattr(case, f.name) == getattr(whole, f.name) for f in fields(whole) if f.name not in OWN)


def _key(tree: Any) -> str:
    """What a tree says, wherever it stands in the file."""
    return re.sub(r"mark=Mark\([^)]*\)", "", repr(tree))


def _equations(found: _Asked, phrases: Phrases, above: list[Block]) -> list[Block]:
    """The formula set to zero, what that leaves of it, the value, and what else is asked with it; empty where the value
    does not fulfil it, or something asked has no formula.
    """
    (x,) = found.answer.asked or (None,)
    if not found.zero.expressions or not found.answer.expressions or not isinstance(x, sp.Symbol):
        return []
    formula, value = _general(found, x), found.answer.expressions[0]
    own = next((s for s in formula.free_symbols if s.name == x.name), None)
    if own is None or longer(formula, LONGEST) or not identically_zero(formula.xreplace({own: value})):
        return []
    open_, shown = formula.xreplace({own: x}), phrases.shown(x)
    if not is_clean(phrases.ledger, open_):
        return []
    others = [_other(found, one, own, phrases) for one in found.others]
    if any(o is None for o in others):
        return []
    sides: tuple[Any, ...] = (phrases.math(x), phrases.math(value), *phrases.substituted(value, shown))
    if not phrases.symbolic:
        sides = (*sides, shown)
    left = _left(open_, x)
    found_again = left is not None and left[0] == x and left[1] == value
    return [
        _set_to_zero(found.letter, phrases.math(open_), above),
        *([Equation((phrases.math(left[0]), phrases.math(left[1])))] if left is not None and not found_again else []),
        Equation(sides),
        *(o for o in others if o is not None),
    ]


def _general(found: _Asked, x: sp.Symbol) -> sp.Expr:
    """The formula of what is to vanish with the datum open, also where the general solution has a formula for it."""
    assert found.zero.expressions
    (closed,) = found.zero.expressions[:1]
    if found.letter is not None and all(s.name != x.name for s in closed.free_symbols):
        return found.opened(found.letter)
    # What counts against its letter, as an angular acceleration where the page counts clockwise, has the other sign.
    against = found.letter is not None and found.zero.asked[0] != found.letter
    return simplified(-closed if against else closed)


def _set_to_zero(letter: sp.Symbol | None, formula: Math, above: list[Block]) -> Equation:
    """(3):  F_C = m a_G - P = P (R (R + r)/(R² + k_G²) - 1) = 0, from the line above that found the letter."""
    nought = Math(sp.S.Zero)
    if letter is None:
        return Equation((formula, nought))
    first = next((b for b in above if isinstance(b, Equation) and b.sides[0] == Math(letter) and b.lead), None)
    if first is None:
        return Equation((Math(letter), formula, nought))
    told = () if formula in first.sides or not isinstance(first.sides[1], Math) else (first.sides[1],)
    return Equation((Math(letter), *told, formula, nought), None, first.lead)


def _other(found: _Asked, other: Found, own: sp.Symbol, phrases: Phrases) -> Equation | None:
    """a_best = a_G = 5 F h/(7 m R) = F/m: what else is asked, by the general solution; None: that has no formula."""
    if len(other.asked) != 1 or len(other.expressions or ()) != 1 or other.kind != "number":
        return None
    (asked,), (closed,) = other.asked, other.expressions or ()
    general = found.opened(asked)
    value = found.answer.expressions[0] if found.answer.expressions else own
    if own not in general.free_symbols or longer(general, LONGEST):
        return None
    if not identically_zero(general.xreplace({own: value}) - closed):
        return None
    sides: list[Any] = [Name(other.name), phrases.math(found.named(asked)), phrases.math(general)]
    if other.values is None:
        return Equation((*sides, phrases.math(closed)))
    shown = phrases.in_units(other.values[0], other.unit, other.energy)
    return Equation((*sides, *phrases.substituted(general, shown[0]), *shown))


def _left(formula: sp.Expr, x: sp.Symbol) -> tuple[sp.Expr, sp.Expr] | None:
    """What is left of a formula that is zero, with the letter on the left; None: nothing that would help."""
    numerator = factored(expanded(sp.fraction(together(formula))[0]))
    (factor, *more) = [f for f in sp.Mul.make_args(numerator) if x in f.free_symbols] or (sp.S.Zero,)
    terms = sp.Add.make_args(expanded(factor))
    own = sp.Add(*(t for t in terms if x in t.free_symbols))
    right = sp.Add(*(-t for t in terms if x not in t.free_symbols))
    if own.is_Add and own.is_polynomial(x):
        # (P - m g sin β) k_G² for two terms with one power of the letter.
        power = x ** sp.degree(own, x)
        own = power * simplified(own / power)
    if more or own.is_Add or own == 0 or (own.is_Mul and sum(x in f.free_symbols for f in own.args) > 1):
        return None
    if right.could_extract_minus_sign():
        own, right = -own, -right
    if own.is_Mul and any(f.is_Add for f in own.args):
        own = sp.Mul(*(f for f in own.args if not f.is_Add and f != -1), *(_signed(own)))
    return (own, right) if own != x else None


def _signed(product: sp.Expr) -> list[sp.Expr]:
    """The sums in a product, with its sign in the first of them."""
    sums = [f for f in product.args if f.is_Add]
    return [-sums[0], *sums[1:]] if -1 in product.args else sums


def stood_above(block: Block, above: Iterable[Block]) -> bool:
    """Is it a note of what was noted before, as a part of another note or by itself?"""
    if not isinstance(block, Note):
        return False
    notes = (b.line for b in above if isinstance(b, Note) and b.kind == block.kind)
    return any(all(piece in told or _said_in(piece, told) for piece in block.line) for told in notes)


def _said_in(piece: Inline, told: Line) -> bool:
    """Does a text begin a text of a note?"""
    return isinstance(piece, Text) and any(isinstance(t, Text) and t.text.startswith(piece.text) for t in told)
