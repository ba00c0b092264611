"""What a reader of PDF finds on each page."""

from __future__ import annotations

from pathlib import Path

from pypdf import PdfReader


def texts_of_pages(path: Path) -> list[str]:
    return [page.extract_text() for page in PdfReader(path).pages]
