"""A lesson says in words what each step is for, once, and repeats no equation."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import PROBLEMS
from worked import name_of, worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.blocks import Block, Equation, Paragraph
from planar_cli.report.lessons import LESSONS
from planar_cli.report.narrate import Voice, narrate

FILES = [p for p in PROBLEMS if p.stem in ("ex-2-09", "ex-4-05", "ex-4-10", "ex-4-13", "ladder-sliding")]


def _equations(blocks: tuple[Block, ...]) -> list[str]:
    return [str(b) for b in blocks if isinstance(b, Equation)]


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_words_beside_the_same_equations(path: Path) -> None:
    exam = narrate(worked(path)[0])
    lesson = narrate(worked(path)[0], Voice(audience="lesson"))
    said = [str(b) for b in lesson.blocks if isinstance(b, Paragraph)]
    assert set(_equations(exam.blocks)) <= set(_equations(lesson.blocks))
    told = [x.words for x in LESSONS if any(x.words in text for text in said)]
    assert told
    assert all(sum(words in text for text in said) == 1 for words in told)


def test_the_part_that_is_forgotten_is_named() -> None:
    """Where a point slides on a turning bar the lesson speaks of the Coriolis acceleration; not with a spool."""
    pages = {
        p.stem: Terminal(100).render(narrate(worked(p)[0], Voice(audience="lesson")))
        for p in FILES
        if p.stem in ("ex-2-09", "ex-4-05")
    }
    assert "to leave it out is the usual mistake" in " ".join(pages["ex-2-09"].split())
    assert "to leave it out is the usual mistake" not in " ".join(pages["ex-4-05"].split())
