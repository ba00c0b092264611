"""The short key gives every answer as the page does, without the letters of its solution."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import PROBLEMS
from worked import name_of, worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.document.blocks import Answer, Bullet, Document, Heading
from planar_cli.report.page.key import key_document
from planar_cli.report.page.narrate import narrate

STEMS = ("ex-1-02", "ex-4-05", "ball-on-a-rough-floor", "simple-pendulum", "yo-yo", "ball-up-with-drag-in-letters")
FILES = [p for p in PROBLEMS if p.stem in STEMS]


def _shown(block: Answer | Bullet) -> str:
    """An answer as one line of words."""
    rows = Terminal(400).render(Document("", (block,))).split()
    return " ".join(rows[1:])


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_the_answers_of_the_page(path: Path) -> None:
    solution, verdicts = worked(path)
    page = [_shown(b) for b in narrate(solution).blocks if isinstance(b, Answer)]
    key = [_shown(b) for b in key_document(solution, verdicts, 4).blocks if isinstance(b, Bullet)]
    assert len(key) == len(page) == sum(len(part.found) for part in solution.parts)
    for said, own in zip(page, key, strict=True):
        name, _, answer = own.partition(" ")
        own_name = name.rstrip(":")
        # The letter of the solution may stand for the name of the find.
        told = said.removesuffix(f" (asked for as {own_name})")
        assert said.startswith(own_name) or told != said
        assert told.endswith(answer.removeprefix("= "))


def test_cases_have_their_headings() -> None:
    path = next(p for p in FILES if p.stem == "ex-4-05")
    blocks = key_document(*worked(path), 4).blocks
    assert [b.text for b in blocks if isinstance(b, Heading)] == ["no friction"]
    assert not [b for b in blocks if not isinstance(b, Bullet | Heading)]
