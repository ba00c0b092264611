"""What to write instead, for text that is not YAML: one diagnostic from the error of the scanner or parser."""

from __future__ import annotations

import re

from planar_cli.errors import Diagnostic, Mark
from planar_cli.problem.language.tokens import TABLE, TABLE_IN_A_LINE
from planar_cli.problem.nodes.pyyaml import yaml

_BEGINNINGS = {
    "?": ("`?` begins no value", "declare the name under `unknowns:` with its unit, and leave its value out"),
    "@": ("`@` begins no value", "a state stands behind a quantity: `v(P) @ 2`"),
    "`": ("a backquote begins no value", "leave the backquote out"),
    "%": ("`%` begins no value", "write a fraction, `0.05`; comments begin with `#`"),
    "*": ("`*` begins no value", "write both factors: `2*k`; references are not used"),
    "&": ("`&` begins no value", "write two entries of the list; anchors are not used"),
    "!": ("`!` begins no value", "leave the `!` out; tags are not used"),
    ",": ("a comma too many, or an entry is missing", "write one comma between two entries"),
}


def explain_error(error: yaml.YAMLError, text: str, file: str) -> Diagnostic:
    """The diagnostic for a YAML error in `text`; what is never closed is reported where it was opened."""
    place = getattr(error, "problem_mark", None)
    line, column = (place.line, place.column) if place is not None else (0, 0)
    code, message, hint = _reason(error, text.splitlines() or [""], line, column)
    opened = getattr(error, "context_mark", None)
    if opened is not None and "never closed" in message:
        line, column = opened.line, opened.column
    return Diagnostic(Mark(file, line + 1, column + 1), code, message, hint)


def _reason(error: yaml.YAMLError, lines: list[str], row: int, column: int) -> tuple[str, str, str]:
    """Code, message and hint."""
    line = lines[row] if row < len(lines) else ""
    character = line[column : column + 1]
    problem, context = str(getattr(error, "problem", "") or ""), str(getattr(error, "context", "") or "")
    if character == "\t" or "\t" in line[: len(line) - len(line.lstrip())]:
        return "PL112", "a tab stands where the line is indented", "indent with spaces"
    table = TABLE.search(line)
    if table and line[: table.start()].rstrip().endswith("="):
        return ("PL202", *TABLE_IN_A_LINE)
    for sign, word in (("*", "alias"), ("&", "anchor"), ("!", "tag"), ("%", "directive")):
        if word in context:
            return ("PL111", *_BEGINNINGS[sign])
    if "block scalar" in context:
        hint = "a relation is a whole string in a list: `- a >= 3`; words follow on indented lines after `>-`"
        return "PL111", "`>` and `|` begin no value", hint
    if problem.startswith("mapping values are not allowed") or character == ":":
        return _colon(line, column)
    if character in _BEGINNINGS and character:
        return ("PL111", *_BEGINNINGS[character])
    if re.search(r"[\[{,:]\s*\?\s*,?$", line[: column + 1]):
        return ("PL111", *_BEGINNINGS["?"])
    if character in (">", "|"):
        hint = "a relation is a whole string in a list: `[a >= 3]`, as under `assume`; a value has no sign before it"
        return "PL111", f"`{character}` begins no value", hint
    at_end = not line[column:].strip() and not any(later.strip() for later in lines[row + 1 :])
    return _brackets_and_quotes(problem, context, at_end)


def _colon(line: str, column: int) -> tuple[str, str, str]:
    before = line[:column]
    if re.search(r":\s|[\[{]", before) and before.strip():
        hint = "put words with a colon on the next line, indented, after `>-`; a second key on a line of its own"
        return "PL113", "a second colon stands in this line", hint
    return "PL104", "this key does not fit the lines above", "keys of one mapping begin in the same column"


def _brackets_and_quotes(problem: str, context: str, at_end: bool) -> tuple[str, str, str]:
    if "unexpected end of stream" in problem or "document separator" in problem:
        return "PL104", "this quote is never closed", "write the closing quote, or leave both out"
    if "escape" in problem:
        return "PL104", "a backslash in double quotes begins an escape", "use single quotes, or leave the quotes out"
    for kind, name, example in (("flow sequence", "list", "[a, b]"), ("flow mapping", "mapping", "{a: 1, b: 2}")):
        if kind in context and at_end:
            return "PL104", f"this {name} is never closed", f"write `{example}`"
        if kind in context:
            return "PL104", f"a comma or the closing bracket of a {name} is missing here", f"write `{example}`"
    if "sequence entries are not allowed" in problem:
        return "PL104", "a list does not begin behind a key", "put `- ` on the next line, or write `[a, b]`"
    if "block" in context:
        hint = "entries of one list or mapping begin in the same column"
        return "PL104", "this line does not fit the lines above", hint
    return "PL104", "the text cannot be read here", "check brackets, quotes and indentation"
