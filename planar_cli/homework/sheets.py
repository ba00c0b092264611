"""What is handed out: the sheet of a variant, and the key of all of them, as Markdown, HTML, JSON and CSV.

A sheet holds nothing of the key: it is written from what is asked and given alone.
"""

from __future__ import annotations

import csv
import html
import io
import json
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import groupby

from planar_cli.homework.exports._text import Names, slug
from planar_cli.homework.exports._worked import worked_html
from planar_cli.homework.paper import Expected, Paper, Task
from planar_cli.homework.printed_names import printed
from planar_cli.homework.ready import Homework
from planar_cli.mathml import MathML
from planar_cli.problem.show import harmless, paragraphs_of, spreadsheet_cell
from planar_cli.records import record
from planar_cli.units import pretty_unit

SCHEMA = 1
MARKUP = str.maketrans({c: f"\\{c}" for c in "\\`*_{}[]<>#|~$"})
"""Characters that mean something in Markdown."""
STYLE = (
    "body{font:16px/1.5 Georgia,serif;max-width:46rem;margin:2rem auto;padding:0 1rem;color:#111;background:#fff}"
    "table{border-collapse:collapse}td,th{border:1px solid #999;padding:.2rem .6rem;text-align:left}"
    "pre{font-size:14px;overflow-x:auto}h2,h3{margin-top:2rem}math{font-size:1.05em}sub{line-height:0}"
    ".equation{display:block;padding-left:4rem;text-indent:-2rem}.equation>math{text-indent:0}"
    ".number{float:right;text-indent:0;padding-left:1rem}@media print{h2,h3,h4{break-after:avoid}}"
)


# --- Markdown --------------------------------------------------------------------------------------------------------


@record
class Handed:
    """One sheet: the name of its file without the ending, its variant, and its student ("" where none is named)."""

    name: str
    variant: int
    student: str = ""

    def title(self, homework: Homework) -> str:
        """What stands over it."""
        variant = f"variant {self.variant}" if self.variant else ""
        return ", ".join(filter(None, (homework.title, variant, self.student)))


def handed(homework: Homework, variants: Sequence[int]) -> tuple[Handed, ...]:
    """The sheets of some variants: one for each student who has it, else one for the variant."""
    width = len(str(max(variants, default=0)))
    names = Names()
    found = []
    for variant in variants:
        number = f"sheet-{variant:0{width}d}" if variant else "sheet"
        students = [name for name, own in homework.students if own == variant]
        found += [Handed(names.of(f"{number}-{slug(name)}"), variant, name) for name in students]
        found += [] if students else [Handed(number, variant)]
    return tuple(found)


def sheet(homework: Homework, one: Handed) -> str:
    """A sheet in Markdown."""
    paper = homework.papers[one.variant]
    lines = [f"# {plain(one.title(homework))}", ""]
    lines += _paragraphs(homework.text)
    for number, task in enumerate(paper.tasks, 1):
        lines += [f"## {number}. {plain(task.title)}", ""]
        lines += _paragraphs(task.text)
        if task.given:
            lines += [f"{task.lead}: {', '.join(map(plain, task.given))}", ""]
        lines += [f"- **{plain(e.find)}**{plain(_asked(e))}{_points(e)}" for e in task.expected] + [""]
    return "\n".join([*lines, *_how_to_hand_in(homework, one)])


def _paragraphs(text: str) -> list[str]:
    return [line for paragraph in paragraphs_of(text) for line in (plain(paragraph), "")]


def _how_to_hand_in(homework: Homework, one: Handed) -> Iterable[str]:
    """A form with a line for each answer, beside it an example of its kind with made-up numbers."""
    asked = [(task.problem, e) for task in homework.papers[one.variant].tasks for e in task.expected]
    figures = homework.rules.figures
    axes = "x counts to the right, y upward. " if any(e.axis or e.kind == "vector" for _, e in asked) else ""
    yield "## How to hand in"
    yield ""
    yield (
        "A YAML file with one line for each answer: copy the lines below and write your answers behind the colons, a "
        f"number with its unit and, of a rotation, its sense (cw or ccw). {axes}Give {figures} significant figures. "
        "The examples behind # show how an answer is written; what they say is made up."
    )
    yield from ("", "```text", f"student: {_quoted(one.student) or 'your name or number'}")
    yield from (f"variant: {one.variant}",) if one.variant else ()
    yield "answers:"
    width = max((len(f"{problem}.{e.find}") for problem, e in asked), default=0) + 1
    for problem, e in asked:
        example = _example(e, homework.rules.comma)
        yield f"  {f'{problem}.{e.find}:':<{width}} {f' # {example}' if example else ''}".rstrip()
    yield from ("```", "")


