"""The answers of a solution as a document: a line for each find, by cases; those in letters also as plain text, for the
key of a homework.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from planar_cli.equation.algebra.common_factors import factor_terms
from planar_cli.homework.checking.verdict import Verdict
from planar_cli.homework.variants.told_formula import ToldFormula
from planar_cli.report.answers.answer_letters import answer_block
from planar_cli.report.answers.plain_answers import with_plain_answers
from planar_cli.report.document.blocks import Block, Bullet, Document, Heading, Name, Note, line
from planar_cli.report.notation.notation import plain
from planar_cli.report.page.narrate import phrases_in
from planar_cli.report.words.motion_phrases import motion_phrases
from planar_cli.solve.solved_problem import PartSolution, Solution

FIGURES = 4
"""Of numbers that stand in a formula."""


def key_document(solution: Solution, verdicts: Sequence[Verdict], figures: int) -> Document:
    """The answers as the page gives them, without the letters of its solution, and what the file states otherwise."""
    blocks: list[Block] = []
    for part in solution.parts:
        answers = _answers(part, figures)
        if part.case and answers:
            blocks.append(Heading("CASE", part.case.replace("_", " ")))
        blocks += answers
    return with_disagreements(Document(solution.problem.title or solution.problem.file, tuple(blocks)), verdicts)


def _answers(part: PartSolution, figures: int) -> list[Bullet]:
    """The answers of one part."""
    phrases = phrases_in(part, figures) if part.motion is None else motion_phrases(part.motion, figures)
    part = with_plain_answers(part)
    # No letter of the solution is told here that an answer could be named by.
    told = (answer_block(f, part, phrases, ()) for f in part.found)
    return [Bullet(line(Name(a.name), ": " if a.relation == ":" else f" {a.relation} ", *a.line)) for a in told]


def formulas_told(solution: Solution, numbers: Mapping[str, sp.Expr]) -> dict[str, ToldFormula]:
    """The answers in letters by the names of their finds, as the page tells them: √(2 g L (sin β - μ cos β)); with
    `numbers` put in for some letters.
    """
    told: dict[str, ToldFormula] = {}
    for part in solution.parts:
        phrases = phrases_in(part, FIGURES) if part.motion is None else motion_phrases(part.motion, FIGURES)
        for found in with_plain_answers(part).found:
            if found.values is None and len(found.expressions or ()) == 1 and not found.word:
                (expr,) = found.expressions or ()
                sides = (expr.lhs, expr.rhs) if isinstance(expr, sp.Eq) else (expr,)
                put_in = [_with_numbers(side, numbers) for side in sides]
                number, letters = _as_product(put_in[-1])
                text = " = ".join(plain(phrases.math(side).expr) for side in put_in)
                told[found.name] = ToldFormula(text, number, letters and plain(phrases.math(letters).expr))
    return told


def _with_numbers(expr: sp.Expr, numbers: Mapping[str, sp.Expr]) -> sp.Expr:
    known = {s: numbers[s.name] for s in expr.free_symbols if s.name in numbers}
    return factor_terms(expr.xreplace(known)) if known else expr


def _as_product(expr: sp.Expr) -> tuple[float, sp.Expr | str]:
    """A number and a product of powers of letters; "" where it has none, or is a sum. 0: the number is none."""
    factor, rest = sp.powsimp(sp.expand_power_base(sp.sympify(expr)), force=True).as_independent(
        *expr.free_symbols, as_Add=False
    )
    number = complex(factor)
    is_product = bool(rest.free_symbols) and not rest.has(sp.Add)
    return 0.0 if number.imag else number.real, rest if is_product else ""


def with_disagreements(document: Document, verdicts: Sequence[Verdict]) -> Document:
    """The document with a note for every answer that the file states otherwise."""
    notes = tuple(Note("Disagrees", line(v.message)) for v in verdicts if not v.agrees)
    return Document(document.title, (*document.blocks, *notes))
