"""The answers of a solution as a document: a line for each find, by cases; for the key of a homework."""

from __future__ import annotations

from collections.abc import Sequence

from planar_cli.homework.verdict import Verdict
from planar_cli.report.blocks import Answer, Block, Document, Heading, Note, line
from planar_cli.report.narrate import phrases_in
from planar_cli.report.words import answer_line
from planar_cli.solve.solved_problem import Solution


def key_document(solution: Solution, verdicts: Sequence[Verdict], figures: int) -> Document:
    """The answers, and what the file states otherwise."""
    blocks: list[Block] = []
    for part in solution.parts:
        if part.case:
            blocks.append(Heading("CASE", part.case.replace("_", " ")))
        phrases = phrases_in(part, figures)
        blocks += [Answer(f.name, answer_line(f, phrases), ":" if f.word else "=") for f in part.found]
    return with_disagreements(Document(solution.problem.title or solution.problem.file, tuple(blocks)), verdicts)


def with_disagreements(document: Document, verdicts: Sequence[Verdict]) -> Document:
    """The document with a note for every answer that the file states otherwise."""
    notes = tuple(Note("Disagrees", line(v.message)) for v in verdicts if not v.agrees)
    return Document(document.title, (*document.blocks, *notes))
