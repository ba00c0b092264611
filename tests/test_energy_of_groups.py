"""What nothing joins has a balance of energy of its own: a rod swings up by it while the ball that struck it flies."""

from __future__ import annotations

import pytest
from conftest import PROBLEMS
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.narrate import narrate

FILES = {p.stem: p for p in PROBLEMS}


def _page(stem: str) -> str:
    return " ".join(Terminal(200).render(narrate(worked(FILES[stem])[0])).split())


@pytest.mark.parametrize(
    ("stem", "headings"),
    [
        ("ball-hits-a-hanging-rod", ["From 2 to 3, rod: work and kinetic energy; A_x, A_y do no work"]),
        (
            "pendulum-that-rebounds-from-a-block",
            ["From 3 to 4, sphere: work and kinetic energy; S_cord does no work", "From 3 to 5, block: work and"],
        ),
        ("arrow-through-a-board", ["From 2 to 3, board: work and kinetic energy; N_board does no work"]),
    ],
)
def test_each_group_has_its_own(stem: str, headings: list[str]) -> None:
    page = _page(stem)
    for heading in headings:
        assert heading in page
    assert "∫" not in page.partition("Check")[0]


def test_nothing_that_does_work_leaves_it_to_momentum() -> None:
    page = _page("three-carriages")
    assert "A: conservation of momentum" in page
    assert "work and kinetic energy" not in page


def test_what_a_cord_joins_is_one_group() -> None:
    page = _page("cylinder-down-a-slope-and-on-along-a-floor")
    assert "From 1 to 2, work and kinetic energy" in page
