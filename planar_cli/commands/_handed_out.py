"""Pages that are put together of blocks and of parts that are in print already, in any format."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import groupby
from typing import TYPE_CHECKING, Any

from planar_cli.registry import member

if TYPE_CHECKING:
    from planar_cli.report.handed_out import Piece

SUFFIX = {"markdown": "md", "html": "html", "latex": "tex", "pdf": "pdf", "json": "json", "csv": "csv"}
PDF = "pdf"
PAGES = ("markdown", "html", "pdf")
"""Formats of pages to be read, which can hold worked solutions."""


def printed_as(form: str) -> str:
    """The format in which the parts of a page are printed: a PDF is the page of `html` on paper."""
    return "html" if form == PDF else form


def page(pieces: Iterable[Piece], title: str, form: str) -> bytes:
    """One page; the same for the same pieces. `title`: of the file. PlanarError: a PDF cannot be made here."""
    pages: Any = member("formats", printed_as(form))()
    parts: list[str] = []
    for is_printed, some in groupby(pieces, lambda piece: isinstance(piece, dict)):
        run = list(some)
        parts += [p[pages.kind] for p in run if isinstance(p, dict)] if is_printed else [pages.part(run)]
    return in_form(pages.whole(title, parts), form)


def in_form(text: str, form: str) -> bytes:
    """A page in print as the contents of a file. PlanarError: a PDF cannot be made here."""
    if form != PDF:
        return text.encode()
    from planar_cli.formats._svg import PRINT
    from planar_cli.typeset import pdf

    return pdf(text, PRINT)
