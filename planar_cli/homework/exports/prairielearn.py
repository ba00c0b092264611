"""PrairieLearn: one question folder for each problem."""

from __future__ import annotations

import json
import math
import re
import uuid
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any, ClassVar, final

from planar_cli.homework.exports._asked import (
    Asked,
    LeftOut,
    Number,
    alternatives,
    is_numeric,
    numbers,
    problems,
    question_of,
    shown_unit,
    text_of,
    title_of,
)
from planar_cli.homework.exports._figure import SUFFIX, figure_of
from planar_cli.homework.exports._symbolic import NoFormula, symbolic
from planar_cli.homework.exports._text import Names, bullets, html, number, one_line, paragraphs, slug
from planar_cli.homework.exports._xml import element, paired
from planar_cli.homework.exports.base import Exported, PaperExport
from planar_cli.homework.sets.paper import Paper, Task
from planar_cli.records import record
from planar_cli.units import PURE, UnitError, parse_unit

SERVER = Path(__file__).with_name("_question_server.py")
OURS = uuid.uuid5(uuid.NAMESPACE_DNS, "planar-cli")
CLIENT = "clientFilesQuestion"
"""The folder of files that a question shows."""
FINEST_WEIGHT = 100
"""Points are told to hundredths: weights are whole numbers."""


@final
class PrairieLearn(PaperExport):
    """Questions of a PrairieLearn course, one folder for each problem.

    The files
        `info.json` with a uuid that depends on the titles alone, so that a new export replaces the old question;
        `question.html`; `server.py` with a table of the variants, from which it picks by the variant's seed. A number
        with a unit is a pl-units-input, which takes any unit of the dimension; a pure number or an angle a
        pl-number-input. A vector or list has one input for each number. Yes or no becomes a
        pl-multiple-choice, another word a pl-string-input, a formula a pl-symbolic-input. Tolerances are those of
        `planar check`; diagnosed mistakes show their feedback. The worked solution is in the answer panel. The figure
        of the sheet, the scene as it is given, is a file of `clientFilesQuestion/` for each variant that has its own.

    To import it
        Copy the folder into `questions/` of the course and name its questions in an assessment; then sync.

    What is lost
        A formula with other functions than PrairieLearn knows, or a letter that it takes for a constant. In formulas
        students must write fractions, not decimals. The components of a vector are graded one by one, each with the
        tolerance of the whole vector. Errors carried forward, and sign and precision as verdicts of their own.
    """

    kind: ClassVar[str] = "prairielearn"

    def export(self, papers: Sequence[Paper], title: str, seed: int) -> Exported:
        left_out, names, files = LeftOut(), Names(), dict[str, bytes]()
        for problem, variants in problems(papers).items():
            rows = [_Row(task, variant, left_out) for variant, task in variants]
            like_first = [row for row in rows if row.elements == rows[0].elements]
            for row in rows:
                if row.elements != rows[0].elements:
                    left_out.tell(f"{problem}: it asks otherwise than the first variant and is left out", row.variant)
            if not rows[0].elements:
                continue
            folder = f"{slug(title)}/{names.of(problem)}"
            files[f"{folder}/info.json"] = _info(title, variants[0][1])
            figures = _with_figures(like_first)
            files |= {f"{folder}/{CLIENT}/{name}": drawn for name, drawn in figures.items()}
            files[f"{folder}/question.html"] = _page(rows[0].elements, bool(figures))
            files[f"{folder}/server.py"] = _server(like_first, seed)
        return Exported(files, left_out.sentences())


@record
class _Element:
    """An input of the page; with its question before it, where `asks`."""

    name: str
    tag: str
    attributes: tuple[tuple[str, str], ...]
    content: str
    weight: Fraction
    asks: bool

    def written(self, weight: int) -> str:
        shape = {"answers-name": self.name, **dict(self.attributes), "weight": str(weight)}
        return paired(self.tag, self.content, **shape)


