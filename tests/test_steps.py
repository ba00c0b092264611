"""The headings of the steps of a page."""

from __future__ import annotations

from conftest import PROBLEMS
from worked import worked

from planar_cli.report.document.blocks import Block, Heading, Paragraph, line
from planar_cli.report.equations.steps import SOLVING, without_ritual
from planar_cli.report.page.narrate import narrate

FILES = {p.stem: p for p in PROBLEMS}


def _step(number: int, text: str, aside: str = "") -> Heading:
    return Heading(f"STEP {number}", text, line(aside) if aside else "")


def _page(*headings: Heading) -> list[Block]:
    """Each with something under it."""
    return [block for h in headings for block in (h, Paragraph(line("told")))]


def test_a_single_equation_is_solved_where_it_stands() -> None:
    page = _page(_step(1, "Kinetic analysis"), _step(2, SOLVING, "1 equation, 1 unknown: "), _step(3, "Motion"))
    assert [h.label for h in without_ritual(page) if isinstance(h, Heading)] == ["STEP 1", "STEP 2"]


def test_several_equations_have_their_step() -> None:
    page = _page(_step(1, "Kinetic analysis"), _step(2, SOLVING, "2 equations, 2 unknowns: "))
    assert list(without_ritual(page)) == page


def test_steps_of_a_page_count_on() -> None:
    headings = [b for b in narrate(worked(FILES["ex-1-11"])[0]).blocks if isinstance(b, Heading)]
    assert [(h.label, h.text) for h in headings] == [("STEP 1", "Free flight"), ("STEP 2", "Motion over time")]
