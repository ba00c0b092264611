"""How the line from one point to another is called: OA, or O–satellite where a name is a word."""

from __future__ import annotations

LETTERS = 2
"""Names of at most so many letters stand side by side."""


def line_name(start: str, end: str) -> str:
    """Both names; a stroke keeps words apart."""
    return f"{start}{end}" if max(len(start), len(end)) <= LETTERS else f"{start}–{end}"
