"""The text of a problem wherever it is printed: paragraphs stay apart, and names in braces have their values."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from planar_cli.cli import run
from planar_cli.commands._handed_out import page
from planar_cli.formats.markdown import Markdown
from planar_cli.homework.exports._text import paragraphs
from planar_cli.homework.sets.paper import Expected, Paper, Task
from planar_cli.homework.sets.ready import Homework
from planar_cli.homework.sets.sheets import handed
from planar_cli.problem.nodes.show import paragraphs_of
from planar_cli.problem.structure import load_text
from planar_cli.report.document.handed_out import sheet
from planar_cli.report.page.narrate import Voice, narrate
from planar_cli.solve.run import solve_problem

TWO = """\
title: Stone
plane: vertical
text: >-
  A stone of mass {m} falls
  from {h}.

  Find its speed.
given: {m: {from: 2 kg, to: 4 kg, step: 1 kg}, h: 3.5 m}
bodies: {stone: {particle: [0, h], mass: m}}
states: {1: [at rest], 2: [y(stone) = 0]}
find: {v: v(stone).mag @ 2}
"""
PARAGRAPHS = ["A stone of mass 2 kg falls from 3.5 m.", "Find its speed."]


@pytest.mark.parametrize("form", ["markdown", "html"])
def test_paragraphs_stay_apart_on_sheets(form: str, tmp_path: Path) -> None:
    (tmp_path / "stone.yaml").write_text(TWO)
    (tmp_path / "set.yaml").write_text("text: |\n  Hand in.\n\n  By Friday.\nproblems: [stone.yaml]\n")
    assert run(["key", str(tmp_path / "set.yaml"), "-o", str(tmp_path / "out"), "--format", form]) == 0
    (handed_out,) = (tmp_path / "out").glob("sheet*.[mh]*")
    text = handed_out.read_text()
    assert "x0a" not in text
    between = "\n\n" if form == "markdown" else "</p>\n<p>"
    assert between.join(PARAGRAPHS) in text
    assert between.join(("Hand in.", "By Friday.")) in text


def test_a_sheet_does_not_repeat_what_its_text_tells_and_the_key_has_what_varies(tmp_path: Path) -> None:
    (tmp_path / "stone.yaml").write_text(TWO.replace("falls\n  from {h}", "falls"))
    (tmp_path / "set.yaml").write_text("variants: {number: 1, seed: 1}\nproblems: [stone.yaml]\n")
    assert run(["key", str(tmp_path / "set.yaml"), "-o", str(tmp_path / "out"), "--format", "markdown"]) == 0
    (handed_out,) = (tmp_path / "out").glob("sheet*.[mh]*")
    assert "Also given: $h = 3.5$ m" in handed_out.read_text()
    assert "m = " not in handed_out.read_text()
    key = (tmp_path / "out" / "key.md").read_text()
    assert re.search(r"^- stone: \$m = [234]\$ kg$", key, re.MULTILINE)


def test_a_lesson_has_the_text_with_its_values() -> None:
    problem, wrong = load_text(TWO)
    assert not wrong
    assert problem is not None
    page = Markdown().render(narrate(solve_problem(problem), Voice(audience="lesson")))
    assert "\n\n".join(PARAGRAPHS) in page


def test_letters_with_subscripts_are_formulas_but_not_in_what_is_typed() -> None:
    text = "m_1 < k_O, μ_s, v_B/A, m_1/2, omega_AB, crank.v_A, a_ <b> <sub>x</sub>"
    asked = Expected("T_1", "see T_1", "number", (1.0,), "1", "1", 0.01, 1.0)
    homework = Homework("a_1", "", {0: Paper(0, (Task("x", "", text, (), (asked,)),))}, {}, "")
    (one,) = handed(homework, [0])
    made = page(sheet(homework, one), "a_1", "html").decode()

    def set_(letter: str, below: str) -> str:
        return f"<msub><mi>{letter}</mi><mi>{below}</mi></msub>"

    assert set_("k", "O") in made
    assert set_("μ", "s") in made
    assert "omega_AB, crank.v_A, a_ &lt;b&gt; &lt;sub&gt;x&lt;/sub&gt;</p>" in made
    letter = "<math><msub><mi>T</mi><mn>1</mn></msub></math>"
    assert f"{letter}: see {letter}" in made
    assert "x.T_1:" in made


@pytest.mark.parametrize("text", ["a b\nc", "a\nb\n\n\nc", "a\r\n \r\nb", " a\n"])
def test_no_word_of_a_text_is_lost(text: str) -> None:
    told = paragraphs_of(text)
    assert " ".join(told).split() == text.split()
    assert paragraphs(text) == "".join(f"<p>{p}</p>" for p in told)