def _quoted(name: str) -> str:
    """A name as YAML reads it as one word."""
    name = harmless(name, kept="")
    return name if re.fullmatch(r"[\w.][\w .-]*|", name) else json.dumps(name, ensure_ascii=False)


def _example(expected: Expected, comma: bool) -> str:
    """How an answer of that kind is typed; "" where an example would be one of few answers."""
    unit = f" {expected.unit}" if expected.unit != "1" else ""
    first, second = ("12,3", "4,56") if comma else ("12.3", "4.56")
    if expected.kind == "vector":
        # In quotes: a bracket begins a list in YAML.
        return f'"[{first}; -{second}]{unit}"' if comma else f'"[{first}, -{second}]{unit}"'
    if expected.kind == "formula":
        letters = [n for n, _ in (*expected.letters, *expected.others)]
        return _made_up([n for n in letters if n not in dict(expected.known)] or letters)
    if expected.kind != "number":
        return ""
    return f"{first}{unit}{' cw' if expected.rotation else ''}"


def _made_up(letters: Sequence[str]) -> str:
    """A formula in the first letters of a problem, which is no answer."""
    one, *more = sorted(letters)
    return f"2/7*{one}*sqrt({more[-1]})" if more else f"2/7*{one}"


def key(homework: Homework, variants: Iterable[int], worked: bool, short: bool = True) -> str:
    """The key of some variants in Markdown: the answers, the worked solutions, or both."""
    pieces = _key_pieces(homework, variants, worked, short)
    return "\n".join(f"{_below(p.worked)}\n" if isinstance(p, Task) else p for p in pieces)


def key_html(homework: Homework, variants: Iterable[int], worked: bool, short: bool = True) -> str:
    """The same as one HTML page; formulas are set by the browser."""
    formulas, body = MathML(), ""
    for is_page, pieces in groupby(_key_pieces(homework, variants, worked, short), lambda p: isinstance(p, Task)):
        if is_page:
            body += "".join(worked_html(p.worked, formulas) for p in pieces if isinstance(p, Task))
        else:
            body += _rendered("\n".join(p for p in pieces if isinstance(p, str)))
    return _page(body, f"{homework.title}: key")


def _key_pieces(homework: Homework, variants: Iterable[int], worked: bool, short: bool) -> Iterator[str | Task]:
    """Lines in Markdown, and the tasks whose worked solutions stand between them."""
    yield from (f"# {plain(homework.title)}: key", "")
    for variant in variants:
        paper = homework.papers[variant]
        if len(homework.papers) > 1:
            students = "".join(f", {plain(name)}" for name, own in homework.students if own == variant)
            yield from (f"## {'The files as they are' if not variant else f'Variant {variant}'}{students}", "")
        yield from _short(paper) if short else ()
        yield from paper.tasks if worked else ()


def _short(paper: Paper) -> Iterable[str]:
    yield from ("| Problem | Find | Answer | Points |", "| --- | --- | --- | --- |")
    for task in paper.tasks:
        for e in task.expected:
            yield f"| {plain(task.problem)} | {plain(e.find)} | {plain(e.text)} | {e.points:g} |"
    yield ""
    drawn = [f"- {plain(t.problem)}: {', '.join(map(plain, t.drawn))}" for t in paper.tasks if t.drawn]
    yield from (*drawn, "") if drawn else ()


def _below(page: str) -> str:
    """A page with its headings two levels lower."""
    return "\n".join(f"##{line}" if line.startswith("#") else line for line in page.splitlines())


def _asked(expected: Expected) -> str:
    unit = pretty_unit(expected.unit)
    two = " (two components, x and y)" if expected.kind == "vector" else ""
    # The name of the find stands before it already.
    what = "" if expected.asked in ("", printed(expected.find)) else f": {expected.asked}"
    return f"{what}{two}" + (f", in {unit}" if unit and expected.kind != "word" else "")


