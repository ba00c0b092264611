"""A document as LaTeX source that compiles with pdflatex, xelatex and lualatex, figures as TikZ.

Words of a file are neutralised letter by letter (report/notation/tex_words.py); formulas are those of the report.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import chain
from typing import ClassVar, final

from planar_cli.formats import _latex
from planar_cli.formats._alike import ANNOUNCING, answer_line, aside_of, check_line, heading_words, table_of
from planar_cli.formats._formulas import joined
from planar_cli.formats._tikz import COLOURS, tikz
from planar_cli.formats.base import Pages, runs_of
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
    Inline,
    Line,
    Note,
    Paragraph,
    Result,
    Table,
    Text,
    Title,
    Typed,
)
from planar_cli.report.notation import latex
from planar_cli.report.notation.tex_words import LETTER, in_ascii, words

PREAMBLE = rf"""\documentclass[11pt,a4paper]{{article}}
\ifdefined\Umathcode\else
  \usepackage[T1]{{fontenc}}
  \usepackage[utf8]{{inputenc}}
\fi
\usepackage{{lmodern}}
\usepackage{{textcomp}}
\usepackage[margin=22mm]{{geometry}}
\usepackage{{amsmath,amssymb,array,longtable,tikz}}
\providecommand{{\lt}}{{<}}
\providecommand{{\gt}}{{>}}
% A letter without a command: as it is where TeX reads Unicode, else by its number.
\ifdefined\Umathcode
  \newcommand{{\{LETTER}}}[1]{{\symbol{{"#1}}}}
\else
  \newcommand{{\{LETTER}}}[1]{{[U+#1]}}
\fi
% A title or heading: its size, its words, what stands beside it.
\newcommand{{\planarhead}}[3]{{\par\addvspace{{1.2\bigskipamount}}%
  {{#1\bfseries\noindent #2\unskip\hskip1em\hfil\penalty50\null\nobreak\hfill{{\normalfont\small #3}}\par}}%
  \nopagebreak\smallskip}}
% A formula on display, which may break, and its number.
\newcommand{{\planarshown}}[2]{{\par\smallskip
  {{\leftskip=2em\rightskip=0pt plus 1fil\parfillskip=0pt\hangindent=2em\noindent #1%
  \unskip\nobreak\hfill\penalty50\hskip1em\null\nobreak\hfill\hbox{{#2}}\par}}\smallskip}}
\newcommand{{\planaranswer}}[1]{{\par\medskip
  \fbox{{\begin{{minipage}}{{\dimexpr\linewidth-2\fboxsep-2\fboxrule\relax}}\everymath{{\displaystyle}}#1\end{{minipage}}}}\par\nopagebreak\medskip}}
% A list, which stays with what announces it; how bad it is that a page ends between its entries.
\makeatletter
\newcommand{{\planarlist}}[2]{{{{\@beginparpenalty=10000\@itempenalty=#1\relax\topsep=2pt\partopsep=0pt\parskip=0pt
  \begin{{itemize}}\setlength{{\itemsep}}{{2pt}}\setlength{{\parskip}}{{0pt}}#2\end{{itemize}}}}}}
\makeatother
\setlength{{\parindent}}{{0pt}}
\setlength{{\parskip}}{{0.4\baselineskip}}
\setlength{{\emergencystretch}}{{4em}}
\renewcommand{{\arraystretch}}{{1.3}}
\allowdisplaybreaks
"""
SIZES = (r"\LARGE", r"\Large", r"\large", r"\normalsize")
WIDE = 76
"""So many letters fit side by side in a table."""
SHORT, NEVER = 9, 10_000
"""A list of so many entries is not torn."""
HIGH = 25
"""So many rows fit on a page."""


@final
@record
class Latex(Pages):
    """LaTeX source. Each piece is a paragraph."""

    kind: ClassVar[str] = "latex"
    suffix: ClassVar[str] = ".tex"

    below: int = 0

    def part(self, blocks: Sequence[Block]) -> str:
        return "\n\n".join(piece for run in runs_of(blocks) for piece in self.pieces(run))

    def whole(self, title: str, parts: Sequence[str]) -> str:
        body = "\n\n".join(p for p in parts if p)
        return f"{PREAMBLE}{COLOURS}\\begin{{document}}\n{body}\n\\end{{document}}\n"

    def titles(self, run: Sequence[Title]) -> list[str]:
        return [self._head(words(t.text), t.level) for t in run]

    def headings(self, run: Sequence[Heading]) -> list[str]:
        return [self._heading(h) for h in run]

    def paragraphs(self, run: Sequence[Paragraph]) -> list[str]:
        return [_announcing(told) if (told := _inline(p.line)).endswith(":") else told for p in run]

    def bullets(self, run: Sequence[Bullet]) -> list[str]:
        return [_listed(_inline(b.line) for b in run)]

    def equations(self, run: Sequence[Equation]) -> list[str]:
        return [_shown(e) for e in run]

    def results(self, run: Sequence[Result]) -> list[str]:
        return [rf"$\Rightarrow$ {_inline(r.line)}" for r in run]

    def forces(self, run: Sequence[Forces]) -> list[str]:
        # With the words above it and the figure below it a list of forces stays on one page.
        return [f"\\nopagebreak\n{table}\\par\\nopagebreak" for table in self.tables([table_of(run)])]

    def tables(self, run: Sequence[Table]) -> list[str]:
        return [_table([_inline(c) for c in t.header], [tuple(map(_inline, row)) for row in t.rows]) for t in run]

    def answers(self, run: Sequence[Answer]) -> list[str]:
        listed = _listed(_inline(answer_line(a)) for a in run)
        inside = rf"\textbf{{Answer}}\par{listed}"
        return [rf"\planaranswer{{{inside}}}"]

    def checks(self, run: Sequence[Check]) -> list[str]:
        told = r" \textbullet{} ".join(_inline(check_line(c)) for c in run)
        return [rf"{{\small\textbf{{Check}} {told}\par}}"]

    def notes(self, run: Sequence[Note]) -> list[str]:
        label = rf"\textbf{{{words(run[0].kind)}}}"
        if len(run) == 1:
            told = f"{label} {_inline(run[0].line)}"
            return [_announcing(told) if run[0].kind in ANNOUNCING else told]
        return [f"{label}\n{_listed(_inline(n.line) for n in run)}"]

    def drawings(self, run: Sequence[Drawing]) -> list[str]:
        # The environment `center` would let a page end before it.
        return [f"\\medskip\n{{\\centering\n{tikz(d.figure)}\\par}}\n\\medskip" for d in run]

    def typed(self, run: Sequence[Typed]) -> list[str]:
        rows = chain.from_iterable(t.rows for t in run)
        lines = "\\\\\n".join(rf"\mbox{{{words(r).replace(' ', '~')}}}" for r in rows)
        return [f"{{\\small\\ttfamily\n{lines}\\par}}"]

    def _head(self, text: str, level: int, aside: str = "") -> str:
        size = SIZES[min(max(level, 0) + self.below, len(SIZES) - 1)]
        return rf"\planarhead{{{size}}}{{{text}}}{{{aside}}}"

    def _heading(self, heading: Heading) -> str:
        beside = aside_of(heading)
        aside = words(beside) if isinstance(beside, str) else _inline(beside)
        return self._head(words(heading_words(heading)), 2, aside)


def _formula(part: Inline) -> str:
    return in_ascii(_latex.formula(part))


def _inline(line: Line) -> str:
    """A line with its formulas between dollar signs."""
    return in_ascii(joined(line, _formula, words, _marked).strip())


def _announcing(told: str) -> str:
    """A paragraph that stays on one page with what it announces."""
    return rf"{told}\par\nopagebreak"


def _marked(part: Text) -> str:
    command = {"strong": "textbf", "muted": "textit"}[part.style]
    return rf"\{command}{{{words(part.text)}}}"


def _listed(entries: Iterator[str]) -> str:
    rows = [rf"\item {entry}" for entry in entries]
    told = "\n".join(rows)
    return rf"\planarlist{{{NEVER if len(rows) <= SHORT else 0}}}{{{told}}}"


def _shown(told: Equation) -> str:
    """An equation in pieces between which a line may end."""
    first, *others = [_latex.display(s) for s in told.sides]
    relations = [latex.relation(told.relation), *("=" for _ in others)]
    sides = [first, *(f"{{}} {r} {side}" for r, side in zip(relations, others, strict=False))]
    between = r"\allowbreak ".join(rf"$\displaystyle {in_ascii(s)}$" for s in sides)
    lead = rf"$\displaystyle {in_ascii(_latex.display(told.lead))}$\quad " if told.lead else ""
    note = rf" \qquad $\displaystyle {in_ascii(_latex.display(told.note))}$" if told.note else ""
    number = f"({told.number})" if told.number is not None else ""
    return rf"\planarshown{{{lead}{between}{note}}}{{{number}}}"


def _table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table with columns as wide as what is in them; one that does not fit so has columns of fixed widths, and one
    that may not fit on a page goes on on the next, with widths by which it is right when TeX reads it once.
    """
    longest = [max(map(_size, column)) for column in zip(header, *rows, strict=True)]
    body = "\n".join([rf"{' & '.join(row)} \\ \hline" for row in rows])
    head = " & ".join(rf"\textbf{{{cell}}}" for cell in header) + r" \\ \hline"
    if sum(longest) <= WIDE and len(rows) <= HIGH:
        columns = "|".join("l" for _ in header)
        return f"\\begin{{tabular}}{{|{columns}|}}\n\\hline\n{head}\n{body}\n\\end{{tabular}}"
    parts = [min(max(n, 8), WIDE // 2) for n in longest]
    share = 0.99 / max(sum(parts), WIDE)
    columns = "|".join(rf">{{\raggedright\arraybackslash}}p{{{_less(share * part)}}}" for part in parts)
    high = sum(max(-(-_size(cell) // part) for cell, part in zip(row, parts, strict=True)) for row in rows)
    if high <= HIGH:
        return f"\\begin{{tabular}}{{|{columns}|}}\n\\hline\n{head}\n{body}\n\\end{{tabular}}"
    return f"\\begin{{longtable}}[l]{{|{columns}|}}\n\\hline\n{head}\n\\endhead\n{body}\n\\end{{longtable}}"


def _less(share: float) -> str:
    """A part of the line, without what stands on both sides of a column."""
    return rf"\dimexpr{share:.3f}\linewidth-2\tabcolsep-\arrayrulewidth\relax"


def _size(cell: str) -> int:
    """About how many letters wide a cell is."""
    return len(re.sub(r"\\[A-Za-z]+|[{}$^_~\\]", "", cell))
