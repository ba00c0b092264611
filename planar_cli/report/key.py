"""The answers of a solution as a document: a line for each find, by cases; those in letters also as plain text, for the
key of a homework.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from planar_cli.homework.verdict import Verdict
from planar_cli.report.answer_letters import answer_block
from planar_cli.report.blocks import Block, Bullet, Document, Heading, Name, Note, line
from planar_cli.report.motion_phrases import motion_phrases
from planar_cli.report.narrate import phrases_in
from planar_cli.report.notation import plain
from planar_cli.report.plain_answers import with_plain_answers
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


def formulas_told(solution: Solution) -> dict[str, str]:
    """The answers in letters by the names of their finds, as the page tells them: √(2 g L (sin β - μ cos β))."""
    told: dict[str, str] = {}
    for part in solution.parts:
        phrases = phrases_in(part, FIGURES) if part.motion is None else motion_phrases(part.motion, FIGURES)
        for found in with_plain_answers(part).found:
            if found.values is None and len(found.expressions or ()) == 1 and not found.word:
                (expr,) = found.expressions or ()
                sides = (expr.lhs, expr.rhs) if isinstance(expr, sp.Eq) else (expr,)
                told[found.name] = " = ".join(plain(phrases.math(side).expr) for side in sides)
    return told


def with_disagreements(document: Document, verdicts: Sequence[Verdict]) -> Document:
    """The document with a note for every answer that the file states otherwise."""
    notes = tuple(Note("Disagrees", line(v.message)) for v in verdicts if not v.agrees)
    return Document(document.title, (*document.blocks, *notes))
