"""PrairieLearn questions: the server's program run as the system runs it, and the page as its elements want it."""

from __future__ import annotations

import json
import re
import sys
import types
import uuid
from functools import cache
from html.parser import HTMLParser
from typing import Any

import pytest
import sympy as sp
from exported import PAPERS, drawn, exported

from planar_cli.homework.exports._symbolic import NoFormula, symbolic
from planar_cli.homework.sets.paper import Expected, Paper

# What each element takes, from its own list of attributes.
ATTRIBUTES = {
    "pl-units-input": {"answers-name", "label", "rtol", "atol", "placeholder", "weight"},
    "pl-number-input": {"answers-name", "label", "rtol", "atol", "placeholder", "show-help-text", "suffix", "weight"},
    "pl-string-input": {"answers-name", "label", "ignore-case", "remove-leading-trailing", "weight"},
    "pl-symbolic-input": {"answers-name", "label", "variables", "weight"},
    "pl-multiple-choice": {"answers-name", "weight"},
    "pl-answer": {"correct"},
    "pl-figure": {"file-name", "alt"},
}


@cache
def files(problem: str) -> dict[str, str]:
    found = exported("prairielearn").files
    return {k.rpartition("/")[2]: v.decode() for k, v in found.items() if k.split("/")[1] == problem}


def server(problem: str) -> Any:
    module = types.ModuleType("server")
    exec(compile(files(problem)["server.py"], "server.py", "exec"), module.__dict__)
    return module


def generated(problem: str, seed: Any) -> dict[str, Any]:
    data: dict[str, Any] = {
        "params": {},
        "correct_answers": {},
        "submitted_answers": {},
        "format_errors": {},
        "partial_scores": {},
        "score": 0,
        "feedback": {},
        "variant_seed": seed,
    }
    server(problem).generate(data)
    return data


def graded(problem: str, seed: int, **submitted: Any) -> dict[str, Any]:
    """What `grade` makes of answers that the elements have called wrong."""
    data = generated(problem, seed)
    data["submitted_answers"] = submitted
    data["partial_scores"] = {name: {"score": 0, "weight": 1} for name in submitted}
    server(problem).grade(data)
    return data


@pytest.mark.parametrize("problem", ["slider", "linkage"])
def test_the_files_of_a_question(problem: str) -> None:
    shown = {"figure-1.svg", "figure-2.svg"} if problem == "slider" else set()
    assert set(files(problem)) == {"info.json", "question.html", "server.py"} | shown


@pytest.mark.parametrize("variant", [0, 1, 2])
def test_each_variant_shows_its_figure(variant: int) -> None:
    name = generated("slider", variant)["params"]["figure"]
    assert files("slider")[name] == drawn(variant)
    page = files("slider")["question.html"]
    shown = '<pl-figure file-name="{{params.figure}}" alt="{{params.words}}"></pl-figure>'
    assert (
        f"{{{{{{params.text}}}}}}\n{{{{#params.figure}}}}{shown}{{{{/params.figure}}}}\n{{{{{{params.given}}}}}}"
        in page
    )
    assert "figure" not in files("linkage")["question.html"]


def test_info() -> None:
    info = json.loads(files("slider")["info.json"])
    assert info["type"] == "v3"
    assert uuid.UUID(info["uuid"]).version == 5
    assert info["title"].startswith("A slider <script>")
    assert info["topic"].startswith("Homework 3")
    assert info["uuid"] != json.loads(files("linkage")["info.json"])["uuid"]


def test_the_uuid_depends_on_the_names_alone() -> None:
    again = exported("prairielearn", PAPERS[:1]).files
    infos = [json.loads(v) for k, v in again.items() if k.endswith("slider/info.json")]
    assert infos[0]["uuid"] == json.loads(files("slider")["info.json"])["uuid"]


