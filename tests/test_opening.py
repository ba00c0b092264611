"""The head of a page: what is given as its author wrote it, what is asked, and the principles that the page uses."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import PROBLEMS
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.blocks import Note
from planar_cli.report.narrate import narrate

FILES = {p.stem: p for p in PROBLEMS}


def _notes(stem: str) -> dict[str, str]:
    document = narrate(worked(FILES[stem])[0])
    head = [b for b in document.blocks if isinstance(b, Note)]
    page = Terminal(200).render(document).splitlines()
    return {b.kind: next(row for row in page if row.startswith(b.kind)) for b in head}


def test_numbers_as_they_were_written() -> None:
    """Units of the file, and the value of a formula."""
    notes = _notes("ex-4-10")
    assert "m = 10 kg, l = 0.4 m, k = 800 N/m, l_0 = 0.2828 m" in notes["Given"]
    assert notes["Find"].endswith(" ω")


def test_letters_of_a_problem_in_letters() -> None:
    assert _notes("ex-4-04")["Given"].split()[1:] == ["m,", "L"]


@pytest.mark.parametrize(
    ("stem", "words"),
    [
        ("ex-4-10", "Work and kinetic energy"),
        ("ex-4-05", "Newton's second law"),
        ("ex-2-09", "Coriolis acceleration"),
        ("ex-4-13", "across the blow"),
        ("four-bar", "Kinematics"),
    ],
)
def test_the_principle_that_is_used(stem: str, words: str) -> None:
    assert words in _notes(stem)["Principle"]


def test_one_answer_alone_has_no_head() -> None:
    """What is printed for `--why` begins with the chain to the answer."""
    document = narrate(worked(FILES["ex-2-09"])[0], why="a_cor")
    assert not [b for b in document.blocks if isinstance(b, Note) and b.kind in ("Given", "Find", "Principle")]
    assert isinstance(FILES["ex-2-09"], Path)
