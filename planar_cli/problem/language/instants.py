"""Instants and spans behind `@`, and the refusals that every part of the grammar shares."""

from __future__ import annotations

from typing import NoReturn

from planar_cli.problem.language.tokens import Cursor, Token
from planar_cli.problem.language.words import FUNCTIONS, QUANTITIES

State = str
Span = tuple[str, str]
MAX_QUOTED = 30


class InstantParser:
    """Reads `@ state`, `@ state->state` and spans at a cursor."""

    def __init__(self, cursor: Cursor) -> None:
        self.cursor = cursor

    def instant_or_span(self) -> State | Span | None:
        """`@ state` or `@ state->state`, None if no `@` stands here."""
        cursor = self.cursor
        if not cursor.accept("@"):
            return None
        if cursor.is_sign("->"):
            cursor.fail("a span needs both ends", "write `@ 1->2`", "PL212")
        start = self._state()
        return (start, self._span_end()) if cursor.accept("->") else start

    def state_of(self, what: str) -> State | None:
        """`@ state` behind something that has no span."""
        at = self.instant_or_span()
        if isinstance(at, tuple):
            self.cursor.fail(f"{what} has no value over a span", f"write `mean(…) @ {at[0]}->{at[1]}`", "PL212")
        return at

    def span(self) -> Span:
        cursor = self.cursor
        start = self._state()
        if not cursor.accept("->"):
            cursor.fail("a span needs both ends", f"write `{start}->…`", "PL212")
        return start, self._span_end()

    def _span_end(self) -> State:
        if self.cursor.token.kind not in ("name", "number"):
            self.cursor.fail("a span needs both ends", "write `1->2`", "PL212")
        return self._state()

    def _state(self) -> State:
        cursor = self.cursor
        token = cursor.token
        if token.kind == "name" or (token.kind == "number" and token.text.isdigit()):
            return cursor.take().text
        raise cursor.error("the name of a state is missing", "write `@ 2` or `@ top`", "PL212")


def refuse_neighbour(cursor: Cursor, start: int) -> None:
    """Refuse juxtaposition: behind a term that began at offset `start` comes a sign, the end, or a closing word."""
    token = cursor.token
    if token.kind == "name" and token.text in ("is", "in", "at", "during"):
        return
    if token.kind not in ("name", "number") and not cursor.is_sign("("):
        return
    before = cursor.tokens[cursor.index - 1]
    left = cursor.text[start : before.end]
    if len(left) > MAX_QUOTED:
        left = "…"
    right = "(…)" if token.text == "(" else token.text
    hint = f"write `{left}*{right}` for a product"
    if token.text in ("cw", "ccw"):
        hint = f"write it once, behind a unit: `5 rad/s {token.text}`"
    elif token.kind == "name" and token.text not in FUNCTIONS and token.text not in QUANTITIES:
        hint += f", `({left}) {right}` if {right} is a unit"
    cursor.fail(f"between {left} and {right} the sign is missing", hint, "PL205")


def refuse_at(cursor: Cursor) -> NoReturn:
    """`@` behind a power, a product or a mode."""
    hint = "write `(v(P).mag^2) @ 2`, and `mode(C) @ 2 = stick`"
    cursor.fail("`@` belongs to the quantity, name or bracket just before it, and here is none", hint, "PL212")


def refuse_comma(cursor: Cursor, comma: Token, word: Token | None) -> NoReturn:
    """A comma never stands in an expression: it would split a list of statements."""
    before, after = cursor.before(cursor.index), cursor.peek()
    hint = "the distance from A to B is `r(B/A).mag`; write two entries for two statements"
    if word is not None and before is not None and after.kind == "name":
        hint = f"write `{word.text}({before.text}/{after.text})`"
    cursor.fail("no comma stands inside a quantity or expression", hint, "PL209", comma)