class _Row:
    """One variant: elements of the page, which are the same in all, and a row of the table."""

    def __init__(self, task: Task, variant: int, left_out: LeftOut) -> None:
        self.variant = variant
        self.elements: list[_Element] = []
        text = paragraphs(text_of(task))
        given = bullets(task.given)
        self.figure = figure_of(task)
        letters = self.figure.dollars if self.figure is not None else ""
        self.params: dict[str, Any] = {"text": text, "given": letters + given, "worked": task.worked.get("dollars", "")}
        self.answers: dict[str, Any] = {}
        self.inputs: dict[str, Any] = {}
        self._names = _InputNames()
        for expected in task.expected:
            asked = Asked(task, expected, variant)
            if is_numeric(expected):
                self._numbers(asked, numbers(asked, left_out))
            elif expected.kind == "word":
                self._word(asked)
            else:
                self._formula(asked, left_out)

    @property
    def told(self) -> dict[str, Any]:
        return {"params": self.params, "answers": self.answers, "inputs": self.inputs}

    def _numbers(self, asked: Asked, found: Sequence[Number]) -> None:
        unit = _unit_of_pint(asked.expected.unit)
        for i, one in enumerate(found):
            name = self._names.of(one.name)
            right, relative = one.right, asked.expected.tolerance
            # PrairieLearn adds a relative tolerance; what is above it is told as absolute.
            absolute = number(max(0.0, right.tolerance - relative * abs(right.value)))
            self.answers[name] = f"{number(right.value)} {unit}" if unit else right.value
            self.inputs[name] = {
                "unit": unit,
                "turned": [(t.value, t.tolerance) for t in one.turned],
                "mistakes": [(m.value, m.tolerance, html(m.feedback)) for m in one.mistakes],
            }
            told = {"rtol": number(relative), "atol": f"{absolute} {unit}" if unit else absolute}
            shape = {"rtol": f"{{{{params.{name}.rtol}}}}", "atol": f"{{{{params.{name}.atol}}}}"}
            if unit:
                shape |= {"placeholder": "number and unit"}
            else:
                # Its help would tell the tolerances, and by them how large the answer is.
                shape |= {"placeholder": "number", "show-help-text": "false"}
                shape |= {"suffix": s} if (s := shown_unit(asked.expected)) else {}
            kind = "pl-units-input" if unit else "pl-number-input"
            label = ", ".join(filter(None, (asked.expected.find, one.label)))
            self._add(asked, name, kind, {"label": html(label), **shape}, told, len(found), first=i == 0)

    def _word(self, asked: Asked) -> None:
        name, word = self._names.of(asked.expected.find), one_line(asked.expected.text)
        choices = alternatives(word)
        if choices:
            told = {c: "true" if c == word.lower() else "false" for c in choices}
            options = [element("pl-answer", c, correct=f"{{{{params.{name}.{c}}}}}") for c in choices]
            self._add(asked, name, "pl-multiple-choice", {}, told, 1, True, *options)
        else:
            self.answers[name] = word
            shape = {"label": html(asked.expected.find), "ignore-case": "true", "remove-leading-trailing": "true"}
            self._add(asked, name, "pl-string-input", shape, {}, 1, True)

    def _formula(self, asked: Asked, left_out: LeftOut) -> None:
        try:
            formula, letters = symbolic(asked.expected)
        except NoFormula as why:
            left_out.tell(f"{asked.place}: {why}", asked.variant)
            return
        name = self._names.of(asked.expected.find)
        self.answers[name] = formula
        shape = {"label": html(asked.expected.find), "variables": ", ".join(letters)}
        self._add(asked, name, "pl-symbolic-input", shape, {}, 1, True)

    def _add(
        self,
        asked: Asked,
        name: str,
        kind: str,
        shape: dict[str, str],
        told: dict[str, str],
        count: int,
        first: bool,
        *content: str,
    ) -> None:
        weight = Fraction(asked.expected.points).limit_denominator(FINEST_WEIGHT) / count
        self.params[name] = {"asks": html(question_of(asked.expected)), **told}
        self.elements.append(_Element(name, kind, tuple(shape.items()), "".join(content), weight, first))


class _InputNames:
    """Names of inputs that PrairieLearn and its templates take."""

    def __init__(self) -> None:
        self._taken = {"text", "figure", "words", "given", "worked", "index"}

    def of(self, name: str) -> str:
        plain = re.sub(r"[^A-Za-z0-9_]", "_", name)[:64]
        plain = plain if re.match("[A-Za-z]", plain) else f"find{plain}"
        found, count = plain, 1
        while found in self._taken:
            count += 1
            found = f"{plain}_{count}"
        self._taken.add(found)
        return found


def _unit_of_pint(unit: str) -> str:
    """A unit as PrairieLearn's pint reads it; "" of what pint takes for a pure number, as it does with angles."""
    try:
        if parse_unit(unit).dimension == PURE:
            return ""
    except UnitError:
        return ""
    return re.sub(r"\brev\b", "turn", unit)


def _info(homework: str, task: Task) -> bytes:
    name = uuid.uuid5(OURS, json.dumps([homework, task.problem]))
    told = {
        "uuid": str(name),
        "type": "v3",
        "title": title_of(task),
        "topic": one_line(homework) or "Homework",
        "tags": ["planar"],
    }
    return (json.dumps(told, ensure_ascii=False, indent=2) + "\n").encode()


def _with_figures(rows: Sequence[_Row]) -> dict[str, bytes]:
    """The figures of all variants as files, of which each row is told its own; alike ones are one file."""
    names: dict[bytes, str] = {}
    for row in rows:
        figure = row.figure
        if figure is not None:
            names.setdefault(figure.data, f"figure-{len(names) + 1}{SUFFIX}")
        row.params["figure"] = names[figure.data] if figure is not None else ""
        row.params["words"] = figure.words if figure is not None else ""
    return {name: drawn for drawn, name in names.items()}


def _page(elements: Sequence[_Element], drawn: bool) -> bytes:
    """`drawn`: variants have figures."""
    whole = math.lcm(*(e.weight.denominator for e in elements))
    figure = paired("pl-figure", **{"file-name": "{{params.figure}}", "alt": "{{params.words}}"})
    # Between these marks the template stands only where the variant has one.
    shown = [f"{{{{#params.figure}}}}{figure}{{{{/params.figure}}}}"] if drawn else []
    lines = ["<pl-question-panel>", "{{{params.text}}}", *shown, "{{{params.given}}}", "</pl-question-panel>"]
    for e in elements:
        asks = f"<pl-question-panel><p>{{{{{{params.{e.name}.asks}}}}}}</p></pl-question-panel>"
        lines += [asks] if e.asks else []
        lines.append(f"<p>{e.written(max(1, int(e.weight * whole)))}</p>")
    lines += ["<pl-answer-panel>", "{{{params.worked}}}", "</pl-answer-panel>", ""]
    return "\n".join(lines).encode()


def _server(rows: Sequence[_Row], seed: int) -> bytes:
    """The program with its table behind it; in ASCII, so that nothing in it can be taken for code."""
    table = "\n".join(f"    {row.told!a}," for row in rows)
    return f"{SERVER.read_text(encoding='utf-8')}\n\n# Drawn with seed {seed}.\nVARIANTS += [\n{table}\n]\n".encode()
