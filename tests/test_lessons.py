"""A lesson says in words what each step is for, once, and repeats no equation."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import PROBLEMS
from worked import name_of, worked

from planar_cli.report.document.blocks import Block, Equation, Paragraph, Text
from planar_cli.report.page.narrate import Voice, narrate

STEMS = (
    *(
        "ex-1-02",
        "ex-2-09",
        "ex-4-05",
        "ex-4-10",
        "ex-4-13",
        "ladder-sliding",
        "geneva-wheel",
        "yo-yo",
        "jet-on-a-vane",
    ),
    *("simple-pendulum", "pendulum-against-a-wall", "two-trains-on-crossing-lines"),
)
FILES = [p for p in PROBLEMS if p.stem in STEMS]

LESSON = Voice(audience="lesson")


def _equations(blocks: tuple[Block, ...]) -> list[str]:
    return [str(b) for b in blocks if isinstance(b, Equation)]


def _words(path: Path) -> list[str]:
    """What the lesson adds to a page."""
    lines = [b.line for b in narrate(worked(path)[0], LESSON).blocks if isinstance(b, Paragraph)]
    return [p.text for x in lines for p in x if isinstance(p, Text) and p.style == "muted"]


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_words_beside_the_same_equations(path: Path) -> None:
    """Each once, and none repeats an equation."""
    page, lesson = narrate(worked(path)[0]), narrate(worked(path)[0], LESSON)
    assert _equations(page.blocks) == _equations(lesson.blocks)
    told = _words(path)
    assert told
    assert len(set(told)) == len(told)
    assert not [words for words in told if "=" in words]


@pytest.mark.parametrize(("stem", "words"), [
    ("ex-2-09", "D slides along AB, and AB turns."),
    ("ex-4-05", "spool rolls on the ground: at C the velocities of both agree"),
    ("ex-4-05", "Moments about C, through which unknown forces pass"),
    ("ex-4-10", "The work of a spring is that of its stretch squared at both ends."),
    ("ex-4-13", "A blow is so short"),
    ("ladder-sliding", "At A and B the surfaces slip"),
    ("ex-1-02", "A position vector is put together from known ones"),
    ("geneva-wheel", "The trap is to put numbers in before"),
    ("yo-yo", "thread: where the cord leaves yoyo it moves as the rim on which it is wound"),
    ("yo-yo", "forget the kinetic energy of a rotation"),
    ("jet-on-a-vane", "A stream presses with the mass that arrives in a second"),
    ("pendulum-against-a-wall", "take the way along the path for the difference of the heights"),
    ("two-trains-on-crossing-lines", "relative to something that moves is the difference of both"),
])  # fmt: skip
def test_words_of_this_page(stem: str, words: str) -> None:
    path = next(p for p in FILES if p.stem == stem)
    assert any(words in text for text in _words(path))


def test_nothing_of_other_pages() -> None:
    """The Coriolis acceleration where something slides along a turning body; friction where there is some."""
    others = {p.stem: " ".join(_words(p)) for p in FILES}
    assert "to leave it out is the usual mistake" in others["ex-2-09"]
    assert "to leave it out is the usual mistake" not in others["ex-4-05"]
    assert "friction" not in others["ex-4-10"]
    assert "rotation" not in others["simple-pendulum"]
    assert "runs in at one end" not in others["simple-pendulum"]
    assert "runs in at one end" not in others["yo-yo"]
