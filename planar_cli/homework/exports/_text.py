"""Words from files and students made harmless: for HTML and XML, for file names, for tables that spreadsheets open."""

from __future__ import annotations

import csv
import io
import re
import unicodedata
from collections.abc import Iterable, Sequence
from html import escape

from planar_cli.problem.nodes.show import guarded, paragraphs_of

LONGEST_NAME = 64
_RESERVED = re.compile(r"con|prn|aux|nul|com[0-9]|lpt[0-9]")
# Braces hold the placeholders of templates and the boxes of cloze questions.
_MATH = re.compile(r"[$\\]")
_BRACES = str.maketrans({"{": "&#123;", "}": "&#125;"})
_CONTROL = ("\t", "\r", "\n", "\0")
_ODD = re.compile(r"[^\t\n -~]")


def clean(text: str) -> str:
    """Without characters that XML forbids or that change the direction of reading; each becomes `\\ufffd`."""
    return _ODD.sub(_shown, text.replace("\r\n", "\n").replace("\r", "\n"))


def _shown(match: re.Match[str]) -> str:
    c = match[0]
    bad = unicodedata.category(c) in ("Cc", "Cf", "Cs") or ord(c) & 0xFFFE == 0xFFFE
    return "\ufffd" if bad else c


def one_line(text: str) -> str:
    return " ".join(clean(text).split())


def xml(text: str) -> str:
    """As the text of an XML element or attribute."""
    return escape(clean(text), quote=True)


def html(text: str) -> str:
    """As text on a web page, which no formula renderer and no template takes for its own."""
    return _MATH.sub(r"<span>\g<0></span>", xml(text).translate(_BRACES))


def as_attribute(text: str) -> str:
    """As the value of an attribute of HTML, in which no template and no box of a question begins."""
    return _MATH.sub(lambda m: f"&#{ord(m[0])};", xml(text).translate(_BRACES))


def paragraphs(text: str) -> str:
    """Plain text as HTML paragraphs."""
    return "".join(f"<p>{html(p)}</p>" for p in paragraphs_of(clean(text)))


def bullets(lines: Iterable[str]) -> str:
    items = "".join(f"<li>{html(one_line(line))}</li>" for line in lines)
    return f"<ul>{items}</ul>" if items else ""


def slug(text: str, tail: str = "") -> str:
    """A file name of small letters, digits, `_` and `-`, at most 64 long, that no system reserves; ends in `tail`."""
    plain = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode().lower()
    name = re.sub(r"[^a-z0-9_]+", "-", plain).strip("-_")[: LONGEST_NAME - len(tail)].rstrip("-_") or "unnamed"
    return f"{name}_" if _RESERVED.fullmatch(name + tail) else name + tail


class Names:
    """File names that differ: the second of a kind gets `-2`."""

    def __init__(self) -> None:
        self._taken: set[str] = set()
        self._counts: dict[str, int] = {}

    def of(self, text: str) -> str:
        """A name for a text; a new one at every call."""
        first = name = slug(text)
        while name in self._taken:
            self._counts[first] = self._counts.get(first, 1) + 1
            name = slug(text, f"-{self._counts[first]}")
        self._taken.add(name)
        return name


def number(value: float) -> str:
    """A number as every system reads it: to twelve figures, no minus before zero."""
    return f"{value + 0.0:.12g}" if value else "0"


def table(rows: Iterable[Sequence[str | float]], excel: bool) -> bytes:
    """Rows as CSV in UTF-8. A text that a spreadsheet would take for a formula gets an apostrophe before it."""
    out = io.StringIO()
    csv.writer(out, lineterminator="\r\n").writerows([_cell(c) for c in row] for row in rows)
    return out.getvalue().encode("utf-8-sig" if excel else "utf-8")


def _cell(value: str | float) -> str:
    if not isinstance(value, str):
        return number(value)
    return "'" + clean(value) if value.startswith(_CONTROL) else guarded(clean(value))
