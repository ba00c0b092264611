"""Letters with subscripts in HTML: m_1 in the words of a file becomes m with a lowered 1.

What is typed as it stands, the code of a sheet and the bold names of its finds, stays as it is.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from markdown_it.rules_core import StateCore
    from markdown_it.token import Token

_LETTER = re.compile(r"(?<![\w.])([A-Za-zΑ-Ωα-ω])_([A-Z]/[A-Z]|[A-Za-z0-9Α-Ωα-ω]{1,8})(?![\w])")
"""One letter with its subscript; longer words are names that somebody types."""


def with_subscripts(state: StateCore) -> None:
    """A rule of Markdown: in running words the subscripts of letters are lowered."""
    for block in state.tokens:
        if block.children:
            block.children = list(_lowered(block.children))


def _lowered(tokens: Sequence[Token]) -> Iterator[Token]:
    bold = 0
    for token in tokens:
        bold += token.nesting if token.type in ("strong_open", "strong_close") else 0
        if token.type == "text" and not bold and "_" in token.content:
            yield from _pieces(token)
        else:
            yield token


def _pieces(token: Token) -> Iterator[Token]:
    """Words between letters, and letters with tags of their own: a letter and a subscript need no escaping."""
    behind = 0
    for found in _LETTER.finditer(token.content):
        yield token.copy(content=token.content[behind : found.start()])
        yield token.copy(type="html_inline", content=f"{found[1]}<sub>{found[2]}</sub>")
        behind = found.end()
    yield token.copy(content=token.content[behind:])
