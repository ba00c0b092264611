"""A document as one HTML file that needs nothing else: native MathML, inline SVG, no script, light and dark, for paper
and telephones.

Words of a file are escaped one by one; the content security policy forbids scripts, frames and every connection.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from html import escape
from typing import ClassVar, final

from planar_cli.formats import _svg
from planar_cli.formats._formulas import joined
from planar_cli.formats._latex import DIAGRAMS, NAMING, NOTHING, checked, equation, formula
from planar_cli.formats.base import Format, runs
from planar_cli.mathml import MathML
from planar_cli.records import record
from planar_cli.report.blocks import (
    Answer,
    Bullet,
    Check,
    Document,
    Drawing,
    Equation,
    Forces,
    Heading,
    Line,
    Name,
    Note,
    Paragraph,
    Result,
    Table,
    Text,
    Title,
)
from planar_cli.report.names import printable

POLICY = "default-src 'none'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'"
STYLE = """
:root{color-scheme:light dark;--page:#fff;--text:#1b1b1b;--muted:#666;--line:#d5d9e0;--tint:#f4f6fa;--accent:#1555a5}
@media (prefers-color-scheme:dark){:root{--page:#111418;--text:#e8e8e8;--muted:#9a9a9a;--line:#333a45;--tint:#1a1f27;
--accent:#82b1ff}}
body{background:var(--page);color:var(--text);font:16px/1.5 "Source Serif 4",Georgia,"Times New Roman",serif;
max-width:54rem;margin:0 auto;padding:1rem}
h1{font-size:1.5rem;line-height:1.25;margin:.5rem 0 1rem}h2{font-size:1.1rem;margin:0;display:inline}
summary{cursor:pointer;border-bottom:1px solid var(--line);padding:.3rem 0;margin-top:1rem}
summary .aside{color:var(--muted);float:right}.case{font-size:1.25rem;margin:1.6rem 0 .4rem;color:var(--accent)}
p{margin:.5rem 0}.equation{display:block;margin:.4rem 0 .4rem 2rem;overflow-x:auto;overflow-y:hidden}
.number{float:right;color:var(--muted);margin-left:1rem}.note dt,.check dt{font-weight:600}
table{border-collapse:collapse;margin:.6rem 0;display:block;overflow-x:auto}th,td{border:1px solid var(--line);
padding:.25rem .6rem;text-align:left;vertical-align:top}th{background:var(--tint)}
.answer{border:1.5px solid var(--accent);border-radius:6px;padding:.4rem .8rem;margin:1rem 0;background:var(--tint)}
.answer ul{margin:.2rem 0;padding-left:1.2rem}.foot{color:var(--muted);font-size:.92rem}
figure{margin:.8rem 0;text-align:center;overflow-x:auto}figure svg{max-width:100%;height:auto}
.muted{color:var(--muted)}math{font-size:1.05em}
@media (max-width:36rem){body{padding:.6rem;font-size:15px}.equation{margin-left:.4rem}summary .aside{float:none;
display:block}}
@media print{body{max-width:none;padding:0;font-size:10.5pt}summary{list-style:none}details,figure,table,.answer{
break-inside:avoid}:root{--page:#fff;--text:#000;--tint:#fff}}
"""
_MATH = re.compile(r"\$([^$]*)\$")
MATHML = MathML()


@final
@record
class Html(Format[str]):
    """One HTML file with everything in it. Each piece is an element, or the tag that opens or closes one."""

    kind: ClassVar[str] = "html"
    suffix: ClassVar[str] = ".html"

    def render(self, document: Document) -> str:
        body: list[str] = []
        for run in runs(document):
            opens = isinstance(run[0], Title | Heading | Answer)
            if opens and "<details open>" in body and "</details>" not in body[_last(body) :]:
                body.append("</details>")
            body += self.pieces(run)
        if "<details open>" in body and "</details>" not in body[_last(body) :]:
            body.append("</details>")
        head = (
            '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
            f'<meta http-equiv="Content-Security-Policy" content="{escape(POLICY)}">\n'
            '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
            f"<title>{words(document.title)}</title>\n<style>{STYLE}{_svg.STYLE}</style>\n</head>\n<body>\n"
        )
        return head + "\n".join(body) + "\n</body>\n</html>\n"

    def titles(self, run: Sequence[Title]) -> list[str]:
        return [f"<h1>{words(t.text)}</h1>" for t in run]

    def headings(self, run: Sequence[Heading]) -> list[str]:
        return [piece for h in run for piece in _heading(h)]

    def paragraphs(self, run: Sequence[Paragraph]) -> list[str]:
        return [_paragraph(inline(p.line)) for p in run]

    def bullets(self, run: Sequence[Bullet]) -> list[str]:
        return ["<ul>" + "".join(f"<li>{inline(b.line)}</li>" for b in run) + "</ul>"]

    def equations(self, run: Sequence[Equation]) -> list[str]:
        return [f"<p>{MATHML.display(equation(e))}</p>" for e in run]

    def results(self, run: Sequence[Result]) -> list[str]:
        return [f"<p>⇒ {inline(r.line)}</p>" for r in run]

    def forces(self, run: Sequence[Forces]) -> list[str]:
        both = any(f.right and f.right != NOTHING for f in run)
        heads = ("body", *(run[0].heads if both else run[0].heads[:1]))
        rows = [
            (f"<strong>{words(f.body)}</strong>", inline(f.left), *([inline(f.right)] if both else [])) for f in run
        ]
        return [_table([words(h) for h in heads], rows, "forces")]

    def tables(self, run: Sequence[Table]) -> list[str]:
        return [_table([inline(c) for c in t.header], [tuple(inline(c) for c in row) for row in t.rows]) for t in run]

    def answers(self, run: Sequence[Answer]) -> list[str]:
        listed = "".join(f"<li>{_answer(a)}</li>" for a in run)
        return [f'<section class="answer"><h2>Answer</h2><ul>{listed}</ul></section>']

    def checks(self, run: Sequence[Check]) -> list[str]:
        told = " · ".join(inline(tuple(q for p in c.line for q in checked(p))) for c in run)
        return [f'<p class="foot"><strong>Check</strong> {told}</p>']

    def notes(self, run: Sequence[Note]) -> list[str]:
        label = f"<strong>{words(run[0].kind)}</strong>"
        if len(run) == 1:
            return [f"<p>{label} {inline(run[0].line)}</p>"]
        return [f"<p>{label}</p>", "<ul>" + "".join(f"<li>{inline(n.line)}</li>" for n in run) + "</ul>"]

    def drawings(self, run: Sequence[Drawing]) -> list[str]:
        return [f"<figure>{_svg.svg(d.figure, 'page')}</figure>" for d in run]


def words(text: str) -> str:
    """Words without any meaning for HTML, and none for the formulas among them."""
    return escape(printable(re.sub(r"\s", " ", text)), quote=True).replace("$", "&#36;")


def inline(line: Line) -> str:
    """A line with its formulas in MathML."""
    told = joined(line, formula, words, _marked).strip()
    return _MATH.sub(lambda m: MATHML.inline(m[1]), told)


def _marked(part: Text) -> str:
    tag = {"strong": "strong", "muted": 'span class="muted"'}[part.style]
    return f"<{tag}>{words(part.text)}</{tag.partition(' ')[0]}>"


def _last(body: Sequence[str]) -> int:
    """Where the last part that folds begins."""
    return len(body) - 1 - body[::-1].index("<details open>")


def _heading(heading: Heading) -> list[str]:
    label = heading.label.capitalize() if heading.label.isupper() else heading.label
    between = ": " if heading.label in NAMING else ". "
    text = words(between.join(t for t in (label, heading.text) if t))
    if heading.label == "CASE":
        return [f'<h2 class="case">{text}</h2>']
    aside = words(heading.aside) if isinstance(heading.aside, str) else inline(heading.aside)
    aside = "" if heading.aside == DIAGRAMS or not aside else f'<span class="aside">{aside}</span>'
    return ["<details open>", f"<summary>{aside}<h2>{text}</h2></summary>"]


def _paragraph(told: str) -> str:
    """What ends with a colon stays on one sheet with what it announces."""
    return f'<p class="lead">{told}</p>' if told.endswith(":") else f"<p>{told}</p>"


def _table(header: Sequence[str], rows: Sequence[Sequence[str]], kind: str = "") -> str:
    head = "".join(f"<th>{cell}</th>" for cell in header)
    body = "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows)
    named = f' class="{kind}"' if kind else ""
    return f"<table{named}><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def _answer(answer: Answer) -> str:
    relation = ": " if answer.relation == ":" else f" {answer.relation} "
    return inline((Name(answer.name), Text(relation), *answer.line))
