"""Plain text for Canvas, read by text2qti itself."""

from __future__ import annotations

import html
import re
from dataclasses import replace
from functools import cache
from typing import Any

import pytest
from exported import PAPERS, exported, number
from text2qti.config import Config
from text2qti.quiz import GroupStart, Question, Quiz

from planar_cli.homework.exports.text2qti import SMALLEST
from planar_cli.homework.sets.paper import Paper, Task


def read(source: Any = None) -> Any:
    (content,) = exported("text2qti", source).files.values()
    return Quiz(content.decode(), config=Config())


@cache
def quiz() -> Any:
    return read()


def questions(of: Any = None) -> dict[str, Any]:
    found = [q for q in (of or quiz()).questions_and_delims if isinstance(q, Question)]
    return {q.title_raw.rpartition(": ")[2]: q for q in found}


def words(question: Any) -> str:
    """The text of a question, which is HTML escaped once more."""
    return html.unescape(html.unescape(question.question_html_xml))


def one(value: float, unit: str, **others: Any) -> Any:
    task = Task("p", "P", "", (), (replace(number("a", value, unit), **others),))
    (question,) = questions(read((Paper(0, (task,)),))).values()
    return question


def test_one_group_for_each_number_and_word() -> None:
    groups = [g.group for g in quiz().questions_and_delims if isinstance(g, GroupStart)]
    # Two formulas are left out; vector and list are two questions each.
    assert len(groups) == 12
    assert all((g.pick, len(g.questions)) == (1, len(PAPERS)) for g in groups)
    assert groups[0].points_per_question == 2


def test_a_number_and_its_tolerance() -> None:
    question = questions()["a_A, variant 0"]
    assert question.type == "numerical_question"
    assert question.numerical_exact == 3.2
    assert question.numerical_max == pytest.approx(3.2321)
    assert "in m/s²" in question.question_html_xml


@pytest.mark.parametrize("name", [n for n in questions() if n.split(",")[0] not in ("slips", "mode")])
def test_numbers_are_large_enough_for_canvas(name: str) -> None:
    question = questions()[name]
    for bound, written in (
        (question.numerical_min, question.numerical_min_html_xml),
        (question.numerical_max, question.numerical_max_html_xml),
    ):
        assert abs(bound) >= SMALLEST
        # What four decimals take from the interval is little of it.
        reach = (question.numerical_max - question.numerical_min) / 2
        assert abs(float(written) - bound) <= 0.11 * reach


@pytest.mark.parametrize(
    ("value", "unit", "asked", "exact"),
    [
        (0.25, "1", "the a of A.", 0.25),
        (3.0e-2, "m", "in cm.", 3.0),
        (3.0e-4, "m", "in mm.", 0.3),
        (2.0e-3, "kg", "in g.", 2.0),
        (5e-4, "N*m", "Type how many 10^-3 N·m it is", 0.5),
        (3.0e-9, "1", "Type how many 10^-9 it is", 3.0),
        (-4e-4, "m/s^2", "in mm/s².", -0.4),
    ],
)
def test_a_small_answer_is_asked_in_a_smaller_unit(value: float, unit: str, asked: str, exact: float) -> None:
    question = one(value, unit, scale=0.0)
    assert asked in words(question)
    assert question.numerical_exact == pytest.approx(exact)


def test_a_zero() -> None:
    question = one(0.0, "N")
    assert question.numerical_exact == 0
    assert question.numerical_min == -question.numerical_max


@pytest.mark.parametrize("value", [0.0, 1e-60])
def test_a_number_that_canvas_takes_for_zero_is_told(value: float) -> None:
    task = Task("p", "P", "", (), (replace(number("a", value, "N"), scale=0.0),))
    assert exported("text2qti", (Paper(0, (task,)),)).left_out == (
        "p, a: Canvas cannot tell its number from zero (variant 0)",
    )


def test_words() -> None:
    slips, mode = questions()["slips, variant 0"], questions()["mode, variant 0"]
    assert slips.type == "multiple_choice_question"
    assert [(c.choice_raw, c.correct) for c in slips.choices] == [("yes", True), ("no", False)]
    assert mode.type == "short_answer_question"
    assert [c.choice_raw for c in mode.choices] == ["sticks*"]


def test_hostile_words_are_text() -> None:
    content = questions()["mu, variant 0"].question_html_xml
    # The HTML of the question, as it stands escaped in the XML of the quiz.
    assert "&lt;script" not in content
    assert "&lt;img" not in content
    assert re.findall(r"&lt;(\w+)", content) == ["p"]
    assert "]]" not in content


def test_a_text_that_looks_like_syntax_is_one_paragraph() -> None:
    text = "1. first\n\n=   5\n\n*a) yes\n# head\n- item\nEND_GROUP\n```python {.python .run}\n% comment"
    task = Task("p", "= 5", text, ("= 3", "... x"), (number("a", 1.0, "N"),))
    (question,) = questions(read((Paper(0, (task,)),))).values()
    assert re.findall(r"&lt;(\w+)", question.question_html_xml) == ["p"]
    assert "END_GROUP" in words(question)


def test_what_is_lost_is_told() -> None:
    told = "\n".join(exported("text2qti").left_out)
    for what in ("worked solution", "diagnosed mistakes", "whole turn", "formula", "1 of 0.5 points"):
        assert what in told
