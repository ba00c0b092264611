"""The Markdown of the report as HTML: formulas, lists, tables, and nothing that was not markup before."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest
from conftest import PROBLEMS
from exported import HOSTILE, plain_markdown
from worked import name_of, worked

from planar_cli.formats.markdown import Markdown
from planar_cli.homework.exports._worked import DOLLARS, LATEX, worked_html
from planar_cli.report.narrate import narrate

FILES = [p for p in PROBLEMS if p.stem == "ex-4-05"]


@pytest.mark.parametrize(
    ("markdown", "html"),
    [
        ("# Title", "<h3>Title</h3>"),
        ("## Step 1. $v_A$", r"<h4>Step 1. \(v_A\)</h4>"),
        ("$$\na < b\n$$", r"<p>\[a &lt; b\]</p>"),
        ("- one\n- *two*", "<ul><li>one</li><li><em>two</em></li></ul>"),
        ("**Check:** fine", "<p><strong>Check:</strong> fine</p>"),
        ("**Check:**\n- a", "<p><strong>Check:</strong></p><ul><li>a</li></ul>"),
        ("| a | b |\n| --- | --- |\n| \\| | $x$ |", None),
        ("a \\* b \\<i\\>", "<p>a * b &lt;i&gt;</p>"),
        ("lonely * star", "<p>lonely * star</p>"),
        ("<script>", "<p>&lt;script&gt;</p>"),
    ],
)
def test_markup(markdown: str, html: str | None) -> None:
    table = "<table><tbody><tr><td>a</td><td>b</td></tr><tr><td>|</td><td>\\(x\\)</td></tr></tbody></table>"
    assert worked_html(markdown, LATEX) == (table if html is None else html)


def test_other_delimiters() -> None:
    assert worked_html("$x$\n\n$$\ny\n$$", DOLLARS) == "<p>$x$</p><p>$$y$$</p>"


def test_hostile_words_are_text() -> None:
    html = worked_html(plain_markdown(HOSTILE), LATEX)
    root = ET.fromstring(f"<div>{html}</div>")
    assert "".join(root.itertext()).startswith("<script>alert('x')</script>")
    assert {e.tag for e in root.iter()} == {"div", "p", "span"}
    # No delimiter of a formula is left in one piece of text.
    assert all(d not in (text or "") for e in root.iter() for text in (e.text, e.tail) for d in ("\\(", "\\[", "$x"))


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_pages_of_the_report_are_well_formed(path: Path) -> None:
    solution, _ = worked(path)
    markdown = Markdown().render(narrate(solution))
    root = ET.fromstring(f"<div>{worked_html(markdown, LATEX)}</div>")
    text = "".join(root.itertext())
    assert not re.search(r"\$|\*\*|^#|^- |^\|", text, re.MULTILINE)
    assert text.count("\\[") == markdown.count("\n$$\n") // 2
    assert text.count("\\(") == text.count("\\)") > 3
