"""Pages that are put together of blocks and of parts that are in print already, in any format."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from itertools import groupby
from typing import TYPE_CHECKING, Any

from planar_cli.registry import member

if TYPE_CHECKING:
    from planar_cli.report.document.handed_out import Piece

SUFFIX = {"markdown": "md", "html": "html", "latex": "tex", "pdf": "pdf", "json": "json", "csv": "csv"}
PDF = "pdf"
PICTURE = ".svg"
CALLED = re.compile(rf"\]\(([0-9a-f]{{16}}{re.escape(PICTURE)})\)")
"""A picture in the text of Markdown, by the name that tells what is in it."""
PAGES = ("markdown", "html", "latex", PDF)
"""Formats of pages to be read, which can hold worked solutions."""


def printed_as(form: str) -> str:
    """The format in which the parts of a page are printed: a PDF is the page of `html` on paper."""
    return "html" if form == PDF else form


def page(pieces: Iterable[Piece], title: str, form: str) -> bytes:
    """One page; the same for the same pieces. `title`: of the file. PlanarError: a PDF cannot be made here."""
    (made,) = [data for name, data in files(pieces, title, form, "").items() if not name.endswith(PICTURE)]
    return made


def files(pieces: Iterable[Piece], title: str, form: str, name: str) -> dict[str, bytes]:
    """One page as a file, with the pictures that its text calls beside it. `name`: without the ending."""
    pages: Any = member("formats", printed_as(form))()
    parts: list[str] = []
    pictures: dict[str, str] = {}
    for is_printed, some in groupby(pieces, lambda piece: isinstance(piece, dict)):
        run = list(some)
        printed = [p for p in run if isinstance(p, dict)]
        parts += [p.get(pages.kind, "") for p in printed] if is_printed else [pages.part(run)]
        pictures |= {own: drawn for p in printed for own, drawn in p.items() if own.endswith(PICTURE)}
    text, called = with_pictures(pages.whole(title, parts), pictures, lambda i: f"{name}-{i}{PICTURE}")
    return {f"{name}.{SUFFIX[form]}": in_form(text, form), **{own: drawn.encode() for own, drawn in called.items()}}


def with_pictures(text: str, pictures: Mapping[str, str], named: Callable[[int], str]) -> tuple[str, dict[str, str]]:
    """Markdown whose pictures are called by other names, in the order in which they stand there, and those that it
    calls by these. `named`: the name of the first, the second and so on.
    """
    called = list(dict.fromkeys(n for n in CALLED.findall(text) if n in pictures))
    names = {own: named(i) for i, own in enumerate(called, 1)}
    text = CALLED.sub(lambda m: f"]({names.get(m[1], m[1])})", text) if names else text
    return text, {names[own]: pictures[own] for own in called}


def in_form(text: str, form: str) -> bytes:
    """A page in print as the contents of a file. PlanarError: a PDF cannot be made here."""
    if form != PDF:
        return text.encode()
    from planar_cli.formats._svg import PRINT
    from planar_cli.typeset import pdf

    return pdf(text, PRINT)
