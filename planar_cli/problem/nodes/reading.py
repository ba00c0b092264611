"""Reading nodes: the small functions with which every part of a file is taken apart.

Everything that is wrong goes into a `Report`; reading goes on, with a stand-in (an empty name) where something could
not be read, so that one run tells all that is wrong with a file. The stand-in is passed over by every later check.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from planar_cli.errors import Diagnostic, Mark
from planar_cli.near import nearest
from planar_cli.problem.language.expression import Found, Law, Name, Side, Statement
from planar_cli.problem.language.parser import ParseError, parse_found, parse_law, parse_side, parse_statement
from planar_cli.problem.nodes.nodes import Mapping, Node, Scalar, Sequence

NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
STATE = re.compile(r"[A-Za-z_][A-Za-z0-9_]*|[0-9]+")
SPAN = re.compile(r"\s*([A-Za-z0-9_]+)\s*->\s*([A-Za-z0-9_]+)\s*")


class Report:
    """The diagnostics of one file, each once."""

    def __init__(self) -> None:
        self._found: dict[Diagnostic, None] = {}

    def add(self, mark: Mark, code: str, message: str, hint: str = "") -> None:
        """One more thing that is wrong."""
        self._found.setdefault(Diagnostic(mark, code, message, hint))

    def take(self, diagnostic: Diagnostic) -> None:
        """A diagnostic made elsewhere."""
        self._found.setdefault(diagnostic)

    def sorted(self) -> list[Diagnostic]:
        """All of them in the order of the file."""
        return sorted(self._found, key=lambda d: (d.mark, d.code, d.message))


def unreadable(mark: Mark) -> Name:
    """The stand-in for mathematics that could not be read."""
    return Name("", None, mark)


def close_to(word: str, allowed: Iterable[str]) -> str:
    """The one of `allowed` that looks most like `word`, or ""."""
    choices = {name.lower(): name for name in allowed}
    return choices.get(nearest(word.lower(), choices), "")


def listed(words: Iterable[str], joined: str = "or") -> str:
    """`a, b or c`."""
    all_words = list(words)
    if len(all_words) < 2:
        return "".join(all_words)
    return ", ".join(all_words[:-1]) + f" {joined} " + all_words[-1]


def did_you_mean(word: str, allowed: Iterable[str], lead: str = "") -> str:
    """A hint: the one meant, else all that are allowed after `lead` ("there are ", "write "); "" if there are none."""
    names = list(allowed)
    near = close_to(word, names)
    if near:
        return f"did you mean '{near}'?"
    if not names or not lead:
        return ""
    if len(names) == 1:
        return f"write '{names[0]}'" if lead.startswith("write") else f"there is only '{names[0]}'"
    return lead + listed(names, "or" if lead.startswith("write") else "and")


def shape_of(node: Node) -> str:
    """What a node is, in words."""
    if isinstance(node, Mapping):
        return "names with values"
    return "a list" if isinstance(node, Sequence) else f"'{node.text}'"


def pairs(node: Node, what: str, report: Report, example: str) -> list[tuple[Scalar, Node]]:
    """The pairs of a mapping; anything else is an error that shows the `example`."""
    if isinstance(node, Mapping):
        return list(node.pairs)
    report.add(node.mark, "PL301", f"{what} holds names with values, not {shape_of(node)}", f"write `{example}`")
    return []


def items(node: Node, what: str, report: Report, example: str) -> list[Node]:
    """The items of a list; anything else is an error that shows the `example`."""
    if isinstance(node, Sequence):
        return list(node.items)
    report.add(node.mark, "PL302", f"{what} is a list, not {shape_of(node)}", f"write `{example}`")
    return []


def text(node: Node, what: str, report: Report) -> str:
    """The words of a scalar, else ""."""
    if isinstance(node, Scalar):
        return node.text
    report.add(node.mark, "PL303", f"{what} is one word or line, not {shape_of(node)}")
    return ""


def name(node: Node, what: str, report: Report) -> str:
    """A name of a thing: a letter, then letters, digits, `_`; else "" and an error."""
    word = text(node, what, report)
    if not word or NAME.fullmatch(word):
        return word
    report.add(node.mark, "PL304", f"'{word}' is not {what}", "a name is a letter, then letters, digits and _")
    return ""


def state(node: Node, report: Report) -> str:
    """The name of a state: letters and digits; else "" and an error."""
    word = text(node, "the name of a state", report)
    if not word or STATE.fullmatch(word):
        return word
    hint = "letters and digits, as in `1: [at rest]`"
    if word[0].isdigit() and word.isalnum():
        hint = f"a name is a letter, then letters and digits, or a number alone: `t{word}`, `1`"
    report.add(node.mark, "PL304", f"'{word}' is no name for a state", hint)
    return ""


def span(node: Node, report: Report) -> tuple[str, str] | None:
    """`1->2`, as two names of states."""
    word = text(node, "a span of states", report)
    match = SPAN.fullmatch(word)
    if match:
        return match[1], match[2]
    if word:
        report.add(node.mark, "PL305", f"'{word}' is no span of states", "write both ends: `1->2`")
    return None


def side(node: Node, what: str, report: Report) -> Side:
    """One side of a relation; a stand-in when it cannot be read."""
    line = text(node, what, report)
    if not line:
        return unreadable(node.mark)
    try:
        return parse_side(line, node.mark)
    except ParseError as error:
        report.take(error.diagnostic)
        return unreadable(node.mark)


def statement(node: Node, report: Report) -> Statement | None:
    """One relation of a list; None when it cannot be read."""
    line = _statement_text(node, report)
    if not line:
        return None
    try:
        return parse_statement(line, node.mark)
    except ParseError as error:
        report.take(error.diagnostic)
        return None


def law(node: Node, report: Report) -> Law | None:
    """One line of `motion`; None when it cannot be read."""
    line = _statement_text(node, report)
    if not line:
        return None
    try:
        return parse_law(line, node.mark)
    except ParseError as error:
        report.take(error.diagnostic)
        return None


def found(node: Node, report: Report) -> Found | None:
    """What a find asks for; None when it cannot be read."""
    line = text(node, "what is to be found", report)
    if not line:
        return None
    try:
        return parse_found(line, node.mark)
    except ParseError as error:
        report.take(error.diagnostic)
        return None


def statements(node: Node, what: str, report: Report) -> tuple[Statement, ...]:
    """A list of relations."""
    read = (statement(item, report) for item in _lines(node, what, report))
    return tuple(s for s in read if s is not None)


def laws(node: Node, report: Report) -> tuple[Law, ...]:
    """The list `motion`."""
    read = (law(item, report) for item in _lines(node, "motion", report))
    return tuple(s for s in read if s is not None)


def _lines(node: Node, what: str, report: Report) -> list[Node]:
    if isinstance(node, Mapping):
        _refuse_mapping(node, what, report)
        return []
    if isinstance(node, Scalar):
        report.add(node.mark, "PL302", f"{what} is a list, not {shape_of(node)}", f"write `{what}: [{node.text}]`")
        return []
    return list(node.items)


def _refuse_mapping(node: Mapping, what: str, report: Report) -> None:
    for key, value in node.pairs:
        said = value.text if isinstance(value, Scalar) else "…"
        report.add(
            key.mark,
            "PL307",
            f"'{key.text}: {said}' is a name with a value; {what} is a list of relations",
            f"write `- {key.text} = {said}`",
        )


def _statement_text(node: Node, report: Report) -> str:
    """The line of a relation; a mapping inside the list gets its own hint."""
    if isinstance(node, Mapping):
        _refuse_mapping(node, "this", report)
        return ""
    return text(node, "a relation", report)
