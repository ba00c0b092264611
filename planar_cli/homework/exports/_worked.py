"""A worked solution, from the Markdown of the report to HTML with formulas in LaTeX between delimiters.

Only what the report writes is known: headings, lists, tables, formulas, bold and italic words. All else is text.
"""

from __future__ import annotations

import re
from itertools import groupby

from planar_cli.homework.exports._text import html, xml
from planar_cli.records import record

_PIECES = re.compile(
    r"\\(?P<escaped>[^\w\s])"
    r"|\$(?P<math>(?:\\.|[^$\\])+)\$"
    r"|\*\*(?P<strong>(?:\\.|[^*\\])+)\*\*"
    r"|\*(?P<em>(?:\\.|[^*\\])+)\*"
    r"|(?P<plain>[^\\$*]+|.)",
    re.DOTALL,
)
_HEADING = re.compile(r"(#{1,6}) +(.*)")
_RULE = re.compile(r"\|[\s|:-]*\|?")


@record
class Delimiters:
    """How a system knows a formula: in a line, and on a line of its own."""

    inline: tuple[str, str]
    display: tuple[str, str]


LATEX = Delimiters(("\\(", "\\)"), ("\\[", "\\]"))
DOLLARS = Delimiters(("$", "$"), ("$$", "$$"))


def worked_html(markdown: str, delimiters: Delimiters) -> str:
    """The HTML of a worked solution: well-formed as XML, without attributes."""
    return "".join(
        _block(block.strip("\n"), delimiters) for block in re.split(r"\n[ \t]*\n", markdown) if block.strip()
    )


def _block(block: str, delimiters: Delimiters) -> str:
    heading = _HEADING.fullmatch(block)
    if heading:
        # The page of the system has the higher levels.
        level = min(6, len(heading[1]) + 2)
        return f"<h{level}>{_inline(heading[2], delimiters)}</h{level}>"
    if block.startswith("$$") and block.endswith("$$") and len(block) > 4:
        return f"<p>{_formula(block[2:-2].strip(), delimiters.display)}</p>"
    runs = groupby(block.split("\n"), key=_kind)
    return "".join(_run(kind, list(lines), delimiters) for kind, lines in runs)


def _kind(line: str) -> str:
    return "table" if line.startswith("|") else "list" if line.startswith("- ") else "text"


def _run(kind: str, lines: list[str], delimiters: Delimiters) -> str:
    if kind == "list":
        return "<ul>" + "".join(f"<li>{_inline(line[2:], delimiters)}</li>" for line in lines) + "</ul>"
    if kind == "table":
        rows = "".join(_row(line, delimiters) for line in lines if not _RULE.fullmatch(line))
        return f"<table><tbody>{rows}</tbody></table>" if rows else ""
    return f"<p>{_inline(' '.join(lines), delimiters)}</p>"


def _row(line: str, delimiters: Delimiters) -> str:
    cells = re.split(r"(?<!\\)\|", line.strip().removeprefix("|").removesuffix("|"))
    return "<tr>" + "".join(f"<td>{_inline(cell.strip(), delimiters)}</td>" for cell in cells) + "</tr>"


def _inline(text: str, delimiters: Delimiters) -> str:
    return "".join(_piece(match, delimiters) for match in _PIECES.finditer(text))


def _piece(match: re.Match[str], delimiters: Delimiters) -> str:
    text = match[match.lastgroup or 0]
    match match.lastgroup:
        case "math":
            return _formula(text, delimiters.inline)
        case "strong" | "em" as tag:
            return f"<{tag}>{_inline(text, delimiters)}</{tag}>"
    return html(text)


def _formula(latex: str, between: tuple[str, str]) -> str:
    """Between its delimiters; braces stay, as only the formula renderer reads them."""
    return between[0] + xml(latex) + between[1]