def _points(expected: Expected) -> str:
    return f" ({expected.points:g} {'point' if expected.points == 1 else 'points'})"


def plain(text: str) -> str:
    """Words in which nothing is markup."""
    return " ".join(harmless(text, kept="").translate(MARKUP).split())


# --- HTML ------------------------------------------------------------------------------------------------------------


def as_html(markdown: str, title: str) -> str:
    """A document of ours as one HTML page without scripts; raw HTML in it stays text."""
    return _page(_rendered(markdown), title)


def _rendered(markdown: str) -> str:
    from markdown_it import MarkdownIt

    from planar_cli.homework.subscripts import with_subscripts

    reader = MarkdownIt("commonmark", {"html": False}).enable("table")
    reader.core.ruler.push("subscripts", with_subscripts)
    html_of_it: str = reader.render(markdown)
    return html_of_it


def _page(body: str, title: str) -> str:
    policy = "default-src 'none'; style-src 'unsafe-inline'"
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{html.escape(harmless(title, kept=''))}</title><style>{STYLE}</style></head>\n"
        f"<body>\n{body}</body></html>\n"
    )


# --- data ------------------------------------------------------------------------------------------------------------


def sheet_data(homework: Homework, one: Handed) -> dict[str, object]:
    """A sheet as data."""
    return {
        "schema": SCHEMA,
        "title": homework.title,
        "variant": one.variant,
        **({"student": one.student} if one.student else {}),
        "problems": [_task_data(t, with_answers=False) for t in homework.papers[one.variant].tasks],
    }


def key_data(homework: Homework, variants: Sequence[int]) -> dict[str, object]:
    """The key of some variants as data."""
    return {
        "schema": SCHEMA,
        "title": homework.title,
        "digest": homework.digest,
        "variants": [
            {"variant": k, "problems": [_task_data(t, with_answers=True) for t in homework.papers[k].tasks]}
            for k in variants
        ],
    }


def _task_data(task: Task, with_answers: bool) -> dict[str, object]:
    finds: list[Mapping[str, object]] = []
    for e in task.expected:
        asked = {"find": e.find, "asked": e.asked, "kind": e.kind, "unit": e.unit, "points": e.points}
        told = {"answer": e.text, "values": list(e.values), "tolerance": e.tolerance} if with_answers else {}
        formula = {"formula": e.formula} if with_answers and e.formula else {}
        finds.append({**asked, **told, **formula})
    given = list(dict.fromkeys((*task.drawn, *task.given)))
    return {"problem": task.problem, "title": task.title, "text": task.text, "given": given, "finds": finds}


def as_json(data: Mapping[str, object]) -> str:
    """Data as JSON, the same for the same data."""
    return json.dumps(data, ensure_ascii=False, indent=1) + "\n"


def sheet_csv(homework: Homework, variant: int) -> str:
    """The finds of a variant as a table to be filled in: it is read back as a submission, with its variant."""
    head: tuple[str, ...] = ("problem", "find", "answer", "unit")
    own: tuple[object, ...] = ()
    if variant:
        head, own = (*head, "variant"), (variant,)
    rows = [(t.problem, e.find, "", e.unit, *own) for t in homework.papers[variant].tasks for e in t.expected]
    return _csv(head, rows)


def key_csv(homework: Homework, variants: Iterable[int]) -> str:
    """The key of some variants as a table."""
    rows = [
        # A spreadsheet takes a hyphen, but no minus sign, for the beginning of a formula.
        (
            k,
            t.problem,
            e.find,
            re.sub("^-", "\N{MINUS SIGN}", e.text),
            *(list(e.values) + [""] * (2 - len(e.values)))[:2],
            e.unit,
            e.points,
        )
        for k in variants
        for t in homework.papers[k].tasks
        for e in t.expected
    ]
    return _csv(("variant", "problem", "find", "answer", "value", "second_value", "unit", "points"), rows)


def _csv(head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(head)
    for row in rows:
        writer.writerow([spreadsheet_cell(c) if isinstance(c, str) else c for c in row])
    return out.getvalue()
