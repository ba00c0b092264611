"""A worked solution for course systems: formulas in LaTeX, lists, tables, and nothing that was not markup before."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest
from conftest import PROBLEMS
from exported import HOSTILE
from worked import name_of, worked

from planar_cli.formats._course_html import course_html
from planar_cli.report.document import blocks as doc
from planar_cli.report.page.narrate import narrate

FILES = [p for p in PROBLEMS if p.stem == "ex-4-05"]
X = doc.Name("x")


@pytest.mark.parametrize(
    ("block", "html"),
    [
        (doc.Title("Title"), "<h3>Title</h3>"),
        (doc.Heading("STEP 1", "A"), "<h4>Step 1. A</h4>"),
        (doc.Equation((X, doc.Name("y")), relation="<"), r"<p>\[x \lt y\]</p>"),
        (doc.Bullet(doc.line("one ", X)), r"<ul><li>one \(x\)</li></ul>"),
        (doc.Check(doc.line("fine")), "<p><strong>Check</strong> fine</p>"),
        (doc.Answer("x", doc.line("1")), r"<h4>Answer</h4><ul><li>\(x = 1\)</li></ul>"),
        (doc.Paragraph(doc.line("<script> $x$")), "<p>&lt;script&gt; <span>$</span>x<span>$</span></p>"),
    ],
)
def test_markup(block: doc.Block, html: str) -> None:
    assert course_html([block], "mathjax") == html


def test_other_delimiters() -> None:
    blocks = (doc.Paragraph(doc.line(X)), doc.Equation((X,)))
    assert course_html(blocks, "dollars") == "<p>$x$</p><p>$$x$$</p>"


def test_hostile_words_are_text() -> None:
    html = course_html([doc.Paragraph(doc.line(HOSTILE))], "mathjax")
    root = ET.fromstring(f"<div>{html}</div>")
    assert "".join(root.itertext()).startswith("<script>alert('x')</script>")
    assert {e.tag for e in root.iter()} == {"div", "p", "span"}
    # No delimiter of a formula is left in one piece of text, and no place of a template in the page.
    assert all(d not in (text or "") for e in root.iter() for text in (e.text, e.tail) for d in ("\\(", "\\[", "$x"))
    assert "{{" not in html


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_pages_of_the_report_are_well_formed(path: Path) -> None:
    page = narrate(worked(path)[0])
    root = ET.fromstring(f"<div>{course_html(page.blocks, 'mathjax')}</div>")
    text = "".join(root.itertext())
    assert {name for e in root.iter() for name in e.attrib} == set()
    assert not re.search(r"\$|\*\*|^#|^- |^\|", text, re.MULTILINE)
    assert text.count("\\[") == sum(isinstance(b, doc.Equation) for b in page.blocks)
    assert text.count("\\(") == text.count("\\)") > 3
