"""A document as Markdown with LaTeX formulas between dollar signs, as GitHub, Pandoc and notebooks read it.

Words of a file are escaped, so that a name cannot become a link, an image, HTML or a formula. Inside `$…$` and `$$…$$`
GitHub takes a backslash before punctuation for an escape of its own, and strokes between punctuation for emphasis; the
formulas avoid `\\,` `\\{` `}_{` and the like.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import ClassVar, final

from planar_cli.formats._alike import answer_line, aside_of, check_line, heading_words, table_of
from planar_cli.formats._formulas import joined
from planar_cli.formats._latex import equation, formula
from planar_cli.formats._svg import picture
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
    Line,
    Note,
    Paragraph,
    Result,
    Table,
    Text,
    Title,
    Typed,
)
from planar_cli.report.notation.names import printable

_PUNCTUATION = re.compile(r"([\\`*_{}\[\]<>#|~$^&!])")
_STROKE = re.compile(r"(?<=[^\w\s\\])_")
"""What would begin an emphasis; before a space it does not."""
_BAR = re.compile(r"(?<!\\)\|")
LOWEST = 6
"""The lowest level of headings."""
# What would begin a list, a numbered list or a quotation at the start of a paragraph.
_OPENING = re.compile(r"^(\s*\d*)([-+.)])(?=\s|$)")


@final
@record
class Markdown(Pages):
    """Markdown with formulas in LaTeX. Each piece is a paragraph."""

    kind: ClassVar[str] = "markdown"
    suffix: ClassVar[str] = ".md"

    below: int = 0
    pictures: bool = False
    """Are figures called, as files beside the text whose names tell what is in them?"""

    def part(self, blocks: Sequence[Block]) -> str:
        return "\n\n".join(piece for run in runs_of(blocks) for piece in self.pieces(run))

    def whole(self, title: str, parts: Sequence[str]) -> str:
        return "\n\n".join(p for p in parts if p) + "\n"

    def titles(self, run: Sequence[Title]) -> list[str]:
        return [f"{self._level(1 + t.level)} {escaped(t.text)}" for t in run]

    def headings(self, run: Sequence[Heading]) -> list[str]:
        pieces = []
        for heading in run:
            pieces.append(f"{self._level(2)} {escaped(heading_words(heading))}")
            beside = aside_of(heading)
            aside = escaped(beside) if isinstance(beside, str) else _inline(beside)
            pieces += [aside if aside.startswith("(") else f"({aside})"] if aside else []
        return pieces

    def paragraphs(self, run: Sequence[Paragraph]) -> list[str]:
        return [_paragraph(p.line) for p in run]

    def bullets(self, run: Sequence[Bullet]) -> list[str]:
        return ["\n".join(f"- {_inline(b.line)}" for b in run)]

    def equations(self, run: Sequence[Equation]) -> list[str]:
        return [f"$$\n{protected(equation(e))}\n$$" for e in run]

    def results(self, run: Sequence[Result]) -> list[str]:
        return [f"⇒ {_inline(r.line)}" for r in run]

    def forces(self, run: Sequence[Forces]) -> list[str]:
        return self.tables([table_of(run)])

    def tables(self, run: Sequence[Table]) -> list[str]:
        return ["\n".join([_row(t.header), "|" + " --- |" * len(t.header), *(_row(r) for r in t.rows)]) for t in run]

    def answers(self, run: Sequence[Answer]) -> list[str]:
        return [f"{self._level(2)} Answer", "\n".join(f"- {_inline(answer_line(a))}" for a in run)]

    def checks(self, run: Sequence[Check]) -> list[str]:
        return ["**Check:** " + " · ".join(_inline(check_line(c)) for c in run)]

    def notes(self, run: Sequence[Note]) -> list[str]:
        label = f"**{escaped(run[0].kind)}:**"
        if len(run) == 1:
            return [f"{label} {_inline(run[0].line)}"]
        return [label, "\n".join(f"- {_inline(n.line)}" for n in run)]

    def drawings(self, run: Sequence[Drawing]) -> list[str]:
        """Text alone has none; the tables of forces say the same."""
        return [f"![{escaped(d.figure.words)}]({picture(d.figure)[0]})" for d in run] if self.pictures else []

    def typed(self, run: Sequence[Typed]) -> list[str]:
        # A row that begins with three of them would end the block.
        return ["\n".join(["```text", *(printable(r).replace("```", "` ` `") for r in t.rows), "```"]) for t in run]

    def _level(self, level: int) -> str:
        return "#" * min(level + self.below, LOWEST)


def escaped(text: str) -> str:
    """Words without any meaning for Markdown or HTML."""
    return _PUNCTUATION.sub(r"\\\1", printable(re.sub(r"\s", " ", text)))


def protected(tex: str) -> str:
    """A formula in which Markdown finds nothing of its own; it looks the same."""
    return _STROKE.sub("_ ", tex.replace(r"\\ ", r"\cr ").replace(r"\,", r"\thinspace "))


def _paragraph(line: Line) -> str:
    return _OPENING.sub(r"\1\\\2", _inline(line))


def _inline(line: Line) -> str:
    """A line with each of its formulas between dollar signs."""
    return joined(line, lambda piece: protected(formula(piece)), escaped, _marked).strip()


def _marked(part: Text) -> str:
    """Words in their style."""
    text = escaped(part.text)
    mark = {"strong": "**", "muted": "*"}[part.style]
    return f"{mark}{text}{mark}" if text.strip() == text else text


def _row(cells: Sequence[Line]) -> str:
    # Among words a bar is escaped; one in a formula would end the cell.
    return "| " + " | ".join(_BAR.sub(r"\\vert ", _inline(c)) for c in cells) + " |"
