"""`{m}` in the text of a file stands for the value of the given name m, which each variant has its own of."""

from __future__ import annotations

import re
from collections.abc import Mapping as Dict

from planar_cli.problem.nodes import reading
from planar_cli.problem.nodes.nodes import Mapping, Node, Scalar
from planar_cli.problem.nodes.reading import Report
from planar_cli.units import pretty_unit

PLACEHOLDER = re.compile(r"\{([A-Za-z][A-Za-z0-9_]*)\}")


def check_placeholders(node: Node, report: Report) -> None:
    """Every name in braces in `text` is given; another one would be printed as it stands."""
    text = node.get("text") if isinstance(node, Mapping) else None
    if not isinstance(node, Mapping) or not isinstance(text, Scalar):
        return
    given = node.get("given")
    names = given.keys() if isinstance(given, Mapping) else ()
    in_one_line = text.mark.line == text.end.line and not text.quoted
    for match in PLACEHOLDER.finditer(text.text):
        if match[1] not in names:
            mark = text.mark.shifted(match.start() + 1) if in_one_line else text.mark
            hint = reading.did_you_mean(match[1], names, "there are ") or "give it a value under `given` first"
            report.add(mark, "PL344", f"{match[0]} in `text`: '{match[1]}' is no given name", hint)


def put_in(text: str, values: Dict[str, str]) -> str:
    """A text with its values put in, which are told as a file writes them; of `{n}m` a factor of one is left out."""

    def value_of(found: re.Match[str]) -> str:
        if found[1] not in values:
            return found[0]
        value = told(values[found[1]])
        return "" if value == "1" and text[found.end() : found.end() + 1].isalpha() else value

    return PLACEHOLDER.sub(value_of, text)


def told(value: str) -> str:
    """A value of a file in print: `2.5 m/s^2` with its unit as on a page."""
    number, _, unit = value.partition(" ")
    pretty = pretty_unit(unit) if unit and re.fullmatch(r"[A-Za-z0-9*/^()-]+", unit) else unit
    return f"{number}{pretty}" if pretty == "°" else f"{number} {pretty}".strip()
