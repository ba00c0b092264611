"""A diagnostic as text: place, code, message, the line of the file with a caret, and the hint."""

from __future__ import annotations

import re
from unicodedata import category

from planar_cli.errors import Diagnostic

WIDTH = 110
MAX_TEXT = 600
_NUMBER = r"[-+](\d+([.,]\d*)?|[.,]\d+)([eE][-+]?\d+)?(\s*[A-Za-zµμ°%][\w µμ°%·*/^²³⁻]*)?"
FORMULA = re.compile(rf"(^\s*|;\s*)(?!{_NUMBER}\s*(;|$))(?=[-=+@\uff0d\uff1d\uff0b\uff20])")
"""Where a cell begins with one of these, or their wide forms, some spreadsheet takes it for a formula, also behind
spaces; a semicolon begins a cell too in countries with a decimal comma. A negative number, also with its unit, is none.
"""


def show_diagnostic(diagnostic: Diagnostic, source_text: str) -> str:
    """`file:line:column: CODE message`, the source line, a caret under the column, and `hint: …` if there is one.

    Nothing that comes from a file is printed raw: control and other invisible characters become escapes.
    """
    mark = diagnostic.mark
    place = f"{visible(mark.file)}:{mark.line}:{mark.column}: " if mark.line > 0 else ""
    lines = [f"{place}{diagnostic.code} {visible(diagnostic.message)}"]
    source = lines_of(source_text.removeprefix("\ufeff"))
    if 0 < mark.line <= len(source):
        lines.extend(_excerpt(source[mark.line - 1], mark.column))
    if diagnostic.hint:
        lines.append(f"hint: {visible(diagnostic.hint)}")
    return "\n".join(lines)


def lines_of(text: str) -> list[str]:
    """The lines as editors count them: other characters that end a line for Python are refused at their place."""
    return re.split(r"\r\n|\r|\n", text)


def visible(text: str) -> str:
    """The text with every character that does not print as itself written as an escape, cut if it is very long."""
    cut = text if len(text) <= MAX_TEXT else text[:MAX_TEXT] + "…"
    return "".join(map(_visible_character, cut))


def harmless(text: str, kept: str = "\n") -> str:
    """The whole text with what would steer a terminal, or not be seen on it, written as escapes, but for `kept`.

    Spaces of every width pass: they are seen as a gap, and formulas have them.
    """
    steering = {c for c in set(text) if c not in kept and not c.isprintable() and category(c) != "Zs"}
    return text.translate({ord(c): _visible_character(c) for c in steering})


def paragraphs_of(text: str) -> list[str]:
    """The paragraphs of a text, each as one line; an empty line of a folded text, `>-`, reads as one line feed."""
    return [" ".join(p.split()) for p in re.split(r"[\r\n]+", text) if p.strip()]


def spreadsheet_cell(text: str) -> str:
    """A cell of words that no spreadsheet takes for a formula."""
    return guarded(harmless(text, kept=""))


def guarded(text: str) -> str:
    """Words with an apostrophe where some spreadsheet would take them for a formula."""
    return FORMULA.sub(r"\g<0>'", text)


def _visible_character(character: str) -> str:
    if character.isprintable():
        return character
    code = ord(character)
    return f"\\x{code:02x}" if code < 0x100 else f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"


def _excerpt(line: str, column: int) -> list[str]:
    """The line and the caret line, cut to the neighbourhood of the column."""
    line = line.replace("\t", " ")
    position = min(max(column - 1, 0), len(line))
    begin = max(0, position - WIDTH + 30) if len(line) > WIDTH else 0
    before, after = visible(line[begin:position]), visible(line[position : begin + WIDTH])
    head = "…" if begin else ""
    tail = "…" if begin + WIDTH < len(line) else ""
    indent = " " * (len(head) + len(before))
    return [f"  {head}{before}{after}{tail}", f"  {indent}^"]
