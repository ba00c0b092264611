"""Moodle XML, read as Moodle's importer reads it and graded as its question types grade.

The rules are those of question/format/xml/format.php, question/type/numerical and question/type/multianswer.
"""

from __future__ import annotations

import html
import re
import xml.etree.ElementTree as ET
from base64 import b64decode
from dataclasses import dataclass
from functools import cache
from html.parser import HTMLParser

import pytest
from exported import HOSTILE, PAPERS, TITLE, drawn, exported, number

from planar_cli.homework.exports._spellings import spellings
from planar_cli.homework.exports._text import one_line
from planar_cli.homework.sets.paper import Paper, Task

TAGS = {"p", "span", "ul", "li", "h3", "h4", "h5", "h6", "strong", "em", "table", "thead", "th", "tbody", "tr", "td"}
FORMATS = {"html", "moodle_auto_format", "plain_text", "markdown"}
NUMBER = r"-?(?:[0-9]+[.,]?[0-9]*|[.,][0-9]+)(?:[eE][-+]?[0-9]+)?"
BOX = re.compile(r"\{([0-9]*):(?:NUMERICAL|NM):(.+?)(?<!\\)\}")
ALTERNATIVE = re.compile(rf"(=|%(-?[0-9]+)%)?({NUMBER}):({NUMBER})(#(.*?))?(?=~|$)")


@cache
def quiz() -> ET.Element:
    (content,) = exported("moodle").files.values()
    return ET.fromstring(content)


def text(of: ET.Element, path: str) -> str:
    found = of.find(f"{path}/text")
    assert found is not None
    return found.text or ""


def value(of: ET.Element, path: str) -> str:
    found = of.findtext(path)
    assert found is not None
    return found


@dataclass(frozen=True)
class Grade:
    fraction: float
    feedback: str


class Numerical:
    """A numerical question as Moodle grades it."""

    def __init__(self, question: ET.Element) -> None:
        self.answers = [
            (float(text(a, ".")), float(value(a, "tolerance")), float(a.get("fraction", "")) / 100, text(a, "feedback"))
            for a in question.findall("answer")
        ]
        units = question.findall("units/unit")
        self.units = {value(u, "unit_name"): float(value(u, "multiplier")) for u in units}
        self.penalty = float(value(question, "unitpenalty"))
        self.shown = value(question, "showunits")

    def grade(self, response: str) -> Grade:
        response = response.replace(" ", "")
        match = re.match(r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:e[-+]?\d+)?", response)
        assert match is not None
        unit, plain = response[match.end() :], float(match[0])
        known = unit in self.units
        for due, tolerance, fraction, feedback in self.answers:
            if abs((plain / self.units[unit] if known else plain) - due) <= tolerance:
                penalty = 0.0 if known or not self.units else self.penalty
                return Grade(fraction * (1 - penalty), feedback)
        return Grade(0.0, "")


def numerical(find: str, variant: int = 0) -> Numerical:
    return Numerical(question(find, variant))


def question(find: str, variant: int = 0) -> ET.Element:
    found = [
        q for q in quiz().findall("question") if q.findtext("name/text", "").endswith(f": {find}, variant {variant}")
    ]
    assert len(found) == 1
    return found[0]


def test_one_category_for_each_problem_stands_before_its_questions() -> None:
    kinds = [q.get("type") for q in quiz()]
    paths = [text(q, "category") for q in quiz().findall("question[@type='category']")]
    assert kinds[0] == "category"
    assert len(paths) == 2
    for path in paths:
        # A slash that is written twice belongs to a name.
        parts = re.split(r"(?<!/)/(?!/)", path)
        assert parts[:2] == ["$course$", "top"]
        assert len(parts) == 4
        assert all(parts)


def test_one_question_for_each_find_and_variant() -> None:
    kinds = [q.get("type") for q in quiz()]
    assert kinds.count("numerical") == 6 * 3
    assert kinds.count("cloze") == 2 * 3
    assert kinds.count("multichoice") == kinds.count("shortanswer") == 3


def test_every_question_has_what_the_importer_wants() -> None:
    ids = []
    for q in quiz():
        if q.get("type") == "category":
            continue
        assert 0 < len(text(q, "name")) <= 255
        assert text(q, "questiontext")
        assert q.find("generalfeedback/text") is not None
        assert {e.get("format") for e in q.iter() if "format" in e.attrib} <= FORMATS
        assert float(value(q, "defaultgrade")) > 0
        assert value(q, "hidden") == "0"
        assert {a.get("fraction") for a in q.findall("answer")} <= {"0", "100"}
        ids.append(value(q, "idnumber"))
    assert len(set(ids)) == len(ids)
    assert max(map(len, ids)) <= 100


