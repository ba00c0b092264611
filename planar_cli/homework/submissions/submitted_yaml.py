"""The tree of a student's YAML file, in which a line that is no YAML costs that line alone.

    crank.v_G: [1.61, -0.579] m/s       # no YAML: a text behind a list; read as the one text that it is meant to be

What stands behind `key:` and is no YAML by itself is taken as one plain text, as if it stood in quotes. A line that
cannot be mended so is left out, and told. Limits of size and depth are those of any file: what passes them is refused.
"""

from __future__ import annotations

import re

from planar_cli.errors import Diagnostic, Mark
from planar_cli.problem.nodes.nodes import MAX_SCALAR, Node, read_text

MOST_MENDED = 64_000
"""Characters of a file that is mended: a submission is far shorter."""
MOST_TIMES = 20
"""So many lines are mended one by one; behind them the file is refused as a whole."""
HOW = "write `problem.find: answer`"
LIMIT, TWICE = "PL102", "PL109"
_ENTRY = re.compile(r"([ \t]*(?:[^\s:#'\"\[\]{}]+|\"[^\"]*\"|'[^']*'):[ \t]+)(\S.*?)([ \t]+#.*|[ \t]*)")
_FIRST = re.compile(r"the first is in line ([0-9]+)")
_VARIANT = re.compile(r"^variant:[ \t]+([0-9]{1,9})[ \t]*$", re.MULTILINE)
_STUDENT = re.compile(r"^student:[ \t]+(['\"]?)(\S.*?)\1[ \t]*$", re.MULTILINE)


def yaml_tree(text: str, path: str) -> tuple[Node | None, list[Diagnostic]]:
    """The tree and what is wrong; beside a tree, what was left out of it. None: there is nothing that can be read."""
    text, too_long = _without_long_lines(text, path)
    tree, wrong = _tree(text, path)
    return tree, [*too_long, *wrong]


def _without_long_lines(text: str, path: str) -> tuple[str, list[Diagnostic]]:
    """The text without lines that hold no answer, and what is told of them."""
    if len(text) <= MAX_SCALAR:
        return text, []
    lines = text.split("\n")
    long = [n for n, line in enumerate(lines) if len(line) > MAX_SCALAR]
    if not long or len(lines) == 1:
        return text, []
    told = f"this line has more than {MAX_SCALAR} characters and is not read"
    wrong = [Diagnostic(Mark(path, n + 1, 1), LIMIT, told, "an answer is one short text") for n in long]
    return "\n".join("" if n in long else line for n, line in enumerate(lines)), wrong[:MOST_TIMES]


def _tree(text: str, path: str) -> tuple[Node | None, list[Diagnostic]]:
    tree, wrong = read_text(text, path, blanks=True)
    if tree is None and not text.strip():
        return None, [Diagnostic(Mark(path, 1, 1), "PL106", "the file is empty", "begin with `answers:`")]
    if tree is None and not wrong:
        return None, [Diagnostic(Mark(path, 1, 1), "PL106", "there is nothing in the file", "begin with `answers:`")]
    if tree is not None or len(text) > MOST_MENDED or any(d.code == LIMIT for d in wrong):
        return tree, wrong
    return _mended(text, path, wrong)


def student_told(text: str) -> str:
    """Whose a file is that cannot be read; "" where it does not say so in a line of its own."""
    told = _STUDENT.search(text)
    return told[2] if told is not None else ""


def variant_told(text: str) -> int:
    """The variant of a file that cannot be read; 0 where it does not say so in a line of its own."""
    told = _VARIANT.search(text)
    return int(told[1]) if told is not None else 0


def _mended(text: str, path: str, first: list[Diagnostic]) -> tuple[Node | None, list[Diagnostic]]:
    lines = [_quoted(line, path) for line in text.split("\n")]
    left_out: list[Diagnostic] = []
    for _ in range(MOST_TIMES):
        tree, wrong = read_text("\n".join(lines), path, blanks=True)
        if tree is not None:
            return tree, left_out
        if not wrong or any(d.code == LIMIT for d in wrong):
            break
        told = _without(lines, wrong[0], path)
        if told is None:
            break
        left_out += told
    return None, first


def _quoted(line: str, path: str) -> str:
    """A line of which the value is no YAML, with it in quotes; brackets may go on in the next line."""
    entry = _entry(line)
    if entry is None or _is_open(entry[2]) or _is_yaml(entry[2], path):
        return line
    return _as_text(entry)


def _entry(line: str) -> re.Match[str] | None:
    """`key: value` in one line; what stands behind `answers:` is no text."""
    return None if line.startswith("answers:") else _ENTRY.fullmatch(line)


def _as_text(entry: re.Match[str]) -> str:
    escaped = entry[2].replace("'", "''")
    return f"{entry[1]}'{escaped}'"


def _is_yaml(value: str, path: str) -> bool:
    if value[0].isalnum() and ": " not in value and not value.endswith(":"):
        return True
    return all(d.code == TWICE for d in read_text(f"x: {value}", path, blanks=True)[1])


def _is_open(value: str) -> bool:
    """Does a list, mapping or text begin that is not closed in its line?"""
    if value[0] in "[{":
        return sum(value.count(c) for c in "[{") > sum(value.count(c) for c in "]}")
    return value[0] in "|>" or (value[0] in "'\"" and value.count(value[0]) % 2 == 1)


def _without(lines: list[str], wrong: Diagnostic, path: str) -> list[Diagnostic] | None:
    """Mend the line to which an error belongs, or leave it out; what is told of that. None: there is no such line."""
    at = min(wrong.mark.line, len(lines)) - 1
    if wrong.code == TWICE:
        return _neither(lines, wrong, at)
    for number in range(at, max(at - 3, -1), -1):
        entry = _entry(lines[number])
        if entry is not None and entry[2][0] not in "|>" and not _is_yaml(entry[2], path):
            # A bracket or quote that is never closed is an error of a later line.
            lines[number] = _as_text(entry)
            return []
        if lines[number].strip() and ":" not in lines[number]:
            lines[number] = ""
            return [Diagnostic(Mark(path, number + 1, 1), wrong.code, "this line cannot be read", HOW)]
    if not lines[at].strip():
        return None
    lines[at] = ""
    return [wrong]


def _neither(lines: list[str], wrong: Diagnostic, at: int) -> list[Diagnostic] | None:
    """Leave out what is answered twice: nobody knows which is meant."""
    first = _FIRST.search(wrong.message)
    both = (int(first[1]) - 1, at) if first is not None else ()
    if not both or any(_ENTRY.fullmatch(lines[n]) is None or _nested(lines[n]) for n in both):
        return None
    for number in both:
        lines[number] = ""
    return [Diagnostic(wrong.mark, wrong.code, wrong.message, "neither is graded")]


def _nested(line: str) -> bool:
    return "{" in line
