"""The known word that a misspelt one looks most like."""

from __future__ import annotations

from collections.abc import Iterable


def nearest(word: str, known: Iterable[str], cutoff: float = 0.6) -> str:
    """The word; "": none is like it. `cutoff`: how alike they must be, from 0 to 1."""
    # Most files and lines are spelt right, and importing this takes as long as reading a small file.
    from difflib import get_close_matches

    return next(iter(get_close_matches(word, list(known), n=1, cutoff=cutoff)), "")