class Tags(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.words = ""

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag == "img":
            assert dict(attrs) == {"src": "@@PLUGINFILE@@/figure.svg", "alt": one_line(HOSTILE)}
            return
        assert tag in TAGS
        assert not attrs

    def handle_data(self, data: str) -> None:
        self.words += data


def test_no_text_becomes_markup() -> None:
    words = ""
    for q in quiz():
        for e in q.iter("text"):
            if e.text and q.get("type") != "category":
                tags = Tags()
                tags.feed("" if e.text.startswith(("A slider", "x")) else e.text)
                words += tags.words
    assert "<script>alert('x')</script>" in words


def test_hostile_words_stay_one_category() -> None:
    path = text(quiz()[0], "category")
    assert path.replace("//", "/").startswith("$course$/top/Homework 3 <script>alert('x')</script> =HYPERLINK")


def test_the_right_answer_comes_first() -> None:
    for q in quiz().findall("question[@type='numerical']"):
        fractions = [a.get("fraction") for a in q.findall("answer")]
        assert fractions == sorted(fractions, key=lambda f: f != "100")
        assert fractions[0] == "100"


@pytest.mark.parametrize("typed", ["3.2 m/s^2", "3.2 m/s²", "3.23m/s^2", "320 cm/s^2", "3200 mm/s²"])
def test_right(typed: str) -> None:
    assert numerical("a_A").grade(typed) == Grade(1.0, "")


def test_a_missing_unit_costs_a_tenth() -> None:
    assert numerical("a_A").grade("3.2") == Grade(0.9, "")


def test_each_variant_has_its_numbers() -> None:
    assert numerical("a_A", 1).grade("3.52 m/s^2").fraction == 1
    assert numerical("a_A", 1).grade("3.2 m/s^2").fraction == 0


def test_a_mistake_shows_its_feedback() -> None:
    grade = numerical("a_A").grade("-2.01 m/s^2")
    assert grade == Grade(0.0, "Friction acts the other way.")
    assert "&lt;every&gt;" in numerical("a_A").grade("5.1 m/s^2").feedback


def test_outside_the_tolerance() -> None:
    assert numerical("a_A").grade("3.24 m/s^2").fraction == 0


def test_a_pure_number_has_no_units() -> None:
    one = numerical("mu")
    assert (one.units, one.shown) == ({}, "3")
    assert one.grade("0.25").fraction == 1


def test_a_zero_has_a_tolerance() -> None:
    assert numerical("R").grade("0.00005 N").fraction == 1


@pytest.mark.parametrize("typed", ["350 deg", "-10 °", "710 deg", "6.1087 rad"])
def test_a_direction_is_right_after_a_turn(typed: str) -> None:
    assert numerical("theta").grade(typed).fraction == 1


def test_the_worked_solution_is_the_general_feedback() -> None:
    feedback = text(question("mu"), "generalfeedback")
    assert r"\(x\)" in feedback
    assert r"\[a_{A} \lt 3.2~\mathrm{m/s^{2}} \tag{1}\]" in feedback


def boxes(find: str) -> list[list[tuple[float, float, float, str]]]:
    """The boxes of a cloze question as Moodle's importer takes them apart: value, tolerance, fraction, feedback."""
    found = []
    for _, alternatives in BOX.findall(re.sub(r"&amp;(.{2,9}?;)", r"&\1", text(question(find), "questiontext"))):
        rows = []
        for match in ALTERNATIVE.finditer(alternatives):
            fraction = 1.0 if match[1] == "=" else float(match[2]) / 100
            rows.append((float(match[3]), float(match[4]), fraction, html.unescape(match[6] or "")))
        found.append(rows)
    return found


def test_a_vector_has_a_box_for_each_component() -> None:
    x, y = boxes("v_B")
    assert [r[:3] for r in x] == [(3.0, pytest.approx(0.03005), 1.0)]
    assert (y[0][0], y[0][2]) == (0.0, 1.0)
    assert y[1][0] == 9.0
    assert y[1][2:] == (0.0, "The Coriolis term is missing.")


def test_a_list_has_a_box_for_each_value_from_the_smallest_on() -> None:
    assert [rows[0][0] for rows in boxes("t")] == [2.0, 4.0]


def test_a_question_carries_the_figure_of_its_sheet() -> None:
    """Below the text, above what is given; in the file of the importer it follows the text."""
    for variant in (0, 1):
        told = question("mu", variant).find("questiontext")
        assert told is not None
        assert [e.tag for e in told] == ["text", "file"]
        assert dict(told[1].attrib) == {"name": "figure.svg", "path": "/", "encoding": "base64"}
        assert b64decode(told[1].text or "", validate=True).decode() == drawn(variant)
        shown = told[0].text or ""
        assert shown.index("A block slides") < shown.index("<img") < shown.index(r"\(x = 2") < shown.index("m = 2 kg")
    assert question("v_B").find("questiontext/file") is None


def test_no_box_of_a_question_begins_in_the_words_of_a_figure() -> None:
    told = text(question("mu"), "questiontext")
    assert "{" not in re.findall(r'alt="[^"]*"', told)[0]


def test_no_feedback_ends_its_box() -> None:
    from planar_cli.homework.sets.paper import Expected, Mistaken

    mistake = Mistaken("m", HOSTILE, (5.0, 5.0))
    expected = Expected("v", "v", "vector", (1.0, 2.0), "m/s", "", 0.01, 1.0, mistakes=(mistake,))
    (content,) = exported("moodle", (Paper(0, (Task("p", "P", HOSTILE, (), (expected,)),)),)).files.values()
    asked = ET.fromstring(content).findtext("question/questiontext/text", "")
    found = BOX.findall(asked)
    assert len(found) == 2
    for _, alternatives in found:
        assert [m[3] for m in ALTERNATIVE.finditer(alternatives)] == [alternatives[5:].split(":")[0], "5"]
        assert "script>" not in alternatives


def test_marks_of_a_cloze_question_are_told() -> None:
    told = [s for s in exported("moodle").left_out if "the cloze question gives 2 marks, not 1" in s]
    assert any("linkage, v_B" in s for s in told)


def test_yes_or_no_is_a_choice() -> None:
    q = question("slips")
    assert q.get("type") == "multichoice"
    assert [(text(a, "."), a.get("fraction")) for a in q.findall("answer")] == [("yes", "100"), ("no", "0")]


def test_another_word_is_a_short_answer_whose_star_is_a_star() -> None:
    q = question("mode")
    assert q.get("type") == "shortanswer"
    assert [text(a, ".") for a in q.findall("answer")] == [r"sticks\*"]


def test_formulas_are_told_as_left_out() -> None:
    (told,) = (s for s in exported("moodle").left_out if "formula" in s)
    assert told == "linkage, T; linkage, U: Moodle has no question type for a formula (variants 0, 1, 2)"


def test_variants_and_seed_are_tags() -> None:
    assert [text(t, ".") for t in question("mu", 2).findall("tags/tag")] == ["variant 2", "seed 7"]


@pytest.mark.parametrize("title", ["", "/", "a/", "$course$"])
def test_a_category_has_its_place_below_the_top(title: str) -> None:
    (content,) = exported("moodle", PAPERS[:1], title).files.values()
    parts = re.split(r"(?<!/)/(?!/)", ET.fromstring(content).findtext("question/category/text", ""))
    assert len(parts) == 4


def test_spellings_of_a_unit() -> None:
    found = dict(spellings("N*m"))
    assert {"N*m", "N·m", "Nm"} <= found.keys()
    assert found["kN*m"] == pytest.approx(1e-3)
    assert next(iter(found)) == "N*m"
    assert dict(spellings("m/s"))["km/h"] == pytest.approx(3.6)
    assert spellings("1") == ()
    assert dict(spellings("m^2"))["cm^2"] == pytest.approx(1e4)
    assert dict(spellings("lbf*ft"))["lb-ft"] == 1


def test_a_long_title_keeps_what_tells_questions_apart() -> None:
    assert text(question("v_B"), "name").endswith("xx: v_B, variant 0")
    assert len(TITLE) > 100


def test_points_are_the_default_grade() -> None:
    expected = number("a", 1.0, "N", points=2.5)
    (content,) = exported("moodle", (Paper(0, (Task("p", "P", "", (), (expected,)),)),)).files.values()
    assert ET.fromstring(content).findtext("question/defaultgrade") == "2.5"
