"""The statements of the problem language, read from one line of text each.

Every function takes the text of a scalar and the mark of its first character, and raises ParseError, located at the
exact column, for what cannot be read. Nothing here knows the names of a file.
"""

from __future__ import annotations

from planar_cli.errors import Mark
from planar_cli.problem.language.expression import (
    AtRest,
    Equilibrium,
    Extreme,
    Found,
    JustAfter,
    Law,
    Name,
    Relation,
    Side,
    Statement,
)
from planar_cli.problem.language.instants import refuse_at
from planar_cli.problem.language.sides import RELATION_SIGNS, SideParser
from planar_cli.problem.language.tokens import Cursor, ParseError, Token
from planar_cli.problem.language.words import is_reserved
from planar_cli.units import UnitError, parse_unit

__all__ = ["ParseError", "parse_found", "parse_law", "parse_magnitude", "parse_side", "parse_span", "parse_statement"]


def parse_side(text: str, mark: Mark) -> Side:
    """One expression: `3/4*l`, `30 deg`, `r(B/A).mag @ 2`."""
    parser = _begin(text, mark)
    side = parser.side()
    _end(parser)
    return side


def parse_magnitude(text: str, mark: Mark) -> Side:
    """The magnitude of a load, which is a side."""
    return parse_side(text, mark)


def parse_statement(text: str, mark: Mark) -> Statement:
    """A relation, `X is largest`, `[name] at rest`, `equilibrium` or `just after 1`."""
    parser = _begin(text, mark)
    statement = _statement(parser)
    _end(parser)
    return statement


def parse_law(text: str, mark: Mark) -> Law:
    """A statement of `motion`, with `during 1->2` behind it if it does not hold always."""
    parser = _begin(text, mark)
    cursor = parser.cursor
    statement = _statement(parser)
    during = None
    if cursor.is_word("during"):
        cursor.take()
        during = parser.span()
    _end(parser)
    return Law(statement, during)


def parse_found(text: str, mark: Mark) -> Found:
    """What is asked for: a side or a relation, with `in unit` behind it if a unit is wanted."""
    parser = _begin(text, mark)
    cursor = parser.cursor
    first = cursor.token
    side = parser.side()
    related = cursor.token.kind == "sign" and not cursor.is_sign(")", ",", ".")
    what: Side | Relation = parser.relation_from(side, first) if related else side
    unit = None
    if cursor.is_word("in"):
        unit = _wanted_unit(cursor)
    _end(parser)
    return Found(what, unit, text.strip(), cursor.place(first))


def parse_span(text: str, mark: Mark) -> tuple[str, str]:
    """`1->2`, the value of `during:` in a joint or load."""
    parser = _begin(text, mark)
    span = parser.span()
    _end(parser)
    return span


def _begin(text: str, mark: Mark) -> SideParser:
    cursor = Cursor(text, mark)
    if cursor.token.kind == "end":
        cursor.fail("an expression is empty", "write a number with its unit, a name, or a quantity")
    return SideParser(cursor)


def _statement(parser: SideParser) -> Statement:
    cursor = parser.cursor
    first = cursor.token
    if cursor.is_word("at", "equilibrium", "just"):
        return _phrase(parser, first)
    if first.kind == "name" and cursor.peek().kind == "name" and cursor.peek().text == "at":
        return _at_rest(cursor, first)
    left = parser.side()
    if cursor.is_word("is"):
        return _extreme(cursor, left, first)
    if cursor.token.kind == "end":
        hint = "write `left = right`" if not isinstance(left, Name) else f"write `{left.name} = …`"
        cursor.fail("a statement says that something is equal, less or greater", hint, "PL210", first)
    return parser.relation_from(left, first)


def _phrase(parser: SideParser, first: Token) -> Statement:
    """`at rest`, `equilibrium`, `just after state`."""
    cursor = parser.cursor
    if cursor.is_word("at"):
        _rest(cursor)
        return AtRest(None, _text(cursor, first), cursor.place(first))
    if cursor.is_word("equilibrium"):
        cursor.take()
        return Equilibrium(None, _text(cursor, first), cursor.place(first))
    cursor.take()
    if not cursor.is_word("after"):
        cursor.fail("`just` is followed by `after`", "write `just after 1`", "PL211")
    cursor.take()
    if cursor.token.kind == "end":
        cursor.fail("the name of a state is missing", "write `just after 1`", "PL212")
    state = cursor.take()
    if state.kind != "name" and not state.text.isdigit():
        cursor.fail("the name of a state is missing", "write `just after 1`", "PL212", state)
    return JustAfter(state.text, _text(cursor, first), cursor.place(first))


def _at_rest(cursor: Cursor, first: Token) -> Statement:
    if is_reserved(first.text) and first.text != "all":
        cursor.fail(f"`{first.text}` is no body or point", "write `at rest`, or `rod at rest`", "PL211", first)
    cursor.take()
    _rest(cursor)
    return AtRest(first.text, _text(cursor, first), cursor.place(first))


def _rest(cursor: Cursor) -> None:
    cursor.take()
    if not cursor.is_word("rest"):
        cursor.fail("`at` is followed by `rest`", "write `at rest`; an instant is `@ 2`", "PL211")
    cursor.take()


def _extreme(cursor: Cursor, side: Side, first: Token) -> Statement:
    cursor.take()
    if not cursor.is_word("largest", "smallest"):
        hint = "write `X is largest` or `X is smallest`; equality is written `=`"
        cursor.fail("`is` is followed by `largest` or `smallest`", hint, "PL211")
    sense = 1 if cursor.take().text == "largest" else -1
    return Extreme(side, sense, _text(cursor, first), cursor.place(first))


def _text(cursor: Cursor, first: Token) -> str:
    return cursor.text[first.start : cursor.tokens[cursor.index - 1].end]


def _wanted_unit(cursor: Cursor) -> str:
    """The unit behind `in`, up to the end of the text."""
    cursor.take()
    token = cursor.token
    text = cursor.text[token.start :].strip()
    try:
        parse_unit(text)
    except UnitError as error:
        cursor.fail(error.message.replace("`", ""), error.hint, "PL203")
    cursor.index = len(cursor.tokens) - 1
    return text


def _end(parser: SideParser) -> None:
    """Refuse what is left over."""
    cursor = parser.cursor
    token = cursor.token
    if token.kind == "end":
        return
    if token.text == ")":
        cursor.fail("a bracket is closed that was never opened", "leave it out, or write `(` before", "PL214")
    if token.text == ",":
        hint = "the distance from A to B is `r(B/A).mag`; write two entries for two statements"
        cursor.fail("no comma stands inside a quantity or expression", hint, "PL209")
    if token.text in (*RELATION_SIGNS, "==", "=>", "=<", "!=", "<>"):
        cursor.fail("a relation cannot stand here", "a value is written without a relation sign", "PL210")
    if token.text == "in":
        cursor.fail("`in unit` stands only in `find`", "write the unit directly behind a number", "PL211")
    if token.text == "during":
        cursor.fail("`during` stands only in `motion`, behind a statement", "", "PL211")
    if token.text == "@":
        refuse_at(cursor)
    if token.text == "->":
        cursor.fail("a span stands behind `@`", "write `work(f) @ 1->2`", "PL212")
    if token.text == ".":
        cursor.fail("a part belongs to a quantity", "write `v(P).x`", "PL213")
    cursor.fail(f"`{token.text}` cannot stand here", "one expression or statement an entry")
