"""A document as one HTML file that needs nothing else: native MathML, inline SVG, no script, light and dark, for paper
and telephones.

Words of a file are escaped one by one; the content security policy forbids scripts, frames and every connection.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from html import escape
from typing import ClassVar, Protocol

from planar_cli.formats import _svg
from planar_cli.formats._alike import ANNOUNCING, NAMING, answer_line, aside_of, check_line, heading_words, table_of
from planar_cli.formats._formulas import joined
from planar_cli.formats._latex import equation, formula
from planar_cli.formats.base import Pages, runs_of
from planar_cli.mathml import MathML
from planar_cli.records import record
from planar_cli.report.document.blocks import (
    Answer,
    Block,
    Bullet,
    Check,
    Drawing,
    Equation,
    Forces,
    Heading,
    Line,
    Note,
    Paragraph,
    Result,
    Table,
    Text,
    Title,
    Typed,
)
from planar_cli.report.document.marks import Figure
from planar_cli.report.notation.names import printable

POLICY = "default-src 'none'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'"
STYLE = """
:root{color-scheme:light dark;--page:#fff;--text:#1b1b1b;--muted:#666;--line:#d5d9e0;--tint:#f4f6fa;--accent:#1555a5}
@media screen and (prefers-color-scheme:dark){:root{--page:#111418;--text:#e8e8e8;--muted:#9a9a9a;--line:#333a45;
--tint:#1a1f27;--accent:#82b1ff}}
body{background:var(--page);color:var(--text);font:16px/1.5 "Source Serif 4",Georgia,"Times New Roman",serif;
max-width:54rem;margin:0 auto;padding:1rem}
.title{font-size:1.5rem;line-height:1.25;margin:.5rem 0 1rem}summary>:not(.aside){display:inline}
summary>:not(.aside),.answer>:first-child{font-size:1.1rem;margin:0}
h2.title{font-size:1.3rem;margin-top:1.8rem}h3.title{font-size:1.15rem;margin-top:1.5rem}
summary{cursor:pointer;border-bottom:1px solid var(--line);padding:.3rem 0;margin-top:1rem}summary::after{content:"";
display:block;clear:both}
summary .aside{color:var(--muted);float:right}.case,.part{display:block;margin:1.6rem 0 .4rem;
color:var(--accent)}.case{font-size:1.25rem}.part{font-size:1.15rem}
p{margin:.5rem 0}.equation{display:block;margin:.4rem 0 .4rem 2rem;overflow-x:auto;overflow-y:hidden;line-height:1.7}
.long{display:inline-block;max-width:100%}
.number{float:right;color:var(--muted);margin-left:1rem}.note dt,.check dt{font-weight:600}
.forces td:first-child{white-space:nowrap}
table{border-collapse:collapse;margin:.6rem 0;display:block;overflow-x:auto}th,td{border:1px solid var(--line);
padding:.25rem .6rem;text-align:left;vertical-align:top}th{background:var(--tint)}
.answer{border:1.5px solid var(--accent);border-radius:6px;padding:.4rem .8rem;margin:1rem 0;background:var(--tint)}
.answer ul{margin:.2rem 0;padding-left:1.2rem}.answer li{margin:.3rem 0}li math{math-style:normal}
.foot{color:var(--muted);font-size:.92rem}
figure{margin:.8rem 0;text-align:center;overflow-x:auto}figure svg{max-width:100%;height:auto}
.panels{display:flex;flex-wrap:wrap;justify-content:center;align-items:center;gap:.5rem 1rem}.between{font-size:1.4rem}
figcaption{flex-basis:100%;font-size:.92rem}
.muted{color:var(--muted)}math:has(mfrac,msqrt){margin-block:.15em}
math{font-size:1.05em;font-family:"STIX Two Math","Cambria Math","Latin Modern Math",
"Libertinus Math","Noto Sans Math",math}
@media (max-width:36rem){body{padding:.6rem;font-size:15px}.equation{margin-left:.4rem}summary .aside{float:none;
display:block;font-size:.92rem}.panels{flex-direction:column}figcaption{flex-basis:auto}}
@media print{body{max-width:none;padding:0;font-size:10.5pt}summary{list-style:none}details{margin-top:.6rem}
details::details-content{content-visibility:visible}figure,table,tr,.answer,.equation,.whole{break-inside:avoid}
summary,.title,.case,.part,.lead,.forces,p:has(+.forces),p:has(+ul),.answer:has(+.foot){break-after:avoid}
figure{margin:.3rem 0}figure svg{zoom:.8}
.equation,table,figure{overflow:visible}table{display:table}}
@page{margin:16mm 18mm}
"""
_ENTITIES = str.maketrans({c: f"&#{ord(c)};" for c in "$\\{}"})
"""What would begin a formula, or a place in a template of a course system, where it is a word."""
FOLD = "<details open>"
BEGINS = (FOLD, "<h", "<section")
"""With these ends what folds before them."""
_MATH = re.compile(r"\$([^$]*)\$")
MATHML = MathML()
LOWEST = 6
"""The lowest level of headings."""


class Formulas(Protocol):
    """How formulas in LaTeX get into HTML: in a line, and on a line of their own."""

    def inline(self, latex: str) -> str: ...
    def display(self, latex: str) -> str: ...


@record
class Html(Pages):
    """One HTML file with everything in it. Each piece is an element, or the tag that opens or closes one."""

    kind: ClassVar[str] = "html"
    suffix: ClassVar[str] = ".html"

    below: int = 0
    formulas: Formulas = MATHML

    def part(self, blocks: Sequence[Block]) -> str:
        body: list[str] = []
        folds = False
        for piece in (p for run in runs_of(blocks) for p in self.pieces(run)):
            if folds and piece.startswith(BEGINS):
                body.append("</details>")
            folds = piece == FOLD or (folds and not piece.startswith(BEGINS))
            body.append(piece)
        body += ["</details>"] if folds else []
        return "\n".join(body)

    def whole(self, title: str, parts: Sequence[str]) -> str:
        head = (
            '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
            f'<meta http-equiv="Content-Security-Policy" content="{escape(POLICY)}">\n'
            '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
            f"<title>{words(title)}</title>\n<style>{STYLE}{_svg.STYLE}</style>\n</head>\n<body>\n"
        )
        body = re.split('(?=<h2 class="title">)', "\n".join(p for p in parts if p))
        # A problem of a sheet or key is not torn over two sheets of paper where it fits on one.
        wholes = [f'<div class="whole">\n{part.rstrip()}\n</div>\n' for part in body[1:]]
        return head + "".join((body[0], *wholes)).rstrip("\n") + "\n</body>\n</html>\n"

    def titles(self, run: Sequence[Title]) -> list[str]:
        return [self.headed(words(t.text), 1 + t.level, "title") for t in run]

    def headings(self, run: Sequence[Heading]) -> list[str]:
        return [piece for h in run for piece in self.heading(h)]

    def headed(self, text: str, level: int, look: str = "") -> str:
        """A title or heading of a level."""
        tag = f"h{min(level + self.below, LOWEST)}"
        return f"<{tag}{f' class={chr(34)}{look}{chr(34)}' if look else ''}>{text}</{tag}>"

    def paragraphs(self, run: Sequence[Paragraph]) -> list[str]:
        return [_paragraph(self.inline(p.line)) for p in run]

    def bullets(self, run: Sequence[Bullet]) -> list[str]:
        return ["<ul>" + "".join(f"<li>{self.inline(b.line)}</li>" for b in run) + "</ul>"]

    def equations(self, run: Sequence[Equation]) -> list[str]:
        return [f"<p>{self.formulas.display(equation(e))}</p>" for e in run]

    def results(self, run: Sequence[Result]) -> list[str]:
        return [f"<p>⇒ {self.inline(r.line)}</p>" for r in run]

    def forces(self, run: Sequence[Forces]) -> list[str]:
        return [self._table(table_of(run), "forces")]

    def tables(self, run: Sequence[Table]) -> list[str]:
        return [self._table(t) for t in run]

    def _table(self, table: Table, kind: str = "") -> str:
        head, *rows = ([self.inline(cell) for cell in row] for row in (table.header, *table.rows))
        headed = "".join(f"<th>{cell}</th>" for cell in head)
        body = "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows)
        named = f' class="{kind}"' if kind else ""
        return f"<table{named}><thead><tr>{headed}</tr></thead><tbody>{body}</tbody></table>"

    def answers(self, run: Sequence[Answer]) -> list[str]:
        listed = "".join(f"<li>{self.inline(answer_line(a))}</li>" for a in run)
        return [f'<section class="answer">{self.headed("Answer", 2)}<ul>{listed}</ul></section>']

    def checks(self, run: Sequence[Check]) -> list[str]:
        told = " · ".join(self.inline(check_line(c)) for c in run)
        return [f'<p class="foot"><strong>Check</strong> {told}</p>']

    def notes(self, run: Sequence[Note]) -> list[str]:
        label = f"<strong>{words(run[0].kind)}</strong>"
        if len(run) == 1:
            look = ' class="lead"' if run[0].kind in ANNOUNCING else ""
            return [f"<p{look}>{label} {self.inline(run[0].line)}</p>"]
        return [
            f'<p class="lead">{label}</p>',
            "<ul>" + "".join(f"<li>{self.inline(n.line)}</li>" for n in run) + "</ul>",
        ]

    def drawings(self, run: Sequence[Drawing]) -> list[str]:
        return [_figure(d.figure, self.inline(d.figure.note)) for d in run]

    def typed(self, run: Sequence[Typed]) -> list[str]:
        return ["<pre>" + "\n".join(map(_code, t.rows)) + "</pre>" for t in run]

    def heading(self, heading: Heading) -> list[str]:
        """A heading that folds what is below it, but for one over several steps, which fold each by itself."""
        text, aside = words(heading_words(heading)), self.aside(heading)
        if heading.label in NAMING:
            return [self.headed(text, 2, "case" if heading.label == "CASE" else "part")]
        beside = f'<span class="aside">{aside}</span>' if aside else ""
        return [FOLD, f"<summary>{self.headed(text, 2)}{beside}</summary>"]

    def aside(self, heading: Heading) -> str:
        """What stands beside a heading."""
        told = aside_of(heading)
        return words(told) if isinstance(told, str) else self.inline(told)

    def inline(self, line: Line) -> str:
        """A line with its formulas."""
        told = joined(line, formula, words, _marked).strip()
        return _MATH.sub(lambda m: self.formulas.inline(m[1]), told)


def words(text: str) -> str:
    """Words without any meaning for HTML, and none for the formulas among them."""
    return escape(printable(re.sub(r"\s", " ", text)), quote=True).translate(_ENTITIES)


def _code(row: str) -> str:
    return escape(printable(row), quote=True)


def _marked(part: Text) -> str:
    tag = {"strong": "strong", "muted": 'span class="muted"'}[part.style]
    return f"<{tag}>{words(part.text)}</{tag.partition(' ')[0]}>"


def _figure(figure: Figure, note: str) -> str:
    """The panels of a figure stand side by side where there is room, one below the other on a telephone."""
    panels = _svg.panels(figure, "page")
    under = f"<figcaption>{note}</figcaption>" if note else ""
    if len(panels) == 1:
        return f"<figure>{panels[0]}{under}</figure>"
    signs = [f'<span class="between">{words(s)}</span>' for s in figure.between] or [""] * len(panels)
    told = "".join(sign + panel for sign, panel in zip(["", *signs], panels, strict=False))
    return f'<figure class="panels">{told}{under}</figure>'


def _paragraph(told: str) -> str:
    """What ends with a colon stays on one sheet with what it announces."""
    return f'<p class="lead">{told}</p>' if told.endswith(":") else f"<p>{told}</p>"
