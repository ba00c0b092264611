"""The text of a problem, as its reader has it: paragraph by paragraph, with the values of the given names in it."""

from __future__ import annotations

from dataclasses import replace

from planar_cli.problem.nodes.placeholders import put_in
from planar_cli.problem.nodes.show import paragraphs_of
from planar_cli.problem.scene.scene import Problem
from planar_cli.report.document.blocks import Block, Document, Paragraph, line
from planar_cli.report.document.prose import with_pretty_units


def stated_text(problem: Problem) -> list[Block]:
    """The paragraphs; none of a file without a text."""
    values = {s.name: s.written for s in problem.given if s.written}
    return [Paragraph(line(with_pretty_units(p))) for p in paragraphs_of(put_in(problem.text, values))]


def with_task(document: Document, problem: Problem) -> Document:
    """A page that is handed out, with the text of the problem under its title; who has the file open has it there."""
    return replace(document, blocks=(*stated_text(problem), *document.blocks))
