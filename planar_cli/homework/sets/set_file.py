"""A homework set: which problem files it has, what they count, how they are graded, and how many variants there are.

The page `planar explain homework` shows all its keys.
"""

from __future__ import annotations

import os
import re
from collections.abc import Mapping as Dict
from dataclasses import field
from pathlib import Path

from planar_cli.errors import FileProblem, Mark
from planar_cli.homework.sets.rules import Rules
from planar_cli.problem.nodes import reading
from planar_cli.problem.nodes.fields import Fields
from planar_cli.problem.nodes.nodes import Mapping, Node, Scalar, read_file
from planar_cli.problem.nodes.reading import Report
from planar_cli.records import record

KEYS = (
    *("title", "problems", "variants", "students", "tolerance", "sigfig", "figures", "credit", "decimal_comma"),
    "text",
)
ENTRY = ("file", "name", "points", "ask")
CREDITS = ("unit", "no_unit", "sign", "precision", "carried")
NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]{0,63}")
MOST_VARIANTS = 10_000
MOST_PROBLEMS = 200


@record
class SetProblem:
    """One problem of a set. `points`: of each find that is named; `whole`: of the problem, where no find is named;
    `ask`: what finds ask, in the lecturer's words.
    """

    name: str
    path: str
    mark: Mark
    points: Dict[str, float] = field(default_factory=dict)
    whole: float | None = None
    ask: Dict[str, str] = field(default_factory=dict)


@record
class HomeworkSet:
    """A whole set as its file has it."""

    path: str
    title: str
    text: str
    problems: tuple[SetProblem, ...]
    rules: Rules
    variants: int = 0
    seed: int = 1
    students: tuple[str, ...] = ()

    def variant_of(self, student: str) -> int | None:
        """The variant that a student has by the list of the set; None: it does not name the student."""
        if student not in self.students or not self.variants:
            return None
        return self.students.index(student) % self.variants + 1


def read_set(path: str) -> HomeworkSet:
    """A set file. FileProblem: with everything that is wrong with it."""
    _, node, wrong = read_file(path)
    if node is None or wrong:
        raise FileProblem(wrong)
    report = Report()
    found = _read(path, node, report)
    if report.sorted():
        raise FileProblem(report.sorted())
    return found


def _read(path: str, node: Node, report: Report) -> HomeworkSet:
    whole = Fields(node, KEYS, "a homework set", report, {"points": "write `{file: …, points: 4}` at the problem"})
    title = _text(whole, "title") or Path(path).stem
    students = _students(whole)
    variants, seed = _variants(whole, len(students))
    problems = _problems(path, whole)
    return HomeworkSet(path, title, _text(whole, "text"), problems, _rules(whole), variants, seed, students)


def _text(whole: Fields, key: str) -> str:
    node = whole.node(key)
    return "" if node is None else reading.text(node, key, whole.report)


# --- problems --------------------------------------------------------------------------------------------------------


def _problems(path: str, whole: Fields) -> tuple[SetProblem, ...]:
    node = whole.need("problems", "write `problems: [slope.yaml, gears.yaml]`")
    items = [] if node is None else reading.items(node, "problems", whole.report, "problems: [slope.yaml]")
    found = [p for item in items[:MOST_PROBLEMS] if (p := _problem(path, item, whole.report)) is not None]
    if len(items) > MOST_PROBLEMS:
        whole.report.add(items[MOST_PROBLEMS].mark, "PL801", f"a set has at most {MOST_PROBLEMS} problems")
    names: dict[str, SetProblem] = {}
    for one in found:
        if one.name in names:
            hint = "give one of them another: `{file: …, name: …}`"
            whole.report.add(one.mark, "PL801", f"two problems have the name '{one.name}'", hint)
        names[one.name] = one
    return tuple(names.values())


def _problem(path: str, node: Node, report: Report) -> SetProblem | None:
    if isinstance(node, Scalar):
        file, name, points, ask = node, None, None, {}
    else:
        fields = Fields(node, ENTRY, "a problem of a set", report, example="{file: slope.yaml}")
        needed = fields.need("file", "write `{file: slope.yaml, points: 4}`")
        if not isinstance(needed, Scalar):
            return None
        file, name, points = needed, fields.node("name"), fields.node("points")
        ask = _ask(fields.node("ask"), report)
    place = Path(path).parent / file.text
    if not os.path.lexists(place):
        what = f"the problem file {file.text} of the set is not there"
        report.add(file.mark, "PL101", what, "write its path as seen from the set file")
    called = name.text if isinstance(name, Scalar) else re.sub(r"[^A-Za-z0-9_-]", "-", place.stem)
    if not NAME.fullmatch(called):
        report.add(node.mark, "PL801", f"'{called}' is no name of a problem", "letters, digits, _ and -, at most 64")
        return None
    own, each = _points(points, report)
    return SetProblem(called, str(place), file.mark, own, each, ask)


