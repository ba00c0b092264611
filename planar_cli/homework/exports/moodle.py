"""Moodle: questions of the question bank, as Moodle XML."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterator, Sequence
from typing import ClassVar, final

from planar_cli.homework.exports._asked import (
    Asked,
    Interval,
    LeftOut,
    Number,
    alternatives,
    finds,
    is_numeric,
    name_of,
    numbers,
    problems,
    question_of,
    shown_unit,
    text_of,
    title_of,
)
from planar_cli.homework.exports._figure import SUFFIX, Figure, figure_of
from planar_cli.homework.exports._spellings import spellings
from planar_cli.homework.exports._text import bullets, html, number, one_line, paragraphs, slug, xml
from planar_cli.homework.exports._xml import DECLARATION, element
from planar_cli.homework.exports.base import Exported, PaperExport
from planar_cli.homework.sets.paper import Paper, Task

PENALTY, UNIT_PENALTY = "0.3333333", "0.1"
RIGHT, WRONG = "100", "0"
LONGEST_NAME = 255
FILES, FIGURE = "@@PLUGINFILE@@/", f"figure{SUFFIX}"
"""Where a text calls the files that come with it."""
# What Moodle may read as an end, an entity or a tag inside a cloze question, which knows no sure escapes.
_WIDE = {ord(c): chr(ord(c) + 0xFEE0) for c in '<>&{}~#%\\"$'}


@final
class Moodle(PaperExport):
    """Questions for the question bank of Moodle, as one file of Moodle XML.

    The file
        One category for each problem, below one of the homework; in it one question for each find and variant.
        A number becomes a numerical question: the right answer first, then the diagnosed mistakes as answers without
        marks that show their feedback. The tolerance is that of `planar check`, written as Moodle needs it: absolute;
        that of a mistake is the same, as Moodle does not count figures, by which `planar check` knows mistakes closer.
        The units block has the unit in its usual spellings; a missing or unknown unit costs a tenth of the marks.
        A direction is right after a whole turn too. A vector or list becomes a cloze question with one box for each
        number. Yes or no becomes a choice; another word a short answer. The worked solution is the
        general feedback. The figure of the sheet, the scene as it is given, stands below the text; each question
        carries its own as SVG. Tags tell variant and seed.

    To import it
        Question bank, Import, "Moodle XML format". In a quiz add a random question from each category, or by their
        tag the questions of one variant. Formulas are shown by Moodle's MathJax filter. The general feedback of a
        question is the worked solution of its whole problem: under "Review options" show it after the quiz is closed.

    What is lost
        Formulas as answers: Moodle itself has no question type for them. The boxes of a cloze question take no unit
        and share the marks evenly. The components of a vector are graded one by one, each with the tolerance of the
        whole vector. Errors carried forward, and sign and precision as verdicts of their own.
    """

    kind: ClassVar[str] = "moodle"

    def export(self, papers: Sequence[Paper], title: str, seed: int) -> Exported:
        left_out = LeftOut()
        parts = [
            part
            for variants in problems(papers).values()
            for part in (_category(title, variants[0][1]), *_questions(variants, seed, left_out))
        ]
        whole = "\n".join([f"{DECLARATION}<quiz>", *parts, "</quiz>", ""])
        return Exported({f"{slug(title)}.xml": whole.encode()}, left_out.sentences())


def _category(homework: str, task: Task) -> str:
    """A slash inside a name is written twice."""
    names = [one_line(name)[:LONGEST_NAME] for name in (homework, f"{task.problem}: {title_of(task)}")]
    path = "/".join(["$course$", "top", *(n.strip("/ ").replace("/", "//") or "Homework" for n in names)])
    return element("question", element("category", _text(path)), type="category")


def _questions(variants: Sequence[tuple[int, Task]], seed: int, left_out: LeftOut) -> Iterator[str]:
    for of_one in finds(variants).values():
        for asked in of_one:
            expected = asked.expected
            if is_numeric(expected):
                found = numbers(asked, left_out)
                if len(found) == 1:
                    yield _numerical(asked, found[0], seed)
                elif found:
                    yield _cloze(asked, found, seed, left_out)
            elif expected.kind == "word":
                yield _word(asked, seed)
            else:
                left_out.tell(f"{asked.place}: Moodle has no question type for a formula", asked.variant)


def _numerical(asked: Asked, found: Number, seed: int) -> str:
    units = [
        element("unit", element("multiplier", number(factor)), element("unit_name", xml(name)))
        for name, factor in spellings(asked.expected.unit)
    ]
    return element(
        "question",
        *_head(asked, f"<p>{html(question_of(asked.expected))}</p>", seed),
        *(_interval(i, RIGHT) for i in (found.right, *found.turned)),
        *(_interval(i, WRONG) for i in found.mistakes),
        *([element("units", *units)] if units else []),
        element("unitgradingtype", "1" if units else "0"),
        element("unitpenalty", UNIT_PENALTY),
        # A box for number and unit together; none for the unit of a pure number.
        element("showunits", "0" if units else "3"),
        element("unitsleft", "0"),
        _tags(asked, seed),
        type="numerical",
    )


def _interval(interval: Interval, fraction: str) -> str:
    return element(
        "answer",
        _text(number(interval.value)),
        element("feedback", _text(html(interval.feedback)), format="html"),
        element("tolerance", number(interval.tolerance)),
        fraction=fraction,
        format="moodle_auto_format",
    )


def _cloze(asked: Asked, found: Sequence[Number], seed: int, left_out: LeftOut) -> str:
    """One box for each number; their marks are whole numbers."""
    points = asked.expected.points
    weight = max(1, round(points / len(found)))
    if weight * len(found) != points:
        why = f"gives {weight * len(found)} marks, not {points:g}, as each of its boxes has whole marks"
        left_out.tell(f"{asked.place}: the cloze question {why}; a quiz can give it others", asked.variant)
    unit = shown_unit(asked.expected)
    boxes = "".join(f"<p>{html(n.label)}: {_box(n, weight)}{f' {html(unit)}' if unit else ''}</p>" for n in found)
    question = f"<p>{html(question_of(asked.expected))} Type numbers without units.</p>{boxes}"
    return element("question", *_head(asked, question, seed), _tags(asked, seed), type="cloze")


def _box(found: Number, weight: int) -> str:
    right = [f"%{RIGHT}%{_around(i)}" for i in (found.right, *found.turned)]
    wrong = [f"%{WRONG}%{_around(i)}#{one_line(i.feedback).translate(_WIDE)}" for i in found.mistakes]
    return f"{{{weight}:NUMERICAL:{'~'.join([*right, *wrong])}}}"


def _around(interval: Interval) -> str:
    return f"{number(interval.value)}:{number(interval.tolerance)}"


def _word(asked: Asked, seed: int) -> str:
    expected = asked.expected
    head = _head(asked, f"<p>{html(question_of(expected))}</p>", seed)
    word = one_line(expected.text)
    choices = alternatives(word)
    if choices:
        answers = [_said(html(c), RIGHT if c == word.lower() else WRONG, "html") for c in choices]
        shape = (element("single", "true"), element("shuffleanswers", "false"), element("answernumbering", "none"))
        return element("question", *head, *shape, *answers, _tags(asked, seed), type="multichoice")
    # A star stands for anything.
    answer = _said(word.replace("*", "\\*"), RIGHT, "moodle_auto_format")
    return element("question", *head, element("usecase", "0"), answer, _tags(asked, seed), type="shortanswer")


def _said(answer: str, fraction: str, form: str) -> str:
    feedback = element("feedback", _text(""), format="html")
    return element("answer", _text(answer), feedback, fraction=fraction, format=form)


def _head(asked: Asked, question: str, seed: int) -> Iterator[str]:
    """What all types have, in the order of Moodle's own files. `question`: HTML."""
    task, expected = asked.task, asked.expected
    # By its place, as names that differ only in case are one to some databases.
    place = task.expected.index(expected) + 1
    figure = figure_of(task)
    shown, file = (figure.shown(f"{FILES}{FIGURE}"), _file(figure)) if figure is not None else ("", "")
    body = paragraphs(text_of(task)) + shown + bullets(task.given) + question
    yield element("name", _text(name_of(task, expected.find, asked.variant, LONGEST_NAME)))
    yield element("questiontext", _text(body), file, format="html")
    yield element("generalfeedback", _text(task.worked.get("mathjax", "")), format="html")
    yield element("defaultgrade", number(expected.points))
    yield element("penalty", PENALTY)
    yield element("hidden", "0")
    yield element("idnumber", f"{slug(task.problem)}.{place}.{seed}.{asked.variant}")


def _file(figure: Figure) -> str:
    """A file of a question's text, which Moodle keeps with it."""
    data = b64encode(figure.data).decode()
    return element("file", data, name=FIGURE, path="/", encoding="base64")


def _tags(asked: Asked, seed: int) -> str:
    tags = (f"variant {asked.variant}", f"seed {seed}")
    return element("tags", *(element("tag", _text(tag)) for tag in tags))


def _text(content: str) -> str:
    return element("text", xml(content))
