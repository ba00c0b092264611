"""Pages on paper: what announces something stands on one page with it, wherever a page ends."""

from __future__ import annotations

from pathlib import Path

import pytest
from pdf_text import texts_of_pages

from planar_cli.formats._svg import PRINT
from planar_cli.formats.html import Html
from planar_cli.report.document import blocks as doc
from planar_cli.report.document.marks import Figure, Panel, Polyline
from planar_cli.report.document.prose import with_pretty_units
from planar_cli.typeset import pdf

FIGURE = Figure((Panel((Polyline(((0.0, 0.0), (2.0, 1.0)), "body"),)),), "a diagram", note=doc.line("shown below"))
PIECE = (
    doc.Heading("CASE", "announced"),
    doc.Note("Given", doc.line("something given")),
    doc.Note("Assume", doc.line("something assumed")),
    doc.Heading("STEP 1", "Kinetic analysis"),
    doc.Paragraph(doc.line("Just after that")),
    doc.Forces("rod", doc.line("W"), doc.line("I")),
    doc.Drawing(FIGURE),
)
END = (doc.Answer("x", doc.line("1 m found")), doc.Check(doc.line("checked by hand")))


def pages(blocks: tuple[doc.Block, ...], folder: Path) -> list[str]:
    path = folder / "page.pdf"
    path.write_bytes(pdf(Html().render(doc.Document("Title", blocks)), PRINT))
    return texts_of_pages(path)


def together(words: tuple[str, ...], made: list[str]) -> bool:
    return any(all(w in page for w in words) for page in made)


@pytest.mark.parametrize("above", [22, 26, 30, 34])
def test_what_announces_stays_with_what_it_announces(above: int, tmp_path: Path) -> None:
    filling = tuple(doc.Paragraph(doc.line(f"line {k}")) for k in range(above))
    made = pages((*filling, *PIECE, *END), tmp_path)
    words = ("announced", "something given", "something assumed", "Kinetic", "Just after", "free-body", "shown below")
    assert together(words, made)
    assert together(("found", "checked by hand"), made)


@pytest.mark.parametrize("above", [31, 33, 35])
def test_a_list_stays_with_the_words_before_it(above: int, tmp_path: Path) -> None:
    filling = tuple(doc.Paragraph(doc.line(f"line {k}")) for k in range(above))
    given = (doc.Paragraph(doc.line("Given: much")), *(doc.Bullet(doc.line(f"asked {k}")) for k in range(4)))
    assert together(("Given", "asked 0", "asked 3"), pages((*filling, *given), tmp_path))


@pytest.mark.parametrize("above", [30, 31, 32, 33, 34, 35])
def test_an_answer_stays_with_its_check(above: int, tmp_path: Path) -> None:
    made = pages((*(doc.Paragraph(doc.line(f"line {k}")) for k in range(above)), *END), tmp_path)
    assert together(("found", "checked by hand"), made)


def test_a_number_stands_at_the_right_of_a_formula_that_goes_on(tmp_path: Path) -> None:
    long = doc.line(*(piece for k in range(60) for piece in (doc.Name("a"), doc.Text(" + "))), doc.Name("b"))
    made = pages((doc.Equation((doc.Name("x"), long), 7),), tmp_path)
    assert "(7)" in made[0]


@pytest.mark.parametrize(("typed", "printed"), [
    ("It brakes at 3 m/s^2, with 4 N*s/m.", "It brakes at 3 m/s², with 4 N·s/m."),
    ("a force F_0*sin(w*t), 2 x^2, 5 km", "a force F_0*sin(w*t), 2 x^2, 5 km"),
])  # fmt: skip
def test_units_in_sentences(typed: str, printed: str) -> None:
    assert with_pretty_units(typed) == printed