@pytest.mark.parametrize("seed", [0, 1, 2, 123456789, "5"])
def test_the_seed_picks_a_variant(seed: Any) -> None:
    data = generated("slider", seed)
    assert data["correct_answers"]["mu"] == pytest.approx(0.25 * (1 + int(seed) % 3 / 10))
    json.dumps(data)


def test_answers_have_their_units() -> None:
    answers = generated("slider", 0)["correct_answers"]
    assert answers["a_A"] == "3.2 m/s^2"
    assert answers["theta"] == 350.0
    assert generated("linkage", 0)["correct_answers"]["v_B_y"] == "0 m/s"


class Page(HTMLParser):
    """Elements of the page with their attributes."""

    def __init__(self, content: str) -> None:
        super().__init__()
        self.found: list[tuple[str, dict[str, str]]] = []
        self.open: list[str] = []
        self.feed(content)
        assert not self.open

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.open.append(tag)
        self.found.append((tag, {k: v or "" for k, v in attrs}))

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


@pytest.mark.parametrize("problem", ["slider", "linkage"])
def test_the_page_has_elements_that_exist(problem: str) -> None:
    page = Page(files(problem)["question.html"])
    for tag, attributes in page.found:
        if tag in ("pl-question-panel", "pl-answer-panel", "p"):
            assert not attributes
        else:
            assert attributes.keys() <= ATTRIBUTES[tag]
            assert int(attributes.get("weight", "1")) > 0
    names = [a["answers-name"] for _, a in page.found if "answers-name" in a]
    assert len(set(names)) == len(names)
    data = generated(problem, 0)
    choices = {a["answers-name"] for tag, a in page.found if tag == "pl-multiple-choice"}
    assert set(names) == set(data["correct_answers"]) | choices


@pytest.mark.parametrize("problem", ["slider", "linkage"])
@pytest.mark.parametrize("seed", [0, 1, 2])
def test_every_placeholder_has_a_value(problem: str, seed: int) -> None:
    params = generated(problem, seed)["params"]
    for path in re.findall(r"\{\{\{?params\.([\w.]+)\}?\}\}", files(problem)["question.html"]):
        value: Any = params
        for part in path.split("."):
            value = value[part]
        assert isinstance(value, str)


def test_no_tolerance_tells_how_large_the_answer_is() -> None:
    page = Page(files("slider")["question.html"])
    assert all("placeholder" in a for tag, a in page.found if tag in ("pl-units-input", "pl-number-input"))
    assert all(a["show-help-text"] == "false" for tag, a in page.found if tag == "pl-number-input")


def test_tolerances_are_those_of_the_check() -> None:
    params = generated("slider", 0)["params"]
    assert params["a_A"]["rtol"] == "0.01"
    assert params["a_A"]["atol"] == "0.0001 m/s^2"
    assert params["mu"]["atol"] == "0.0001"
    # A vector is measured by its size.
    assert generated("linkage", 0)["params"]["v_B_y"]["atol"] == "0.03005 m/s"


def test_the_text_is_escaped_and_the_solution_has_its_formulas() -> None:
    params = generated("slider", 0)["params"]
    assert "<script" not in params["text"]
    assert "{{" not in params["text"]
    assert "<script" not in params["worked"]
    assert r"$$a_{A} \lt 3.2~\mathrm{m/s^{2}} \tag{1}$$" in params["worked"]


def test_a_mistake_has_its_feedback() -> None:
    data = graded("slider", 0, theta=170.2)
    assert data["partial_scores"]["theta"]["feedback"] == "This is the other root."
    assert data["partial_scores"]["theta"]["score"] == 0