def _ask(node: Node | None, report: Report) -> dict[str, str]:
    """What finds ask, in words."""
    example = 'ask: {s: "the compression of the spring"}'
    words = [] if node is None else reading.pairs(node, "ask", report, example)
    return {key.text: reading.text(value, f"what {key.text} asks", report) for key, value in words}


def _points(node: Node | None, report: Report) -> tuple[dict[str, float], float | None]:
    if node is None:
        return {}, None
    if isinstance(node, Mapping):
        return {
            key.text: _number(value, f"the points of {key.text}", report, 0, 1e6) for key, value in node.pairs
        }, None
    return {}, _number(node, "points", report, 0, 1e6)


# --- rules -----------------------------------------------------------------------------------------------------------


def _rules(whole: Fields) -> Rules:
    credit_node = whole.node("credit")
    credit: dict[str, float] = {}
    if credit_node is not None:
        fields = Fields(credit_node, CREDITS, "credit", whole.report, example="{unit: 0.5, sign: 0}")
        for key in CREDITS:
            if (node := fields.node(key)) is not None:
                credit[key] = _number(node, f"the credit for {key}", whole.report, 0, 1)
    tolerance, sigfig, figures = (whole.node(k) for k in ("tolerance", "sigfig", "figures"))
    if tolerance is not None and sigfig is not None:
        whole.report.add(sigfig.mark, "PL801", "`tolerance` and `sigfig` exclude each other", "leave one of them out")
    asked = 3 if figures is None else int(_number(figures, "figures", whole.report, 1, 12))
    if sigfig is not None:
        asked = int(_number(sigfig, "sigfig", whole.report, 1, 12))
    comma = whole.node("decimal_comma")
    if comma is not None and not (isinstance(comma, Scalar) and comma.text in ("true", "false")):
        whole.report.add(comma.mark, "PL801", "decimal_comma is `true` or `false`")
    return Rules(
        None if tolerance is None else _number(tolerance, "the tolerance", whole.report, 1e-9, 0.5),
        "relative" if sigfig is None else "sigfig",
        asked,
        credit.get("unit", 0.0),
        credit.get("no_unit"),
        credit.get("sign", 0.0),
        credit.get("precision", 1.0),
        credit.get("carried", 1.0),
        isinstance(comma, Scalar) and comma.text == "true",
    )


def _variants(whole: Fields, students: int) -> tuple[int, int]:
    """Their number, where none is written that of the students, and the seed."""
    node = whole.node("variants")
    if node is None:
        return 0, 1
    fields = Fields(node, ("number", "seed"), "variants", whole.report, example="{number: 30, seed: 7}")
    given = fields.node("number") if students else fields.need("number", "write `{number: 30, seed: 7}`")
    count, seed = min(students, MOST_VARIANTS), fields.node("seed")
    if given is not None:
        count = int(_number(given, "the number of variants", whole.report, 1, MOST_VARIANTS))
    return count, 1 if seed is None else int(_number(seed, "the seed", whole.report, 0, 10**9))


def _students(whole: Fields) -> tuple[str, ...]:
    node = whole.node("students")
    items = [] if node is None else reading.items(node, "students", whole.report, "students: [s101, s102]")
    names: dict[str, None] = {}
    for item in items:
        word = reading.text(item, "a student", whole.report)
        if word in names:
            whole.report.add(item.mark, "PL801", f"the student '{word}' stands twice in the list")
        names[word] = None
    return tuple(names)


def _number(node: Node, what: str, report: Report, low: float, high: float) -> float:
    word = reading.text(node, what, report)
    if re.fullmatch(r"[0-9]{1,9}(\.[0-9]{1,9})?([eE]-?[0-9])?", word) and low <= float(word) <= high:
        return float(word)
    if word:
        report.add(node.mark, "PL801", f"'{word}' does not fit {what}", f"write a number from {low:g} to {high:g}")
    return low
