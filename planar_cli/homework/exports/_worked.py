"""A worked solution, from the Markdown of the report to HTML; its formulas as whoever shows the page can set them.

Only what the report writes is known: headings, lists, tables, formulas, bold and italic words. All else is text.
"""

from __future__ import annotations

import re
from itertools import groupby
from typing import Protocol

from planar_cli.homework.exports._text import html, xml
from planar_cli.records import record

_PIECES = re.compile(
    r"\\(?P<escaped>[^\w\s]|_)"
    r"|\$(?P<math>(?:\\.|[^$\\])+)\$"
    r"|\*\*(?P<strong>(?:\\.|[^*\\])+)\*\*"
    r"|\*(?P<em>(?:\\.|[^*\\])+)\*"
    r"|(?P<plain>[^\\$*]+|.)",
    re.DOTALL,
)
_HEADING = re.compile(r"(#{1,6}) +(.*)")
_RULE = re.compile(r"\|[\s|:-]*\|?")


class Formulas(Protocol):
    """How formulas in LaTeX get into HTML: in a line, and on a line of their own."""

    def inline(self, latex: str) -> str: ...
    def display(self, latex: str) -> str: ...


@record
class Delimiters:
    """What stands around a formula, by which a system knows it; braces stay, as only its renderer reads them."""

    around: tuple[str, str]
    around_display: tuple[str, str]

    def inline(self, latex: str) -> str:
        """A formula in a line."""
        return self.around[0] + xml(latex) + self.around[1]

    def display(self, latex: str) -> str:
        """A formula on a line of its own."""
        return self.around_display[0] + xml(latex) + self.around_display[1]


LATEX = Delimiters(("\\(", "\\)"), ("\\[", "\\]"))
DOLLARS = Delimiters(("$", "$"), ("$$", "$$"))


def worked_html(markdown: str, formulas: Formulas) -> str:
    """The HTML of a worked solution: well-formed as XML, but for its formulas without attributes."""
    return "".join(_block(block.strip("\n"), formulas) for block in re.split(r"\n[ \t]*\n", markdown) if block.strip())


def _block(block: str, formulas: Formulas) -> str:
    heading = _HEADING.fullmatch(block)
    if heading:
        # The page of the system has the higher levels.
        level = min(6, len(heading[1]) + 2)
        return f"<h{level}>{_inline(heading[2], formulas)}</h{level}>"
    if block.startswith("$$") and block.endswith("$$") and len(block) > 4:
        return f"<p>{formulas.display(block[2:-2].strip())}</p>"
    runs = groupby(block.split("\n"), key=_kind)
    return "".join(_run(kind, list(lines), formulas) for kind, lines in runs)


def _kind(line: str) -> str:
    return "table" if line.startswith("|") else "list" if line.startswith("- ") else "text"


def _run(kind: str, lines: list[str], formulas: Formulas) -> str:
    if kind == "list":
        return "<ul>" + "".join(f"<li>{_inline(line[2:], formulas)}</li>" for line in lines) + "</ul>"
    if kind == "table":
        rows = "".join(_row(line, formulas) for line in lines if not _RULE.fullmatch(line))
        return f"<table><tbody>{rows}</tbody></table>" if rows else ""
    return f"<p>{_inline(' '.join(lines), formulas)}</p>"


def _row(line: str, formulas: Formulas) -> str:
    cells = re.split(r"(?<!\\)\|", line.strip().removeprefix("|").removesuffix("|"))
    return "<tr>" + "".join(f"<td>{_inline(cell.strip(), formulas)}</td>" for cell in cells) + "</tr>"


def _inline(text: str, formulas: Formulas) -> str:
    return "".join(_piece(match, formulas) for match in _PIECES.finditer(text))


def _piece(match: re.Match[str], formulas: Formulas) -> str:
    text = match[match.lastgroup or 0]
    match match.lastgroup:
        case "math":
            return formulas.inline(text)
        case "strong" | "em" as tag:
            return f"<{tag}>{_inline(text, formulas)}</{tag}>"
    return html(text)