def test_a_mistake_with_a_unit_is_converted_by_the_system(monkeypatch: pytest.MonkeyPatch) -> None:
    class Quantity:
        def __init__(self, text: str) -> None:
            self.text = text

        def to(self, unit: str) -> Any:
            assert (self.text, unit) == ("-200 centimeter / second ** 2", "m/s^2")
            return types.SimpleNamespace(magnitude=-2.0)

    system = types.ModuleType("prairielearn")
    system.__dict__["get_unit_registry"] = lambda: types.SimpleNamespace(Quantity=Quantity)
    monkeypatch.setitem(sys.modules, "prairielearn", system)
    data = graded("slider", 0, a_A="-200 centimeter / second ** 2")
    assert data["partial_scores"]["a_A"]["feedback"] == "Friction acts the other way."


@pytest.mark.parametrize("typed", [None, "", "x", "3 m/s^2", {"_type": "complex"}, [1]])
def test_what_is_no_number_has_no_feedback(typed: Any) -> None:
    data = graded("slider", 0, a_A=typed, theta=typed)
    assert all("feedback" not in part for part in data["partial_scores"].values())


@pytest.mark.parametrize(("typed", "score"), [(-10.0, 1.0), (710.0, 1.0), (10.0, 0.0)])
def test_a_direction_is_right_after_a_turn(typed: float, score: float) -> None:
    data = graded("slider", 0, theta=typed, mu=9.0)
    assert data["partial_scores"]["theta"]["score"] == score
    assert data["score"] == score / 2


def test_words_and_formulas() -> None:
    data = generated("linkage", 0)
    assert data["params"]["slips"] | {"asks": ""} == {"asks": "", "yes": "true", "no": "false"}
    assert data["correct_answers"]["mode"] == "sticks*"
    m, g, beta = sp.symbols("m g beta")
    assert sp.sympify(data["correct_answers"]["T"], {"beta": beta}) == sp.Rational(1, 2) * m * g * sp.sin(beta)
    assert any("heaviside" in s for s in exported("prairielearn").left_out)


@pytest.mark.parametrize(
    ("formula", "letters", "due"),
    [
        ("0.25*m", ("m",), "(1/4)*m"),
        ("2*m^2/1e3", ("m",), "2*m^2/1000"),
        ("sqrt(2*g*h)*pi", ("g", "h"), "sqrt(2*g*h)*pi"),
        ("m_1 + 2", ("m_1",), "m_1 + 2"),
        ("e*m", ("e", "m"), None),
        ("m + x", ("m",), None),
        ("m.real", ("m",), None),
        ("__import__('os')", ("m",), None),
        ("m; m", ("m",), None),
        ("", ("m",), None),
        ("m", ("m'",), None),
    ],
)
def test_formulas_that_the_system_takes(formula: str, letters: tuple[str, ...], due: str | None) -> None:
    expected = Expected(
        "f", "f", "formula", (), "1", "", 0, 0, formula=formula, letters=tuple((n, "1") for n in letters)
    )
    if due is None:
        with pytest.raises(NoFormula):
            symbolic(expected)
    else:
        assert symbolic(expected) == (due, letters)


def test_a_variant_that_asks_otherwise_is_told() -> None:
    other = PAPERS[1].tasks[0]
    short = type(other)(other.problem, other.title, other.text, other.given, other.expected[:2])
    result = exported("prairielearn", (Paper(0, (PAPERS[0].tasks[0],)), Paper(1, (short,))))
    assert any("asks otherwise than the first variant" in s and "variant 1" in s for s in result.left_out)


def test_names_of_inputs_are_plain_and_differ() -> None:
    finds = ("text", "text!", "α", "2x", "a b", "a-b")
    task = PAPERS[0].tasks[0]
    made = tuple(Expected(f, f, "number", (1.0,), "N", "", 0.01, 1.0) for f in finds)
    result = exported("prairielearn", (Paper(0, (type(task)("p", "P", "", (), made),)),))
    page = next(v for k, v in result.files.items() if k.endswith("question.html")).decode()
    names = re.findall(r'answers-name="([^"]*)"', page)
    assert len(set(names)) == 6
    assert all(re.fullmatch("[A-Za-z][A-Za-z0-9_]*", n) for n in names)
