"""A worked solution as HTML for course systems: plain elements without attributes, well-formed as XML, formulas in
LaTeX between delimiters by which the system knows them.

No figures: what a system lets pass differs, and the lists of forces say the same.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from html import escape
from typing import ClassVar

from planar_cli.formats._alike import answer_line, heading_words
from planar_cli.formats.base import runs_of
from planar_cli.formats.html import Html, words
from planar_cli.records import record
from planar_cli.report.document.blocks import Answer, Block, Drawing, Heading, Title
from planar_cli.report.notation.names import printable

LEVEL = 2
"""The page of the system has the higher levels of headings."""
_LOOKS = re.compile(' class="[a-z ]+"')
_ALONE = re.compile("&#(36|92);")
"""A dollar sign or a backslash among words."""


@record
class Delimiters:
    """What stands around a formula, by which a system knows it; braces stay, as only its renderer reads them."""

    around: tuple[str, str]
    around_display: tuple[str, str]

    def inline(self, latex: str) -> str:
        """A formula in a line."""
        return self.around[0] + escape(printable(latex)) + self.around[1]

    def display(self, latex: str) -> str:
        """A formula on a line of its own."""
        return self.around_display[0] + escape(printable(latex)) + self.around_display[1]


DELIMITERS = {
    "mathjax": Delimiters(("\\(", "\\)"), ("\\[", "\\]")),
    "dollars": Delimiters(("$", "$"), ("$$", "$$")),
}
"""The two ways, by the names under which exports find a part that is printed so."""


def course_html(blocks: Sequence[Block], way: str) -> str:
    """Blocks as a course system shows them. `way`: how formulas are delimited."""
    return CourseHtml(LEVEL, DELIMITERS[way]).part(blocks)


@record
class CourseHtml(Html):
    """The pieces of a page without anything that a system would have to know of."""

    kind: ClassVar[str] = "course html"

    def part(self, blocks: Sequence[Block]) -> str:
        # In an element of its own the sign begins no formula.
        printed = "".join(piece for run in runs_of(blocks) for piece in self.pieces(run))
        return _ALONE.sub(lambda m: f"<span>{chr(int(m[1]))}</span>", _LOOKS.sub("", printed))

    def titles(self, run: Sequence[Title]) -> list[str]:
        return [self.headed(words(t.text), 1 + t.level) for t in run]

    def heading(self, heading: Heading) -> list[str]:
        aside = self.aside(heading)
        return [self.headed(words(heading_words(heading)), 2), *([f"<p>{aside}</p>"] if aside else [])]

    def answers(self, run: Sequence[Answer]) -> list[str]:
        listed = "".join(f"<li>{self.inline(answer_line(a))}</li>" for a in run)
        return [self.headed("Answer", 2), f"<ul>{listed}</ul>"]

    def drawings(self, run: Sequence[Drawing]) -> list[str]:
        return []
