"""A heading that only says of which state something is stands beside the single line under it."""

from __future__ import annotations

import pytest

from planar_cli.formats.terminal import Terminal
from planar_cli.report.document.blocks import Block, Document, Equation, Heading, Name, Paragraph, line
from planar_cli.report.page.beside_headings import beside_headings

ONE, OTHER = (Equation((line(Name(name)), line("r"))) for name in ("a", "b"))
STEP = Heading("STEP 2", "Solving")


@pytest.mark.parametrize("words", ["Hence:", "Hence, at 2:", "At 2:", "In state at_8:", "Hence, in state at_8:"])
def test_one_line_stands_beside_its_heading(words: str) -> None:
    head = Paragraph(line(words))
    (told, step) = beside_headings([head, ONE, STEP])
    assert isinstance(told, Equation)
    assert (told.lead, told.sides, step) == (head.line, ONE.sides, STEP)


@pytest.mark.parametrize("blocks", [
    [Paragraph(line("At 2:")), ONE, OTHER],
    [Paragraph(line("At 2:")), Equation(ONE.sides, 4)],
    [Paragraph(line("At 2, the acceleration is zero:")), Equation(ONE.sides, lead=line("(1):"))],
    [Paragraph(line("At 2, ", Name("x"), " = 0:")), ONE],
    [Paragraph(line("B moves horizontally:")), ONE],
])  # fmt: skip
def test_others_stay_above(blocks: list[Block]) -> None:
    assert beside_headings(blocks) == blocks


def test_words_stand_apart_from_numbers_of_equations() -> None:
    blocks = [Equation(ONE.sides, 4), Paragraph(line("At 2:")), OTHER]
    rows = Terminal().render(Document("", tuple(beside_headings(blocks)))).splitlines()[-2:]
    assert rows == ["    (4)  a = r", "  At 2:   b = r"]
